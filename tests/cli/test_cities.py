"""Tests of commands on cities: options for level and heights, and which of them a folder stores."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from nearfar.cli._app import run
from tests.support.city_cases import collection, everything, feature, square, write_json

PLACE = ("--center", "-30,1.7,0", "--r1", "10", "--r2", "20", "--face-size", "8", "--samples", "1", "--size", "16x12")
SMALL = (*PLACE[-4:], "--fov", "10")


def triangles(capsys: pytest.CaptureFixture[str], *arguments: str) -> int:
    assert run(["info", *arguments, "--json"]) == 0
    count: int = json.loads(capsys.readouterr().out)["triangles"]
    return count


def test_info_takes_a_level(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = str(write_json(tmp_path / "town.city.json", everything()))
    assert 0 < triangles(capsys, "-i", path, "--lod", "1") < triangles(capsys, "-i", path)


def test_compare_uses_the_heights_of_reduce(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rows = (feature([square(10.0 * n, 0.0, 8.0)], roof=5.0 + n, height=1.0) for n in range(4))
    path, folder = str(write_json(tmp_path / "town.geojson", collection(*rows))), str(tmp_path / "reduced")
    assert run(["reduce", "--far", "map", "-i", path, "-o", folder, *PLACE, "--height", "roof"]) == 0
    report = json.loads((tmp_path / "reduced" / "report.json").read_text(encoding="utf-8"))
    assert report["parts"] == {"height": "roof"}
    capsys.readouterr()
    compared = str(tmp_path / "compared")
    assert run(["compare", "-i", folder, "-o", compared, *SMALL, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["triangles"] == report["triangles"]


@pytest.mark.parametrize(
    ("name", "arguments", "words"),
    [
        ("town.city.json", ("--lod", "many"), "--lod: expected"),
        ("town.city.json", ("--height", "roof"), "height does not apply to it"),
        ("town.geojson", ("--lod", "1"), "--lod: expected none for town.geojson"),
    ],
)
def test_wrong_options_are_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str, arguments: tuple[str, ...], words: str
) -> None:
    document = everything() if "city" in name else collection(feature([square(0.0, 0.0, 8.0)]))
    assert run(["info", "-i", str(write_json(tmp_path / name, document)), *arguments]) == 1
    assert words in capsys.readouterr().err


def test_procedural_scenes_have_no_levels(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["info", "-i", "room", "--lod", "1"]) == 1
    assert "--lod: expected none with room" in capsys.readouterr().err
