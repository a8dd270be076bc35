"""Image quality: structural similarity, pixel errors, discontinuity and tears, and a comparison by several of them.

`ssim`, `psnr` and `compare` are in `nearfar` as well.
"""

from nearfar.metrics._comparison import compare
from nearfar.metrics._discontinuity import boundary_mask, discontinuity
from nearfar.metrics._motion_similarity import motion_ssim
from nearfar.metrics._perceptual import flip, jod
from nearfar.metrics._pixel_errors import object_completion, psnr, rmse
from nearfar.metrics._similarity import ms_ssim, ssim, ssim_pairs, visual_continuity
from nearfar.metrics._tear import BoundaryTear, boundary_tear, tear

__all__ = [
    "BoundaryTear",
    "boundary_mask",
    "boundary_tear",
    "compare",
    "discontinuity",
    "flip",
    "jod",
    "motion_ssim",
    "ms_ssim",
    "object_completion",
    "psnr",
    "rmse",
    "ssim",
    "ssim_pairs",
    "tear",
    "visual_continuity",
]
