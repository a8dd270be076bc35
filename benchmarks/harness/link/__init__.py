"""A real link with a rate, a delay and losses: two network namespaces and a process between them.

with shaped(nf.stream.Link(50, rtt_ms=20, loss=0.01)) as link:
    link.command("server", ["python", "-m", "http.server"])  # for subprocess: runs at the server's side
    with link.side("server"):                                # sockets made here are at the server's side
        ...

The link carries any IP traffic: TCP, UDP, QUIC. It needs root, `ip` and `nsenter`; `no_link` states what is missing.
The machine's own network is not changed. Nothing is left behind, however the process ends: the kernel removes a
namespace without a name when the last process that holds it has ended.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import asdict
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import nearfar as nf
from benchmarks.harness.link.namespace import ADDRESSES, enter_namespace, new_namespace, no_link

SERVER, CLIENT = ADDRESSES
SIDES = ("server", "client")
CHECKOUT = Path(__file__).resolve().parents[3]
QUEUE_SECONDS = 0.1
"""Seconds in which a full queue before the bottleneck drains at the link's initial rate."""

__all__ = ["CLIENT", "SERVER", "Shaped", "no_link", "shaped"]


class Shaped:
    """An active link; made by `shaped`."""

    def __init__(self, namespaces: Sequence[int], process: subprocess.Popen[str], folder: Path) -> None:
        self._namespaces = dict(zip(SIDES, namespaces, strict=True))
        self._process, self._folder = process, folder

    def side(self, name: str) -> AbstractContextManager[None]:
        """Move this thread to one side, "server" or "client"; sockets that it creates stay there."""
        return enter_namespace(self._namespaces[name])

    def command(self, name: str, arguments: Sequence[str]) -> list[str]:
        """Return the command that runs a program at one side, while this process lives."""
        return ["nsenter", f"--net=/proc/{os.getpid()}/fd/{self._namespaces[name]}", *arguments]

    def program(self, name: str, path: str) -> str:
        """Return the path of a wrapper that runs a program at one side with the given arguments."""
        script = self._folder / f"{name}-{Path(path).name}"
        script.write_text(f'#!/bin/sh\nexec {" ".join(self.command(name, [path]))} "$@"\n')
        script.chmod(0o700)
        return str(script)

    def counts(self) -> dict[str, Any]:
        """Return counts of packets `down` to the client and `up`, the greatest lateness `latest`, and `cpu` seconds."""
        assert self._process.stdin
        self._process.stdin.write("\n")
        self._process.stdin.flush()
        return _answer(self._process)


@contextmanager
def shaped(
    link: nf.stream.Link, *, queue: int | None = None, congestion: str = "cubic", seed: int = 0
) -> Iterator[Shaped]:
    """Bring up a link between two sides; both directions have its rate, half its delay, and its losses.

    A rate or trace counts all bytes from IP headers on and begins with the first packet. `queue` is the size of the
    queue before the bottleneck in bytes, by default a tenth of a second; packets that find it full are dropped.
    `congestion` is TCP's congestion control on both sides. `seed` decides which packets are lost. OSError for missing
    requirements, which it lists, and for a congestion control that the kernel lacks.
    """
    reason = no_link()
    if reason:
        raise OSError(reason)
    namespaces = [new_namespace(), new_namespace()]
    try:
        settings = {
            "link": asdict(link),
            "queue": max(int(QUEUE_SECONDS * float(link._clock()._rates[0])), 16 * 1500) if queue is None else queue,
            "congestion": congestion,
            "seed": seed,
            "namespaces": namespaces,
        }
        with TemporaryDirectory() as folder, _forwarder(settings) as process:
            yield Shaped(namespaces, process, Path(folder))
    finally:
        for namespace in namespaces:
            os.close(namespace)


@contextmanager
def _forwarder(settings: dict[str, Any]) -> Iterator[subprocess.Popen[str]]:
    """Run the process between the sides until the context ends."""
    # Interrupts reach only this process, which then closes the link; the other one ends when its input is closed.
    with subprocess.Popen(
        [sys.executable, "-m", "benchmarks.harness.link.forward", json.dumps(settings)],
        cwd=CHECKOUT,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        pass_fds=settings["namespaces"],
        start_new_session=True,
    ) as process:
        _answer(process)
        yield process


def _answer(process: subprocess.Popen[str]) -> dict[str, Any]:
    assert process.stdout
    line = process.stdout.readline()
    if not line:
        raise OSError("the process that carries packets has ended")
    answer: dict[str, Any] = json.loads(line)
    if "problem" in answer:
        raise OSError(answer["problem"])
    return answer
