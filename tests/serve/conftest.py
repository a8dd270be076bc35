"""Fixtures shared by tests of the server."""

from __future__ import annotations

from pathlib import Path

import pytest

import nearfar as nf


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A bundle of a room, in its own folder."""
    folder = tmp_path_factory.mktemp("serve") / "room"
    nf.stream.export(nf.datasets.room(), folder, center=(0.3, 1.6, 0.2), radii=[1.5, 3.0], face_size=64, samples=1)
    return folder
