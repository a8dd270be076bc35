"""File server that delays its responses as `nearfar.stream.Link` describes: handshakes, round trips, windows, rate."""

from __future__ import annotations

import re
import threading
import time
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import nearfar as nf
from benchmarks.harness.files import Handler, Listener
from nearfar.stream._transport import INITIAL_WINDOW, PIECE_BYTES


class Line:
    """The link that all connections share; counts requests."""

    def __init__(self, link: nf.stream.Link) -> None:
        if link.mbps is None or link.loss > 0.0:
            raise ValueError("link: expected a constant rate without losses")
        self.link, self.requests = link, 0
        self._rate = link.mbps * 1e6 / 8.0
        self._lock, self._free_time = threading.Lock(), 0.0

    def count(self) -> None:
        with self._lock:
            self.requests += 1

    def reserve(self, size: int) -> tuple[float, float]:
        """Return the begin and the end of the transfer of some bytes."""
        with self._lock:
            begin = max(self._free_time, time.monotonic())
            self._free_time = begin + size / self._rate
            return begin, self._free_time


class _DelayedHandler(Handler):
    """Serves files and single ranges of them; an instance is a connection in slow start."""

    def __init__(self, *request: Any, line: Line, directory: str) -> None:
        self._line = line
        super().__init__(*request, directory=directory)

    def setup(self) -> None:
        super().setup()
        self._ready = time.monotonic() + self._line.link.handshake * self._line.link.rtt
        self._credits = deque([(self._ready, INITIAL_WINDOW)])

    def do_GET(self) -> None:  # noqa: N802
        arrival = max(self._ready, time.monotonic()) + self._line.link.rtt
        self._line.count()
        path = Path(self.translate_path(self.path))
        content = path.read_bytes() if path.is_file() else b""
        wanted = re.fullmatch(r"bytes=(\d+)-(\d+)", self.headers.get("Range", ""))
        part = content[int(wanted[1]) : int(wanted[2]) + 1] if wanted else content
        _sleep_until(arrival)
        self.send_response(404 if not path.is_file() else 206 if wanted else 200)
        self.send_header("Content-Length", str(len(part)))
        self.end_headers()
        start = 0
        while start < len(part):
            size = self._take_credit(min(PIECE_BYTES, len(part) - start))
            begin, end = self._line.reserve(size)
            _sleep_until(end)
            self.wfile.write(part[start : start + size])
            self._credits.append((begin + self._line.link.rtt, 2 * size))
            start += size

    def _take_credit(self, size: int) -> int:
        """Wait for the congestion window to have room; return the number of bytes that may be sent, at most `size`."""
        moment, count = self._credits.popleft()
        _sleep_until(moment)
        if count > size:
            self._credits.appendleft((moment, count - size))
        return min(count, size)


def _sleep_until(moment: float) -> None:
    time.sleep(max(moment - time.monotonic(), 0.0))


@contextmanager
def serve_over(link: nf.stream.Link, folder: Path) -> Iterator[tuple[str, Line]]:
    """Serve a folder over a link; yield its address and the line."""
    line = Line(link)
    with Listener(("127.0.0.1", 0), partial(_DelayedHandler, line=line, directory=str(folder))) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.05,))
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}", line
        finally:
            server.shutdown()
            thread.join()
