"""Names of a frame's channels (its images)."""

from __future__ import annotations

from collections.abc import Iterable

from nearfar._base import check

DRAWN = ("color", "range", "object_id", "face_id", "position", "normal", "albedo", "shading_normal", "coverage")
"""Names of the channels that sources draw."""

CHANNELS = (*DRAWN, "motion")
"""Names of all channels, in their order."""

VECTORS = ("color", "position", "normal", "albedo", "shading_normal")
"""Names of channels with three values per pixel."""

BYTES = {name: 12 if name in VECTORS else 8 if name in ("face_id", "motion") else 4 for name in CHANNELS}
"""Bytes per pixel of each channel."""


def channel_names(channels: Iterable[str]) -> tuple[str, ...]:
    """Return channel names without repetition in the order of `CHANNELS`; ValueError for unknown names, or no name."""
    if isinstance(channels, str):
        channel = check.choice("channels", channels, CHANNELS)
        raise TypeError(f"channels: expected a sequence of names such as ({channel!r},), got the string {channel!r}")
    requested = check.items("channels", channels, str, "a sequence of names")
    names = {check.choice("channels", name, CHANNELS) for name in requested}
    if not names:
        raise ValueError(f"channels: expected at least one of {', '.join(CHANNELS)}, got none")
    return tuple(name for name in CHANNELS if name in names)


def missing(channel: str, channels: Iterable[str]) -> ValueError:
    """Return the error for a missing channel, which lists the channels to render."""
    needed = tuple(name for name in CHANNELS if name in {channel, *channels})
    return ValueError(f"frame has no {channel}: render it with channels={needed!r}")
