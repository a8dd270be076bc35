"""Names of the images that a frame may hold, and limits of what renderers are asked for."""

from __future__ import annotations

from collections.abc import Iterable

from nearfar._base import check

CHANNELS = ("color", "range", "object_id", "face_id", "position", "normal")
"""All images that a frame may hold."""

MAX_SAMPLES = 1024
"""Most colour samples of a pixel."""


def channel_names(channels: Iterable[str]) -> tuple[str, ...]:
    """Return the names of wanted images, each once and in the order of `CHANNELS`; ValueError for unknown ones."""
    if isinstance(channels, str):
        raise TypeError(f"channels: expected a sequence of names such as ({channels!r},), got the string {channels!r}")
    if not isinstance(channels, Iterable):
        raise TypeError(f"channels: expected a sequence of names, got {type(channels).__name__}")
    names = {check.choice("channels", name, CHANNELS) for name in channels}
    if not names:
        raise ValueError(f"channels: expected at least one of {', '.join(CHANNELS)}, got none")
    return tuple(name for name in CHANNELS if name in names)
