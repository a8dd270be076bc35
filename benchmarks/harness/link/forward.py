"""Process that carries packets between two TUN devices; a link starts it.

It answers each line on its standard input with its counts as a line of JSON, and ends when its input is closed, which
also happens if the parent process dies. The devices, and with them the link, end with it.
"""

from __future__ import annotations

import json
import os
import select
import sys
import time
from contextlib import suppress
from dataclasses import asdict
from typing import Any

from benchmarks.harness.link.namespace import ADDRESSES, open_device
from benchmarks.harness.link.path import Path
from nearfar.stream import Link

MTU = 1500
PRIORITY = 50
"""Real-time priority; measured pages may run with a lower one."""
BATCH = 64
"""Number of packets read in a row before arrived ones are written."""


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
