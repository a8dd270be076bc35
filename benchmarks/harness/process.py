"""Runs parts of benchmarks in separate processes, whose memory and caches are their own."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


def run_module(module: str, *arguments: object, seconds: float | None = None) -> Any:
    """Run a module with arguments; return the JSON of the last line that it prints.

    RuntimeError if the process failed, with its last message, or did not end within `seconds`.
    """
    command = [sys.executable, "-m", module, *map(str, arguments)]
    try:
        process = subprocess.run(command, capture_output=True, text=True, check=False, timeout=seconds)
    except subprocess.TimeoutExpired:
        raise RuntimeError(f"not done after {seconds:g} s") from None
    if process.returncode:
        raise RuntimeError((process.stderr.strip().splitlines() or [f"ended with {process.returncode}"])[-1])
    return json.loads(process.stdout.splitlines()[-1])


@contextmanager
def running(*command: str, **settings: Any) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Run a program until the context ends; yield the process and the first line that it prints."""
    pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    with subprocess.Popen(command, **pipes, **settings) as process:
        assert process.stdout
        try:
            yield process, process.stdout.readline().strip()
        finally:
            process.terminate()
