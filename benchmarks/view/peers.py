"""Bytes that a server sends to pages of one room, with and without exchange of files between pages.

python -m benchmarks.view.peers [--quick] [--bundle FOLDER] [--pages N …]

Pages of one headless Chromium on this machine, each with a separate cache, load all files of a bundle: that of the
procedural city, or one in a folder. They start together, or each after the previous one has finished. Bytes of files
are those of the requests. All bytes are counted by the server as it sends them, with scripts, styles and manifests;
some are compressed. Seconds are since navigation; all pages share the cores of the machine, and draw in software.
"""

from __future__ import annotations

import argparse
import re
import tempfile
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.request import urlopen

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.view.load import CENTER, WATCH
from nearfar.serve._rooms import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support.browser import started
from tests.support.peer_pages import PeerPage, bytes_of, peer_page

SIZE = (160, 100)
WAYS = {"server alone": "&peers=off", "together": "", "in turns": ""}


@dataclass(frozen=True)
class Loads:
    """The loads of some pages."""

    files: int
    """Bytes of files that the server sent."""
    all: int
    """Bytes of all its responses."""
    exchanged: int
    """Bytes of files exchanged between pages."""
    first: float
    """Seconds until the first picture, the median of all pages."""
    slowest: float
    """The longest of these times."""


def bytes_sent(url: str) -> int:
    """Bytes sent by a server, by its own count."""
    with urlopen(f"{url}metrics") as answer:
        found = re.search(r"^nearfar_sent_bytes_total (\d+)", answer.read().decode(), re.MULTILINE)
    assert found
    return int(found[1])


def loads(chromium: Any, folder: Path, count: int, way: str) -> Loads:
    """Load a bundle in `count` pages."""
    with Server({"": Site.of_bundle(folder)}, rooms=Rooms()) as server, ExitStack() as stack:
        pages: list[PeerPage] = []
        for _ in range(count):
            pages.append(stack.enter_context(peer_page(chromium, SIZE)))
            pages[-1].page.add_init_script(f"({WATCH})()")
        for page in pages:
            page.open(server.url, "bench", WAYS[way])
            if way == "in turns":
                page.wait_for_files()
                page.rest()
        told = [page.wait_for_files() for page in pages]
        firsts = [float(page.page.evaluate("() => window.shownRings[0]")) / 1e3 for page in pages]
        exchanged = sum(each["others"]["bytes"] for each in told)
        return Loads(bytes_of(folder, pages), bytes_sent(server.url), exchanged, float(np.median(firsts)), max(firsts))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="a small city")
    parser.add_argument("--bundle", type=Path, help="the folder of a bundle, instead of the city")
    parser.add_argument("--pages", type=int, nargs="+", default=[1, 2, 4, 8], help="numbers of pages")
    given = parser.parse_args()
    print(machine())
    with tempfile.TemporaryDirectory() as name:
        folder = given.bundle
        if folder is None:
            folder = Path(name) / "bundle"
            nf.stream.export(nf.datasets.city(blocks=3, detail=1 if given.quick else 2), folder, center=CENTER)
        size = nf.stream.open(folder).nbytes
        rows = []
        for count in given.pages:
            for way in WAYS:
                if way == "in turns" and count == 1:
                    continue
                # A browser becomes slower after drawing for long.
                with started() as chromium:
                    found = loads(chromium, folder, count, way)
                numbers = [f"{value / 1e6:.2f}" for value in (found.files, found.all, found.exchanged)]
                rows.append([str(count), way, numbers[0], f"{found.files / size:.2f}", *numbers[1:]])
                rows[-1] += [f"{found.first:.1f}", f"{found.slowest:.1f}"]
                print(rows[-1], flush=True)
    header = ["pages", "files from", "MB of files", "of one page's", "all MB", "MB among pages", "first picture, s"]
    print(table(f"a bundle of {size / 1e6:.2f} MB", [*header, "the slowest, s"], rows))


if __name__ == "__main__":
    main()
