"""The page in the package is what its sources make, and its parts do what Python's do."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.view._page import page_files
from tests.support import need

pytestmark = pytest.mark.slow

WEB = Path(__file__).resolve().parents[2] / "web"
MOST_BYTES = 350_000
"""Script and style, compressed."""


def run(*command: str, **environment: str) -> None:
    need("web")
    done = subprocess.run(
        command, cwd=WEB, capture_output=True, text=True, check=False, timeout=300, env=os.environ | environment
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_types_hold() -> None:
    run("npx", "tsc", "--noEmit")


def test_the_package_holds_what_the_sources_make(tmp_path: Path) -> None:
    run("node", "build.mjs", str(tmp_path / "dist"))
    made = {path.name: path.read_bytes() for path in (tmp_path / "dist").iterdir()}
    assert made == page_files(), "run `make page`"


def test_the_page_is_small() -> None:
    import gzip

    assert sum(len(gzip.compress(content)) for content in page_files().values()) <= MOST_BYTES


def test_units_hold_and_ranges_are_those_of_python(tmp_path: Path) -> None:
    scene = nf.datasets.city(blocks=2, detail=1)
    settings: dict[str, Any] = {"center": (3.0, 1.7, -2.0), "radii": [10.0, 22.0, 63.0], "face_size": 128, "samples": 1}
    bundle = nf.stream.export(scene, tmp_path / "bundle", **settings)
    run("node", "build.mjs", "--tests")
    run("node", "--test", "build/tests", NEARFAR_BUNDLE=str(tmp_path / "bundle"))
    for ring in range(1, bundle.count + 1):
        codes = np.fromfile(tmp_path / f"bundle.{ring}.u16", "<u2").reshape(6, 128, 128)
        np.testing.assert_array_equal(bundle._layout.scale.ranges(codes), bundle.map(ring).range)
