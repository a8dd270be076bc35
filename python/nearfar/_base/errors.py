"""Exceptions of nearfar for files, scenes and devices; wrong arguments raise ValueError or TypeError instead."""

from nearfar._core import DeviceError, Error, FormatError, SceneError

__all__ = ["DeviceError", "Error", "FormatError", "SceneError"]


class UnusableError(ValueError):
    """A file cannot be used; the message is a sentence without the file's name, which the loader adds."""
