"""Process that carries packets between two TUN devices; a link starts it.

It answers each line on its standard input with its counts as a line of JSON, and ends when its input is closed, which
also happens if the parent process dies. The devices, and with them the link, end with it.
"""

from __future__ import annotations

import json
import os
import random
import select
import sys
import time
from collections import deque
from contextlib import suppress
from dataclasses import asdict, dataclass
from typing import Any

from benchmarks.harness.link.namespace import ADDRESSES, open_device
from nearfar.stream import Link
from nearfar.stream._link import Clock

MTU = 1500
PRIORITY = 50
"""Real-time priority; measured pages may run with a lower one."""
BATCH = 64
"""Number of packets read in a row before arrived ones are written."""


@dataclass
class Counts:
    """Packets of one direction."""

    taken: int = 0
    """Packets sent by a side."""
    overflowed: int = 0
    """Packets dropped because the queue was full."""
    lost: int = 0
    """Packets lost behind the bottleneck."""
    delivered: int = 0
    delivered_bytes: int = 0
    """Bytes with all headers from IP on."""


class Path:
    """Packets in transit, on a clock that the caller reads. Packets stay in order."""

    def __init__(self, clock: Clock, *, delay: float, loss: float, queue: int, seed: int) -> None:
        """Store the clock of the rate, the delay in seconds, the share lost, and the size of the queue in bytes."""
        self._clock, self._delay, self._loss, self._max_queued = clock, delay, loss, queue
        self._random = random.Random(seed).random
        self._waiting = deque[tuple[float, int]]()
        """Times at which packets leave the bottleneck, and their bytes."""
        self._queued = 0
        self._last_departure = 0.0
        self._flying = deque[tuple[float, bytes]]()
        self.counts = Counts()

    def take(self, now: float, packet: bytes) -> None:
        """Accept a packet that a side sends."""
        counts, waiting, size = self.counts, self._waiting, len(packet)
        counts.taken += 1
        while waiting and waiting[0][0] <= now:
            self._queued -= waiting.popleft()[1]
        if self._queued + size > self._max_queued:
            counts.overflowed += 1
            return
        self._last_departure = self._clock.end_of_transfer(max(now, self._last_departure), size)
        self._queued += size
        waiting.append((self._last_departure, size))
        if self._random() < self._loss:
            counts.lost += 1
            return
        self._flying.append((self._last_departure + self._delay, packet))

    def next(self) -> float | None:
        """Time at which the next packet arrives at the other side."""
        return self._flying[0][0] if self._flying else None

    def due(self, now: float) -> list[bytes]:
        """Remove and return the packets that have arrived."""
        flying, arrived = self._flying, list[bytes]()
        while flying and flying[0][0] <= now:
            arrived.append(flying.popleft()[1])
        self.counts.delivered += len(arrived)
        self.counts.delivered_bytes += sum(map(len, arrived))
        return arrived


class Forwarder:
    """Forwards packets of both sides."""

    def __init__(self, devices: list[int], paths: list[Path]) -> None:
        """Store the devices of both sides and the paths that begin at each."""
        self._devices = devices
        self._paths = dict(zip(devices, paths, strict=True))
        self._opposite = dict(zip(devices, reversed(devices), strict=True))
        self._start: float | None = None
        self._late = 0.0

    def run(self, control: int, answers: Any) -> None:
        """Forward packets until the control is closed."""
        watched = [*self._devices, control]
        while True:
            for device in select.select(watched, [], [], self._deliver())[0]:
                if device != control:
                    self._take(device)
                elif not os.read(control, 4096):
                    return
                else:
                    print(json.dumps(self._counts()), file=answers, flush=True)

    def _seconds(self) -> float:
        """Seconds since the first packet, with which a trace begins."""
        now = time.monotonic()
        if self._start is None:
            self._start = now
        return now - self._start

    def _deliver(self) -> float | None:
        """Write arrived packets; return the seconds until the next packet arrives, None if there is none."""
        if self._start is None:
            return None
        nearest: float | None = None
        for device, path in self._paths.items():
            now, time_due = self._seconds(), path.next()
            if time_due is not None and time_due <= now:
                self._late = max(self._late, now - time_due)
                for packet in path.due(now):
                    # A side whose device is down loses its packets.
                    with suppress(OSError):
                        os.write(self._opposite[device], packet)
                time_due = path.next()
            if time_due is not None:
                nearest = time_due if nearest is None else min(nearest, time_due)
        return None if nearest is None else max(nearest - self._seconds(), 0.0)

    def _take(self, device: int) -> None:
        path, now = self._paths[device], self._seconds()
        with suppress(BlockingIOError):
            for _ in range(BATCH):
                path.take(now, os.read(device, MTU + 64))

    def _counts(self) -> dict[str, Any]:
        """Counts of both directions, the greatest delay of a write after its due time, and seconds of CPU time."""
        down, up = (asdict(path.counts) for path in self._paths.values())
        return {"down": down, "up": up, "latest": self._late, "cpu": time.process_time()}


def main() -> None:
    settings = json.loads(sys.argv[1])
    link = Link(**settings["link"])
    # Real-time priority keeps packets on time on a busy machine.
    with suppress(OSError):
        os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(PRIORITY))
    try:
        devices = [
            open_device(namespace, address, mtu=MTU, congestion=settings["congestion"])
            for namespace, address in zip(settings["namespaces"], ADDRESSES, strict=True)
        ]
    except OSError as error:
        print(json.dumps({"problem": str(error)}), flush=True)
        return
    paths = [
        Path(link._clock(), delay=link.rtt / 2.0, loss=link.loss, queue=settings["queue"], seed=settings["seed"] + side)
        for side in range(2)
    ]
    print(json.dumps({}), flush=True)
    Forwarder(devices, paths).run(sys.stdin.fileno(), sys.stdout)


if __name__ == "__main__":
    main()
