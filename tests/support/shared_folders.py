"""Folders that a run of tests makes once, in the first worker that needs one; all workers read them."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from nearfar._base import locks


def make_once(factory: pytest.TempPathFactory, name: str, make: Callable[[Path], object]) -> Path:
    """A path below a folder of the run, after a function has written there. Tests that change it copy it first."""
    own = factory.getbasetemp()
    folder = (own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "made"
    path, done = folder / name, folder / f"{name}.done"
    with locks.hold(folder / f"{name}.lock", None):
        if not done.exists():
            shutil.rmtree(path, ignore_errors=True)  # Left by a function that failed.
            make(path)
            done.touch()
    return path
