"""Process that serves a folder over HTTP/1.1: python -m benchmarks.harness.files FOLDER ADDRESS; it prints its port.

Files go out as they are, without compression. It ends when its standard input is closed.
"""

from __future__ import annotations

import sys
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from typing import Any


class _Handler(SimpleHTTPRequestHandler):
    """Keeps connections open, as servers for the web do, and prints nothing."""

    protocol_version = "HTTP/1.1"
    # The end of a file does not wait until the client has acknowledged what is before it.
    disable_nagle_algorithm = True

    def log_message(self, *_: Any) -> None:
        pass


class _Listener(ThreadingHTTPServer):
    daemon_threads = True

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Browsers break connections off when a page is left; that is no error."""


def main() -> None:
    folder, address = sys.argv[1:]
    with _Listener((address, 0), partial(_Handler, directory=folder)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        print(server.server_port, flush=True)
        sys.stdin.read()
        server.shutdown()


if __name__ == "__main__":
    main()
