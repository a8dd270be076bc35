"""Tests of commands on folders written by `nearfar reduce`, and of the extent-dependent defaults."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

import nearfar as nf
from nearfar._base import exr
from nearfar.cli._app import run
from tests.support.cli_cases import city as city, command, document

FAST = ("--size", "96x60", "--samples", "1", "--face-size", "32")


@pytest.fixture(scope="module")
def reduced_folder(city: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("reduced") / "light"
    arguments = ["reduce", "-i", str(city), "-o", str(folder), "--center", "0,1.7,0", *FAST]
    assert run([*arguments, "--equirectangular", "exr"]) == 0
    return folder


def test_info_describes_a_folder(reduced_folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture = tmp_path / "small.png"
    status, out, err = command(capsys, "info", "-i", reduced_folder, "--json", "--preview", picture)
    assert (status, err) == (0, "")
    report = document(out, "info")
    reduced = nf.Impostors.load(reduced_folder)
    assert report["reduced"]["triangles"] == reduced.stats["scene_triangles"] == 1212
    assert report["reduced"]["triangles_left"] == report["triangles"] == reduced.triangle_count
    assert report["reduced"]["map"]["channels"] == ["color"]
    names = [
        name
        for name in ("light.glb", "near.glb", "far.glb", "far.exr", "reduced.json")
        if (reduced_folder / name).exists()
    ]
    sizes = {name: (reduced_folder / name).stat().st_size for name in names}
    assert "light.glb" in names
    assert (report["kind"], report["reduced"]["files"]) == ("reduced", sizes)
    assert report["preview"]["seconds"] >= 0
    with Image.open(picture) as image:
        assert np.asarray(image).std() > 5.0
    assert command(capsys, "info", "-i", reduced_folder)[0] == 0


@pytest.mark.parametrize("method", [None, "continuous", "conventional"])
def test_render_shows_a_folder(
    method: str | None, reduced_folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "a.png"
    chosen = () if method is None else ("--method", method)
    view = ("--eye", "0,1.7,4", "--target", "90,1,0", "--size", "96x60", "--samples", "1")
    status, out, err = command(capsys, "render", "-i", reduced_folder, "-o", path, *view, *chosen, "--json")
    assert status == 0, err
    assert document(out, "render")["method"] == (method or "impostors")
    impostors = nf.Impostors.load(reduced_folder)
    published = impostors.published.with_morph("none" if method == "conventional" else "blend")
    camera = nf.Camera.look_at((0, 1.7, 4), (90, 1, 0), fov=nf.Fov.symmetric(90, 1.6), size=(96, 60))
    expected = nf.render(published if method else impostors, camera, channels=("color",)).to_image()
    with Image.open(path) as image:
        np.testing.assert_array_equal(np.asarray(image), expected)


@pytest.mark.slow
@pytest.mark.stress
def test_compare_measures_a_folder_against_its_source_scene(
    city: Path, reduced_folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    view = ("--user", "0,1.7,5", "--target", "90,1,0", "--size", "192x120", "--samples", "1", "--fov", "20", "--json")
    results = []
    sources = ((reduced_folder,), (reduced_folder, "--truth", city), (city, "--center", "0,1.7,0", *FAST[-2:]))
    for out, given in zip("abc", sources, strict=True):
        status, printed, err = command(capsys, "compare", "-i", *given, "-o", tmp_path / out, *view)
        assert status == 0, err
        results.append(document(printed, "compare"))
    assert results[0]["pictures"] == results[1]["pictures"]
    for name, values in results[0]["pictures"].items():
        whole = results[2]["pictures"][name]
        assert values["boundary_pixels"] == whole["boundary_pixels"] > 0
        assert values["boundary"] == pytest.approx(whole["boundary"], rel=1e-3)
        # The folder's map has one sample a texel of 3°, not four.
        assert values["psnr"] == pytest.approx(whole["psnr"], abs=2.0)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (
            ("render", "-o", "a.png", "--method", "truth"),
            "--method: expected impostors, continuous or conventional with a folder",
        ),
        (("render", "-o", "a.png", "--r1", "3"), "--r1: expected none with a folder as -i, which has its own"),
        (("compare", "-o", "out", "--exact"), "--exact: expected none with a folder"),
        (("partition",), "expected a scene file, got a folder with a reduced scene"),
    ],
)
def test_unsupported_options_for_folders_are_errors(
    arguments: tuple[str, ...], words: str, reduced_folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    status, _, err = command(capsys, *arguments, "-i", reduced_folder)
    assert status == 1
    assert words in err
    assert list(tmp_path.iterdir()) == []


def test_a_folder_without_its_scene_requires_one(
    reduced_folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    reduced = nf.ReducedScene.load(reduced_folder)
    reduced.save(tmp_path / "alone")
    status, _, err = command(capsys, "compare", "-i", tmp_path / "alone", "-o", tmp_path / "out")
    assert status == 1
    assert "--truth: expected the scene that" in err


def test_the_far_map_is_written_as_one_picture(reduced_folder: Path, city: Path, tmp_path: Path) -> None:
    _, parts = exr.read(reduced_folder / "far-equirectangular.exr", "equirectangular", 1)
    red = parts["color"]["R"]
    env = nf.EnvMap.load(reduced_folder / "far.exr")
    assert red.shape == (64, 128)
    expected = nf.convert_envmap(env.color, source="cube", target="equirectangular", size=64)
    # Half floats twice.
    np.testing.assert_allclose(red, expected[..., 0], rtol=2e-3, atol=1e-4)
    arguments = ["bake", "-i", str(city), "-o", str(tmp_path / "map.exr"), "--face-size", "32", "--center", "0,1.7,0"]
    assert run([*arguments, "--equirectangular", str(tmp_path / "map.png")]) == 0
    with Image.open(tmp_path / "map.png") as image:
        assert image.size == (128, 64)
        assert np.asarray(image).std() > 5.0
    with pytest.raises(ValueError, match=r"expected a name ending in \.exr or \.png"):
        env.save_equirectangular(tmp_path / "map.jpg")


def test_small_scenes_are_reduced_by_their_own_size(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ball = trimesh.creation.icosphere(4, 0.4)
    ball.export(tmp_path / "ball.glb")
    reduce = ("reduce", "-i", tmp_path / "ball.glb", "-o", tmp_path / "out", *FAST)
    status, out, err = command(capsys, *reduce, "--json")
    assert status == 0, err
    report = document(out, "report")
    assert report["r2"] < 2.0
    assert np.linalg.norm(report["center"]) > 0.4
    assert 0 < report["triangles_left"] < report["triangles"]
    status, out, err = command(capsys, *reduce, "--far", "map", "--r1", "30", "--r2", "50")
    assert status == 0, err
    text = " ".join(out.split())
    assert "5,120 → 5,120, no reduction" in text
    assert "no reduction: all 5,120 triangles stay geometry, because everything lies within r2 = 50 m" in text
    assert "no reduction: all 5,120" in (tmp_path / "out" / "report.md").read_text()


@pytest.mark.parametrize(
    "arguments",
    [
        ("export", "-o", "{}/b"),
        ("reduce", "-o", "{}/b"),
        ("compare", "-o", "{}/b"),
        ("stereo", "-o", "{}/b"),
        ("bake", "-o", "{}/b.exr"),
        ("render", "-o", "{}/b.png"),
        ("partition", "--r1", "5", "--r2", "9", "-o", "{}/b.json"),
        ("lod", "-o", "{}/b.glb"),
        ("cut", "-o", "{}/b.glb"),
        ("cut", "--cell", "50", "-o", "{}/b"),
        ("orthoview", "build", "--cell", "50", "-o", "{}/b"),
    ],
)
def test_a_missing_parent_folder_is_noticed_before_the_scene_is_read(
    arguments: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    filled = [part.format(tmp_path / "none") for part in arguments]
    status, _, err = command(capsys, *filled, "-i", tmp_path / "missing.glb")
    assert status == 1
    assert f"{tmp_path / 'none'}" in err
    assert not (tmp_path / "none").exists()
