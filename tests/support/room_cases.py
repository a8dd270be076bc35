"""Servers with rooms, connections that break, and helpers for tests of users."""

from __future__ import annotations

import asyncio
import itertools
from collections.abc import AsyncIterator, Callable, Coroutine, Iterable
from contextlib import asynccontextmanager
from typing import Any, TypeVar
from urllib.parse import urlsplit

import nearfar as nf
from nearfar.serve._limits import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from nearfar.stream.client import Room

Event = TypeVar("Event")
Result = TypeVar("Result")

HANGS = 60.0
"""Timeout in seconds of a test that waits for an event."""

KEY = bytes(range(32))

REST = (0.0, 0.0, 0.0, 1.0)
"""The identity quaternion."""


def server(rooms: Rooms | None = None, **settings: Any) -> Server:
    """A server with rooms and a site of one document."""
    return Server({"": Site({"a.txt": b"a"}, has_page=False)}, rooms=rooms or Rooms(), **settings)


def run(script: Coroutine[Any, Any, Result]) -> Result:
    """Run a script of users; TimeoutError if it hangs."""

    async def whole() -> Result:
        async with asyncio.timeout(HANGS):
            return await script

    return asyncio.run(whole())


async def until(room: Room, kind: type[Event], is_wanted: Callable[[Event], bool] = lambda _: True) -> Event:
    """The next matching event of a kind."""
    async for event in room:
        if isinstance(event, kind) and is_wanted(event):
            return event
    raise AssertionError(f"the room ended before {kind.__name__}")


async def some(room: Room, kind: type[Event], count: int) -> list[Event]:
    """The next events of a kind."""
    return [await until(room, kind) for _ in range(count)]


async def is_refused(server: Server, **settings: Any) -> nf.stream.client.RoomError:
    """Return the error of a join that must fail."""
    try:
        async with nf.stream.client.join(server.url, **{"room": "hall", **settings}):
            pass
    except nf.stream.client.RoomError as error:
        return error
    raise AssertionError("expected a refusal")


class Wire:
    """A connection to a server that can be cut, even within a message; data to the server is delayed."""

    def __init__(self, url: str, delay: float = 0.0) -> None:
        self._delay = delay
        self._writers: list[asyncio.StreamWriter] = []
        self._tasks: list[asyncio.Task[None]] = []
        self.left: int | None = None
        """Bytes still passed from the server before the cut; None for no limit."""
        self.passes = asyncio.Event()
        """While cleared, no data to the server is read."""
        self.passes.set()
        self.url = ""
        self.lead_to(url)

    def lead_to(self, url: str | None) -> None:
        """Route new connections to a server, or nowhere."""
        self._port = None if url is None else urlsplit(url).port

    async def _connected(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        if self._port is None:
            writer.transport.abort()
            return
        onward, back = await asyncio.open_connection("127.0.0.1", self._port)
        self._writers += [writer, back]
        self._tasks += [
            asyncio.create_task(self._pass(reader, back, is_counted=False)),
            asyncio.create_task(self._pass(onward, writer, is_counted=True)),
        ]

    async def _pass(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, *, is_counted: bool) -> None:
        try:
            while data := await reader.read(1 << 16):
                if not is_counted:
                    await asyncio.sleep(self._delay)
                    await self.passes.wait()
                if is_counted and self.left is not None:
                    data, self.left = data[: self.left], self.left - len(data)
                    if self.left <= 0:
                        writer.write(data)
                        await writer.drain()
                        self.left = None
                        self.cut()
                        return
                writer.write(data)
            writer.write_eof()
        except OSError:
            writer.transport.abort()

    def cut(self) -> None:
        """Break all connections."""
        self.passes.set()
        for writer in self._writers:
            writer.transport.abort()
        self._writers.clear()

    async def end(self) -> None:
        """Wait for all relay tasks."""
        self.cut()
        await asyncio.gather(*self._tasks, return_exceptions=True)


@asynccontextmanager
async def wire(url: str, delay: float = 0.0) -> AsyncIterator[Wire]:
    """A connection to a server through another port, on which data to the server is delayed by some seconds."""
    made = Wire(url, delay)
    listening = await asyncio.start_server(made._connected, "127.0.0.1", 0)
    try:
        made.url = f"http://127.0.0.1:{listening.sockets[0].getsockname()[1]}/"
        yield made
    finally:
        listening.close()
        await made.end()


@asynccontextmanager
async def answers(messages: Iterable[bytes]) -> AsyncIterator[str]:
    """A server that admits everybody, as user 1 in an empty room, and sends these messages."""
    from aiohttp import web

    async def enter(request: web.Request) -> web.WebSocketResponse:
        socket = web.WebSocketResponse()
        await socket.prepare(request)
        await socket.receive()
        for message in itertools.chain([bytes.fromhex("8105000100000000")], messages):
            await socket.send_bytes(message)
        await socket.receive()
        return socket

    application = web.Application()
    application.router.add_get("/rooms/hall", enter)
    runner = web.AppRunner(application)
    await runner.setup()
    try:
        site = web.TCPSite(runner, "127.0.0.1", 0)
        await site.start()
        yield f"http://127.0.0.1:{runner.addresses[0][1]}/"
    finally:
        await runner.cleanup()
