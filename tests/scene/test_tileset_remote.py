"""Tests of tilesets behind URLs: requests, caching, and refusals."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import nearfar as nf
from tests.support import need
from tests.support.range_server import RangeHandler, Served, serve_folder
from tests.support.tile_cases import b3dm, glb, instanced, levels, tile, tileset, write

need("fsspec")
need("aiohttp")

CUBE = b3dm(glb())


class Broken(RangeHandler):
    def do_GET(self) -> None:  # noqa: N802 - the base class's name
        if self.path.startswith("/broken"):
            self.send_error(500)
        else:
            super().do_GET()


@pytest.fixture
def served(tmp_path: Path) -> Iterator[Served]:
    with serve_folder(tmp_path, Broken) as server:
        yield server


def gets(served: Served) -> list[str]:
    """Paths that were read since the last call, sorted."""
    found = sorted(path for method, path, _ in served.answers.elements() if method == "GET")
    served.answers.clear()
    return found


def test_a_tileset_at_a_url(tmp_path: Path, served: Served) -> None:
    files = {
        "a/tileset.json": tileset(tile(9.0, "b/inner.json", children=[tile(0.0, "../trees%20here.i3dm?v=1")])),
        "a/b/inner.json": tileset(tile(0.0, "/root.b3dm")),
        "trees here.i3dm": instanced(b"box.glb", 2, embedded=False, POSITION=np.eye(3, dtype=np.float32)[:2]),
        "box.glb": glb(),
        "root.b3dm": CUBE,
    }
    write(tmp_path, files)
    scene = nf.Scene.load(f"{served.url}a/tileset.json?key=secret")
    assert scene.triangle_count == 36
    assert set(scene.object_names) == {"../root", "../trees here/0", "../trees here/1"}
    expected = ["a/b/inner.json", "a/tileset.json?key=secret", "box.glb", "root.b3dm", "trees%20here.i3dm?v=1"]
    assert gets(served) == expected
    # An unchanged file is not read again.
    assert nf.Scene.load(f"{served.url}a/tileset.json?key=secret").triangle_count == 36
    assert gets(served) == []
    (tmp_path / "root.b3dm").write_bytes(b3dm(glb(np.eye(3), [[0, 1, 2]])) + bytes(7))
    assert nf.Scene.load(f"{served.url}a/tileset.json?key=secret").triangle_count == 25
    assert gets(served) == ["root.b3dm"]


def test_detail_decides_what_is_read(tmp_path: Path, served: Served) -> None:
    files = {"t.json": tileset(levels(2, lambda _, key: f"t{key}.b3dm"))}
    files |= {f"t{key}.b3dm": CUBE for key in ("", *"0123", *(f"{a}{b}" for a in "0123" for b in "0123"))}
    write(tmp_path, files)
    assert nf.Scene.load(f"{served.url}t.json", error=32).triangle_count == 48
    assert gets(served) == ["t.json", "t0.b3dm", "t1.b3dm", "t2.b3dm", "t3.b3dm"]
    assert nf.Scene.load(f"{served.url}t.json", triangles=12 * 7).triangle_count == 12 * 7
    assert nf.Scene.load(f"{served.url}t2.b3dm").triangle_count == 12


def test_missing_files_and_servers(tmp_path: Path, served: Served) -> None:
    write(
        tmp_path,
        {"t.json": tileset(tile(9.0, "a.b3dm", children=[tile(0.0, "no.b3dm"), tile(0, "no.json")])), "a.b3dm": CUBE},
    )
    scene = nf.Scene.load(f"{served.url}t.json")
    assert any("no.b3dm is missing" in note and "no.json is missing" in note for note in scene.report.notes)
    with pytest.raises(FileNotFoundError, match=r"nowhere\.json"):
        nf.Scene.load(f"{served.url}nowhere.json")
    write(tmp_path, {"u.json": tileset(tile(9.0, "broken.b3dm"))})
    with pytest.raises((OSError, nf.SceneError), match=r"broken\.b3dm"):
        nf.Scene.load(f"{served.url}u.json")
    with pytest.raises(OSError, match=r"t\.json"):
        nf.Scene.load("http://127.0.0.1:9/t.json")


@pytest.mark.parametrize(
    "uri", ["http://127.0.0.1:1/a.b3dm", "//localhost/a.b3dm", "https://127.0.0.1/a.b3dm", "file:///etc/passwd"]
)
def test_other_origins_are_refused(tmp_path: Path, served: Served, uri: str) -> None:
    write(tmp_path, {"t.json": tileset(tile(9.0, uri))})
    with pytest.raises(nf.SceneError, match=r"t\.json: it refers to .* which lies at another origin"):
        nf.Scene.load(f"{served.url}t.json")


def test_other_files_at_urls_are_refused(tmp_path: Path, served: Served) -> None:
    with pytest.raises(nf.SceneError, match=r"a\.glb: only 3D Tiles are read from URLs"):
        nf.Scene.load(f"{served.url}a.glb")
