"""Instant regions on demand, or controlled by a test: files of numbers that depend on the place.

Run as a program with a cache folder and a limit on file size, or 0, it serves them until it is killed.
"""

from __future__ import annotations

import hashlib
import json
import resource
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from nearfar.serve._server import Server
from nearfar.serve._site import Site
from nearfar.stream._on_demand import Part

FILES, BYTES = 40, 200_000


def files_of(center: list[float]) -> dict[str, bytes]:
    """Files of a region by their names."""
    found = {}
    for number in range(FILES):
        content = hashlib.shake_128(f"{center} {number}".encode()).digest(BYTES)
        found[f"files/{hashlib.sha256(content).hexdigest()[:32]}.bin"] = content
    return found


def region(center: list[float]) -> Part:
    """A region of one part."""
    files = files_of(center)
    described = {
        name: {"bytes": len(content), "sha256": hashlib.sha256(content).hexdigest()} for name, content in files.items()
    }
    manifest = json.dumps({"center": center, "files": described}).encode()
    return Part(0, b'{"event":"end"}\n', {**files, "manifest.json": manifest}, None)


class Kitchen:
    """Makes regions one by one, when the test permits."""

    def __init__(self) -> None:
        self.begun: list[list[float]] = []
        self._permits = threading.Semaphore(0)

    def site(self) -> Site:
        """Serve the regions."""

        def begin(center: list[float]) -> list[float]:
            self.begun.append(center)
            return center

        return Site({"files/other": b"another file"}, (begin, self._next, 2.0, None, 0))

    def let(self, count: int) -> None:
        """Permit a number of further regions."""
        self._permits.release(count)

    def _next(self, center: list[float], look: Callable[[], None]) -> Part:
        while not self._permits.acquire(timeout=0.01):
            look()
        return Part(0, f'{{"event":"end","center":{center}}}\n'.encode(), {"manifest.json": b'{"files":{}}'}, None)


@contextmanager
def serving(cache: Path, most: int = 0) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Serve in a separate process, which can be killed; yields the process and its address."""
    command = [sys.executable, "-m", "tests.support.made_regions", str(cache), str(most)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as running:
        assert running.stdout
        try:
            yield running, running.stdout.readline().strip()
        finally:
            running.kill()


def main() -> None:
    """Serve until the input ends."""
    cache, most = Path(sys.argv[1]), int(sys.argv[2])
    if most:
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
    site = Site(demand=(lambda center: center, lambda center, look: region(center), 2.0, str(cache), 10**9))
    with Server({"": site}) as server:
        print(server.url, flush=True)
        sys.stdin.read()


if __name__ == "__main__":
    main()
