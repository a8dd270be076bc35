"""A file server that also answers range requests, like web servers and object stores."""

from __future__ import annotations

import re
import threading
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from http.server import BaseHTTPRequestHandler, SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any


class RangeHandler(SimpleHTTPRequestHandler):
    """Serves a folder; of files also one range at a time: `bytes=FIRST-LAST`, `bytes=FIRST-` and `bytes=-COUNT`."""

    def do_GET(self) -> None:
        path = Path(self.translate_path(self.path))
        asked = re.fullmatch(r"bytes=(\d*)-(\d*)", self.headers.get("Range", ""))
        if asked is None or not path.is_file():
            super().do_GET()
            return
        content, (first, last) = path.read_bytes(), asked.groups()
        start = int(first) if first else max(len(content) - int(last), 0)
        stop = min(int(last) + 1, len(content)) if first and last else len(content)
        self.send_response(206)
        self.send_header("Content-Type", self.guess_type(path))
        self.send_header("Content-Range", f"bytes {start}-{stop - 1}/{len(content)}")
        self.send_header("Content-Length", str(stop - start))
        self.end_headers()
        self.note_sent(stop - start)
        self.wfile.write(content[start:stop])

    def note_sent(self, size: int) -> None:
        """Take notice of the size of a response with content."""

    def copyfile(self, source: Any, outputfile: Any) -> None:
        self.note_sent(Path(source.name).stat().st_size)
        super().copyfile(source, outputfile)

    def log_message(self, *_: Any) -> None:
        """Print nothing."""


@dataclass(frozen=True)
class Served:
    """A folder that is served."""

    url: str
    """Address of the folder, which ends with a slash."""
    answers: Counter[tuple[str, str, int]] = field(default_factory=Counter)
    """Counts of responses by method, path below the folder and status."""
    sent: list[tuple[str, int]] = field(default_factory=list)
    """Paths below the folder and sizes of responses with content, in their order."""


@contextmanager
def running(handler: Callable[..., BaseHTTPRequestHandler]) -> Iterator[str]:
    """Run a server on this machine, and return its address, which ends with a slash."""
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}/"
        finally:
            server.shutdown()
            thread.join()


@contextmanager
def serve_folder(folder: Path, handler: type[RangeHandler] = RangeHandler) -> Iterator[Served]:
    """Serve a folder to this machine."""
    answers: Counter[tuple[str, str, int]] = Counter()
    sent: list[tuple[str, int]] = []

    def log_request(self: RangeHandler, code: int | str = "-", size: int | str = "-") -> None:
        answers[self.command, self.path.lstrip("/"), int(code)] += 1

    def note_sent(self: RangeHandler, size: int) -> None:
        sent.append((self.path.lstrip("/"), size))

    noting = type("Noting", (handler,), {"log_request": log_request, "note_sent": note_sent})
    with running(partial(noting, directory=str(folder))) as url:
        yield Served(url, answers, sent)
