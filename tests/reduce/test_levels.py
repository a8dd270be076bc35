"""Tests of levels of detail in reduced scenes: near objects change, the map stays, and the morph moves spheres."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from nearfar._reduce.drawing import morph_spheres
from nearfar._scene.levels import Leveled
from tests.support.gpu_cases import ADAPTERS, adapter
from tests.support.leveled_cases import GREY, RED, bytes_of, model_of

CENTER = (0.0, 1.7, 0.0)
R1, R2 = 8.0, 20.0
PLACES = {
    "near": (1, 1, -6),
    "between": (-4, 2, -13),
    "across": (6, 1, -19.5),
    "far": (3, 4, -40),
    "mover": (-2, 1, -5),
}


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    """Balls with three levels in every zone, one of which moves, above a ground."""
    frames = np.tile(np.eye(4), (len(PLACES), 1, 1))
    frames[:, :3, 3] = list(PLACES.values())
    models = [model_of((3, 2, 1), color=RED), model_of((3, 1), color=GREY)]
    return nf.lod.place(models, [0, 1, 0, 1, 0], frames, names=list(PLACES), dynamic=["mover"])


@pytest.fixture(scope="module")
def reduced(scene: nf.Scene) -> nf.ReducedScene:
    return nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=64, channels=("color", "range", "object_id"))


def views(count: int) -> list[nf.Camera]:
    fov = nf.Fov.symmetric(90, 4 / 3)
    eyes = [(0.3 * n, 1.7, 0.2 * n) for n in range(count)]
    return [nf.Camera.look_at(eye, (0, 1.5, -20), fov=fov, size=(120, 90)) for eye in eyes]


def test_near_objects_show_their_levels_in_front_of_the_same_map(scene: nf.Scene, reduced: nf.ReducedScene) -> None:
    levels = {"near": 2, "between": 1, "across": 2, "far": 1, "mover": 1}
    coarse = reduced.at_levels(levels)
    assert coarse.env is reduced.env
    # The near part equals that of a scene whose objects have only these levels.
    expected = nf.reduce(scene.at_levels(levels), center=CENTER, r1=R1, r2=R2, face_size=64)
    assert coarse.triangle_count == expected.triangle_count < reduced.triangle_count
    (camera,) = views(1)
    ids = coarse.render(camera, channels=("object_id", "range")).require("object_id")
    near = np.isin(ids, [list(PLACES).index(name) for name in ("near", "between", "mover")])
    assert near.sum() > 300
    shown = coarse.render(camera, channels=("range",)).require("range")
    whole = nf.render(scene.at_levels(levels), camera, channels=("range",)).require("range")
    untouched = ids == list(PLACES).index("near")
    np.testing.assert_allclose(shown[untouched], whole[untouched], rtol=1e-5)


@pytest.mark.parametrize("lod", ["off", "depth", {"near": 1, "mover": 2}, [2, 1, 2, 1, 2]])
def test_a_path_equals_single_calls(reduced: nf.ReducedScene, lod: object) -> None:
    cameras = views(3)
    along = list(nf.render_path(reduced, cameras, lod=lod, backend="cpu"))  # type: ignore[arg-type]
    for camera, frame in zip(cameras, along, strict=True):
        assert bytes_of(frame) == bytes_of(nf.render(reduced, camera, lod=lod, backend="cpu"))  # type: ignore[arg-type]
        assert bytes_of(frame) == bytes_of(reduced.at_levels(frame.lod.levels).render(camera, backend="cpu"))
        assert frame.lod.full_triangles == reduced.triangle_count
        assert frame.lod.triangles == reduced.at_levels(frame.lod.levels).triangle_count


@pytest.mark.parametrize("name", ADAPTERS)
def test_adapters_draw_chosen_levels_of_reduced_scenes(reduced: nf.ReducedScene, name: str) -> None:
    with adapter(name):
        drawn = list(nf.render_path(reduced, views(3), lod="depth", backend="gpu"))
    traced = list(nf.render_path(reduced, views(3), lod="depth", backend="cpu"))
    for gpu, cpu in zip(drawn, traced, strict=True):
        np.testing.assert_array_equal(gpu.lod.levels, cpu.lod.levels)
        assert (gpu.require("object_id") == cpu.require("object_id")).mean() > 0.995


def test_poses_and_levels_combine(scene: nf.Scene, reduced: nf.ReducedScene) -> None:
    pose = scene.transform("mover")
    pose[:3, 3] = (0, 2, -9)
    (camera,) = views(1)
    levels = {"mover": 2, "near": -1}
    one = reduced.at({"mover": pose}).at_levels(levels).render(camera)
    other = reduced.at_levels(levels).at({"mover": pose}).render(camera)
    assert bytes_of(one) == bytes_of(other)
    assert bytes_of(one) == bytes_of(reduced.at_levels(levels).render(camera, at={"mover": pose}))
    assert not (one.require("object_id") == list(PLACES).index("near")).any()
    # An omitted moving object needs no pose.
    gone = reduced.at({"mover": pose}).at_levels({"mover": -1}).render(camera)
    assert not (gone.require("object_id") == list(PLACES).index("mover")).any()


def test_unchanged_levels_are_not_gathered_again(reduced: nf.ReducedScene) -> None:
    first = reduced.at_levels({"near": 1})
    assert reduced.at_levels({"near": 1})._core is first._core
    assert reduced.at_levels({"near": 2})._core is not first._core


def test_unchanged_levels_use_the_settings_of_each_picture(reduced: nf.ReducedScene) -> None:
    camera, coarse = views(2)[1], reduced.at_levels({"near": 1})
    grown = bytes_of(coarse.with_growth(0.0).render(camera))
    assert grown != bytes_of(coarse.render(camera))
    assert grown == bytes_of(reduced.with_growth(0.0).at_levels({"near": 1}).render(camera))


def test_a_saved_scene_has_no_levels(reduced: nf.ReducedScene, tmp_path: object) -> None:
    folder = f"{tmp_path}/light"
    reduced.save(folder)
    with pytest.raises(ValueError, match="objects have levels"):
        nf.render(nf.ReducedScene.load(folder), views(1)[0], lod="depth")


place = st.tuples(*[st.floats(-60, 60)] * 3)


@given(place, st.floats(0.01, 5), st.tuples(*[st.floats(-0.55, 0.55)] * 3), st.sampled_from(["blend", "cylinder"]))
def test_morphed_spheres_enclose_their_points(
    middle: tuple[float, float, float], radius: float, step: tuple[float, float, float], kind: str
) -> None:
    """Tests the bound on the morph's stretching of a ball, for users within half of r₁."""
    user = np.add(CENTER, np.multiply(step, R1))
    sphere = Leveled(("ball",), np.array([0]), (), np.array([0]), np.array([middle], np.float64), np.array([radius]))
    shown = morph_spheres(sphere, user, center=CENTER, kind=kind, growth={"r1": R1, "r2": R2, "strength": 1.0})
    random = np.random.default_rng(0).normal(size=(500, 3))
    ball = middle + radius * random / np.linalg.norm(random, axis=1, keepdims=True)
    points = nf.morph(ball, user=user, center=CENTER, r1=R1, r2=R2, kind=kind)
    assert np.linalg.norm(points - shown.centers[0], axis=1).max() <= shown.radii[0] * (1 + 1e-9)
