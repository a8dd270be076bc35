"""Folders that are made once in a run of tests, by the first of its workers that needs one; all of them read it."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from nearfar._base.locks import hold


def made(factory: pytest.TempPathFactory, name: str, make: Callable[[Path], object]) -> Path:
    """A path below a folder of the run, after a function has written there. Tests that change it copy it first."""
    own = factory.getbasetemp()
    folder = (own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "made"
    path, done = folder / name, folder / f"{name}.done"
    with hold(folder / f"{name}.lock", None):
        if not done.exists():
            shutil.rmtree(path, ignore_errors=True)  # of a function that failed
            make(path)
            done.touch()
    return path
