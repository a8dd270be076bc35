"""Pictures of reduced scenes: displayed positions, content of the map, and continuity at the border of the parts."""

from __future__ import annotations

import numpy as np
import pytest

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from tests.support.reduce_cases import ALL, CENTER, R1, R2, SIZE, Array, box, camera, place, rho, street


def pixel_centers(size: tuple[int, int]) -> Array:
    x, y = np.meshgrid(np.arange(size[0]) + 0.5, np.arange(size[1]) + 0.5)
    return np.stack([x, y], axis=-1)


@pytest.fixture(scope="module")
def conventional(scene: nf.Scene) -> nf.ReducedScene:
    channels = ("color", "range", "object_id")
    return nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=512, samples=1, morph="none", channels=channels)


RANGE = ("color", "range")

USERS = [(0, 0, 8), (-6, 0.3, -5), (9, -0.5, 0), (0, 6, 0)]


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
@pytest.mark.parametrize("offset", USERS)
def test_every_near_pixel_shows_the_morphed_point(
    scene: nf.Scene, kind: str, offset: tuple[float, float, float]
) -> None:
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=16, samples=1, morph=kind, channels=RANGE)
    user = CENTER + np.array(offset)
    view = camera(user, (1, -0.05, -0.2))
    frame = reduced.render(view, channels=("position", "face_id"), tolerance_px=0.25)
    near = frame.require("face_id") >= 0
    points = frame.require("position")[near]
    assert near.sum() > 3000
    # Pixels are split at r₂, regardless of their triangles' extent; float32 resolves 50 m to 4e-6 m.
    assert rho(points).max() <= R2 + 1e-5
    shown = view.project(nf.morph(points.astype(np.float64), user=user, center=CENTER, r1=R1, r2=R2, kind=kind))
    miss = np.abs(shown[:, :2] - pixel_centers(SIZE)[near]).max(axis=1)
    # Pieces are within a quarter of the image's finest pixel.
    # Traced positions are float32: 4e-6 m of 15 m are 2e-5 pixels here, and more where a surface is seen edge-on.
    assert miss.max() < 0.25 * 1.02
    assert frame.stats["tolerance_held"]
    assert np.median(miss) < 0.05


def test_the_vertex_morph_without_splitting_distorts_long_triangles(blend: nf.ReducedScene) -> None:
    view = camera(CENTER + np.array([0, 0, 8]), (1, -0.05, -0.2))
    frame = blend.render(view, channels=("position", "face_id"), tolerance_px=np.inf)
    near = frame.require("face_id") >= 0
    points = frame.require("position")[near].astype(np.float64)
    shown = view.project(nf.morph(points, user=view.position, center=CENTER, r1=R1, r2=R2))
    assert np.abs(shown[:, :2] - pixel_centers(SIZE)[near]).max() > 5


@pytest.mark.parametrize("offset", USERS)
def test_far_pixels_are_lookups_of_the_map(blend: nf.ReducedScene, offset: tuple[float, float, float]) -> None:
    view = camera(CENTER + np.array(offset), (1, 0.1, 0.5))
    frame = blend.render(view, channels=ALL)
    far = frame.require("face_id") < 0
    assert far.sum() > 3000
    directions = view.rays()[1][far]
    assert blend.env is not None
    # Rays have float32 directions: 6e-8 of a face of 512 texels, times a contrast of 1.
    np.testing.assert_allclose(frame.require("color")[far], blend.env.sample(directions), atol=1e-4)
    ranges = blend.env.sample(directions, channel="range")
    # For the same reason a ray on the border of two texels may hit the other one.
    same = frame.require("range")[far] == ranges
    assert same.mean() > 0.999
    assert (frame.require("object_id")[far] == blend.env.sample(directions, channel="object_id")).mean() > 0.999
    assert np.isnan(frame.require("normal")[far]).all()
    hit = same & np.isfinite(ranges)
    # A point of the map is what the centre sees in that direction; float32 resolves 2 km to 1.2e-4 m.
    np.testing.assert_allclose(
        frame.require("position")[far][hit], CENTER + directions[hit] * ranges[hit, None], atol=1e-3
    )


def crossing(reduced: nf.ReducedScene, view: nf.Camera, point: Array) -> tuple[float, float]:
    """Image x at which the near part and the map show a point, from the pixels whose points are nearest to it."""
    frame = reduced.render(view, channels=("position", "face_id"))
    row = int(view.project(point[None])[0, 1])
    found = []
    for part in (frame.require("face_id")[row] >= 0, frame.require("face_id")[row] < 0):
        distance = np.linalg.norm(frame.require("position")[row] - point, axis=-1)
        found.append(float(np.nanargmin(np.where(part, distance, np.inf))) + 0.5)
    return found[0], found[1]


def test_the_conventional_break_has_the_predicted_width_and_blend_has_none(
    blend: nf.ReducedScene, conventional: nf.ReducedScene
) -> None:
    # Where the wall's face at z = -20 crosses r₂, at eye height.
    point = np.array([CENTER[0] + np.sqrt(R2**2 - 18.0**2), 1.7, -20.0])
    # On this side of the centre the near part does not cover the same place in the map.
    user = CENTER + np.array([0, 0, 8])
    view = camera(user, (1, 0, -0.45), (640, 360))
    near, far = view.project(np.stack([point, point + user - CENTER]))[:, 0]
    # Seen from 8 m aside at 50 m: about 9 degrees.
    assert abs(near - far) > 40
    shown_near, shown_far = crossing(conventional, view, point)
    # A pixel of the image, and a texel of the map, which covers 1.1 pixels here.
    assert abs(shown_near - near) <= 1.5
    assert abs(shown_far - far) <= 2.5
    shown_near, shown_far = crossing(blend, view, point)
    assert abs(shown_near - far) <= 1.5
    assert abs(shown_far - far) <= 2.5
    assert abs(shown_near - shown_far) <= 3.5


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
@pytest.mark.parametrize("face_size", [32, 256])
def test_the_ground_has_no_cracks_and_walls_show_no_sky(kind: str, face_size: int) -> None:
    scene = street()
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=face_size, samples=1, morph=kind)
    for offset in USERS:
        view = camera(CENTER + np.array(offset), (-1, -0.2, 0.4), (320, 180))
        color = reduced.render(view, channels=("color",)).require("color")
        # Towards -x there is only ground: two texels below the horizon everything is one grey.
        below = view.rays()[1][..., 1] < -2.0 * 2 / face_size
        ground = nf.render(scene, view, channels=("color",)).require("color")[below][0]
        # Linear filtering of equal colours rounds once or twice.
        np.testing.assert_allclose(color[below], np.broadcast_to(ground, color[below].shape), atol=1e-6)


def test_pixels_inside_r1_equal_the_truth(scene: nf.Scene, blend: nf.ReducedScene) -> None:
    view = camera(CENTER + np.array([2, 0.2, -3]), (1, -0.1, 1.5))
    truth, frame = (nf.render(scene, view, channels=ALL), blend.render(view, channels=ALL))
    near = truth.require("object_id") == scene.object_names.index("near")
    assert near.sum() > 300
    for name in ALL:
        np.testing.assert_array_equal(frame.require(name)[near], truth.require(name)[near], err_msg=name)


@pytest.mark.parametrize("method", ["blend", "conventional"])
def test_at_the_centre_the_truth_is_reproduced(
    scene: nf.Scene, blend: nf.ReducedScene, conventional: nf.ReducedScene, method: str
) -> None:
    reduced = {"blend": blend, "conventional": conventional}[method]
    view = camera(CENTER, (1, 0, -0.3))
    truth, frame = nf.render(scene, view, channels=ALL), reduced.render(view, channels=ALL)
    near = frame.require("face_id") >= 0
    assert 3000 < near.sum() < near.size - 3000
    for name in ALL:
        np.testing.assert_array_equal(frame.require(name)[near], truth.require(name)[near], err_msg=name)
    difference = frame.require("color") - truth.require("color")
    # Far pixels are resampled: they differ only at silhouettes, by the contrast there (0.5) on a few percent of the
    # pixels. A shift by one texel would be tolerated; a mirrored or rotated map would differ by 0.2 everywhere.
    assert np.sqrt(np.mean(difference**2)) < 0.03
    assert np.median(np.abs(difference[~near])) < 2e-3


def test_without_near_geometry_only_the_map_is_shown(scene: nf.Scene) -> None:
    alone = scene.subset(objects=["tower"])
    reduced = nf.reduce(alone, center=CENTER, r1=R1, r2=R2, face_size=64, samples=1, channels=("color", "object_id"))
    assert reduced.stats["drawn"] == 0
    for user in (CENTER, CENTER + 5.0):
        frame = reduced.render(camera(user, (1, 0.2, 0.7)), channels=("object_id", "face_id"))
        assert (frame.require("face_id") == -1).all()
        assert (frame.require("object_id") == scene.object_names.index("tower")).sum() > 50


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["blend", "cylinder", "none"])
def test_users_outside_the_cylinder_see_inside(scene: nf.Scene, kind: str) -> None:
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=64, samples=1, morph=kind, channels=RANGE)
    view = camera(CENTER + np.array([-90.0, 5, 0]), (1, -0.1, 0))
    frame = reduced.render(view, channels=("color", "position", "face_id"))
    near = frame.require("face_id") >= 0
    assert near.sum() > 500
    assert rho(frame.require("position")[near]).max() <= R2 + 1e-4
    assert np.isfinite(frame.require("color")).all()
    if kind == "none":
        truth = nf.render(scene, view, channels=("position",)).require("position")
        # The interval's ends are float32 distances of up to 140 m.
        np.testing.assert_allclose(frame.require("position")[near], truth[near], atol=1e-4)


def test_conventional_at_r1_keeps_less_geometry(scene: nf.Scene) -> None:
    plain = {"morph": "none", "boundary": "r1"}
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=64, samples=1, channels=RANGE, **plain)
    frame = reduced.render(camera(CENTER + np.array([0, 0, 5]), (1, -0.1, 0)), channels=("position", "face_id"))
    near = frame.require("face_id") >= 0
    assert R1 - 1 < rho(frame.require("position")[near]).max() <= R1 + 1e-5
    assert reduced.stats["drawn"] == reduced.stats["near"]


def test_instances_and_far_origins_agree_with_merged_geometry() -> None:
    vertices, faces = box((-5, 0, -5), (5, 12, 5))
    spots = [(20.0, 0.0), (40.0, 10.0), (0.0, 48.0), (-70.0, 5.0)]
    shift = np.array([1e6, 0, -2e6])
    build = SceneBuilder()
    build.place_many(build.mesh(vertices, faces), [place(*(shift + np.array([x, 0, z]))) for x, z in spots], "block")
    placed = build.build()
    merged = nf.Scene.from_arrays(
        np.concatenate([vertices + np.array([x, 0, z]) for x, z in spots]),
        np.concatenate([faces + 8 * i for i in range(len(spots))]),
    )
    frames = []
    for scene, at in ((placed, shift), (merged, np.zeros(3))):
        reduced = nf.reduce(scene, center=CENTER + at, r1=R1, r2=R2, face_size=64, samples=1)
        frames.append(reduced.render(camera(CENTER + at + [0, 0, -6], (1, 0.05, 0.6)), channels=("face_id", "color")))
    # The same numbers in the same order; rounding matters only at silhouettes.
    assert (frames[0].require("face_id") == frames[1].require("face_id")).mean() > 0.999
    assert np.abs(frames[0].require("color") - frames[1].require("color")).mean() < 1e-3
