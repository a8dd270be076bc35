"""`nearfar serve` in a separate process."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def serving(*arguments: object) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Run the command in a separate process; yields it and the address that it prints first."""
    command = [sys.executable, "-m", "nearfar.cli", "serve", "--port", "0", *map(str, arguments)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
        try:
            assert running.stdout is not None
            yield running, running.stdout.readline().split()[0]
        finally:
            running.kill()


def rest_of(running: subprocess.Popen[str]) -> tuple[str, str]:
    """The rest of its output and of its log. (`communicate` would lose what was read ahead with the first line.)"""
    assert running.stdout is not None
    assert running.stderr is not None
    return running.stdout.read(), running.stderr.read()
