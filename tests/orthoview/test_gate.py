"""The server of the comparison of viewers: it stops after an allowed number of bytes."""

from __future__ import annotations

import socket
import threading
import urllib.request
from pathlib import Path
from urllib.parse import urlsplit

import pytest

from benchmarks.orthoview._gate import Gate, serve
from tests.support.waiting import wait_until

CONTENT = bytes(range(256)) * 100


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "file.bin").write_bytes(CONTENT)
    return tmp_path


def read(url: str, **headers: str) -> bytes:
    with urllib.request.urlopen(urllib.request.Request(url, headers=headers), timeout=60) as answer:
        return bytes(answer.read())


def wait_for(gate: Gate, count: int) -> None:
    """Wait until a number of bytes has been sent and a client waits for more."""
    wait_until(lambda: (gate.sent, gate.waiting) == (count, 1))


def test_at_most_the_allowed_bytes_are_sent(folder: Path) -> None:
    gate, found = Gate(allowed=5000), list[bytes]()
    with serve({"counted": folder, "free": folder}, gate, frozenset({"counted"})) as url:
        assert read(f"{url}free/file.bin") == CONTENT
        assert (gate.sent, gate.requests) == (0, 0)
        reader = threading.Thread(target=lambda: found.append(read(f"{url}counted/file.bin?v=1")))
        reader.start()
        wait_for(gate, 5000)
        assert not found
        gate.allow(7777)
        wait_for(gate, 7777)
        gate.allow(1e9)
        reader.join()
        assert found == [CONTENT]
        assert read(f"{url}counted/file.bin", Range="bytes=10-19") == CONTENT[10:20]
        assert read(f"{url}counted/file.bin", Range="bytes=-5") == CONTENT[-5:]
    assert (gate.sent, gate.requests) == (len(CONTENT) + 15, 3)


def test_a_disconnected_client_uses_no_bytes(folder: Path) -> None:
    gate = Gate(allowed=5000)
    with serve({"counted": folder}, gate, frozenset({"counted"})) as url:
        place = urlsplit(url)
        with socket.create_connection((place.hostname, place.port)) as client:
            client.sendall(b"GET /counted/file.bin HTTP/1.1\r\nHost: here\r\n\r\n")
            wait_for(gate, 5000)
        wait_until(lambda: gate.waiting == 0)  # The server has noticed.
        gate.allow(5000 + len(CONTENT))
        assert read(f"{url}counted/file.bin") == CONTENT
    assert gate.sent == 5000 + len(CONTENT)
