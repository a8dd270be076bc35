"""Bytes that a server sends to pages of one room, with and without exchange of files between pages.

Pages of one headless Chromium on this machine, each with a separate cache, load all files of a bundle: that of the
procedural city, or one in a folder. They start together, or each after the previous one has finished. Bytes of files
are those that pages request from the server. All bytes are counted by the server as it sends them, with scripts, styles
and manifests; some are compressed. Seconds are since navigation; all pages share the cores of the machine, and draw in
software.
"""

from __future__ import annotations

import itertools
import re
from contextlib import ExitStack
from pathlib import Path
from typing import Any
from urllib.request import urlopen

import numpy as np

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.view.load import CENTER, WATCH
from nearfar.serve._limits import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support.browser import started
from tests.support.peer_pages import PeerPage, bytes_of, peer_page

SIZE = (160, 100)
MODES = {"server alone": "&peers=off", "together": "", "in turns": ""}


def bytes_sent(url: str) -> int:
    """Bytes sent by a server, by its own count."""
    with urlopen(f"{url}metrics") as response:
        match = re.search(r"^nearfar_sent_bytes_total (\d+)", response.read().decode(), re.MULTILINE)
    assert match
    return int(match[1])


def loads(chromium: Any, folder: Path, count: int, mode: str) -> tuple[int, int, int, float, float]:
    """Load a bundle in `count` pages.

    Returns the bytes of files that the server sent, of all its responses, and of files exchanged between pages; and the
    median and the longest time in seconds until a page's first picture.
    """
    with Server({"": Site.of_bundle(folder)}, rooms=Rooms()) as server, ExitStack() as stack:
        pages: list[PeerPage] = []
        for _ in range(count):
            pages.append(stack.enter_context(peer_page(chromium, SIZE)))
            pages[-1].page.add_init_script(f"({WATCH})()")
        for page in pages:
            page.open(server.url, "bench", MODES[mode])
            if mode == "in turns":
                page.wait_for_files()
                page.rest()
        reports = [page.wait_for_files() for page in pages]
        firsts = [float(page.page.evaluate("() => window.shownRings[0]")) / 1e3 for page in pages]
        exchanged = sum(each["others"]["bytes"] for each in reports)
        return bytes_of(folder, pages), bytes_sent(server.url), exchanged, float(np.median(firsts)), max(firsts)


def main() -> None:
    options = start(
        __doc__,
        "--quick",
        bundle=(Path, "the folder of a bundle, instead of the city"),
        pages=([1, 2, 4, 8], "numbers of pages"),
    )
    with folder_or_temporary() as temporary:
        folder = options.bundle
        if folder is None:
            folder = temporary / "bundle"
            nf.stream.export(nf.datasets.city(blocks=3, detail=1 if options.quick else 2), folder, center=CENTER)
        size = nf.stream.open(folder).nbytes
        rows = []
        for count, mode in itertools.product(options.pages, MODES):
            if mode == "in turns" and count == 1:
                continue
            # A browser becomes slower after drawing for long.
            with started() as chromium:
                of_files, sent, exchanged, *seconds = loads(chromium, folder, count, mode)
            rows.append([count, mode, of_files / 1e6, of_files / size, sent / 1e6, exchanged / 1e6, *seconds])
            print(rows[-1], flush=True)
    header = "pages | files from | MB of files {:.2f} | of one page's {:.2f} | all MB {:.2f} | MB among pages {:.2f}"
    header += " | first picture, s {:.1f} | the slowest, s {:.1f}"
    print(table(f"a bundle of {size / 1e6:.2f} MB", header, rows))


if __name__ == "__main__":
    main()
