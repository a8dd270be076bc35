"""Makes scenes too heavy for a thin VR device light enough to run on it, and says what that costs in image quality."""

from nearfar._envmap import cube_lookup
from nearfar._errors import DeviceError, Error, FormatError, SceneError
from nearfar._scene import Scene
from nearfar._version import __version__

__all__ = ["DeviceError", "Error", "FormatError", "Scene", "SceneError", "__version__", "cube_lookup"]
