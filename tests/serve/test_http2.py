"""Idle HTTP/2 connections are closed, and other clients are not disturbed."""

from __future__ import annotations

import socket
import ssl
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from urllib.parse import urlsplit

import h2.config
import h2.connection
import h2.events
import h2.settings
import httpx
import pytest

import nearfar as nf
from nearfar.serve._limits import Limits
from nearfar.serve._server import Certificate, Server
from nearfar.serve._site import Site
from tests.support.asking import get
from tests.support.waiting import wait_until


@pytest.fixture(scope="module")
def make_server(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Server]:
    """A factory of servers of a bundle with limits."""
    folder = tmp_path_factory.mktemp("serve")
    nf.stream.export(nf.datasets.room(), folder / "room", center=(0.3, 1.6, 0.2), radii=[1.5], face_size=64, samples=1)
    certificate = Certificate.self_signed(folder / "tls", ["localhost", "127.0.0.1"])
    return lambda **limits: Server(
        {"": Site.of_bundle(folder / "room")}, certificate=certificate, limits=Limits(**limits)
    )


@pytest.fixture(scope="module")
def idle(make_server: Callable[..., Server]) -> Iterator[Server]:
    """A server with short timeouts for idle clients, for the sum of both limits."""
    with make_server(header_seconds=2, silent_seconds=1) as running:
        yield running


@pytest.fixture(scope="module")
def silent(make_server: Callable[..., Server]) -> Iterator[Server]:
    """A server with short timeouts for clients that do not read."""
    with make_server(silent_seconds=1) as running:
        yield running


@contextmanager
def line(server: Server, window: int = 65535) -> Iterator[tuple[ssl.SSLSocket, h2.connection.H2Connection]]:
    """An HTTP/2 connection whose client accepts a number of bytes of each response at first."""
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
    context.set_alpn_protocols(["h2"])
    where = urlsplit(server.url)
    plain = socket.create_connection((where.hostname, where.port), timeout=60)
    with context.wrap_socket(plain, server_hostname="localhost") as encrypted:
        assert encrypted.selected_alpn_protocol() == "h2"
        state = h2.connection.H2Connection(h2.config.H2Configuration(header_encoding="utf-8"))
        asked = {h2.settings.SettingCodes.INITIAL_WINDOW_SIZE: window}
        state.local_settings = h2.settings.Settings(client=True, initial_values=asked)
        state.initiate_connection()
        encrypted.sendall(state.data_to_send())
        yield encrypted, state


def ask(encrypted: ssl.SSLSocket, state: h2.connection.H2Connection, path: str) -> None:
    where = [(":method", "GET"), (":scheme", "https"), (":authority", "localhost"), (":path", path)]
    state.send_headers(state.get_next_available_stream_id(), where, end_stream=True)
    encrypted.sendall(state.data_to_send())


def until_it_ends(encrypted: ssl.SSLSocket, state: h2.connection.H2Connection) -> list[h2.events.Event]:
    """Answer pings, but read nothing, until the server closes the connection."""
    events: list[h2.events.Event] = []
    try:
        while data := encrypted.recv(1 << 16):
            events += state.receive_data(data)
            encrypted.sendall(state.data_to_send())
    except (ConnectionError, ssl.SSLError):
        pass
    return events


def lost(server: Server, reason: str) -> float:
    for text in get(server.url + "metrics", verify=False).text.splitlines():
        if text.startswith(f'nearfar_connections_lost_total{{reason="{reason}"}}'):
            return float(text.rsplit(" ", 1)[1])
    return 0.0


def test_clients_with_unfinished_handshakes_are_disconnected(idle: Server) -> None:
    where = urlsplit(idle.url)
    with ExitStack() as stack:
        lines = [
            stack.enter_context(socket.create_connection((where.hostname, where.port), timeout=60)) for _ in range(3)
        ]
        for plain, begin in zip(lines, (b"", b"\x16\x03\x01\x02\x00\x01", b"GET / HT"), strict=True):
            plain.sendall(begin)
        for plain in lines:
            while plain.recv(1 << 16):
                pass


def test_a_client_without_requests_is_disconnected(idle: Server) -> None:
    before = lost(idle, "idle")
    with line(idle) as (encrypted, state):
        until_it_ends(encrypted, state)
    wait_until(lambda: lost(idle, "idle") == before + 1)


@pytest.mark.parametrize("window", [0, 30_000])
def test_a_client_that_reads_nothing_is_disconnected(silent: Server, window: int) -> None:
    before = lost(silent, "silence")
    with line(silent, window) as (encrypted, state):
        ask(encrypted, state, "/page.js")
        events = until_it_ends(encrypted, state)
    taken = sum(len(event.data) for event in events if isinstance(event, h2.events.DataReceived))
    assert any(isinstance(event, h2.events.ResponseReceived) for event in events)
    assert taken == window
    wait_until(lambda: lost(silent, "silence") == before + 1)


def test_a_client_with_incomplete_headers_is_disconnected(idle: Server) -> None:
    with line(idle) as (encrypted, _):
        # HEADERS of stream 1 without END_HEADERS, and no frame after it.
        encrypted.sendall(bytes.fromhex("000001 01 01 00000001 82"))
        assert encrypted.recv(1 << 16)
        while encrypted.recv(1 << 16):
            pass


def test_many_concurrent_responses_equal_the_files(make_server: Callable[..., Server]) -> None:
    with make_server() as server, httpx.Client(http2=True, verify=False, timeout=60) as asking:
        contents = {asking.get(server.url + "page.js").content for _ in range(20)}
        assert len(contents) == 1
        assert (
            asking.get(server.url + "x", headers={f"h{number}": "x" * 4000 for number in range(20)}).status_code == 431
        )
        assert asking.get(server.url + "page.js").content in contents
