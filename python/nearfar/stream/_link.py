"""Links between a server and a client: rate, delay and loss, and how HTTP uses them."""

from __future__ import annotations

import csv
import os
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check, formats

SEGMENT = 1460
"""Bytes of a TCP segment's content on Ethernet."""
MOST_MBPS = 1e6
"""Greatest rate, megabits a second."""
MOST_RTT = 60_000.0
"""Greatest round-trip time, milliseconds."""
MOST_POINTS = 10_000_000
"""Greatest number of points of a trace."""

Trace = tuple[ArrayLike, ArrayLike] | str | os.PathLike[str]
"""Times in seconds and rates in megabits a second, or the CSV file with both."""


@dataclass(frozen=True)
class Link:
    """A link to a server, over which HTTP fetches files.

    Raises
    ------
    ValueError, TypeError
        For rates of 0 or less, for a trace that falls in time, has rates below 0 or ends with 0, for shares of packets
        outside 0 to 0.5, and unless exactly one of `mbps` and `trace` is given.
    FormatError
        For a CSV file whose rows are not two numbers; OSError for one that cannot be read.
    """

    mbps: float | None = None
    """Rate in megabits (10⁶ bits) a second."""
    rtt_ms: float = 0.0
    """Time from a request to the first byte of its answer on an idle link, milliseconds."""
    loss: float = 0.0
    """Share of packets that are lost, at random; 0 to 0.5."""
    trace: Trace | None = None
    """Instead of `mbps`: times in seconds, from 0 on, and the rate in megabits a second from each of them on; as two
    arrays, or as a CSV file with a row for each time. The last rate stays."""
    http: int = 2
    """1: up to six connections with a request each. 2: one connection that all requests share."""
    handshake: float = 2.0
    """Round trips before a new connection carries a request: 1 for TCP, and 1 more for TLS 1.3."""

    def __post_init__(self) -> None:
        if (self.mbps is None) == (self.trace is None):
            raise ValueError("mbps: expected either it or a trace")
        if self.mbps is not None:
            object.__setattr__(self, "mbps", _rate(self.mbps))
        else:
            object.__setattr__(self, "trace", _checked(self.trace))
        object.__setattr__(self, "rtt_ms", check.within("rtt_ms", self.rtt_ms, 0.0, MOST_RTT))
        object.__setattr__(self, "loss", check.within("loss", self.loss, 0.0, 0.5))
        object.__setattr__(self, "http", check.integer("http", self.http, 1, 2))
        object.__setattr__(self, "handshake", check.within("handshake", self.handshake, 0.0, 10.0))

    @property
    def rtt(self) -> float:
        """Round-trip time in seconds."""
        return self.rtt_ms / 1e3

    def _clock(self) -> Clock:
        """Return what tells how long bytes take."""
        times, mbps = ((0.0,), (self.mbps,)) if self.mbps is not None else cast(Any, self.trace)
        return Clock(np.array(times, np.float64), np.array(mbps, np.float64) * (1e6 / 8.0))


class Clock:
    """How long bytes take over a link with a rate that changes."""

    def __init__(self, times: NDArray[np.float64], rates: NDArray[np.float64]) -> None:
        """Take times in seconds, the first of them 0, and the bytes a second from each of them on."""
        self._times, self._rates = times, rates
        self._counts = np.concatenate([[0.0], np.cumsum(np.diff(times) * rates[:-1])])
        """Bytes that could have come at each time."""

    def after(self, time: float, count: int) -> float:
        """Return when so many bytes have come that begin at a time."""
        if len(self._times) == 1:
            return time + count / float(self._rates[0])
        place = int(np.searchsorted(self._times, time, side="right")) - 1
        goal = float(self._counts[place] + (time - self._times[place]) * self._rates[place]) + count
        # Of equal counts the first, which ends a time with a rate above 0.
        place = max(int(np.searchsorted(self._counts, goal, side="left")) - 1, 0)
        return max(time, float(self._times[place] + (goal - self._counts[place]) / self._rates[place]))


def _rate(value: Any) -> float:
    rate = check.number("mbps", value)
    if rate == 0.0:
        raise ValueError("mbps: expected a positive number, got 0: nothing would ever arrive")
    if not 0.0 < rate <= MOST_MBPS:
        raise ValueError(f"mbps: expected a positive number up to {MOST_MBPS:g}, got {rate:g}")
    return rate


def _checked(trace: Any) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Times and rates of a trace; the first time becomes 0."""
    if isinstance(trace, str | os.PathLike):
        trace = _from_csv(trace)
    if not isinstance(trace, tuple | list) or len(trace) != 2:
        raise TypeError(f"trace: expected times and rates, or a CSV file, got {check.described(trace)}")
    times = check.array("trace", trace[0], columns=None, dtype=np.float64, finite=True)
    rates = check.array("trace", trace[1], columns=None, dtype=np.float64, finite=True)
    if times.ndim != 1 or times.shape != rates.shape or not 1 <= len(times) <= MOST_POINTS:
        raise ValueError(f"trace: expected as many times as rates, got shapes {times.shape} and {rates.shape}")
    if times[0] != 0.0:
        raise ValueError(f"trace: expected times from 0 on, got {times[0]:g} first")
    falls = np.flatnonzero(np.diff(times) <= 0.0)
    if len(falls):
        raise ValueError(f"trace: expected ascending times, got {times[falls[0] + 1]:g} after {times[falls[0]]:g}")
    wrong = np.flatnonzero((rates < 0.0) | (rates > MOST_MBPS))
    if len(wrong):
        raise ValueError(f"trace: expected rates from 0 to {MOST_MBPS:g}, got {rates[wrong[0]]:g}")
    if rates[-1] == 0.0:
        raise ValueError("trace: expected a last rate above 0, got 0: what is left then would never arrive")
    return tuple(times.tolist()), tuple(rates.tolist())


def _from_csv(path: Any) -> tuple[list[float], list[float]]:
    """Times and rates of a CSV file, which may begin with a row of names."""
    place = check.path("trace", path)
    with formats.guarded(str(place)):
        lines = [row for row in csv.reader(place.read_text(encoding="utf-8").splitlines()) if row]
        if lines and not _is_number(lines[0][0]):
            lines = lines[1:]
        for number, row in enumerate(lines, 1):
            if len(row) != 2 or not all(map(_is_number, row)):
                raise ValueError(f"row {number}: expected a time and a rate, got {check.shortened(','.join(row))}")
        return [float(row[0]) for row in lines], [float(row[1]) for row in lines]


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
