"""Tests of the pictures of both eyes: against single renders, the geometry of disparity, and the lenses' axes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from tests.support.card_cases import Card
from tests.support.hmd_cases import quaternion
from tests.support.leveled_cases import ball, model_from
from tests.support.reduce_cases import CENTER, R1, R2, street

QUEST = nf.hmd.QUEST_2
HEAD = (CENTER[0] + 1.0, CENTER[1], CENTER[2] - 0.5)
TURNED = quaternion((0, 1, 0), 35.0)
SIZE = (72, 64)


@pytest.fixture(scope="module")
def reduced() -> nf.ReducedScene:
    return nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=128, channels=("color", "range", "object_id"))


def render_separately(source: Any, hmd: nf.Hmd = QUEST, **arguments: Any) -> list[nf.Frame]:
    """Return frames of both eyes by two calls of `render`."""
    return [
        nf.render(source, hmd.camera(eye, HEAD, TURNED, size=SIZE), backend="cpu", **arguments)
        for eye in ("left", "right")
    ]


def same(stereo: nf.StereoFrame, frames: list[nf.Frame]) -> None:
    for ours, theirs in zip((stereo.left, stereo.right), frames, strict=True):
        assert ours.camera == theirs.camera
        assert ours.channels == theirs.channels
        assert all(ours.require(name).tobytes() == theirs.require(name).tobytes() for name in ours.channels)


def middle_of(hmd: nf.Hmd) -> NDArray[np.float64]:
    eyes = [hmd.camera(eye, HEAD, TURNED).position for eye in ("left", "right")]
    return np.asarray(np.mean(eyes, axis=0))


# pictures ------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", ["QUEST_2", "INDEX", "VIVE"])
def test_both_eyes_are_two_renders_of_a_scene(name: str) -> None:
    hmd, scene = nf.hmd.get(name), street()
    settings: dict[str, Any] = {"samples": 2, "channels": ("color", "range", "object_id", "normal"), "t_max": 60.0}
    stereo = nf.render_eyes(scene, hmd, HEAD, orientation=TURNED, size=SIZE, backend="cpu", **settings)
    same(stereo, render_separately(scene, hmd, **settings))
    assert stereo.hmd is hmd


def test_each_eye_is_the_user_of_a_reduced_scene(reduced: nf.ReducedScene) -> None:
    common: dict[str, Any] = {"orientation": TURNED, "size": SIZE, "backend": "cpu"}
    same(nf.render_eyes(reduced, QUEST, HEAD, **common), render_separately(reduced))
    one = middle_of(QUEST)
    at_middle = nf.render_eyes(reduced, QUEST, HEAD, user="middle", **common)
    same(at_middle, render_separately(reduced, user=one))
    same(nf.render_eyes(reduced, QUEST, HEAD, user=one, **common), render_separately(reduced, user=one))
    assert at_middle.left.require("range").tobytes() != render_separately(reduced)[0].require("range").tobytes()


def test_pictures_morphed_for_the_head_break_at_r2_and_per_eye_do_not(reduced: nf.ReducedScene) -> None:
    """Compares directions to points just before r2 in the eyes' pictures and in the map, in radians."""
    angles = np.linspace(0.0, 2 * np.pi, 64, endpoint=False)
    points = np.column_stack([np.cos(angles), 0 * angles, np.sin(angles)]) * (R2 - 1e-6) + CENTER
    eye = np.array(QUEST.camera("left", HEAD, TURNED).position)

    def break_at_r2(user: NDArray[np.float64]) -> float:
        shown = nf.morph(points, user=user, center=CENTER, r1=R1, r2=R2) - eye
        far = points - np.array(CENTER)
        cosine = (shown * far).sum(axis=1) / np.linalg.norm(shown, axis=1) / np.linalg.norm(far, axis=1)
        return float(np.arccos(np.clip(cosine, -1.0, 1.0)).max())

    assert break_at_r2(eye) < 1e-6
    assert break_at_r2(middle_of(QUEST)) == pytest.approx(QUEST.ipd / 2 / R2, rel=0.01)


@pytest.mark.parametrize("depth", [0.5, 1.0, 2.0, 5.0, 20.0])
@pytest.mark.parametrize("ipd", [0.058, 0.07])
def test_disparity_is_focal_length_times_eye_distance_over_depth(depth: float, ipd: float) -> None:
    """Measures the middle of a square in front of the head from the lens's axis of each eye, in pixels."""
    hmd, size = QUEST.with_ipd(ipd), (900, 906)
    side = 0.2 * depth
    square = trimesh.creation.box((side, side, 1e-4), trimesh.transformations.translation_matrix((0, 0, -depth)))
    stereo = nf.render_eyes(nf.Scene.from_trimesh(square), hmd, (0, 0, 0), size=size, channels=["object_id"])
    places = []
    for frame, eye in ((stereo.left, hmd.left), (stereo.right, hmd.right)):
        columns = np.flatnonzero((frame.require("object_id") == 0).any(axis=0))
        axis = -eye.fov.left / (eye.fov.right - eye.fov.left) * size[0]
        places.append((columns[0] + columns[-1] + 1) / 2 - axis)
    focal = size[0] / (QUEST.left.fov.right - QUEST.left.fov.left)
    # Each edge is found to half a pixel. The front of the box is 5e-5 m nearer.
    assert places[0] - places[1] == pytest.approx(focal * ipd / depth, abs=1.0)
    assert places[0] == pytest.approx(focal * ipd / 2 / depth, abs=0.5)


def test_size_is_the_headsets_a_share_of_it_or_explicit() -> None:
    scene, small = street(), nf.Hmd(name="small", left=QUEST.left, right=QUEST.right, render_size=(31, 20))
    assert nf.render_eyes(scene, small, HEAD).left.camera.size == (31, 20)
    assert nf.render_eyes(scene, small, HEAD, scale=0.5).right.camera.size == (16, 10)
    assert nf.render_eyes(scene, small, HEAD, scale=1e-9).right.camera.size == (1, 1)
    assert nf.render_eyes(scene, small, HEAD, size=(7, 8)).right.camera.size == (7, 8)


def test_levels_are_chosen_once_for_both_eyes() -> None:
    scene = ball(3).with_levels({"ball": model_from([ball(n) for n in (3, 2, 1)])})
    stereo = nf.render_eyes(scene, QUEST, (0, 0, 9), size=SIZE, lod="depth", channels=["face_id"])
    assert stereo.left.lod is stereo.right.lod
    same(
        stereo,
        [
            nf.render(scene, QUEST.camera(eye, (0, 0, 9), size=SIZE), lod=stereo.left.lod.levels, channels=["face_id"])
            for eye in ("left", "right")
        ],
    )


def test_objects_are_posed_for_both_eyes() -> None:
    box = nf.Scene.from_trimesh(trimesh.creation.box((1, 1, 1))).with_dynamic(["object"])
    away = np.eye(4)
    away[2, 3] = -3.0
    stereo = nf.render_eyes(box, QUEST, (0, 0, 0), size=SIZE, at={"object": away}, channels=["range"])
    for frame in (stereo.left, stereo.right):
        assert frame.require("range").min() == pytest.approx(2.5, abs=0.01)


# lenses --------------------------------------------------------------------------------------------------------------
def test_side_by_side_and_files(tmp_path: Path) -> None:
    stereo = nf.render_eyes(street(), QUEST, HEAD, size=SIZE, channels=["color"])
    both = stereo.side_by_side
    assert both.shape == (SIZE[1], 2 * SIZE[0], 3)
    assert np.array_equal(both[:, : SIZE[0]], stereo.left.to_image())
    assert np.array_equal(both[:, SIZE[0] :], stereo.right.to_image())
    stereo.save(tmp_path / "both.PNG")
    with Image.open(tmp_path / "both.PNG") as written:
        assert np.array_equal(np.asarray(written), both)
    with pytest.raises(ValueError, match=r"path: expected a name ending in .png, got 'both.exr'"):
        stereo.save("both.exr")


@pytest.mark.parametrize("hmd", [QUEST.with_lens(), nf.hmd.VIVE_PRO, nf.hmd.RIFT_S])
def test_each_eye_is_warped_about_its_own_axis(hmd: nf.Hmd) -> None:
    stereo = nf.render_eyes(street(), hmd, HEAD, size=SIZE, channels=["color"])
    assert hmd.lens is not None
    radius = hmd.tan_half_angle if hmd.lens_radius is None else hmd.lens_radius
    for frame, eye, ours in zip(
        (stereo.left, stereo.right), (hmd.left, hmd.right), stereo.warped(filter="cubic"), strict=True
    ):
        linear = hmd.lens.warp(frame.require("color"), True, fov=eye.fov, lens_radius=radius, filter="cubic")
        again = nf.Frame(frame.camera, color=np.clip(linear, 0.0, 1.0)).to_image()
        assert np.array_equal(ours, again)
        # The pixel on the axis is unchanged.
        column = int(-eye.fov.left / (eye.fov.right - eye.fov.left) * SIZE[0])
        row = int(eye.fov.up / (eye.fov.up - eye.fov.down) * SIZE[1])
        assert np.abs(ours[row, column].astype(int) - frame.to_image()[row, column]).max() <= 40
    assert [picture.shape for picture in stereo.warped(size=(30, 20))] == [(20, 30, 3)] * 2


def test_mirrored_eyes_have_mirrored_pictures() -> None:
    """Renders a scene that is its own mirror image: the right eye's warped picture is the left one's, mirrored."""
    row = [
        trimesh.creation.box((0.4, 0.4 + abs(x), 1e-3), trimesh.transformations.translation_matrix((x, 0, -3)))
        for x in (-2.0, -0.9, 0.0, 0.9, 2.0)
    ]
    scene = nf.Scene.from_trimesh(trimesh.util.concatenate(row))
    stereo = nf.render_eyes(
        scene, QUEST.with_lens(), (0, 0, 0), size=(240, 200), samples=4, channels=["color", "range"]
    )
    left, right = stereo.warped()
    shape = np.isfinite(stereo.left.require("range"))
    assert (shape != np.isfinite(stereo.right.require("range"))[:, ::-1]).mean() < 0.001
    black, mirrored = (left == 0).all(axis=2), (right == 0).all(axis=2)[:, ::-1]
    assert 0.2 < black.mean() < 0.8
    assert (black != mirrored).mean() < 0.001
    # Samples of edges are not mirrored.
    assert (np.abs(left.astype(int) - right[:, ::-1]).max(axis=2) > 1).mean() < 0.02


def test_a_headset_without_a_lens_explains_how_to_set_one() -> None:
    stereo = nf.render_eyes(street(), QUEST, HEAD, size=(8, 8), channels=["color"])
    with pytest.raises(ValueError, match="hmd: expected a lens, Oculus Quest 2"):
        stereo.warped()


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"scale": 0}, ValueError, "scale: expected a number above 0"),
        ({"scale": 1e300}, ValueError, r"scale\[0\]: expected a whole number from 1 to"),
    ],
)
def test_bad_arguments(arguments: dict[str, Any], error: type[Exception], message: str) -> None:
    given = {"source": street(), "hmd": QUEST, "position": HEAD, "size": None, **arguments}
    if given["size"] is None and "scale" not in given:
        given["size"] = (4, 4)
    with pytest.raises(error, match=message):
        nf.render_eyes(given.pop("source"), given.pop("hmd"), given.pop("position"), **given)


def test_frames_of_two_sizes_are_refused_as_a_pair() -> None:
    frames = [nf.Frame(QUEST.camera(eye, HEAD, size=(4, n))) for eye, n in (("left", 4), ("right", 5))]
    with pytest.raises(ValueError, match="right: expected a frame of the left one's size"):
        nf.StereoFrame(QUEST, frames[0], frames[1])
    pair = nf.StereoFrame(QUEST, frames[0], frames[0])
    with pytest.raises(ValueError, match="frame has no color"):
        _ = pair.side_by_side


def test_notebooks_show_both_eyes_or_fall_back_to_the_repr(reduced: nf.ReducedScene) -> None:
    stereo = nf.render_eyes(reduced, QUEST, HEAD, size=SIZE)
    shown = Card(stereo._repr_html_())
    assert shown.count("img") == 1
    assert "72 × 64 pixels each" in shown.text
    without_color = nf.render_eyes(reduced, QUEST, HEAD, size=SIZE, channels=("range",))
    assert without_color._repr_html_().startswith("<pre>")
