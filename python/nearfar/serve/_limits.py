"""Limits of a server."""

from __future__ import annotations

from dataclasses import dataclass

from nearfar._base import check

_MAX_SECONDS = 86400.0
_MAX_COUNT = 2**20


@dataclass(frozen=True)
class Limits:
    """Limits on connections and regions, and timeouts for clients.

    Parameters
    ----------
    connections
        Greatest number of connections; further ones wait until one ends.
    per_client
        Greatest number of connections per address; further ones are closed at once. Local programs are exempt.
    header_bytes
        Greatest size of a request's headers in bytes, at least 8192.
    header_seconds
        Timeout for a handshake, for the headers of a request, and between two requests of a connection.
    silent_seconds
        Timeout for a client that reads nothing of a response.
    grace_seconds
        Time for open responses to finish when the server closes.
    regions
        Greatest number of a scene's regions in progress; further requests are refused with 503.
    regions_per_client
        Greatest number of a scene's regions in progress per address; further requests are refused with 429.
    threads
        Threads that make regions of a scene. The first one makes only coarse maps.
    memory_bytes
        Bytes of a scene's regions that may stay in memory if they cannot be written to disk.
    """

    connections: int = 1024
    per_client: int = 256
    header_bytes: int = 1 << 15
    header_seconds: float = 30.0
    silent_seconds: float = 60.0
    grace_seconds: float = 3.0
    regions: int = 64
    regions_per_client: int = 4
    threads: int = 2
    memory_bytes: int = 256 << 20

    def __post_init__(self) -> None:
        for name in ("connections", "per_client", "regions", "regions_per_client"):
            check.integer(name, getattr(self, name), 1, _MAX_COUNT)
        # Smaller limits would reject the headers that browsers send.
        check.integer("header_bytes", self.header_bytes, 1 << 13, 1 << 20)
        for name in ("header_seconds", "silent_seconds"):
            check.in_range(name, getattr(self, name), 0.01, _MAX_SECONDS)
        check.in_range("grace_seconds", self.grace_seconds, 0.0, _MAX_SECONDS)
        check.integer("threads", self.threads, 1, 256)
        check.integer("memory_bytes", self.memory_bytes, 0, 1 << 62)
