"""The page in the package equals the build of its sources, and its parts agree with Python's."""

from __future__ import annotations

from pathlib import Path

import pytest

import nearfar.view
from nearfar.view._page import page_files
from nearfar.view._tree import tree_page
from tests.support import need
from tests.support.web_cases import run

pytestmark = pytest.mark.slow

STORED = Path(nearfar.view.__file__).parent / "dist"

MAX_BYTES = 350_000
"""Script and style, compressed."""


def test_type_checks_pass() -> None:
    need("web")
    run("npx", "tsc", "--noEmit")


def test_the_package_contains_the_build_of_the_sources(tmp_path: Path) -> None:
    need("web")
    run("node", "build.mjs", str(tmp_path / "dist"))
    made, stored = (
        {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*.*")}
        for folder in (tmp_path / "dist", STORED)
    )
    assert made == stored, "run `make page`"
    assert set(page_files()) == {name for name in stored if "/" not in name}


def test_the_page_is_small() -> None:
    import gzip

    assert sum(len(gzip.compress(content)) for content in page_files().values()) <= MAX_BYTES
    need("anywidget")
    from nearfar.view import _widget

    assert len(gzip.compress(_widget._script().encode())) <= MAX_BYTES
    sizes = {name: len(gzip.compress(content)) for name, content in tree_page().items()}
    # A script that only browsers with WebGPU load.
    assert sizes.pop("orthoview-webgpu.js") <= 20_000
    assert sum(sizes.values()) <= 62_000
