"""Tests of clipping planes and boxes: on the CPU and on adapters."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._reduce.drawing import MorphKind
from tests.support.gpu_cases import ADAPTERS, adapter, check_color, check_ids, edges
from tests.support.reduce_cases import ALL, CENTER, R1, R2, camera, place, street

USER = CENTER + np.array([2.0, 0.4, -1.5])
AHEAD = (0.9, -0.12, -0.7)
SIZE = (320, 180)

CLIPS = {
    "a plane across the wall": nf.Clip(planes=[(-1.0, 0.0, 0.3, 45.0)]),
    "two planes": nf.Clip(planes=[(0.0, 2.0, 0.0, -2.0), (0.6, 0.0, -0.8, -12.0)]),
    "a box": nf.Clip(box=[(9.0, 0.5, -24.0), (40.0, 9.0, 14.0)]),
    "a box and a plane": nf.Clip(planes=[(0.0, -1.0, 0.0, 7.0)], box=[(-30.0, -1.0, -40.0), (60.0, 20.0, 40.0)]),
}


def is_kept(clip: nf.Clip, points: NDArray[Any], slack: float = 0.0) -> NDArray[np.bool_]:
    """Whether points (…, 3) lie in all half-spaces, extended by a slack in metres."""
    kept = np.ones(points.shape[:-1], bool)
    for *normal, d in clip.half_spaces.tolist():
        kept &= points @ np.array(normal) + d >= -slack * np.linalg.norm(normal)
    return kept


def view(size: tuple[int, int] = SIZE) -> nf.Camera:
    return camera(USER, AHEAD, size)


@pytest.mark.parametrize("name", CLIPS)
def test_pixels_show_the_nearest_unclipped_surface(name: str) -> None:
    """Compares every pixel with all triangles, one by one."""
    scene, clip, eye = street(dynamic=True).at({"car": place(20.0, 0.75, -10.0)}), CLIPS[name], view((64, 36))
    frame = nf.render(scene, eye, clip=clip, channels=("range", "position", "face_id"))
    origins, ways = (rays.reshape(-1, 3) for rays in eye.rays())
    corners = scene.triangles().astype(np.float64)
    best = np.full(len(ways), math.inf)
    for a, b, c in corners:
        normal = np.cross(b - a, c - a)
        with np.errstate(all="ignore"):
            t = ((a - origins) @ normal) / (ways @ normal)
            point = origins + t[:, None] * ways
            sides = [np.cross(q - p, point - p) @ normal for p, q in ((a, b), (b, c), (c, a))]
            inside = (np.min(sides, axis=0) >= 0.0) & (t > 0.0) & is_kept(clip, point)
        best = np.where(inside & (t < best), t, best)
    found, expected = frame.require("range").ravel(), best
    differ = ~np.isclose(found, expected, rtol=1e-4)
    # Rays through edges of triangles and of the clip, within rounding.
    assert differ.mean() < 0.002
    assert 0.05 < np.isfinite(expected).mean() < 0.98


@pytest.mark.parametrize("name", CLIPS)
@pytest.mark.parametrize("projection", [nf.Orthographic(-30, 30, -10, 20), nf.CubeFace(0)], ids=["parallel", "face"])
def test_every_projection_is_clipped(name: str, projection: Any) -> None:
    eye = nf.Camera(tuple(USER), fov=projection, size=(64, 64))
    frame = nf.render(street(), eye, clip=CLIPS[name], channels=("position",))
    position = frame.require("position") + frame.origin
    hit = np.isfinite(position).all(axis=-1)
    assert is_kept(CLIPS[name], position[hit], 1e-3).all()
    whole = nf.render(street(), eye, channels=("position",)).require("position") + frame.origin
    shown = np.isfinite(whole).all(axis=-1) & is_kept(CLIPS[name], whole, -1e-3)
    np.testing.assert_allclose(position[shown], whole[shown], atol=1e-4)


@pytest.mark.parametrize("name", CLIPS)
@pytest.mark.parametrize("kind", ["blend", "cylinder", "none"])
def test_reduced_scenes_are_clipped_at_displayed_positions(name: str, kind: MorphKind) -> None:
    scene = street(dynamic=True).at({"car": place(30.0, 0.75, -16.0)})
    reduced = nf.reduce(
        scene, center=CENTER, r1=R1, r2=R2, face_size=64, morph=kind, channels=("color", "range", "object_id")
    )
    eye, clip = view(), CLIPS[name]
    frame = reduced.render(eye, clip=clip, channels=ALL[:3], method="vertex")
    shown = frame.require("range")[..., None] * eye.rays()[1] + np.array(eye.position)
    hit = np.isfinite(frame.require("range"))
    kept = is_kept(clip, np.where(hit[..., None], shown, 0.0), 0.02)
    assert kept[hit].all()
    # Kept geometry that is not behind something clipped is visible.
    whole = reduced.render(eye, channels=ALL[:4], method="vertex")
    at = whole.require("range")[..., None] * eye.rays()[1] + np.array(eye.position)
    near = whole.require("face_id") >= 0
    inside = near & is_kept(clip, np.where(near[..., None], at, 0.0), -0.02)
    np.testing.assert_allclose(frame.require("range")[inside], whole.require("range")[inside], rtol=1e-4)
    assert hit.any()


@pytest.mark.parametrize("adapter_name", ADAPTERS)
def test_adapters_clip_like_the_tracer(adapter_name: str) -> None:
    scene = street(dynamic=True).at({"car": place(30.0, 0.75, -16.0)})
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=64, channels=("color", "range", "object_id"))
    sources: list[nf.Renderable] = [scene, reduced, reduced.with_morph("cylinder"), reduced.with_morph("none")]
    for source, clip in itertools.product(sources, CLIPS.values()):
        with adapter(adapter_name):
            cpu, gpu = (
                nf.render(source, view((160, 90)), clip=clip, channels=ALL[:3], backend=backend)
                for backend in ("cpu", "gpu")
            )
        check_ids(cpu.require("object_id"), gpu.require("object_id"))
        check_color(cpu, gpu)
        inner = ~edges(cpu.require("object_id"))
        hit = inner & np.isfinite(cpu.require("range")) & np.isfinite(gpu.require("range"))
        np.testing.assert_allclose(cpu.require("range")[hit], gpu.require("range")[hit], rtol=2e-3)


def test_ray_limits_and_planes_combine() -> None:
    clip = CLIPS["a plane across the wall"]
    eye = view((64, 36))
    both = nf.render(street(), eye, clip=clip, t_min=20.0, t_max=60.0, channels=("range", "position"))
    distance = both.require("range")
    hit = np.isfinite(distance)
    assert hit.any()
    assert (distance[hit] >= 20.0 - 1e-4).all()
    assert (distance[hit] <= 60.0 + 1e-4).all()
    assert is_kept(clip, both.require("position")[hit] + both.origin, 1e-3).all()


def test_planes_far_from_the_origin_keep_their_precision() -> None:
    shift = np.array([1e6, 0.0, -2e6])
    box = np.array([[-5.0, 0.0, -5.0], [5.0, 3.0, 5.0], [5.0, 0.0, 5.0]]) + shift
    scene = nf.Scene.from_arrays(box, np.array([[0, 1, 2]], np.uint32))
    place, target = np.add(shift, (0.0, 1.0, 20.0)), np.add(shift, (0.0, 1.0, 0.0))
    eye = nf.Camera.look_at(place, target, fov=nf.Fov.symmetric(40), size=(64, 64))
    frame = nf.render(scene, eye, clip=nf.Clip(planes=[(1.0, 0.0, 0.0, -shift[0])]), channels=("position",))
    x = (frame.require("position") + frame.origin)[..., 0] - shift[0]
    assert np.nanmin(x) > -0.2
    assert np.nanmin(x) < 0.4


def test_bent_rays_and_a_traced_far_part_refuse_planes() -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=16)
    clip = CLIPS["a box"]
    for how in ({"method": "exact"}, {"env": False, "method": "vertex"}):
        with pytest.raises(ValueError, match="clip: expected None with"):
            reduced.render(view(), clip=clip, **how)
