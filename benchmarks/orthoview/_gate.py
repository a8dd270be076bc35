"""File server over one link with a given rate, which stops when the allowed number of bytes has been sent."""

from __future__ import annotations

import math
import re
import select
import socket
import threading
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

from benchmarks.harness.files import Handler, Listener

PIECE = 4096
"""Bytes sent at once: small, so that rates and limits are exact."""


@dataclass
class Gate:
    """Counts and delays the bytes of file contents, which all share one link."""

    mbps: float = math.inf
    rtt_ms: float = 0.0
    allowed: float = math.inf
    """Total number of bytes allowed."""
    sent: int = 0
    requests: int = 0
    waiting: int = 0
    """Number of clients that wait until more bytes are allowed."""
    _free_time: float = 0.0
    _changed: threading.Condition = field(default_factory=threading.Condition)

    def allow(self, count: float) -> None:
        """Set the total number of bytes allowed from now on."""
        with self._changed:
            self.allowed = count
            self._changed.notify_all()

    def take(self, count: int, connection: socket.socket) -> int:
        """Wait until some of `count` bytes may be sent, and return their number; 0 if the client has gone."""
        with self._changed:
            self.waiting += 1
            while self.sent >= self.allowed and not _is_closed(connection):
                self._changed.wait(0.1)
            self.waiting -= 1
            if self.sent >= self.allowed:
                return 0
            count_sent = int(min(count, self.allowed - self.sent))
            self.sent += count_sent
            self._free_time = max(self._free_time, time.monotonic()) + count_sent * 8e-6 / self.mbps
            end_time = self._free_time
        time.sleep(max(end_time - time.monotonic(), 0.0))
        return count_sent


class _Handler(Handler):
    """Serves folders by the first part of the address; some of them through the gate."""

    def __init__(self, *request: Any, folders: Mapping[str, Path], gate: Gate, counted: frozenset[str]) -> None:
        self._folders, self._gate, self._counted = folders, gate, counted
        super().__init__(*request)

    def translate_path(self, path: str) -> str:
        name, _, name_in_folder = path.partition("?")[0].lstrip("/").partition("/")
        folder = self._folders.get(name)
        return str(folder / name_in_folder) if folder else ""

    def do_GET(self) -> None:  # noqa: N802
        path = Path(self.translate_path(self.path))
        if path.is_dir():
            path /= "index.html"
        if not path.is_file():
            self.send_error(404)
            return
        content, size = path.read_bytes(), path.stat().st_size
        requested_range = re.fullmatch(r"bytes=(\d*)-(\d*)", self.headers.get("Range", ""))
        if requested_range is not None:
            first, last = requested_range.groups()
            start = int(first) if first else max(size - int(last), 0)
            stop = min(int(last) + 1, size) if first and last else size
            content = content[start:stop]
        if self._is_counted:
            self._gate.requests += 1
            time.sleep(self._gate.rtt_ms / 1e3)
        self.send_response(200 if requested_range is None else 206)
        if requested_range is not None:
            self.send_header("Content-Range", f"bytes {start}-{stop - 1}/{size}")
        self.send_header("Content-Type", self.guess_type(path))
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self._send(content)

    @property
    def _is_counted(self) -> bool:
        return self.path.lstrip("/").partition("/")[0] in self._counted

    def _send(self, content: bytes) -> None:
        if not self._is_counted:
            self.wfile.write(content)
            return
        start = 0
        while start < len(content):
            sent = self._gate.take(min(PIECE, len(content) - start), self.connection)
            if sent == 0:
                self.close_connection = True
                return
            self.wfile.write(content[start : start + sent])
            start += sent


def _is_closed(connection: socket.socket) -> bool:
    """Whether the peer has closed a connection."""
    readable, _, _ = select.select([connection], [], [], 0)
    try:
        return bool(readable) and not connection.recv(1, socket.MSG_PEEK)
    except OSError:
        return True


@contextmanager
def serve(folders: Mapping[str, Path], gate: Gate, counted: frozenset[str]) -> Iterator[str]:
    """Serve folders by name, `counted` ones through the gate; yield the address."""
    with Listener(("127.0.0.1", 0), partial(_Handler, folders=folders, gate=gate, counted=counted)) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.05,))
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}/"
        finally:
            gate.allow(math.inf)
            server.shutdown()
            thread.join()
