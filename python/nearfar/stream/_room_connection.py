"""WebSocket connection of a room, using aiohttp."""

from __future__ import annotations

import asyncio
import importlib.util
import os
import ssl
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING
from urllib.parse import quote, urlsplit

from nearfar._base import check
from nearfar.stream import _room_frames as frames, _room_names
from nearfar.stream._room_events import RoomError

if TYPE_CHECKING:
    import aiohttp

HEARTBEAT = 15.0
"""Seconds without data from the server before a ping; without a reply after half of it the connection is broken."""

CLOSING = 5.0
"""Timeout for the server to close after bye, seconds. When it closes, the user's seat is free."""

MAX_MESSAGE = 1 << 23
"""Greatest size of a message in bytes: a user's full queue and one pose of each other user."""

_AGAIN = range(500, 600)
"""HTTP status codes of a server, or a proxy, that may succeed later."""


@dataclass(frozen=True)
class Address:
    """Address of a room, and the certificates to trust."""

    url: str
    certificates: ssl.SSLContext | None

    @classmethod
    def build(cls, url: str, room: str, token: str | None, certificate: str | os.PathLike[str] | None) -> Address:
        """Build the address of a server's room; errors name the argument."""
        base = _server(url)
        query = "" if token is None else f"?token={quote(check.text('token', token), safe='.')}"
        name = quote(_room_names.room("room", room), safe="")
        return cls(f"{base}/rooms/{name}{query}", _trusted(certificate))


class Connection:
    """A WebSocket, closed by `close`. Cancelling `receive` keeps it open and loses no message."""

    def __init__(self, address: Address) -> None:
        self._address = address
        self._session: aiohttp.ClientSession | None = None
        self._socket: aiohttp.ClientWebSocketResponse | None = None
        self._receiving: asyncio.Task[aiohttp.WSMessage | None] | None = None

    async def open(self) -> None:
        """Connect; RoomError on failure, with the reason "gone" if a later attempt may succeed."""
        import aiohttp
        import yarl

        self._session = aiohttp.ClientSession()
        trusted: ssl.SSLContext | bool = self._address.certificates or True
        try:
            self._socket = await self._session.ws_connect(
                yarl.URL(self._address.url, encoded=True), heartbeat=HEARTBEAT, max_msg_size=MAX_MESSAGE, ssl=trusted
            )
        except aiohttp.WSServerHandshakeError as error:
            raise _unwelcome(error.status) from None
        except aiohttp.ClientConnectorCertificateError:
            sentence = "expected a server whose certificate is known; certificate= takes that of one that signs itself"
            raise RoomError("unreached", sentence) from None
        except aiohttp.InvalidURL:
            raise RoomError("unreached", "expected the address of a server that there can be") from None
        except (aiohttp.ClientError, OSError) as error:
            raise RoomError("gone", check.one_line(f"the server cannot be reached: {error}", 300)) from None

    async def send(self, data: bytes) -> None:
        """Send a message; RoomError if the connection is broken."""
        if self._socket is None:
            raise broken()
        try:
            await self._socket.send_bytes(data)
        except (ConnectionError, RuntimeError):
            raise broken() from None

    async def receive(self) -> bytes | None:
        """Return the next message; None at the end."""
        import aiohttp

        if self._receiving is None:
            self._receiving = asyncio.create_task(self._receive())
        # aiohttp marks a WebSocket as closed when its receive() is cancelled, and then does not wait for Close.
        await asyncio.wait([self._receiving])
        message, self._receiving = self._receiving.result(), None
        if message is None:
            return None
        if message.type is aiohttp.WSMsgType.BINARY:
            return bytes(message.data)
        if message.type is aiohttp.WSMsgType.TEXT:
            raise RoomError("frame", "the server sent what is no frame: a text")
        return None

    async def close(self) -> None:
        """Send bye and wait until the server closes, at most CLOSING seconds. Cancellation takes effect afterwards."""
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
                    async with asyncio.timeout(CLOSING):
                        with suppress(RoomError):
                            await self.send(frames.bye())
                        await self._socket.close()
        finally:
            if self._receiving is not None:
                self._receiving.cancel()
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


def broken() -> RoomError:
    """Return the error for a broken connection."""
    return RoomError("gone", "the connection broke off")


def require() -> None:
    """Raise ImportError with the command to install if aiohttp is missing."""
    if importlib.util.find_spec("aiohttp") is None:
        raise ImportError('rooms need aiohttp: pip install "nearfar[stream]"')


def _server(url: str) -> str:
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


def _trusted(certificate: str | os.PathLike[str] | None) -> ssl.SSLContext | None:
    if certificate is None:
        return None
    path = check.path("certificate", certificate)
    try:
        return ssl.create_default_context(cafile=path)
    except ssl.SSLError:
        raise ValueError(f"certificate: expected a file of certificates in PEM, got {check.shortened(path)}") from None


def _unwelcome(code: int) -> RoomError:
    """Return the error for a response that refuses the WebSocket."""
    if code in _AGAIN:
        return RoomError("gone", f"the server answered with code {code}")
    why = {
        403: "it is not called by this name",
        404: "it has no rooms, or they are not at this address",
    }.get(code, "it makes no WebSocket")
    return RoomError("unreached", f"the server answered with code {code}: {why}")
