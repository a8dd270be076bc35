"""A server on this machine for the page and one bundle. It answers with nothing but their files."""

from __future__ import annotations

import hashlib
import os
import threading
from collections.abc import Mapping
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from types import TracebackType
from typing import Any
from urllib.parse import unquote, urlsplit

from nearfar._base import check
from nearfar.stream import _store
from nearfar.view._content import Read, opened
from nearfar.view._page import INDEX, POLICY, TYPES, page_files

HOST = "127.0.0.1"
NAMES = {HOST, "localhost"}
"""Names by which browsers may call the server: another name is another site's that points here."""

FOREVER = "public, max-age=31536000, immutable"
"""For files that are named by their content."""


class Server:
    """Serves the page and a bundle on 127.0.0.1, in threads of its own; use it in a `with` block, or `close` it.

    Parameters
    ----------
    path
        The folder of a bundle or of a reduced scene, its JSON document, or the URL of a bundle.
    port
        Port to listen on; 0 for any that is free.

    Raises
    ------
    FormatError, ValueError, OSError
        As `nearfar.stream.open` and `ReducedScene.load` do, and if the port is taken.
    """

    def __init__(self, path: str | os.PathLike[str], *, port: int = 0) -> None:
        number = check.integer("port", port, 0, 65535)
        self._files = _served(path)
        handler = type("Handler", (_Handler,), {"files": self._files})
        try:
            self._server = _Listener((HOST, number), handler)
        except OSError as error:
            raise OSError(error.errno, f"{error.strerror}: choose another port", f"{HOST}:{number}") from None
        self._thread = threading.Thread(target=self._server.serve_forever, name="nearfar view", daemon=True)
        self._thread.start()

    @property
    def url(self) -> str:
        """Address of the page."""
        return f"http://{HOST}:{self._server.server_port}/"

    def close(self) -> None:
        """Stop listening."""
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()

    def __enter__(self) -> Server:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"Server({self.url!r}, {len(self._files)} files)"


def _served(path: str | os.PathLike[str]) -> Mapping[str, Read]:
    """Readers of the files that are served, by their paths."""

    def constant(content: bytes) -> Read:
        return lambda: content

    return {
        **opened(path),
        **{name: constant(content) for name, content in page_files().items()},
        "": constant(page_files()[INDEX]),
    }


class _Listener(ThreadingHTTPServer):
    daemon_threads = True
    # A second server on the same port is an error, not a lottery.
    allow_reuse_port = False

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Browsers break connections off when a page is left; that is no error."""


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server_version = "nearfar"
    sys_version = ""
    files: Mapping[str, Read]
    timeout = 60

    def do_GET(self) -> None:
        self._answer(with_content=True)

    def do_HEAD(self) -> None:
        self._answer(with_content=False)

    def _answer(self, *, with_content: bool) -> None:
        if self.headers.get("Host", "").rpartition(":")[0] not in NAMES:
            self._refuse(HTTPStatus.FORBIDDEN, f"open http://{HOST}:{self.server.server_port}/")  # type: ignore[attr-defined]
            return
        name = unquote(urlsplit(self.path).path).removeprefix("/")
        read = self.files.get(name)
        if read is None:
            self._refuse(HTTPStatus.NOT_FOUND, "no such file")
            return
        try:
            content = read()
        except OSError as error:
            self._refuse(HTTPStatus.NOT_FOUND, f"the file cannot be read: {error.strerror}")
            return
        tag = f'"{hashlib.sha256(content).hexdigest()[:32]}"'
        if self.headers.get("If-None-Match") == tag:
            self.send_response(HTTPStatus.NOT_MODIFIED)
            self._headers(name, tag)
            self.end_headers()
            return
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", TYPES.get((name or INDEX).rpartition(".")[2], TYPES["bin"]))
        self.send_header("Content-Length", str(len(content)))
        self._headers(name, tag)
        self.end_headers()
        if with_content:
            self.wfile.write(content)

    def _headers(self, name: str, tag: str) -> None:
        self.send_header("ETag", tag)
        self.send_header("Cache-Control", FOREVER if name.startswith(f"{_store.FOLDER}/") else "no-cache")
        self.send_header("Content-Security-Policy", POLICY)
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("Referrer-Policy", "no-referrer")
        self.send_header("Cross-Origin-Resource-Policy", "same-origin")

    def _refuse(self, status: HTTPStatus, reason: str) -> None:
        content = f"{status.value} {status.phrase}: {reason}\n".encode()
        self.send_response(status)
        self.send_header("Content-Type", "text/plain; charset=utf-8")
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, *_: Any) -> None:
        """Say nothing for each request."""
