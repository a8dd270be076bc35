"""Loads pages over a link: a real one if possible, else one that Chromium's developer tools emulate."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import nearfar as nf
from benchmarks.harness.link import CHECKOUT, SERVER, Shaped, no_link, shaped
from benchmarks.harness.process import running
from tests.support.browser import started
from tests.support.reader_cases import browser

LOCAL = "127.0.0.1"


class Network:
    """Network between servers and pages; `network` creates it."""

    def __init__(self, link: nf.stream.Link, real: Shaped | None) -> None:
        self.link, self.real = link, real

    @property
    def name(self) -> str:
        """Name of the kind of network, and of its link."""
        rate = "a trace" if self.link.mbps is None else f"{self.link.mbps:g} Mbit/s"
        kind = "packets shaped between two namespaces" if self.real else "Chromium's own throttle"
        return f"{rate}, {self.link.rtt_ms:g} ms, {self.link.loss:.0%} lost: {kind}"

    @contextmanager
    def serve_files(self, folder: Path) -> Iterator[str]:
        """Serve files without compression from a process at the server's side; yield the address."""
        with self._run_module("benchmarks.harness.files", folder, self._address) as port:
            yield f"http://{self._address}:{int(port)}/"

    @contextmanager
    def serve_bundle(self, bundle: Path) -> Iterator[str]:
        """Serve a bundle with its page by `nearfar serve`, at the server's side; yield the address."""
        options = ("--host", self._address, "--port", 0, "--log", "off")
        with self._run_module("nearfar.cli", "serve", bundle, *options) as line:
            yield line.split()[0]

    @property
    def _address(self) -> str:
        return LOCAL if self.real is None else SERVER

    @contextmanager
    def _run_module(self, module: str, *arguments: object) -> Iterator[str]:
        """Run a module at the server's side until the context ends; yield the first line that it prints."""
        command = [sys.executable, "-m", module, *map(str, arguments)]
        if self.real is not None:
            command = self.real.command("server", command)
        with running(*command, cwd=CHECKOUT, start_new_session=True) as (_, line):
            yield line

    @contextmanager
    def browser(self, url: str) -> Iterator[Any]:
        """Start Chromium at the client's side; pages at the address get the rights of pages served with TLS."""
        origin = "{0.scheme}://{0.netloc}".format(urlsplit(url))
        flags = (f"--unsafely-treat-insecure-origin-as-secure={origin}", "--ignore-certificate-errors")
        path = browser()
        if self.real is not None and path is not None:
            path = self.real.program("client", path)
        with started(path, flags) as chromium:
            yield chromium

    @contextmanager
    def page(self, chromium: Any, size: tuple[int, int]) -> Iterator[Any]:
        """Open a page of a browser without a cache and without connections."""
        width, height = size
        context = chromium.new_context(viewport={"width": width, "height": height})
        page = context.new_page()
        if self.real is None:
            _throttle(context.new_cdp_session(page), self.link)
        try:
            yield page
        finally:
            context.close()


def _throttle(session: Any, link: nf.stream.Link) -> None:
    if link.mbps is None or link.loss:
        raise ValueError("link: expected a rate and no loss: Chromium's own throttle has neither traces nor losses")
    session.send("Network.enable")
    rate = link.mbps * 1e6 / 8.0
    limits = {"latency": link.rtt_ms, "downloadThroughput": rate, "uploadThroughput": rate}
    session.send("Network.emulateNetworkConditions", {"offline": False, **limits})


@contextmanager
def network(link: nf.stream.Link, *, real: bool | None = None) -> Iterator[Network]:
    """Set up a link: a real one or Chromium's throttle; by default the real one if possible."""
    if real if real is not None else not no_link():
        with shaped(link) as active_link:
            yield Network(link, active_link)
    else:
        yield Network(link, None)
