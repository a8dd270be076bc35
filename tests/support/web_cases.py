"""Runs programs of the page's sources."""

from __future__ import annotations

import os
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import pytest

from tests.support.reader_cases import SECONDS
from tests.support.shared_folders import make_once

WEB = Path(__file__).resolve().parents[2] / "web"


def run(*command: str, **environment: str) -> None:
    """Run a program in the folder of the sources; AssertionError with its output if it fails."""
    around = os.environ | environment
    done = subprocess.run(command, cwd=WEB, env=around, capture_output=True, text=True, check=False, timeout=SECONDS)
    assert done.returncode == 0, done.stdout + done.stderr


def web_tests(factory: pytest.TempPathFactory) -> Path:
    """The folder of the sources' unit tests, bundled for Node once in a run."""
    return make_once(factory, "web-tests", lambda path: run("node", "build.mjs", "--tests", str(path)))


@cache
def bundled(source: str) -> str:
    """A script of the page's tests with all its imports, to be injected into a page before its own."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "script.js"
        run("npx", "esbuild", source, "--bundle", "--format=iife", "--log-level=warning", f"--outfile={out}")
        return out.read_text()
