"""A link to a server, from which connections of rooms can be lost without the server being told."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress

_CHUNK = 1 << 16
_ROOM = b"GET /rooms/"


class LostLink:
    """Passes bytes on in both directions, until connections of rooms are lost."""

    def __init__(self, port: int) -> None:
        self._target, self._lost = port, threading.Event()
        self._sockets: list[socket.socket] = []
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port = int(self._listener.getsockname()[1])
        threading.Thread(target=self._listen, daemon=True).start()

    def lose(self) -> None:
        """Lose the connections of rooms that there are; those that come pass."""
        lost, self._lost = self._lost, threading.Event()
        lost.set()

    def close(self) -> None:
        """Close all connections."""
        for each in (self._listener, *self._sockets):
            with suppress(OSError):
                each.shutdown(socket.SHUT_RDWR)
            each.close()

    def _listen(self) -> None:
        with suppress(OSError):
            while True:
                near, _ = self._listener.accept()
                far = socket.create_connection(("127.0.0.1", self._target))
                self._sockets += [near, far]
                threading.Thread(target=self._send, args=(near, far, self._lost), daemon=True).start()
                threading.Thread(target=self._pass, args=(far, near), daemon=True).start()

    def _send(self, near: socket.socket, far: socket.socket, lost: threading.Event) -> None:
        is_room = False
        with suppress(OSError):
            while chunk := near.recv(_CHUNK):
                is_room = is_room or chunk.startswith(_ROOM)
                if not (is_room and lost.is_set()):
                    far.sendall(chunk)
        # The server keeps a lost connection until it has waited long enough.
        if not (is_room and lost.is_set()):
            _end(far)

    def _pass(self, far: socket.socket, near: socket.socket) -> None:
        with suppress(OSError):
            while chunk := far.recv(_CHUNK):
                near.sendall(chunk)
        _end(near)


def _end(to: socket.socket) -> None:
    with suppress(OSError):
        to.shutdown(socket.SHUT_WR)


@contextmanager
def lost_link(port: int) -> Iterator[LostLink]:
    """A link to a port of this machine."""
    link = LostLink(port)
    try:
        yield link
    finally:
        link.close()
