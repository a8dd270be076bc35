"""Tests of the command line: its main job, output that fits its schemas, and error messages."""

from __future__ import annotations

import gzip
import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar._trace import viewpoint
from nearfar.cli._options import read_point
from nearfar.cli._output import metres
from nearfar.cli._users import choose_users
from tests.support import need
from tests.support.cli_cases import city as city, command, document


def pixels(path: Path) -> NDArray[np.uint8]:
    with Image.open(path) as picture:
        return np.asarray(picture.convert("RGB"))


def test_info_describes_a_scene(city: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, out, _ = command(capsys, "info", "-i", city, "--json")
    assert status == 0
    report = document(out, "info")
    assert report["triangles"] == 12 * 101
    # Corners of up to 100 m in float32: half a step is 4e-6 m, and the file was written from float64.
    np.testing.assert_allclose(report["bounds"][0], [-100, -1, -100], atol=1e-4)
    status, out, _ = command(capsys, "info", "-i", city)
    assert status == 0
    assert out.count("1,212") == 1
    assert "-100,-1,-100 m" in out


def test_printed_positions_can_be_pasted_back() -> None:
    for point in ((-6783380.125, 1.7, 0.0), (1e-5, -0.25, 999.125)):
        text = metres(point).removesuffix(" m")
        assert read_point("--center", text) == pytest.approx(point, abs=1e-3, rel=1e-6)
        assert " " not in text


def test_partition_counts_and_refuses_above_a_limit(
    city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ("partition", "-i", city, "--center", "0,1.7,0", "--r1", "10", "--r2", "20")
    status, out, _ = command(capsys, *arguments, "--json", "-o", tmp_path / "partition.json")
    assert status == 0
    report = document(out, "partition")
    assert report == json.loads((tmp_path / "partition.json").read_text())
    assert 0 < report["summary"]["nsf"] < 12 * 101
    counts = [entry["triangles"] for entry in report["load_curve"]]
    assert counts == sorted(counts)
    assert report["load_curve"][0] == {"radius": 20.0, "triangles": report["summary"]["nsf"]}
    status, _, err = command(capsys, *arguments, "--max-triangles", "3")
    assert status == 1
    assert re.fullmatch(r"nearfar: expected at most 3 triangles near, got \d+\n", err)


def test_bake_writes_a_map(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "map.exr"
    status, out, err = command(
        capsys, "bake", "-i", city, "-o", path, "--center", "0,1.7,0", "--face-size", "32", "--json"
    )
    assert status == 0, err
    assert document(out, "bake")["bytes"] == path.stat().st_size
    status, _, err = command(capsys, "bake", "-i", city, "-o", path, "--center", "0,1.7,0", "--r2", "5000")
    assert status == 1
    assert "there is nothing beyond 5000 m to bake" in err


@pytest.mark.parametrize("method", ["truth", "continuous", "conventional"])
def test_render_writes_a_picture(method: str, city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "picture.png"
    settings = ("--size", "64x48", "--samples", "1", "--method", method, "--json")
    map_size = () if method == "truth" else ("--face-size", "64")
    status, out, err = command(capsys, "render", "-i", city, "-o", path, "--eye", "3,1.7,0", *settings, *map_size)
    assert status == 0, err
    assert document(out, "render")["method"] == method
    picture = pixels(path)
    assert picture.shape == (48, 64, 3)
    assert picture.std() > 5.0


def test_demo_does_the_whole_job(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "demo"
    # The folder of an earlier run, which is replaced.
    folder.mkdir()
    for name in ("reduced.json", "of_an_earlier_run.png"):
        (folder / name).touch()
    settings = ("--size", "96x64", "--samples", "1", "--face-size", "64", "--json")
    status, out, err = command(capsys, "demo", "-i", city, "-o", folder, *settings)
    assert status == 0, err
    report = document(out, "report")
    assert report == json.loads((folder / "report.json").read_text(encoding="utf-8"))
    assert sorted(path.name for path in folder.iterdir()) == sorted(report["files"])
    names = {"truth", "conventional", "continuous", "impostors", "published"}
    assert {"side_by_side.png", "report.md", *(f"{name}.png" for name in names)} <= set(report["files"])
    assert set(report["pictures"]) == names - {"truth"}
    assert report["triangles_left"] < report["triangles"]
    assert pixels(folder / "side_by_side.png").shape[1] == 3 * 96 + 2 * 6
    assert {"light.glb", "near.glb", "far.exr", "reduced.json", "users.png"} <= set(report["files"])
    assert set(report["users"]["methods"]) == {"conventional", "continuous", "impostors"}
    text = (folder / "report.md").read_text(encoding="utf-8")
    assert f"{report['triangles']:,} triangles become {report['triangles_left']:,}" in text
    need("matplotlib")
    assert pixels(folder / "load_curve.png").std() > 5.0


def test_users_of_a_report_have_pictures_of_its_size_within_limits(city: Path) -> None:
    scene = nf.Scene.load(city)
    # SSIM needs 11 pixels in each direction.
    sizes = {(960, 600): (480, 300), (96, 64): (96, 64), (4800, 50): (1056, 11), (8, 8): (11, 11)}
    for pixels, size in sizes.items():
        users = choose_users(scene, (0.0, 1.7, 0.0), 5.0, pixels)
        assert {camera.size for _, camera in users} == {size}


@pytest.mark.parametrize(
    ("arguments", "status", "words"),
    [
        (["info", "-i", "missing.glb"], 1, "missing.glb"),
        (["info", "-i", "city:block=3"], 1, "expected settings from blocks, .*'block' .did you mean blocks"),
        (["info", "-i", "city:blocks=many"], 1, "expected a whole number for blocks, got 'many'"),
        (["info"], 2, "--input"),
        (["nonsense"], 2, "nonsense"),
        (["partition", "-i", "CITY", "--r1", "50", "--r2", "30"], 1, "--r1: expected less than r2"),
        # Radii are checked before the scene is loaded, which may take long.
        (["partition", "-i", "missing.glb", "--r1", "-1"], 1, "--r1: expected a number of at least 0"),
        (["bake", "-i", "missing.glb", "-o", "a.exr", "--r1", "30", "--r2", "20"], 1, "--r1: expected less than r2"),
        (["info", "-i", "city", "--up", "z"], 1, "--up: expected y with city"),
        (["render", "-i", "CITY", "-o", "a.jpg", "--size", "8x8"], 1, r"\.png or \.exr"),
        (["render", "-i", "CITY", "-o", "a.png", "--r1", "9"], 1, "--r1: expected none with --method truth"),
        (["render", "-i", "CITY", "-o", "missing/a.png", "--size", "8x8"], 1, "missing/a.png: cannot be written"),
        (["demo", "-i", "CITY", "-o", "."], 1, "holds other files"),
    ],
)
def test_errors_of_the_main_commands_are_one_sentence(
    arguments: list[str],
    status: int,
    words: str,
    city: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / "somebodys.txt").write_text("")
    monkeypatch.chdir(tmp_path)
    got, out, err = command(capsys, *(str(city) if a == "CITY" else a for a in arguments))
    assert got == status, err
    assert re.search(words, err), err
    assert "Traceback" not in err
    assert out == ""
    if status == 1:
        assert re.fullmatch(r"nearfar: [^\n]+\n", err)
    assert [path.name for path in tmp_path.iterdir()] == ["somebodys.txt"]


def test_the_process_exits_with_the_status() -> None:
    # No other program failure exits with 2.
    process = subprocess.run([sys.executable, "-m", "nearfar.cli", "info"], capture_output=True, text=True, timeout=600)
    assert process.returncode == 2, process.stderr


def test_the_command_line_imports_lazily() -> None:
    code = "import sys, nearfar.cli; print(any(m.partition('.')[0] in ('typer', 'rich') for m in sys.modules))"
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=600, check=True)
    assert process.stdout.strip() == "False"


def test_the_chosen_place_is_open_ground(city: Path) -> None:
    scene = nf.Scene.load(city)
    place = viewpoint.find(scene)
    # Rays start 25 m up, with float32 distances; a centimetre is irrelevant for a viewpoint.
    assert place.eye[1] == pytest.approx(viewpoint.EYE_HEIGHT, abs=0.01)
    around = viewpoint.horizontal_distances(scene, place.eye)
    assert around.min() >= viewpoint.CLEARANCE
    # The chosen quarter turn sees farther than the other three.
    turned = np.roll(np.minimum(around, 500.0), 9 - int(np.argmax(viewpoint._horizontal_rays() @ place.forward)))
    assert turned[:19].mean() >= turned[19:].mean()


def test_commands_read_files_of_other_units(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "room.stl"
    trimesh.creation.box((4000, 2500, 5000)).export(path)
    status, out, err = command(capsys, "info", "-i", path, "--json")
    assert status == 0
    assert "higher than buildings" in document(out, "info")["report"]["unit_note"]
    assert re.fullmatch(r"nearfar: \S+room.stl: the scene has 4,000 × 2,500 × 5,000 m, .* by scale .*\n", err)
    at = ("--center", "0,1.7,0", "--r1", "30", "--r2", "50")
    for arguments in (("partition", *at), ("reduce", "--far", "map", *at, "-o", tmp_path / "light", "--size", "32x20")):
        status, out, err = command(capsys, *arguments, "-i", path, "--scale", "0.001", "--json")
        assert (status, err) == (0, "")
    assert document(out, "report")["triangles_left"] == 12
    status, _, err = command(capsys, "partition", "-i", "city", "--scale", "0.1")
    assert (status, err) == (1, "nearfar: --scale: expected none with city, which is in metres already, got 0.1\n")
    status, _, err = command(capsys, "partition", "-i", path, "--scale", "0")
    assert (status, err) == (1, "nearfar: --scale: expected a number above 0, got 0.0\n")


def test_files_that_expand_greatly_are_read_on_request(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "box.stl.gz"
    path.write_bytes(gzip.compress(trimesh.creation.box().export(file_type="stl")))
    status, _, err = command(capsys, "info", "-i", path, "--max-bytes", "100")
    assert status == 1
    assert "it unpacks to more than 100 bytes" in err
    for arguments in (("info",), ("partition", "--center", "0,1,0", "--r1", "1", "--r2", "2")):
        assert command(capsys, *arguments, "-i", path, "--max-bytes", "10000")[0] == 0
    status, _, err = command(capsys, "info", "-i", "room", "--max-bytes", "100")
    assert (status, err) == (1, "nearfar: --max-bytes: expected none with room, which is no file, got 100\n")


def test_a_folder_of_the_same_name_does_not_hide_a_procedural_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "room").mkdir()
    status, out, _ = command(capsys, "partition", "-i", "room", "--json")
    assert status == 0
    assert document(out, "partition")["summary"]["triangles"] > 1000
    status, _, err = command(capsys, "partition", "-i", "./room")
    assert status == 1
    assert err.startswith("nearfar: ./room: expected a scene file, got a folder")


@pytest.mark.parametrize("name", ["reduce", "compare"])
def test_reports_warn_of_a_doubtful_unit(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "room.stl"
    trimesh.creation.box((4000, 2500, 5000)).export(path)
    # A narrow view, because the pictures in which tears are measured have a headset's density.
    narrow = ("--fov", "10") if name == "compare" else ()
    common = ("-i", path, "--center", "0,1.7,0", "-o", tmp_path / "out", "--size", "32x20", "--face-size", "16")
    status, _, err = command(capsys, name, *common, *narrow)
    assert status == 0
    assert "higher than buildings" in err
    assert "\nNote: the scene has 4,000 × 2,500" in (tmp_path / "out" / "report.md").read_text(encoding="utf-8")


def test_both_eyes_of_a_headset_are_rendered(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "view.png"
    common = ("render", "-i", city, "-o", path, "--eye", "0,1.7,0", "--target", "3,2,-9", "--size", "40x36", "--json")
    status, out, _ = command(capsys, *common, "--hmd", "quest_2")
    assert status == 0
    report = document(out, "render")
    assert (report["hmd"], report["lens"], report["size"]) == ("Oculus Quest 2", None, [40, 36])
    assert sorted(file.name for file in tmp_path.iterdir()) == ["view.png", "view_left.png", "view_right.png"]
    left, right = pixels(tmp_path / "view_left.png"), pixels(tmp_path / "view_right.png")
    assert left.shape == (36, 40, 3)
    assert (left != right).any()
    assert np.array_equal(pixels(path), np.concatenate([left, right], axis=1))
    generic = ("--lens", "generic", "--face-size", "64")
    status, out, _ = command(capsys, *common, "--hmd", "quest_2", *generic, "--method", "continuous")
    assert status == 0
    report = document(out, "render")
    assert report["lens"].startswith("generic, that of Cardboard")
    assert {Path(file).name for file in report["files"].values()} == {file.name for file in tmp_path.iterdir()}
    warped = pixels(tmp_path / "view_left_warped.png")
    assert (warped[0, 0] == 0).all()
    assert (warped != pixels(tmp_path / "view_left.png")).any()
    status, out, _ = command(capsys, *common[:-1], "--hmd", "vive_pro")
    assert status == 0
    assert "Liebisch (2021)" in out


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("--hmd", "quest_9"), "--hmd: expected one of"),
        (("--hmd", "quest_2", "--fov", "80"), "--fov: expected none with --hmd"),
        (("--hmd", "quest_2", "--lens", "flat"), "--lens: expected one of 'own', 'generic', got 'flat'"),
        (("--lens", "generic"), "--lens: expected it with --hmd only"),
        (("--hmd", "quest_2", "-o", "view.exr"), "view.exr: expected a name ending in .png"),
    ],
)
def test_unsupported_headset_options_are_errors(
    city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], sentence: str
) -> None:
    status, _, err = command(capsys, "render", "-i", city, "-o", tmp_path / "view.png", *arguments)
    assert status == 1
    assert sentence in err
    assert list(tmp_path.iterdir()) == []
