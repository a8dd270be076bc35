"""How much a server takes on."""

from __future__ import annotations

from dataclasses import dataclass

from nearfar._base import check

_MOST_SECONDS = 86400.0
_MOST = 2**20


@dataclass(frozen=True)
class Limits:
    """How many connections and regions a server takes, and how long it waits for clients.

    Parameters
    ----------
    connections
        Connections at the same time; others wait until one ends.
    per_client
        Connections of one address; more are closed at once. Programs on the server's machine may have all.
    header_bytes
        Bytes of a request's headers, at least 8192.
    header_seconds
        Time for a handshake, for the headers of a request, and between two requests of a connection.
    silent_seconds
        Time in which a client takes no byte of an answer.
    grace_seconds
        Time that answers get to end when the server closes.
    regions
        Regions of a scene that are waited for; more are refused with 503.
    regions_per_client
        Regions of a scene that one address may wait for; more are refused with 429.
    threads
        Threads that make regions of a scene. The first one makes coarse maps alone.
    memory_bytes
        Bytes of a scene's regions that stay in memory where the disk takes no more.

    Raises
    ------
    ValueError
        For a value outside its limits, which the message names.
    TypeError
        If a value is no number.
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
            check.integer(name, getattr(self, name), 1, _MOST)
        # Less would not hold the headers that browsers send.
        check.integer("header_bytes", self.header_bytes, 1 << 13, _MOST)
        for name in ("header_seconds", "silent_seconds"):
            check.within(name, getattr(self, name), 0.01, _MOST_SECONDS)
        check.within("grace_seconds", self.grace_seconds, 0.0, _MOST_SECONDS)
        check.integer("threads", self.threads, 1, 256)
        check.integer("memory_bytes", self.memory_bytes, 0, 1 << 62)
