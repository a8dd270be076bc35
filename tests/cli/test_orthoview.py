"""Tests of `nearfar orthoview`."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import nearfar as nf
from nearfar.cli import _orthoview
from nearfar.orthoview import _leaves
from tests.support import need
from tests.support.cli_cases import city, command, document

__all__ = ["city"]

need("zarr")

BOX = "--box=-60,-60,59,59"


@pytest.fixture(scope="module")
def store(city: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("trees") / "city.zarr"
    box = np.array([[-60, -np.inf, -60], [59, np.inf, 59]])
    nf.orthoview.build(nf.Scene.load(city), path, cell=30, aabb=box, size=32, directions=5)
    return path


def test_a_tree_is_built_shown_updated_checked_and_exported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, city: Path, store: Path
) -> None:
    path, picture, plain = tmp_path / "city.zarr", tmp_path / "views.png", tmp_path / "plain.zarr"
    options = ("--cell", "30", BOX, "--size", "32", "--directions", "5", "--json")
    status, out, _ = command(capsys, "orthoview", "build", "-i", city, "-o", path, *options)
    assert status == 0
    built, expected = document(out, "orthoview_info"), nf.orthoview.open(store)
    assert (built["held"], built["complete"]) == (expected.held, True)
    assert built["source"] == str(city)
    status, out, _ = command(capsys, "orthoview", "info", path, "--preview", picture)
    assert status == 0
    assert f"{expected.held['leaves']:,} not empty" in out
    assert f"rendered the views of {expected.done['drawn']} leaves; found" in " ".join(out.split())
    np.testing.assert_array_equal(np.asarray(Image.open(picture)), expected.preview())
    less = tmp_path / "less.glb"
    assert command(capsys, "cut", "-i", city, "-o", less, "--box=-999,-999,-21,999")[0] == 0
    change = ("--box=-20,-20,59,59", "--json")
    status, out, _ = command(capsys, "orthoview", "update", path, "-i", less, *change)
    assert status == 0
    updated = document(out, "orthoview_info")
    assert updated["generation"] == 1
    assert updated["held"]["bytes"] < 0.9 * built["held"]["bytes"]  # Only the ground remains there.
    status, out, _ = command(capsys, "orthoview", "verify", path, "--json")
    assert status == 0
    assert document(out, "orthoview_info")["files"] == nf.orthoview.open(path).verify()
    status, out, _ = command(capsys, "orthoview", "export", path, "-o", plain, "--json")
    assert status == 0
    exported = document(out, "orthoview_info")
    assert (exported["generation"], exported["held"]) == (0, updated["held"])


def test_the_side_of_leaves_is_chosen_and_explained(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, city: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A build that resumes keeps the side, and says nothing about it."""
    monkeypatch.setattr(_orthoview, "MIN_ANNOUNCED", 0.0)
    path = tmp_path / "city.zarr"
    options = ("orthoview", "build", "-i", city, "-o", path, BOX, "--size", "32", "--directions", "5", "--json")
    box = np.array([[-60, -np.inf, -60], [59, np.inf, 59]])
    choice = nf.orthoview.choose_cell(nf.Scene.load(city), aabb=box, size=32, directions=5)
    with monkeypatch.context() as patched:
        patched.setattr(_leaves.Leaves, "_leaf", interrupt)
        status, _, err = command(capsys, *options)
    assert status == 130
    assert f"nearfar: chose --cell {choice.cell:g}: {choice}" in err
    assert re.search(r"nearfar: the build of about [0-9,]+ leaves may take [0-9]+ (s|min) in one process", err)
    status, out, _ = command(capsys, "orthoview", "info", path, "--json")
    shown = document(out, "orthoview_info")
    assert (shown["cell"], shown["unbuilt"]) == (choice.cell, np.prod(shown["leaves"]))
    assert f"{shown['unbuilt']:,} leaves are not built yet" in command(capsys, "orthoview", "info", path)[1]
    status, out, err = command(capsys, *options)
    assert (status, "--cell" in err, document(out, "orthoview_info")["complete"]) == (0, False, True)


def interrupt(*_arguments: Any) -> None:
    raise KeyboardInterrupt


def test_a_tree_is_written_for_splat_viewers(capsys: pytest.CaptureFixture[str], tmp_path: Path, store: Path) -> None:
    options = ("--splats", "--level", "1", "--box=-60,-60,20,20", "--light", "1,2,0")
    box = np.array([[-60, -np.inf, -60], [20, np.inf, 20]])
    status, out, _ = command(capsys, "orthoview", "export", store, "-o", tmp_path / "a.spz", *options, "--json")
    assert status == 0
    counts = nf.orthoview.open(store).export_splats(tmp_path / "b.spz", level=1, aabb=box, light=(1, 2, 0))
    assert document(out, "orthoview_info")["splats"] == counts
    assert (tmp_path / "a.spz").read_bytes() == (tmp_path / "b.spz").read_bytes()
    others = ("--splats", "--level", "1", "--light", "none", "--compression", "spz")
    status, out, _ = command(capsys, "orthoview", "export", store, "-o", tmp_path / "tiles", *others)
    assert status == 0
    wanted = nf.orthoview.open(store).export_splats(tmp_path / "own", level=1, light=None, compression="spz")
    assert f"{wanted['splats']:,} for {wanted['pixels']:,} pixels, in {wanted['tiles']:,} tiles" in out
    names = [{path.relative_to(tmp_path / own) for path in (tmp_path / own).rglob("*")} for own in ("tiles", "own")]
    assert names[0] == names[1]


def test_info_recognises_a_tree(capsys: pytest.CaptureFixture[str], tmp_path: Path, store: Path) -> None:
    picture = tmp_path / "views.png"
    status, out, _ = command(capsys, "info", "-i", store, "--json", "--preview", picture)
    assert status == 0
    described = document(out, "info")
    expected = document(command(capsys, "orthoview", "info", store, "--json")[1], "orthoview_info")
    assert (described["kind"], described["orthoview"]) == ("orthoview", expected)
    np.testing.assert_array_equal(np.asarray(Image.open(picture)), nf.orthoview.open(store).preview())
    assert f"{expected['held']['leaves']:,} not empty" in command(capsys, "info", "-i", store)[1]
    (tmp_path / "other.zarr").mkdir()
    (tmp_path / "other.zarr" / "zarr.json").write_text('{"node_type": "group", "attributes": {}}')
    status, _, err = command(capsys, "info", "-i", tmp_path / "other.zarr")
    assert (status, "expected a nearfar.orthoview document" in err) == (1, True)


def test_a_damaged_tree_is_reported_in_one_sentence(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, store: Path
) -> None:
    copy = nf.orthoview.open(store).compact(tmp_path / "copy.zarr")
    shard = next(path for path in (Path(copy.path) / "0").rglob("0") if path.is_file())
    content = shard.read_bytes()
    shard.unlink()  # The copy shares its files.
    shard.write_bytes(content[:-1])
    status, out, err = command(capsys, "orthoview", "verify", copy.path)
    assert (status, out) == (1, "")
    assert err.startswith(f"nearfar: {shard}: damaged orthoviews: expected {len(content)} bytes")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("build", "-i", "city", "-o", "new", "--cell", "9", "--scale", "2"), "--scale: expected none with city"),
        (("build", "-i", "none.glb", "-o", "new", "--cell", "9"), "none.glb"),
        (("info", "new"), "no store of orthoviews"),
        (("update", "new", "-i", "city", "--box", "0,0,1,1"), "no store of orthoviews"),
        (("verify", "new"), "no store of orthoviews"),
        (("export", "new", "-o", "other"), "no store of orthoviews"),
        (("export", "new", "-o", "other", "--light", "none"), "need --splats"),
        (("export", "new", "-o", "other", "--splats"), "no store of orthoviews"),
    ],
)
def test_wrong_options_of_orthoview_are_reported_in_one_sentence(
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    words: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    status, _, err = command(capsys, "orthoview", *arguments)
    assert status == 1
    assert words in err
    assert err.count("\n") == 1
    assert not (tmp_path / "new").exists()
