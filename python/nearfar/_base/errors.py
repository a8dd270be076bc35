"""Exceptions of nearfar. Wrong arguments are ValueError or TypeError; these are for files, scenes and devices."""

from nearfar._core import DeviceError, Error, FormatError, SceneError

__all__ = ["DeviceError", "Error", "FormatError", "SceneError"]
