"""Tests of `nearfar cut`."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import ArrayLike

import nearfar as nf
from tests.support.cli_cases import command

CITY = "city:blocks=2,detail=0"


def test_a_box_becomes_a_scene_file_for_other_commands(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    file = tmp_path / "part.glb"
    status, out, _ = command(capsys, "cut", "-i", CITY, "-o", file, "--box", "0,0,60,60")
    city, part = nf.datasets.city(blocks=2, detail=0), nf.Scene.load(file)
    expected = city.query([[0, -np.inf, 0], [60, np.inf, 60]])
    assert status == 0
    assert f"{expected.triangle_count:,} triangles" in out
    assert part.triangle_count == expected.triangle_count < city.triangle_count
    assert np.allclose(part.bounds, expected.bounds, atol=1e-3)


@pytest.mark.slow
def test_written_tiles_load_as_a_world(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    tiles, file = tmp_path / "tiles", tmp_path / "part.glb"
    assert command(capsys, "cut", "-i", CITY, "-o", tiles, "--cell", "150")[0] == 0
    city = nf.datasets.city(blocks=2, detail=0)
    for world in (tiles, tiles / "tiles.json"):
        assert command(capsys, "cut", "-i", world, "-o", file, "--box", "-30,-30,10,10")[0] == 0
        expected = city.query([[-30, -np.inf, -30], [10, np.inf, 10]])
        assert nf.Scene.load(file).triangle_count == expected.triangle_count


def test_parts_that_cannot_be_read_are_reported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tiles, missing = tmp_path / "tiles", tmp_path / "tiles" / "tile_0_0.glb"
    settings = ("cut", "-i", CITY, "-o", tiles, "--cell", "1000")
    query = nf.Scene.query

    def fail(self: nf.Scene, aabb: ArrayLike, detail: float = 0.0) -> nf.Scene:
        if np.allclose(np.asarray(aabb)[0, [0, 2]], 0.0):
            raise OSError("the disk is gone")
        return query(self, aabb, detail)

    with monkeypatch.context() as patched:
        patched.setattr(nf.Scene, "query", fail)
        status, _, err = command(capsys, *settings)
    assert status == 0
    assert "1 tile is incomplete; the same call writes them again" in err
    assert "0_0: OSError: the disk is gone" in err
    assert not missing.exists()
    status, _, err = command(capsys, "cut", "-i", tiles, "-o", tmp_path / "part.glb", "--box", "-30,-30,10,10")
    assert (status, "the tile of cell 0_0 is incomplete: OSError" in err) == (0, True)
    assert command(capsys, *settings)[2] == ""
    assert missing.exists()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("-o", "part.glb", "--box", "2,0,1,1"), "--box: expected least x and z before"),
        (("-o", "part.glb", "--box", "9e5,0,9e6,1"), "--box: expected one with triangles"),
        (("-o", "part.obj", "--box", "0,0,1,1"), "expected a name ending in .glb"),
    ],
)
def test_invalid_cuts_are_refused(
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    words: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    status, _, err = command(capsys, "cut", "-i", CITY, *arguments)
    assert status == 1
    assert words in err
