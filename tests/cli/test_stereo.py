"""Tests of `nearfar stereo`: its documents, pictures and notes, and refused options."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import nearfar as nf
from tests.support import need
from tests.support.cli_cases import city as city, command, document

FAST = ("--size", "96x80", "--samples", "1", "--eye", "0,1.7,0", "--target", "30,1.7,-40")


def test_pictures_and_measures_equal_the_library_functions(
    city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    need("matplotlib")
    status, printed, _ = command(capsys, "stereo", "-i", city, "-o", tmp_path / "out", *FAST, "--json")
    assert status == 0
    found = document(printed, "stereo")
    folder = tmp_path / "out"
    assert sorted(path.name for path in folder.iterdir()) == found["files"]
    scene, rig = nf.Scene.load(city), nf.stereo.HybridRig.of(nf.hmd.QUEST_2, mono_plane=8.0, size=(96, 80))
    way = nf.Camera.look_at((0, 1.7, 0), (30, 1.7, -40), fov=nf.Fov.symmetric(90), size=(1, 1)).orientation
    hybrid = rig.render(scene, (0, 1.7, 0), way, channels=("color",))
    np.testing.assert_array_equal(np.asarray(Image.open(folder / "left.png")), hybrid.left.to_image())
    np.testing.assert_array_equal(np.asarray(Image.open(folder / "anaglyph.png")), hybrid.anaglyph)
    clip = rig.clip((0, 1.7, 0), way, near=0.1)
    plain = nf.render_eyes(
        scene, nf.hmd.QUEST_2, (0, 1.7, 0), orientation=way, size=(96, 80), clip=clip, channels=("color",)
    )
    expected = nf.ssim(
        plain.left.to_image(), hybrid.left.to_image(), data_range=255.0, window="uniform", size=4, convention="full"
    )
    assert found["eyes"]["left"]["ssim"] == pytest.approx(float(expected), abs=1e-6)
    assert found["error"]["horizontal"] == pytest.approx(rig.max_error(), abs=1e-4)
    assert found["triangles"] == rig.triangles(scene, (0, 1.7, 0), way)
    assert found["pixels"] == hybrid.stats["pixels"]
    with Image.open(folder / "differences.png") as picture:
        assert picture.size == (2 * 96, 2 * 80)
    page = (folder / "report.html").read_text(encoding="utf-8")
    assert page.count("<img") == 5
    assert "Greatest error by depth" in page


def test_the_plane_follows_from_an_error(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, printed, _ = command(
        capsys, "stereo", "-i", city, "-o", tmp_path / "out", *FAST, "--max-error", "0.5", "--json"
    )
    assert status == 0
    found = document(printed, "stereo")
    assert found["error"]["horizontal"] == pytest.approx(0.5, abs=1e-3)


def test_lines_bend_up_to_the_end_of_a_zone(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = tmp_path / "out"
    status, printed, _ = command(capsys, "stereo", "-i", city, "-o", output, *FAST, "--zone-end", "12", "--json")
    assert status == 0
    found = document(printed, "stereo")
    assert (found["mono_plane"], found["zone_end"]) == (8.0, 12.0)
    assert "8 m, lines bend up to 12 m" in (output / "report.html").read_text(encoding="utf-8")


def test_a_folder_notes_where_sharing_gains_nothing(
    city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    light = tmp_path / "light"
    reduced = nf.reduce(nf.Scene.load(city), center=(0, 1.7, 0), r1=5.0, r2=20.0, face_size=32, samples=1)
    reduced.save(light)
    for plane, words in (("30", "lies beyond r2 = 20 m"), ("8", "")):
        status, printed, _ = command(
            capsys, "stereo", "-i", light, "-o", tmp_path / plane, *FAST, "--mono-plane", plane, "--json"
        )
        assert status == 0
        found = document(printed, "stereo")
        assert found["triangles"] is None
        assert any(words in finding for finding in found["findings"]) == bool(words)


def test_a_table_is_printed_and_an_empty_far_part_is_noted(
    city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status, printed, _ = command(capsys, "stereo", "-i", city, "-o", tmp_path / "out", *FAST, "--mono-plane", "5000")
    assert status == 0
    assert "nothing lies beyond the mono plane" in " ".join(printed.split())
    high = ("--size", "64x60", "--eye", "0,90,0", "--target", "20,0,5", "--mono-plane", "5")
    status, printed, _ = command(capsys, "stereo", "-i", city, "-o", tmp_path / "high", *high)
    assert status == 0
    assert "nothing lies before the mono plane" in " ".join(printed.split())


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--mono-plane", "8", "--max-error", "1"), "--max-error: expected none with --mono-plane"),
        (("--zone-end", "8"), "--zone-end: expected more than the mono plane's 8 metres, got 8"),
        (("--mono-plane", "0.05"), "--mono-plane: expected more than 0.1 metres, got 0.05"),
    ],
)
def test_wrong_options_are_refused_and_no_files_remain(
    city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], options: tuple[str, ...], words: str
) -> None:
    status, _, errors = command(capsys, "stereo", "-i", city, "-o", tmp_path / "out", *FAST, *options)
    assert (status, (tmp_path / "out").exists()) == (1, False)
    assert errors.startswith(f"nearfar: {words}")
