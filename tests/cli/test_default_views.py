"""Default views are not empty: objects of any size, from scenes and from folders of reduced scenes."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

from tests.support.cli_cases import city as city, command, document

SMALL = ("--size", "64x40", "--samples", "1", "--backend", "cpu")


def share_of_changes(path: Path) -> float:
    """Return the share of pixels that differ from their left neighbours, of which the sky has hardly any."""
    with Image.open(path) as picture:
        codes = np.asarray(picture.convert("RGB")).astype(int)
    return float((np.abs(codes - codes[:, :1]).max(axis=-1) > 16).mean())


@pytest.mark.parametrize("size", [0.15, 10.0, 150.0])
def test_an_object_of_any_size_is_visible(size: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "ball.stl"
    ball = trimesh.creation.icosphere(3, radius=size / 2)
    ball.vertices *= 1 + 0.1 * np.sin(9 * ball.vertices / size)
    ball.export(path)
    assert command(capsys, "render", "-i", path, "-o", tmp_path / "scene.png", *SMALL)[0] == 0
    assert command(capsys, "info", "-i", path, "--preview", tmp_path / "preview.png")[0] == 0
    assert command(capsys, "reduce", "-i", path, "-o", tmp_path / "light", *SMALL, "--face-size", "32")[0] == 0
    assert command(capsys, "render", "-i", tmp_path / "light", "-o", tmp_path / "light.png", *SMALL)[0] == 0
    for name in ("scene.png", "preview.png", "light/truth.png", "light/continuous.png", "light.png"):
        assert 0.02 < share_of_changes(tmp_path / name) < 0.5, name
    report = json.loads((tmp_path / "light" / "report.json").read_text(encoding="utf-8"))
    assert len({row["triangles"] for row in report["load_curve"]}) > 2


@pytest.mark.parametrize(("roof", "view"), [(False, "overview from above"), (True, "from ")])
def test_previews_show_open_scenes_from_above_and_halls_from_within(
    roof: bool, view: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    hall = trimesh.creation.box((90, 6, 90)).apply_translation((0, 3, 0))
    hall.invert()
    blocks = [trimesh.creation.box((9, 6, 9)).apply_translation((x, 3, z)) for x in (-30, 30) for z in (-30, 0, 30)]
    trimesh.util.concatenate([*blocks, hall] if roof else blocks).export(tmp_path / "flat.stl")
    picture = tmp_path / "preview.png"
    status, out, _ = command(capsys, "info", "-i", tmp_path / "flat.stl", "--preview", picture, "--json")
    assert (status, document(out, "info")["preview"]["view"].startswith(view)) == (0, True)
    assert share_of_changes(picture) > 0.02


def test_a_folder_is_shown_from_the_view_of_its_report(
    city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    light = tmp_path / "light"
    # At this centre the default view is another one.
    arguments = ("--center", "15,1.7,30", "--face-size", "64", *SMALL)
    assert command(capsys, "reduce", "-i", city, "-o", light, *arguments)[0] == 0
    assert command(capsys, "render", "-i", light, "-o", tmp_path / "seen.png", *SMALL)[0] == 0
    with Image.open(light / "impostors.png") as one, Image.open(tmp_path / "seen.png") as other:
        difference = np.abs(np.asarray(one.convert("RGB")).astype(int) - np.asarray(other.convert("RGB")))
    assert difference.mean() < 2.0
    # A view also exists without its report, or with a damaged one.
    report = json.loads((light / "report.json").read_text(encoding="utf-8"))
    for change in ({"target": "up"}, {"user": report["target"]}, {"user": [1, 2]}):
        (light / "report.json").write_text(json.dumps(report | change), encoding="utf-8")
        assert command(capsys, "render", "-i", light, "-o", tmp_path / "seen.png", *SMALL)[0] == 0
    (light / "report.json").unlink()
    assert command(capsys, "render", "-i", light, "-o", tmp_path / "seen.png", *SMALL)[0] == 0
    assert share_of_changes(tmp_path / "seen.png") > 0.02


def test_a_folder_without_near_geometry_is_described(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    light = tmp_path / "light"
    far = ("--center", "0,100,0", "--r1", "1", "--r2", "2", "--far", "map")
    path = tmp_path / "walls.stl"
    trimesh.util.concatenate([trimesh.creation.box((2, 20, 2)).apply_translation((x, 0, 9)) for x in (-50, 50)]).export(
        path
    )
    assert command(capsys, "reduce", "-i", path, "-o", light, *far, *SMALL, "--face-size", "16")[0] == 0
    status, out, err = command(capsys, "info", "-i", light, "--json", "--preview", tmp_path / "a.png")
    assert (status, err) == (0, "")
    assert document(out, "info")["bounds"] is None
    status, out, _ = command(capsys, "info", "-i", light)
    assert status == 0
    assert "inf" not in out


def test_stretched_headset_pictures_are_noted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for size, stretched in (("64x40", True), ("72x72", False)):
        arguments = ("--hmd", "quest 2", "-o", tmp_path / "eyes.png", "--size", size, "--samples", "1", "--json")
        status, out, _ = command(capsys, "render", "-i", "room:detail=0", *arguments)
        assert status == 0
        assert any("stretched" in text for text in document(out, "render")["findings"]) == stretched
