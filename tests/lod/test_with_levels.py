"""Levels for objects of existing scenes, and refused combinations."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from tests.support.leveled_cases import (
    GREY,
    RED,
    SIZE,
    ball,
    bytes_of,
    frames,
    leveled,
    mesh_of,
    model_of,
    same_triangles,
    view,
)

Array = NDArray[np.float64]


def street() -> tuple[nf.Scene, Array]:
    """A floor and a ball that are merged into one mesh, and two chairs of one mesh."""
    builder = SceneBuilder()
    floor = builder.material(RED)
    sheet = builder.mesh([[-9, -2, -19], [9, -2, -19], [0, -2, 9]], [[0, 2, 1]], material=floor)
    builder.instance(sheet, name="floor")
    place = np.eye(4)
    place[:3, 3] = (0.5, 0.5, -5.0)
    builder.instance(mesh_of(builder, ball(3), builder.material(GREY)), place, name="ball")
    chair = mesh_of(builder, ball(1), builder.material(GREY))
    builder.place_many(chair, frames(2, seed=8), ["chair_0", "chair_1"])
    return builder.build(), place


def test_levels_replace_a_merged_object_and_keep_the_rest() -> None:
    scene, place = street()
    assert scene.report.instances == 3
    model = model_of((3, 1))
    whole = scene.with_levels({"ball": model})
    assert whole.object_names == scene.object_names
    assert same_triangles(whole, scene)
    assert leveled(whole).names == ("ball",)
    np.testing.assert_array_equal(leveled(whole).centers[0], model.center + place[:3, 3])
    coarse = whole.at_levels([1])
    assert coarse.triangle_count == scene.triangle_count - 1280 + 80
    ids = nf.render(coarse, view(), backend="cpu").require("object_id")
    assert {0, 1} <= set(np.unique(ids))
    gone = nf.render(whole, view(), lod=[-1], channels=("color", "object_id"), backend="cpu")
    others = scene.subset(objects=["floor", "chair_0", "chair_1"])
    assert bytes_of(gone) == bytes_of(nf.render(others, view(), channels=("color", "object_id"), backend="cpu"))
    both = whole.with_levels({"chair_1": model_of((1, 0)), "ball": model})
    assert leveled(both).names == ("ball", "chair_1")
    assert both.at_levels({"chair_1": 1}).triangle_count == scene.triangle_count - 60


def test_levels_of_an_object_keep_its_pose() -> None:
    source, place = trimesh.Scene(), np.diag([2.0, 1.0, 0.5, 1.0])
    place[:3, 3] = (4.0, 1.0, -6.0)
    source.add_geometry(trimesh.creation.icosphere(3), node_name="ball", transform=place)
    source.add_geometry(trimesh.creation.box(), node_name="box", transform=np.diag([1.0, 2.0, -1.0, 1.0]))
    scene = nf.Scene.from_trimesh(source).with_dynamic(["ball"])
    camera = nf.Camera.look_at((0.0, 1.0, 5.0), (2.0, 0.5, -3.0), fov=nf.Fov.symmetric(90), size=SIZE)
    pose = np.diag([1.0, 1.0, -3.0, 1.0])
    for start in (scene, scene.at({"ball": pose})):
        levels = nf.lod.simplify(start.subset(objects=["ball"]), (0.5, 0.1))
        assert levels.name == "ball"
        model = nf.lod.measure(
            levels, fov=nf.Fov.symmetric(90), size=SIZE, views=4, distances=4, samples=1, cache=False
        )
        # Placed explicitly they keep their coordinates.
        put = nf.lod.place([model], [0], [np.eye(4)])
        assert put.leveled is not None
        np.testing.assert_allclose(put.bounds, levels[0].scene.bounds, atol=1e-5)
        np.testing.assert_allclose(put.leveled.centers[0], levels.center, atol=1e-6)
        leveled = start.with_levels({"ball": model})
        assert leveled.leveled is not None
        np.testing.assert_allclose(leveled.leveled.centers[0], levels.center, atol=1e-6)
        for pose_now in (start, start.at({"ball": place}), start.at({"ball": pose})):
            shown = pose_now.with_levels({"ball": model})
            differ = nf.render(shown, camera).require("color") != nf.render(pose_now, camera).require("color")
            assert differ.any(axis=-1).mean() < 0.002


WRONG: list[tuple[str, Callable[[nf.Scene, nf.lod.LodModel], Any], type[Exception], str]] = [
    ("unknown object", lambda s, m: s.with_levels({"bell": m}), ValueError, "models: the scene has no object 'bell'"),
    ("no levels", lambda s, m: nf.render(s, view(), lod=[0]), ValueError, "lod: .* see Scene.with_levels"),
    ("no levels", lambda s, m: s.at_levels([0]), ValueError, "levels: .* see with_levels"),
    (
        "count",
        lambda s, m: s.with_levels({"ball": m}).at_levels([0, 1]),
        ValueError,
        "levels: expected one for each of 1",
    ),
    ("range", lambda s, m: s.with_levels({"ball": m}).at_levels([2]), ValueError, "expected -1 to 1 for 'ball', got 2"),
    ("below", lambda s, m: s.with_levels({"ball": m}).at_levels([-2]), ValueError, "expected -1 to 1 for 'ball'"),
    ("name", lambda s, m: s.with_levels({"ball": m}).at_levels({"floor": 0}), ValueError, "levels: .* got 'floor'"),
    ("in render", lambda s, m: nf.render(s.with_levels({"ball": m}), view(), lod=[7]), ValueError, "lod: expected -1"),
    ("index", lambda s, m: nf.lod.place([m], [1], np.eye(4)[None]), ValueError, "model_index: expected 0 to 0"),
    ("indices", lambda s, m: nf.lod.place([m], [0, 0], np.eye(4)[None]), ValueError, "model_index: expected one"),
    ("flat", lambda s, m: nf.lod.place([m], [0], [np.diag([1, 0, 1, 1])]), ValueError, "flat one for 'object_0'"),
    ("names", lambda s, m: nf.lod.place([m], [0], [np.eye(4)], names=["a", "b"]), ValueError, "names: expected 1"),
]


@pytest.mark.parametrize(("call", "error", "message"), [row[1:] for row in WRONG], ids=[row[0] for row in WRONG])
def test_impossible_levels_are_errors(call: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        call(street()[0], model_of((1, 0)))


def test_models_need_geometry() -> None:
    whole = model_of((1, 0))
    bare = nf.lod.LodModel(
        triangles=whole.triangles,
        curves=whole.curves,
        center=whole.center,
        radius=whole.radius,
        sigma=whole.sigma,
        errors=whole.errors,
    )
    with pytest.raises(ValueError, match="expected a model with the geometry of its levels"):
        nf.lod.place([bare], [0], np.eye(4)[None])
