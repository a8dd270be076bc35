"""Links between a server and a client: rate, delay and loss, and their use by HTTP."""

from __future__ import annotations

import csv
import os
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check, formats

SEGMENT = 1460
"""Payload bytes of a TCP segment on Ethernet."""
MAX_MBPS = 1e6
"""Greatest rate, megabits per second."""
MAX_RTT = 60_000.0
"""Greatest round-trip time, milliseconds."""
MAX_POINTS = 10_000_000
"""Greatest number of points of a trace."""

Trace = tuple[ArrayLike, ArrayLike] | str | os.PathLike[str]
"""Times in seconds and rates in megabits per second, or the path of a CSV file with both."""


@dataclass(frozen=True)
class Link:
    """A link to a server, over which HTTP fetches files.

    ValueError and TypeError for rates of 0 or less; for a trace whose times fall, with rates below 0 or a last rate of
    0; for a loss outside 0 to 0.5; and unless exactly one of `mbps` and `trace` is given. FormatError for a CSV file
    whose rows are not two numbers; OSError for one that cannot be read.
    """

    mbps: float | None = None
    """Rate in megabits (10⁶ bits) per second."""
    rtt_ms: float = 0.0
    """Time from a request to the first byte of the response on an idle link, milliseconds."""
    loss: float = 0.0
    """Share of packets that are lost at random, 0 to 0.5."""
    trace: Trace | None = None
    """Alternative to `mbps`: times in seconds, from 0 on, and the rate in megabits per second from each time on; as
    two arrays, or as a CSV file with a row for each time. The last rate stays."""
    http: int = 2
    """HTTP version. 1: up to six connections with one request each. 2: one connection that all requests share."""
    handshake: float = 2.0
    """Round trips before a new connection carries a request: 1 for TCP, and 1 more for TLS 1.3."""

    def __post_init__(self) -> None:
        if (self.mbps is None) == (self.trace is None):
            raise ValueError("mbps: expected either it or a trace")
        if self.mbps is not None:
            object.__setattr__(self, "mbps", _rate(self.mbps))
        else:
            object.__setattr__(self, "trace", _parse_trace(self.trace))
        object.__setattr__(self, "rtt_ms", check.in_range("rtt_ms", self.rtt_ms, 0.0, MAX_RTT))
        object.__setattr__(self, "loss", check.in_range("loss", self.loss, 0.0, 0.5))
        object.__setattr__(self, "http", check.integer("http", self.http, 1, 2))
        object.__setattr__(self, "handshake", check.in_range("handshake", self.handshake, 0.0, 10.0))

    @property
    def rtt(self) -> float:
        """Round-trip time in seconds."""
        return self.rtt_ms / 1e3

    def _clock(self) -> Clock:
        """Return the clock that computes transfer times."""
        times, mbps = ((0.0,), (self.mbps,)) if self.mbps is not None else cast(Any, self.trace)
        return Clock(np.array(times, np.float64), np.array(mbps, np.float64) * (1e6 / 8.0))


class Clock:
    """Transfer times over a link whose rate changes."""

    def __init__(self, times: NDArray[np.float64], rates: NDArray[np.float64]) -> None:
        """Take times in seconds, starting at 0, and the rate in bytes per second from each time on."""
        self._times, self._rates = times, rates
        self._counts = np.concatenate([[0.0], np.cumsum(np.diff(times) * rates[:-1])])
        """Bytes that can have been transferred up to each time."""

    def end_of_transfer(self, time: float, count: int) -> float:
        """Return the end of a transfer of `count` bytes that starts at `time`."""
        if len(self._times) == 1:
            return time + count / float(self._rates[0])
        index = int(np.searchsorted(self._times, time, side="right")) - 1
        goal = float(self._counts[index] + (time - self._times[index]) * self._rates[index]) + count
        # Equal counts mark a pause; the first of them ends an interval with a rate above 0.
        index = max(int(np.searchsorted(self._counts, goal, side="left")) - 1, 0)
        return max(time, float(self._times[index] + (goal - self._counts[index]) / self._rates[index]))


def check_ascending(name: str, times: NDArray[np.float64]) -> None:
    """Raise ValueError unless times ascend."""
    drops = np.flatnonzero(np.diff(times) <= 0.0)
    if len(drops):
        raise ValueError(f"{name}: expected ascending times, got {times[drops[0] + 1]:g} after {times[drops[0]]:g}")


def _rate(value: Any) -> float:
    rate = check.number("mbps", value)
    if rate == 0.0:
        raise ValueError("mbps: expected a positive number, got 0: nothing would ever arrive")
    if not 0.0 < rate <= MAX_MBPS:
        raise ValueError(f"mbps: expected a positive number up to {MAX_MBPS:g}, got {rate:g}")
    return rate


def _parse_trace(trace: Any) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Check the times and rates of a trace, whose first time must be 0."""
    if isinstance(trace, str | os.PathLike):
        trace = _from_csv(trace)
    if not isinstance(trace, tuple | list) or len(trace) != 2:
        raise TypeError(f"trace: expected times and rates, or a CSV file, got {check.type_and_value(trace)}")
    times = check.array("trace", trace[0], columns=None, dtype=np.float64, finite=True)
    rates = check.array("trace", trace[1], columns=None, dtype=np.float64, finite=True)
    if times.ndim != 1 or times.shape != rates.shape or not 1 <= len(times) <= MAX_POINTS:
        raise ValueError(f"trace: expected as many times as rates, got shapes {times.shape} and {rates.shape}")
    if times[0] != 0.0:
        raise ValueError(f"trace: expected times from 0 on, got {times[0]:g} first")
    check_ascending("trace", times)
    wrong_rows = np.flatnonzero((rates < 0.0) | (rates > MAX_MBPS))
    if len(wrong_rows):
        raise ValueError(f"trace: expected rates from 0 to {MAX_MBPS:g}, got {rates[wrong_rows[0]]:g}")
    if rates[-1] == 0.0:
        raise ValueError("trace: expected a last rate above 0, got 0: remaining bytes would never arrive")
    return tuple(times.tolist()), tuple(rates.tolist())


def _from_csv(path: Any) -> tuple[list[float], list[float]]:
    """Read times and rates from a CSV file, which may begin with a header row."""
    file = check.path("trace", path)
    with formats.guarded(str(file)):
        rows = [row for row in csv.reader(file.read_text(encoding="utf-8").splitlines()) if row]
        if rows and not _is_number(rows[0][0]):
            rows = rows[1:]
        for number, row in enumerate(rows, 1):
            if len(row) != 2 or not all(map(_is_number, row)):
                raise ValueError(f"row {number}: expected a time and a rate, got {check.shortened(','.join(row))}")
        return [float(row[0]) for row in rows], [float(row[1]) for row in rows]


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
