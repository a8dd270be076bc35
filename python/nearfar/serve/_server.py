"""A server of sites; its work is done in Rust, in threads of its own."""

from __future__ import annotations

import errno
import os
import weakref
from collections.abc import Mapping
from types import TracebackType

from nearfar import _core
from nearfar._base import check
from nearfar.serve._site import Site
from nearfar.view._page import POLICY

LOCAL = "127.0.0.1"
NAMES = (LOCAL, "localhost")
"""Names by which browsers may call a server on this machine: another name is another site's that points here."""

HEADERS = (
    ("content-security-policy", POLICY),
    ("x-content-type-options", "nosniff"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-resource-policy", "same-origin"),
    ("permissions-policy", "xr-spatial-tracking=(self)"),
)
"""Headers of all answers."""


class Server:
    """Serves sites over HTTP from now on; use it in a `with` block, or `close` it.

    Parameters
    ----------
    sites
        Sites by the first part of their paths; a single one may have the empty name.
    port
        Port on 127.0.0.1 to listen on; 0 for any that is free.
    connections
        Connections at the same time; others wait.

    Raises
    ------
    OSError
        If the port is taken, or a cache cannot be opened.
    """

    def __init__(self, sites: Mapping[str, Site], *, port: int = 0, connections: int = 1024) -> None:
        number = check.integer("port", port, 0, 65535)
        most = check.integer("connections", connections, 1, 65536)
        listed = [(name, site.documents(), site.demand) for name, site in sites.items()]
        try:
            self._server = _core.Server(
                listed,
                host=LOCAL,
                port=number,
                hosts=list(NAMES),
                headers=list(HEADERS),
                connections=most,
                header_seconds=30.0,
                silent_seconds=60.0,
                grace_seconds=3.0,
            )
        except OSError as error:
            if error.errno != errno.EADDRINUSE:
                raise
            raise OSError(
                error.errno, f"{os.strerror(error.errno)}: choose another port", f"{LOCAL}:{number}"
            ) from None
        # Threads that make regions need the interpreter.
        self._end = weakref.finalize(self, self._server.close)

    @classmethod
    def of_bundle(cls, path: str | os.PathLike[str], *, port: int = 0) -> Server:
        """Serve one bundle or reduced scene; errors also as `stream.open` and `ReducedScene.load` raise them."""
        check.integer("port", port, 0, 65535)
        return cls({"": Site.of_bundle(path)}, port=port)

    @property
    def url(self) -> str:
        """Address of the server."""
        return f"http://{LOCAL}:{self._server.port}/"

    def close(self) -> None:
        """Stop; answers that are being sent get a few seconds to end."""
        self._end()

    def __enter__(self) -> Server:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"Server({self.url!r})"
