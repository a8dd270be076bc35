"""Tests of a newcomer's workflow: scenes to light folders, pictures, reports, headset pictures and levels."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

pytestmark = pytest.mark.slow

CHECKOUT = Path(__file__).resolve().parents[2]
SCRIPT = CHECKOUT / "scripts" / "first_hour.py"

STEPS = {"info", "reduce", "info of the folder", "picture of the folder", "picture of the scene", "compare", "headset"}


@pytest.fixture(scope="module")
def way(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("first_hour")
    command = [sys.executable, str(SCRIPT), "--quick", "-o", str(folder)]
    process = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True, timeout=1800, check=False)
    assert process.returncode == 0, process.stdout + process.stderr
    return folder


def test_every_step_of_every_scene_works(way: Path) -> None:
    steps = json.loads((way / "steps.json").read_text(encoding="utf-8"))
    assert [step["name"] for step in steps if step["status"]] == []
    for scene in ("city", "room", "forest"):
        assert {step["name"] for step in steps if step["scene"] == scene} == STEPS
    assert [step["name"] for step in steps if step["scene"] == "ring"] == ["levels"]


def test_every_picture_shows_something_and_is_on_the_page(way: Path) -> None:
    page = (way / "index.html").read_text(encoding="utf-8")
    steps = json.loads((way / "steps.json").read_text(encoding="utf-8"))
    shown = [name for step in steps for name in step["pictures"]]
    assert len(shown) > 30
    for name in shown:
        assert f'src="{name}"' in page
        if not name.endswith(".svg"):
            with Image.open(way / name) as picture:
                assert np.asarray(picture.convert("L")).std() > 1.0, name


def test_importing_takes_little_time_besides_numpy(way: Path) -> None:
    steps = json.loads((way / "steps.json").read_text(encoding="utf-8"))
    (text,) = [step["text"] for step in steps if step["name"] == "import"]
    own, numpy = map(int, re.findall(r"(\d+) ms", text))
    # CPU time; both together take at most 1.6 times NumPy's.
    assert own <= 0.6 * numpy


@pytest.mark.parametrize("name", ["missing.glb", "empty"])
def test_missing_files_are_named(name: str, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    command = [sys.executable, str(SCRIPT), str(tmp_path / name), "-o", str(tmp_path / "out")]
    process = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True, timeout=600, check=False)
    assert process.returncode == 1
    assert process.stderr.startswith("first_hour: ")
    assert name in process.stderr
