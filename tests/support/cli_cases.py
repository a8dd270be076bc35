"""Support for tests of the command line: a small scene as a file, a call, and documents checked by schemas."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import trimesh

from nearfar.cli._app import run
from tests.support import validator


@pytest.fixture(scope="module")
def city(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file of a few boxes around a square, so that no command needs a large scene."""
    path = tmp_path_factory.mktemp("scene") / "boxes.glb"
    boxes = [trimesh.creation.box((200, 1, 200), trimesh.transformations.translation_matrix((0, -0.5, 0)))]
    for x in range(-90, 91, 20):
        for z in range(-90, 91, 20):
            height = 8 + (x * 7 + z * 3) % 17
            boxes.append(
                trimesh.creation.box((8, height, 8), trimesh.transformations.translation_matrix((x, height / 2, z)))
            )
    trimesh.Scene(boxes).export(path)
    return path


def command(capsys: pytest.CaptureFixture[str], *arguments: str | Path) -> tuple[int, str, str]:
    status = run([str(argument) for argument in arguments])
    printed = capsys.readouterr()
    return status, printed.out, printed.err


def document(text: str, schema: str) -> dict[str, Any]:
    loaded: dict[str, Any] = json.loads(text)
    for name in ("header", schema):
        validator(name).validate(loaded)
    assert loaded["format"] == f"nearfar.{schema}"
    return loaded
