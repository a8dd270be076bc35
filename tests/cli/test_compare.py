"""Tests of `nearfar compare`: its measures, its report pages, and the exit status of its thresholds."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from PIL import Image

import nearfar as nf
from nearfar.cli import _methods
from nearfar.cli._app import run
from tests.support import need, valid
from tests.support.cli_cases import city as city, command

PLACE = ("--center", "0,1.7,0", "--user", "0,1.7,5", "--target", "90,1,0")
# Tears are measured at 20 pixels a degree, so that a narrow view is a fast one.
FAST = ("--size", "192x120", "--samples", "1", "--face-size", "64", "--fov", "45")
NARROW = (*FAST[:-1], "20")
WIDE = FAST[:-2]


@pytest.fixture(scope="module")
def compared(city: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, Any]]:
    need("matplotlib")
    folder = tmp_path_factory.mktemp("compare") / "out"
    assert run(["compare", "-i", str(city), "-o", str(folder), *PLACE, *FAST, "--impostors"]) == 0
    return folder, json.loads((folder / "compare.json").read_text(encoding="utf-8"))


@pytest.mark.slow
def test_the_document_is_valid_and_its_files_are_there(compared: tuple[Path, dict[str, Any]]) -> None:
    folder, document = compared
    assert valid(document, "compare")
    assert sorted(path.name for path in folder.iterdir()) == document["files"]
    for name in document["files"]:
        if name.endswith(".png"):
            with Image.open(folder / name) as picture:
                picture.load()
    assert document["thresholds"] == []
    assert document["triangles_left"] < document["triangles"]
    assert document["pictures"]["conventional"]["unmeasured"].keys() <= {"flip"}
    lacking = {"tear", "tear_kink", "discontinuity", "discontinuity_p99", "boundary"}
    assert document["pictures"]["impostors"]["unmeasured"].keys() - {"flip"} == lacking


@pytest.mark.slow
def test_measures_equal_the_library_functions(city: Path, compared: tuple[Path, dict[str, Any]]) -> None:
    _, document = compared
    scene = nf.Scene.load(city)
    fov = nf.Fov.symmetric(45, 192 / 120)
    view = nf.Camera.look_at(document["user"], (90, 1, 0), fov=fov, size=(192, 120))
    truth = nf.render(scene, view, channels=("color",))
    radii = {key: document[key] for key in ("r1", "r2")}
    assert radii == {"r1": 8.76, "r2": 50.0}
    reduced = nf.reduce(scene, center=(0, 1.7, 0), **radii, face_size=64, channels=("color", "range"))
    impostors = nf.reduce(scene, center=(0, 1.7, 0), r2=50.0, far="impostors", face_size=64)
    values = document["pictures"]["impostors"]
    # The few far triangles of this scene stay geometry, so the picture equals the truth: a document has no infinity.
    assert nf.psnr(truth, impostors.render(view, channels=("color",))) == math.inf
    assert values["psnr"] is None
    assert (values["tear"], values["discontinuity"], values["boundary"]) == (None, None, None)
    assert document["triangles_of_impostors"] == impostors.triangle_count
    for name, light in (("conventional", reduced.with_morph("none")), ("continuous", reduced)):
        frame = light.render(view, channels=("color", "position"))
        values = document["pictures"][name]
        torn = nf.metrics.discontinuity(frame)
        edge = nf.metrics.boundary_mask(frame, center=(0, 1.7, 0), radius=50) & ~np.isnan(torn)
        # The document has four to six decimals.
        assert values["psnr"] == pytest.approx(nf.psnr(truth, frame), abs=1e-4)
        assert values["ssim"] == pytest.approx(nf.ssim(truth, frame), abs=1e-6)
        assert values["discontinuity"] == pytest.approx(np.nanmean(torn), abs=1e-5)
        assert values["boundary_pixels"] == edge.sum() > 0
        assert values["boundary"] == pytest.approx(np.abs(torn[edge]).mean(), abs=1e-5)
        # Twenty pixels for each degree around the view's axis.
        dense = light.render(replace(view, size=(949, 593)), channels=("position",), method="exact")
        along = nf.metrics.boundary_tear(dense, center=(0, 1.7, 0), radius=50)
        assert values["tear_density"] == pytest.approx(20.0, rel=1e-3)
        for key in ("tear", "kink", "shared"):
            name_of = "tear" if key == "tear" else f"tear_{key}"
            assert values[name_of] == pytest.approx(getattr(along, key), abs=1e-5)
    assert document["pictures"]["conventional"]["tear"] > 2 * document["pictures"]["continuous"]["tear"]


class Page(HTMLParser):
    """Parser that checks that every element is closed."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in ("meta", "img"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.slow
def test_reports_show_every_picture_and_measure(compared: tuple[Path, dict[str, Any]]) -> None:
    folder, document = compared
    text, page = ((folder / name).read_text(encoding="utf-8") for name in ("report.md", "report.html"))
    parser = Page()
    parser.feed(page)
    assert parser.open == []
    assert page.count("data:image/png;base64,") == len(re.findall(r"!\[.*\]\((.*)\)", text)) == 3
    assert "http" not in page
    for values in document["pictures"].values():
        for report in (text, page):
            assert ("equal pictures" if values["psnr"] is None else f"{values['psnr']:.4g}") in report
            torn = values["discontinuity"]
            assert ("not measurable" if torn is None else f"{torn:.4g}") in report
        for measure, reason in values["unmeasured"].items():
            assert values[measure] is None
            assert reason in text


@pytest.mark.parametrize(
    ("kept", "failed"),
    [
        ({"--min-psnr": "5", "--max-discontinuity": "50", "--max-tear": "500"}, {}),
        ({"--max-discontinuity": "50"}, {"--min-psnr": "90", "--max-boundary-discontinuity": "1e-6"}),
        ({"--min-psnr": "5"}, {"--min-ssim": "0.9999", "--max-discontinuity": "1e-9", "--max-tear": "1e-6"}),
    ],
)
def test_thresholds_set_the_exit_status(
    city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], kept: dict[str, str], failed: dict[str, str]
) -> None:
    out = tmp_path / "out"
    limits = [word for pair in (kept | failed).items() for word in pair]
    arguments = (*PLACE, *NARROW, *limits, "--json", "--exact")
    found, printed, errors = command(capsys, "compare", "-i", city, "-o", out, *arguments)
    document = json.loads(printed)
    assert found == (3 if failed else 0)
    assert valid(document, "compare")
    assert document["method"] == "exact"
    found_kept = {check["option"]: check["kept"] for check in document["thresholds"]}
    assert found_kept == dict.fromkeys(kept, True) | dict.fromkeys(failed, False)
    assert set(re.findall(r"--m\w+-[a-z-]+\w", errors)) == set(failed)
    assert (out / "report.html").exists()


def test_thresholds_that_cannot_be_measured_fail(
    city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sky = ("--center", "0,1.7,0", "--target", "0,90,1", "--max-boundary-discontinuity", "0.0001")
    status, printed, errors = command(capsys, "compare", "-i", city, "-o", tmp_path / "out", *NARROW, *sky, "--json")
    assert status == 3
    assert "--max-boundary-discontinuity: boundary was not measured, because no pixel of" in errors
    document = json.loads(printed)
    assert valid(document, "compare")
    (check,) = document["thresholds"]
    assert (check["value"], check["measured"], check["kept"]) == (None, False, False)
    assert any("the boundary is not in view" in note for note in document["findings"])
    for name in ("report.md", "report.html"):
        text = (tmp_path / "out" / name).read_text(encoding="utf-8")
        assert "not measured" in text
        assert "the boundary is not in view" in text


def test_a_view_in_which_the_boundary_can_be_measured_is_chosen(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A wall in front of another crosses r2: from right of O, its near part hides where its far part begins."""
    scene, out = tmp_path / "wall.glb", tmp_path / "out"
    meshes = []
    for (x, z), (u, v), height in (((-45, -60), (-10, -40), 30), ((-200, -60), (60, -120), 90)):
        corners = [(x, -height, z), (u, -height, v), (u, height, v), (x, height, z)]
        meshes.append(trimesh.Trimesh(corners, [(0, 1, 2), (0, 2, 3)]))
    trimesh.Scene(meshes).export(scene)
    view = ("--center", "0,1.7,0", "--r1", "30", "--r2", "55", "--target=-27.5,1.7,-50", "--distance", "1")
    small = ("--size", "96x60", "--samples", "1", "--face-size", "256", "--fov", "20")
    ahead = np.array([-27.5, -50.0]) / np.hypot(27.5, 50.0)
    right = np.array([-ahead[1], 0.0, ahead[0]])
    users = {side: (0.0, 1.7, 0.0) + sign * right for side, sign in (("right", 1.0), ("left", -1.0))}
    for user, considered, measurable in ((None, 2, 1), ("right", 1, 0)):
        given = () if user is None else ("--user=" + ",".join(f"{value:.9f}" for value in users[user]),)
        status, printed, _ = command(capsys, "compare", "-i", scene, "-o", out, *view, *small, *given, "--json")
        document = json.loads(printed)
        assert status == 0
        assert valid(document, "compare")
        assert document["views"] == {"considered": considered, "measurable": measurable}
        assert document["user"] == pytest.approx(users[user or "left"], abs=1e-6)
        boundaries = [values["boundary"] for values in document["pictures"].values()]
        assert (None in boundaries) == (measurable == 0)
        assert any("the boundary cannot be measured" in text for text in document["findings"]) == (measurable == 0)
    assert "be measured in the only view considered" in (out / "report.md").read_text(encoding="utf-8")
    # The small pictures of a view may promise more than its own pictures keep.
    monkeypatch.setattr(_methods.Methods, "can_measure", lambda methods, view: True)
    status, printed, _ = command(capsys, "compare", "-i", scene, "-o", out, *view, *small, "--json")
    document = json.loads(printed)
    assert document["user"] == pytest.approx(users["right"], abs=1e-6)
    assert document["views"] == {"considered": 2, "measurable": 1}
    assert any("the boundary cannot be measured" in text for text in document["findings"])
    assert "1 of the 2 views considered, but not in the one shown" in (out / "report.md").read_text(encoding="utf-8")
    # From the left most of the boundary's pixels see both sides; a greater least share makes it not measurable.
    monkeypatch.setattr(_methods, "MIN_SHARED", 1.1)
    user = "--user=" + ",".join(f"{value:.9f}" for value in users["left"])
    status, printed, _ = command(capsys, "compare", "-i", scene, "-o", out, *view, *small, user, "--json")
    document = json.loads(printed)
    assert all(values["tear_shared"] > 0 for values in document["pictures"].values())
    assert document["views"] == {"considered": 1, "measurable": 0}
    assert any("the boundary cannot be measured" in text for text in document["findings"])


def test_narrow_views_have_small_pictures(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    view = ("--center", "0,1.7,0", "--target", "90,1,0", "--size", "64x40", "--fov", "0.1")
    small = ("--samples", "1", "--face-size", "64", "--json")
    status, printed, errors = command(capsys, "compare", "-i", city, "-o", tmp_path / "out", *view, *small)
    assert status == 0, errors
    assert json.loads(printed)["views"]["considered"] == 2


def test_equal_pictures_pass_a_psnr_threshold(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    near = ("--center", "0,1.7,0", "--r1", "900", "--r2", "1000", "--user", "0,1.7,0", "--min-psnr", "60")
    status, printed, _ = command(capsys, "compare", "-i", city, "-o", tmp_path / "out", *NARROW, *near, "--json")
    document = json.loads(printed)
    assert (status, document["pictures"]["continuous"]["psnr"]) == (0, None)
    assert any("nothing is far" in note for note in document["findings"])
    assert any("no reduction: all 1,212 triangles stay geometry" in note for note in document["findings"])


@pytest.mark.stress
@pytest.mark.slow
def test_the_default_view_shows_differences_between_the_methods(
    city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for command_name in ("compare", "reduce"):
        out = tmp_path / command_name
        status, printed, errors = command(capsys, command_name, "-i", city, "-o", out, *WIDE, "--json")
        assert status == 0, errors
        document = json.loads(printed)
        assert document["findings"] == []
    pictures = [np.asarray(Image.open(tmp_path / "reduce" / f"{name}.png")) for name in ("conventional", "continuous")]
    assert (pictures[0] != pictures[1]).any(axis=-1).mean() > 0.02
    pictures = json.loads((tmp_path / "compare" / "compare.json").read_text())["pictures"]
    assert pictures["conventional"]["boundary_pixels"] > 0
    assert pictures["conventional"]["tear"] > 2 * pictures["continuous"]["tear"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--center", "0,1.7,0", "--r1", "1", "--r2", "2", "--target", "9,1,0"), "nothing is near"),
        (("--center", "0,1.7,0", "--user", "0,1.7,29"), "folds: the user is .* m beyond the fold margin"),
    ],
)
def test_reports_say_what_is_missing(
    arguments: tuple[str, ...], words: str, city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = tmp_path / "raised.glb"
    boxes = [trimesh.creation.box((4, 4, 4), trimesh.transformations.translation_matrix((x, 2, 8))) for x in (-30, 30)]
    trimesh.Scene(boxes).export(scene)
    chosen = scene if words == "nothing is near" else city
    status, out, _ = command(capsys, "compare", "-i", chosen, "-o", tmp_path / "out", *FAST, *arguments)
    assert status == 0
    assert re.search(words, " ".join(out.split()))
    assert re.search(words, (tmp_path / "out" / "report.html").read_text(encoding="utf-8"))


def test_compare_errors_are_sentences(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for wrong, words in [
        (("--r1", "60", "--r2", "50"), "--r1: expected less than r2"),
        (("--truth", "city"), "--truth: expected none with a scene"),
    ]:
        status, _, errors = command(capsys, "compare", "-i", city, "-o", tmp_path / "out", *FAST, *wrong)
        assert status == 1
        assert words in errors
        assert not (tmp_path / "out").exists()
