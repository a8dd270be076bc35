"""Runs a part of a benchmark in a separate process, whose memory and caches are its own."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any


def run_module(module: str, *arguments: object, seconds: float | None = None) -> Any:
    """Run a module with arguments; return the JSON of the last line that it prints.

    RuntimeError if the process failed, with its last message, or did not end within `seconds`.
    """
    command = [sys.executable, "-m", module, *map(str, arguments)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=seconds)
    except subprocess.TimeoutExpired:
        raise RuntimeError(f"not done after {seconds:g} s") from None
    if done.returncode:
        raise RuntimeError((done.stderr.strip().splitlines() or [f"ended with {done.returncode}"])[-1])
    return json.loads(done.stdout.splitlines()[-1])
