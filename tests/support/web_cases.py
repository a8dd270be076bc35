"""Runs programs of the page's sources."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

from tests.support.reader_cases import SECONDS

WEB = Path(__file__).resolve().parents[2] / "web"


def run(*command: str, **environment: str) -> None:
    """Run a program in the folder of the sources; AssertionError with its output if it fails."""
    around = os.environ | environment
    done = subprocess.run(command, cwd=WEB, env=around, capture_output=True, text=True, check=False, timeout=SECONDS)
    assert done.returncode == 0, done.stdout + done.stderr
