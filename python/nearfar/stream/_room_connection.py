"""WebSocket connection of a room, using aiohttp."""

from __future__ import annotations

import asyncio
import importlib.util
import os
import ssl
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any
from urllib.parse import quote, urlsplit

from nearfar._base import check
from nearfar.stream import _room_frames as frames
from nearfar.stream._room_events import RoomError

if TYPE_CHECKING:
    import aiohttp

PING_SECONDS = 15.0
"""Seconds without data from the server until a ping. Without a reply within half this time the connection is broken."""

CLOSE_TIMEOUT = 5.0
"""Seconds to wait after bye until the server closes the connection, which frees the user's seat."""

MAX_MESSAGE_BYTES = 1 << 23
"""Greatest size of a message in bytes: enough for a user's full queue and one pose of each other user."""


@dataclass(frozen=True)
class Address:
    """Address of a room, and the certificates to trust."""

    url: str
    certificates: ssl.SSLContext | None

    @classmethod
    def build(cls, url: str, room: str, token: str | None, certificate: str | os.PathLike[str] | None) -> Address:
        """Build the address of a server's room; errors name the argument."""
        base = _check_server(url)
        query = "" if token is None else f"?token={quote(check.text('token', token), safe='.')}"
        name = quote(frames.room_name("room", room), safe="")
        return cls(f"{base}/rooms/{name}{query}", _load_certificates(certificate))


class Connection:
    """A WebSocket. Only `close` closes it: cancelling `receive` keeps it open and loses no message."""

    def __init__(self, address: Address) -> None:
        self._address = address
        self._session: aiohttp.ClientSession | None = None
        self._socket: aiohttp.ClientWebSocketResponse | None = None
        self._reader: asyncio.Task[aiohttp.WSMessage | None] | None = None

    async def open(self) -> None:
        """Connect; RoomError on failure, with the reason "gone" if a later attempt may succeed."""
        import aiohttp
        import yarl

        self._session = aiohttp.ClientSession()
        url, trusted = yarl.URL(self._address.url, encoded=True), self._address.certificates or True
        limits: Any = {"heartbeat": PING_SECONDS, "max_msg_size": MAX_MESSAGE_BYTES}
        try:
            self._socket = await self._session.ws_connect(url, ssl=trusted, **limits)
        except aiohttp.WSServerHandshakeError as error:
            raise _handshake_error(error.status) from None
        except aiohttp.ClientConnectorCertificateError:
            sentence = "expected a server with a trusted certificate; certificate= takes the file of a self-signed one"
            raise RoomError("unreached", sentence) from None
        except aiohttp.InvalidURL:
            raise RoomError("unreached", "expected a valid address of a server") from None
        except (aiohttp.ClientError, OSError) as error:
            raise RoomError("gone", check.one_line(f"the server cannot be reached: {error}", 300)) from None

    async def send(self, data: bytes) -> None:
        """Send a message; RoomError if the connection is broken."""
        if self._socket is None:
            raise broken_error()
        try:
            await self._socket.send_bytes(data)
        except (ConnectionError, RuntimeError):
            raise broken_error() from None

    async def receive(self) -> bytes | None:
        """Return the next message; None at the end."""
        import aiohttp

        if self._reader is None:
            self._reader = asyncio.create_task(self._receive())
        # aiohttp marks a WebSocket as closed when its receive() is cancelled, and then does not wait for Close.
        await asyncio.wait([self._reader])
        message, self._reader = self._reader.result(), None
        if message is not None and message.type is aiohttp.WSMsgType.TEXT:
            raise RoomError("frame", "expected a binary message from the server, got a text")
        return bytes(message.data) if message is not None and message.type is aiohttp.WSMsgType.BINARY else None

    async def close(self) -> None:
        """Send bye and wait until the server closes, at most CLOSE_TIMEOUT. Cancellation takes effect afterwards."""
        await complete(asyncio.create_task(self._close()))

    async def _receive(self) -> aiohttp.WSMessage | None:
        import aiohttp

        if self._socket is None:
            return None
        try:
            return await self._socket.receive()
        except (aiohttp.ClientError, ConnectionError, RuntimeError):
            # aiohttp answers pings during receive, which fails if the connection has ended meanwhile.
            return None

    async def _close(self) -> None:
        try:
            if self._socket is not None:
                with suppress(TimeoutError):
                    async with asyncio.timeout(CLOSE_TIMEOUT):
                        with suppress(RoomError):
                            await self.send(frames.bye())
                        await self._socket.close()
        finally:
            if self._reader is not None:
                self._reader.cancel()
            if self._session is not None:
                await self._session.close()


async def complete(task: asyncio.Task[None]) -> None:
    """Wait until a task has ended; a cancellation takes effect afterwards."""
    cancellation: asyncio.CancelledError | None = None
    while not task.done():
        try:
            await asyncio.wait([task])
        except asyncio.CancelledError as error:
            cancellation = error
    if cancellation is not None:
        raise cancellation
    if not task.cancelled():
        task.result()


def broken_error() -> RoomError:
    return RoomError("gone", "the connection broke off")


def require_aiohttp() -> None:
    """Raise ImportError with the command to install if aiohttp is missing."""
    if importlib.util.find_spec("aiohttp") is None:
        raise ImportError('rooms need aiohttp: pip install "nearfar[stream]"')


def _check_server(url: str) -> str:
    """Return the address of a server without a trailing slash."""
    try:
        parts = urlsplit(check.text("url", url))
        is_server = parts.scheme in ("http", "https", "ws", "wss") and bool(parts.hostname) and parts.port != 0
    except ValueError as error:
        if str(error).startswith("url:"):
            raise
        is_server = False
    if not is_server or parts.query or parts.fragment or not url.isprintable() or " " in url:
        got = check.shortened(url)
        raise ValueError(f"url: expected the address of a server, such as http://127.0.0.1:8080/, got {got}")
    return url.rstrip("/")


def _load_certificates(certificate: str | os.PathLike[str] | None) -> ssl.SSLContext | None:
    if certificate is None:
        return None
    path = check.path("certificate", certificate)
    try:
        return ssl.create_default_context(cafile=path)
    except ssl.SSLError:
        raise ValueError(f"certificate: expected a file of certificates in PEM, got {check.shortened(path)}") from None


def _handshake_error(status: int) -> RoomError:
    """Return the error for a response that refuses the WebSocket; the reason "gone" if a later attempt may succeed."""
    message = f"the server answered with code {status}"
    if 500 <= status < 600:
        return RoomError("gone", message)
    reasons = {403: "it has another host name", 404: "it has no rooms, or they are at another address"}
    return RoomError("unreached", f"{message}: {reasons.get(status, 'it opens no WebSocket')}")
