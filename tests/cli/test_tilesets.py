"""Tests of commands on tilesets: options for detail and place, and which of them a folder stores."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from nearfar.cli._app import run
from tests.support.tile_cases import b3dm, glb, tile, tileset, write

PLACE = ("--center", "0,1.7,0", "--r1", "3", "--r2", "8", "--face-size", "8", "--samples", "1", "--size", "16x12")
SMALL = (*PLACE[-4:], "--fov", "10")


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """Return a coarse tile that four finer ones replace, around longitude 0 and latitude 0."""
    earth = [0.0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 6378137, 0, 0, 1]
    finer = [
        tile(
            0.0,
            "fine.b3dm",
            transform=np.array([[1, 0, 0, 20 * n - 30], [0, 1, 0, 9], [0, 0, 1, 0], [0, 0, 0, 1.0]]).T.ravel().tolist(),
        )
        for n in range(4)
    ]
    root = tile(9.0, "coarse.b3dm", refine="REPLACE", children=finer, transform=earth)
    return write(tmp_path, {"t.json": tileset(root), "coarse.b3dm": b3dm(glb()), "fine.b3dm": b3dm(glb())})


def info(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, object]:
    assert run(["info", *arguments, "--json"]) == 0
    document: dict[str, object] = json.loads(capsys.readouterr().out)
    return document


def test_info_takes_detail_and_place(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert info(capsys, "-i", str(path))["triangles"] == 48
    assert info(capsys, "-i", str(path), "--error", "9")["triangles"] == 12
    assert info(capsys, "-i", str(path), "--triangles", "47")["triangles"] == 12
    document = info(capsys, "-i", str(path), "--error", "9", "--origin", "0,0,-100")
    assert np.allclose(document["bounds"], [[-0.5, 99.5, -0.5], [0.5, 100.5, 0.5]])  # type: ignore[arg-type]


def test_compare_uses_the_tiles_of_reduce(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder, compared = str(path.parent / "reduced"), str(path.parent / "compared")
    assert (
        run(["reduce", "--far", "map", "-i", str(path), "-o", folder, *PLACE, "--error", "9", "--origin", "0,0,0"]) == 0
    )
    report = json.loads((Path(folder) / "report.json").read_text(encoding="utf-8"))
    assert (report["triangles"], report["parts"]) == (12, {"error": 9.0, "origin": [0.0, 0.0, 0.0]})
    capsys.readouterr()
    assert run(["compare", "-i", folder, "-o", compared, *SMALL, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["triangles"] == 12


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--error", "1", "--triangles", "5"), "--triangles: expected None if error is given"),
        (("--origin", "1,2"), "--origin: expected longitude,latitude,height such as"),
        (("--origin", "1,200,2"), "--origin: expected longitude within"),
        (("--triangles", "5"), "its coarsest tiles have 12 triangles, more than 5"),
    ],
)
def test_wrong_options_are_named(
    path: Path, capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], words: str
) -> None:
    assert run(["info", "-i", str(path), *arguments]) == 1
    assert words in capsys.readouterr().err


def test_other_scenes_have_no_tiles(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (path.parent / "a.glb").write_bytes(glb())
    for source in ("room", str(path.parent / "a.glb")):
        assert run(["info", "-i", source, "--error", "1"]) == 1
        assert f"--error: expected none with {source}" in capsys.readouterr().err
