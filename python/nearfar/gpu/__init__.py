"""Work on the graphics device: frames that stay there, and kernels on them and on arrays."""

from __future__ import annotations

from nearfar.gpu._frames import DeviceFrame, render
from nearfar.gpu._kernels import cube_lookup, discontinuity, morph, ssim

__all__ = ["DeviceFrame", "cube_lookup", "discontinuity", "morph", "render", "ssim"]
