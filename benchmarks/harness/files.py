"""Process that serves a folder over HTTP/1.1: python -m benchmarks.harness.files FOLDER ADDRESS; it prints its port.

Files are served without compression. The process ends when its standard input is closed.
"""

from __future__ import annotations

import sys
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from typing import Any


class Handler(SimpleHTTPRequestHandler):
    """Keeps connections open, as web servers do."""

    protocol_version = "HTTP/1.1"
    # The last packet of a file does not wait for the client's acknowledgements.
    disable_nagle_algorithm = True

    def log_message(self, *_: Any) -> None:
        """Print nothing."""


class Listener(ThreadingHTTPServer):
    """Answers each request in a thread that does not outlast the process."""

    daemon_threads = True

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Ignore the error: pages cancel requests that they no longer need, and connections when they are left."""


def main() -> None:
    folder, address = sys.argv[1:]
    with Listener((address, 0), partial(Handler, directory=folder)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        print(server.server_port, flush=True)
        sys.stdin.read()
        server.shutdown()


if __name__ == "__main__":
    main()
