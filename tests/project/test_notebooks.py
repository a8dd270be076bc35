"""Tests that notebooks are stored without outputs, contain no algorithms, and run."""

from __future__ import annotations

import ast
import json
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from tests.support import need

CHECKOUT = Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((CHECKOUT / "notebooks").glob("*.ipynb"))

# Timeout of a notebook in seconds. It takes less than 60 on an idle machine.
SECONDS = 900.0


def cells(path: Path) -> list[dict[str, Any]]:
    document = json.loads(path.read_text(encoding="utf-8"))
    found: list[dict[str, Any]] = document["cells"]
    return found


def test_there_are_notebooks_in_the_order_of_the_stages() -> None:
    near_far = ["01_scene", "02_near_far", "03_headset", "04_gpu"]
    others = ["05_lod_study", "06_lod", "07_stereo", "08_stream", "09_orthoviews"]
    assert [path.stem for path in NOTEBOOKS] == near_far + others


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebooks_are_stripped(path: Path) -> None:
    for cell in cells(path):
        if cell["cell_type"] == "code":
            assert cell["outputs"] == []
            assert cell["execution_count"] is None
        assert cell["metadata"] == {}


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebooks_hold_no_algorithms(path: Path) -> None:
    """Reusable code belongs to the package, with a test; cells contain calls, and loops over displayed results."""
    for cell in cells(path):
        if cell["cell_type"] == "code":
            tree = ast.parse("".join(cell["source"]))
            kinds = (ast.FunctionDef, ast.ClassDef, ast.While, ast.Lambda)
            assert not any(isinstance(node, kinds) for node in ast.walk(tree)), cell["source"]


@pytest.mark.slow
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebooks_run(path: Path, tmp_path: Path) -> None:
    need("notebook")
    need("matplotlib")
    started = time.monotonic()
    process = subprocess.run(
        [sys.executable, CHECKOUT / "scripts" / "notebooks.py", tmp_path, path.stem],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=False,
    )
    assert process.returncode == 0, process.stderr[-4000:]
    print(f"{path.stem}: {time.monotonic() - started:.0f} s")
    shown = [output for cell in cells(tmp_path / path.name) for output in cell.get("outputs", [])]
    assert any("image/png" in output.get("data", {}) for output in shown)
