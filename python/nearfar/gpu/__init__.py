"""Graphics adapters: their list and selection, frames that stay on the device, and kernels on the device."""

from nearfar.gpu._adapters import Adapter, adapters, select, selected, stats
from nearfar.gpu._frames import DeviceFrame, measure, render
from nearfar.gpu._kernels import cube_lookup, discontinuity, morph, ssim

__all__ = [
    "Adapter",
    "DeviceFrame",
    "adapters",
    "cube_lookup",
    "discontinuity",
    "measure",
    "morph",
    "render",
    "select",
    "selected",
    "ssim",
    "stats",
]
