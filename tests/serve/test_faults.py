"""Intruders and faulty clients: nothing else is served, and other clients are not disturbed."""

from __future__ import annotations

import os
import shutil
import socket
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

import nearfar as nf
from nearfar.serve._limits import Limits
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support.asking import get, request
from tests.support.waiting import wait_until

SECRET = b"nobody may see this"
LARGE = 1 << 25
"""Size of a document that exceeds all socket buffers."""


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("faults") / "bundle"
    nf.stream.export(nf.datasets.room(), folder, center=(0.3, 1.6, 0.2), radii=[1.5, 3.0], face_size=64, samples=1)
    for outside in (folder / "secret", folder / "files" / "secret", folder.parent / "secret"):
        outside.write_bytes(SECRET)
    return folder


@pytest.fixture(scope="module")
def server(place: Path) -> Iterator[Server]:
    with Server.of_bundle(place) as running:
        yield running


@contextmanager
def large_server(**limits: Any) -> Iterator[Server]:
    """A server with a large document and the given limits."""
    site = Site({"files/large": bytes(LARGE), "files/other": b"other"})
    with Server({"": site}, limits=Limits(**limits)) as running:
        yield running


def connect(server: Server, receives: int | None = None) -> socket.socket:
    line = socket.socket()
    if receives is not None:
        line.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receives)
    line.settimeout(120)
    line.connect(("127.0.0.1", urlsplit(server.url).port))
    return line


def exchange(server: Server, text: bytes) -> bytes:
    """The server's complete response to a text, until it closes the connection."""
    with connect(server) as line:
        line.sendall(text)
        received = b""
        try:
            while more := line.recv(1 << 16):
                received += more
        except ConnectionResetError:
            pass
        return received


def count(server: Server, name: str) -> float:
    lines = get(server.url + "metrics").text.splitlines()
    return sum(float(line.rsplit(" ", 1)[1]) for line in lines if line.startswith(name))


@pytest.mark.parametrize(
    "target",
    [
        *(b"/../secret", b"/files/../secret", b"/files/../../secret", b"/./secret", b"/files/./secret"),
        *(b"/%2e%2e/secret", b"/files/%2e%2e/secret", b"/files/..%2fsecret", b"/%2e%2e%2fsecret"),
        *(b"/%252e%252e/secret", b"/files/%252e%252e%252fsecret", b"/%25252e%25252e/secret"),
        *(b"/..\\secret", b"/files\\..\\secret", b"/..%5csecret", b"/files%5csecret"),
        *(b"/secret%00", b"/files/secret%00.glb", b"/\x00secret", b"/files/secret\x00.glb"),
        *(b"//etc/passwd", b"/etc/passwd", b"///etc/passwd", b"file:///etc/passwd", b"C:/secret", b"/C:%5csecret"),
        *(b"/%c0%ae%c0%ae/secret", b"/%e0%80%ae%e0%80%ae/secret", b"/\xc0\xae\xc0\xae/secret", b"/%ff", b"/%zz", b"/%"),
        *(b"/secret", b"/files/secret", b"/secret?x=/manifest.json", b"/files", b"/files/", b"*", b":", b"."),
        *(b"http://localhost/../secret", b"http://evil.example/secret", b"/" + b"a/" * 9000 + b"secret"),
        *(b"/proc/self/environ", b"/files/%EF%BC%8E%EF%BC%8E/secret", b"/\xe2\x80\xae/secret", b"/manifest.json/", b""),
    ],
)
@pytest.mark.parametrize("method", [b"GET", b"HEAD"])
def test_other_paths_give_nothing(server: Server, target: bytes, method: bytes) -> None:
    answer = exchange(server, b"%b %b HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n" % (method, target))
    assert SECRET not in answer
    assert b"root:" not in answer
    # It is refused, or the connection is closed.
    assert not answer or answer.startswith(b"HTTP/1.1 4")
    assert get(server.url).status_code == 200


def copied(place: Path, folder: Path) -> tuple[Path, str]:
    """A copy of a bundle below a folder, and the name of one of its files."""
    shutil.copytree(place, folder / "bundle")
    return folder / "bundle", next(iter(nf.stream.open(place).files))


@pytest.mark.parametrize("linked", ["above", "above/bundle", "above/bundle/files", "file"])
def test_links_created_later_are_not_followed(place: Path, tmp_path: Path, linked: str) -> None:
    (tmp_path / "above").mkdir()
    bundle, name = copied(place, tmp_path / "above")
    replaced = bundle / name if linked == "file" else tmp_path / linked
    with Server.of_bundle(bundle) as server:
        assert get(server.url + name).status_code == 200
        replaced.rename(tmp_path / "elsewhere")
        replaced.symlink_to(tmp_path / "elsewhere")
        for method in ("GET", "HEAD"):
            assert request(method, server.url + name).status_code == 404
        replaced.unlink()
        (tmp_path / "elsewhere").rename(replaced)
        assert get(server.url + name).status_code == 200


def test_the_server_does_not_block_on_special_files(place: Path, tmp_path: Path) -> None:
    bundle, name = copied(place, tmp_path)
    with Server.of_bundle(bundle) as server:
        (bundle / name).unlink()
        os.mkfifo(bundle / name)
        assert get(server.url + name).status_code == 404
        (bundle / name).unlink()
        (bundle / name).mkdir()
        assert get(server.url + name).status_code == 404


def test_incomplete_requests_time_out_alone() -> None:
    halves = (b"", b"GET", b"GET / HTTP/1.1\r\nHost: localhost\r\n", b"GET /files/other HTTP/1.1\r\nHo")
    with large_server(header_seconds=1.0) as hasty:
        lines = []
        for text in 20 * halves:
            lines.append(connect(hasty))
            lines[-1].sendall(text)
        assert get(hasty.url + "files/other").content == b"other"
        for line in lines:
            # Its own limit ends it, with 408 or without a response.
            answer = line.recv(1 << 16)
            assert not answer or answer.startswith(b"HTTP/1.1 408")
            line.close()
        wait_until(lambda: count(hasty, "nearfar_connections ") == 1)


def test_slow_headers_time_out() -> None:
    with large_server(header_seconds=1.0) as hasty:
        with connect(hasty) as line:
            line.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n")

            def drip() -> bool:
                try:
                    line.sendall(b"X: y\r\n")
                except OSError:
                    return True
                return count(hasty, 'nearfar_connections_lost_total{reason="headers"}') == 1

            wait_until(drip)
        wait_until(lambda: count(hasty, "nearfar_connections ") == 1)


def test_clients_that_do_not_read_are_disconnected() -> None:
    with large_server(silent_seconds=0.5) as hasty:
        lines = [connect(hasty, receives=4096) for _ in range(10)]
        for line in lines:
            line.sendall(b"GET /files/large HTTP/1.1\r\nHost: localhost\r\n\r\n")
        assert get(hasty.url + "files/other").content == b"other"
        wait_until(lambda: count(hasty, 'nearfar_connections_lost_total{reason="silence"}') == len(lines))
        wait_until(lambda: count(hasty, "nearfar_connections ") == 1)
        for line in lines:
            line.close()


def test_a_slow_client_receives_everything() -> None:
    with large_server(silent_seconds=2.0) as hasty, connect(hasty, receives=4096) as line:
        line.sendall(
            b"GET /files/large HTTP/1.1\r\nHost: localhost\r\nRange: bytes=0-199999\r\nConnection: close\r\n\r\n"
        )
        received = b""
        while more := line.recv(5000):
            received += more
    head, _, body = received.partition(b"\r\n\r\n")
    assert head.startswith(b"HTTP/1.1 206")
    assert len(body) == 200_000


def test_vanished_clients_leave_nothing_behind() -> None:
    with large_server() as server:
        for taken in (0, 1, 70_000):
            lines = [connect(server, receives=4096) for _ in range(20)]
            for line in lines:
                line.sendall(b"GET /files/large HTTP/1.1\r\nHost: localhost\r\n\r\n")
                if taken:
                    line.recv(taken)
                # Reset, as if the machine had crashed.
                line.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
                line.close()
            assert get(server.url + "files/other").content == b"other"
        wait_until(lambda: count(server, "nearfar_connections ") == 1)
