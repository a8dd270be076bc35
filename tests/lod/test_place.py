"""Scenes of many placed models: positions, appearance and shared meshes of levels."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from tests.support.gpu_cases import ADAPTERS, adapter
from tests.support.leveled_cases import (
    GREY,
    RED,
    ball,
    bytes_of,
    checkers,
    frames,
    leveled,
    mesh_of,
    model_from,
    model_of,
    same_triangles,
    view,
)

Array = NDArray[np.float64]


def by_hand(models: list[nf.lod.LodModel], index: Sequence[int], transforms: Array, levels: Sequence[int]) -> nf.Scene:
    """Return the chosen levels' own triangles as instances of grey meshes, in the order of the objects."""
    builder = SceneBuilder()
    material = builder.material(GREY)
    handles: dict[tuple[int, int], int] = {}
    for number, (which, level, matrix) in enumerate(zip(index, levels, transforms, strict=True)):
        builder.object(f"object_{number}")
        if level < 0:
            continue
        if (which, level) not in handles:
            handles[which, level] = mesh_of(builder, geometry(models[which])[level].scene, material)
        builder.instance(handles[which, level], matrix, name=f"object_{number}")
    # Moving objects are instances of separate meshes, like objects with levels.
    return builder.build(dynamic=[f"object_{number}" for number, level in enumerate(levels) if level >= 0])


def geometry(model: nf.lod.LodModel) -> nf.lod.Levels:
    assert model.levels is not None
    return model.levels


LEVELS = [0, 1, 2, 0, -1, 1, 1, -1, 2, 0, 0, 1]


INDEX = [0, 1] * 6


@pytest.mark.parametrize("mirrored", [False, True])
def test_a_picture_of_levels_equals_a_scene_built_from_them(models: list[nf.lod.LodModel], mirrored: bool) -> None:
    transforms = frames(12, seed=1, mirrored=mirrored)
    scene = nf.lod.place(models, INDEX, transforms)
    frame = nf.render(scene, view(), lod=LEVELS, backend="cpu")
    truth = by_hand(models, INDEX, transforms, LEVELS)
    assert bytes_of(frame) == bytes_of(nf.render(truth, view(), backend="cpu"))
    assert same_triangles(scene.at_levels(LEVELS), truth)
    assert frame.lod.levels.tolist() == LEVELS
    assert frame.lod.triangles == truth.triangle_count
    assert frame.lod.full_triangles == 6 * (models[0].triangles[0] + models[1].triangles[0]) == scene.triangle_count
    shown = np.unique(frame.require("object_id"))
    assert not np.isin([4, 7], shown).any()
    assert len(shown) > 6


def test_surfaces_of_levels_come_with_them() -> None:
    plain = model_of((2, 1), color=RED)
    painted = model_of((2, 1), texture=checkers())
    transforms = np.tile(np.eye(4), (2, 1, 1))
    transforms[:, :3, 3] = (-1.5, 0, -5), (1.5, 0, -5)
    scene = nf.lod.place([plain, painted], [0, 1], transforms)
    # One texture for both levels, and each material once: red, textured grey, and the unused green.
    assert (scene.report.textures, scene.report.materials) == (1, 3)
    builder = SceneBuilder()
    for number, (model, material) in enumerate(
        [(plain, builder.material(RED)), (painted, builder.material(GREY, checkers()))]
    ):
        corners = geometry(model)[1].scene.triangles().reshape(-1, 3)
        faces = np.arange(len(corners)).reshape(-1, 3)
        uvs = corners[:, :2] * np.float32(0.9)
        builder.instance(
            builder.mesh(corners, faces, material=material, uvs=uvs), transforms[number], name=f"object_{number}"
        )
    truth = builder.build(dynamic=["object_0", "object_1"])
    frame = nf.render(scene, view(), lod=[1, 1], backend="cpu")
    assert bytes_of(frame) == bytes_of(nf.render(truth, view(), backend="cpu"))
    assert len(np.unique(frame.to_image().reshape(-1, 3), axis=0)) > 100


def test_dynamic_objects_carry_their_levels_and_spheres(models: list[nf.lod.LodModel]) -> None:
    before, after = frames(4, seed=3), frames(4, seed=4)
    scene = nf.lod.place(models, [0, 1, 0, 1], before, dynamic=["object_1", "object_2"])
    posed = scene.at({"object_1": after[1], "object_2": after[2]})
    still = nf.lod.place(models, [0, 1, 0, 1], [before[0], after[1], after[2], before[3]])
    np.testing.assert_allclose(leveled(posed).centers, leveled(still).centers, atol=1e-12)
    np.testing.assert_allclose(leveled(posed).radii, leveled(still).radii, rtol=1e-12)
    levels = [1, 1, 2, -1]
    here, there = (nf.render(s, view(), lod=levels, backend="cpu") for s in (posed, still))
    # Poses are multiplied by the inverse of the loaded transform, so digits differ by rounding.
    np.testing.assert_allclose(here.require("color"), there.require("color"), atol=1e-4)
    assert np.array_equal(here.require("object_id"), there.require("object_id"))
    # Objects omitted from a picture are not in the poses of the others.
    assert posed.at_levels([0, -1, 0, 0]).at({"object_2": before[2]}).triangle_count > 0
    # Levels added later stand at the object's current pose, and move with it.
    late = scene.at({"object_1": after[1]}).with_levels({"object_1": models[0]})
    np.testing.assert_allclose(leveled(late).centers[1], after[1, :3, 3], atol=1e-12)
    back = late.at({"object_1": late.transform("object_1")})
    np.testing.assert_allclose(leveled(back).centers[1], before[1, :3, 3], atol=1e-12)
    later = nf.lod.place(models, [0, 1, 0, 1], before).with_dynamic(["object_3"]).at({"object_3": after[3]})
    np.testing.assert_allclose(leveled(later).centers[3], after[3, :3, 3], atol=1e-12)


def test_bounding_spheres_are_tight(models: list[nf.lod.LodModel]) -> None:
    transforms = frames(8, seed=5, mirrored=True)
    scene = nf.lod.place([models[0]], [0] * 8, transforms)
    objects = leveled(scene)
    ends = np.linalg.svd(transforms[:, :3, :3], compute_uv=False)[:, 0]
    np.testing.assert_allclose(objects.radii, models[0].radius * ends, rtol=1e-12)
    corners = scene.triangles().reshape(8, -1, 3)
    away = np.linalg.norm(corners - objects.centers[:, None], axis=-1).max(axis=1)
    # A ball of radius 1 becomes an ellipsoid of these half axes; its facets cut 1 % off.
    assert (away <= objects.radii * (1 + 1e-6)).all()
    assert (away >= objects.radii * 0.98).all()


def test_a_thousand_objects_share_the_meshes_of_their_levels() -> None:
    shared = [model_of((2, 2, 2, 2, 1, 1, 1, 1, 0, 0, 0)) for _ in range(3)]
    rng = np.random.default_rng(6)
    scene = nf.lod.place(shared, rng.integers(0, 3, 1000), frames(1000, seed=6))
    assert len(np.unique(scene._core.mesh_ids())) == 3
    known: set[int] = set()
    for _ in range(4):
        known |= set(scene.at_levels(rng.integers(-1, 11, 1000))._core.mesh_ids().tolist())
    assert len(known) == 33
    assert set(scene._core.mesh_ids().tolist()) <= known
    same = scene.at_levels(np.zeros(1000, int))
    assert np.array_equal(same._core.mesh_ids(), scene._core.mesh_ids())


def test_scenes_far_from_the_origin_keep_their_digits(models: list[nf.lod.LodModel]) -> None:
    transforms, away = frames(4, seed=7), np.array([3e6, -200.0, 1e6])
    moved = transforms.copy()
    moved[:, :3, 3] += away
    near, far = (nf.lod.place(models, [0, 1, 1, 0], matrices) for matrices in (transforms, moved))
    np.testing.assert_allclose(leveled(far).centers - away, leveled(near).centers, atol=1e-9)
    here = nf.render(near, view(), lod=[1, 1, 0, 2], backend="cpu")
    there = nf.render(far, view(tuple(away)), lod=[1, 1, 0, 2], backend="cpu")
    assert (here.require("object_id") == there.require("object_id")).mean() > 0.999


def test_subsets_keep_levels_of_complete_objects_only(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, [0, 1, 0], frames(3, seed=9))
    two = scene.subset(objects=["object_0", "object_2"])
    assert leveled(two).names == ("object_0", "object_2")
    assert two.at_levels([2, -1]).triangle_count == models[0].triangles[2]
    assert scene.subset(triangles=[0, 5]).leveled is None
    assert scene.at_levels([0, 0, 1]).leveled is None
    assert nf.lod.place(models, [], np.zeros((0, 4, 4))).triangle_count == 0


@pytest.mark.parametrize("name", ADAPTERS)
def test_adapters_get_each_mesh_once(models: list[nf.lod.LodModel], name: str) -> None:
    transforms = frames(40, seed=13)
    scene = nf.lod.place(models, [0, 1] * 20, transforms)
    switched = [[0, 1] * 20, [2, 0] * 20, [1, -1] * 20]
    with adapter(name):
        for levels in switched:
            nf.render(scene, view(), lod=levels, backend="gpu")
        before = nf.gpu.stats()["uploaded_bytes"]
        for levels in switched:
            frame = nf.render(scene, view(), lod=levels, backend="gpu")
            truth = nf.render(scene, view(), lod=levels, backend="cpu")
            assert (frame.require("object_id") == truth.require("object_id")).mean() > 0.995
        sent = nf.gpu.stats()["uploaded_bytes"] - before
        # Level 0 of the ball has 5,120 faces of 12 bytes; the records of an instance and its part take some 100 bytes.
        assert sent < 3 * 40 * 400
        assert sent < int(models[0].triangles[0]) * 12


def test_levels_of_several_pieces_are_merged() -> None:
    def pair(detail: int) -> nf.Scene:
        builder = SceneBuilder()
        piece = mesh_of(builder, ball(detail), builder.material(RED))
        places = np.tile(np.eye(4), (2, 1, 1))
        places[1, :3, 3] = (2.5, 0.25, 0)
        builder.place_many(piece, places, "piece")
        return builder.build()

    model = model_from([pair(2), pair(0)])
    place = frames(1, seed=14)
    scene = nf.lod.place([model], [0], place)
    assert scene._core.instance_count == 1
    for level in (0, 1):
        local = geometry(model)[level].scene.triangles().astype(np.float64)
        world = local @ place[0, :3, :3].T + place[0, :3, 3]
        np.testing.assert_allclose(scene.at_levels([level]).triangles(), world, atol=2e-6)


@pytest.mark.parametrize("name", ADAPTERS)
def test_meshes_that_come_later_share_a_page(name: str) -> None:
    """Levels are uploaded one frame after the other, and need no more buffers than levels that exist already."""
    levels = nf.lod.simplify(ball(4), [0.8**n for n in range(1, 8)], method="meshopt")
    model = model_from([level.scene for level in levels])
    count = len(model)
    scene = nf.lod.place([model], [0] * count, frames(count, seed=15))
    made = []
    with adapter(name):
        for shift in range(2):
            for n in range(count):
                before = nf.gpu.stats()["allocations"]
                shown = np.full(count, n) if shift == 0 else np.roll(np.arange(count), n)
                frame = nf.render(scene, view(), lod=shown, backend="gpu")
                made.append(nf.gpu.stats()["allocations"] - before)
        truth = nf.render(scene, view(), lod=shown, backend="cpu")
    assert made[2:count] == made[count + 2 :]
    # Ranges are within 1e-5 of the tracer's, where both show the same face: edges differ in one pixel of 200.
    assert np.isclose(frame.require("range"), truth.require("range"), rtol=1e-5).mean() > 0.995


def test_level_boxes_contain_every_level(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, [0, 1, 1], frames(3, seed=6), dynamic=["object_1"])
    pose = frames(1, seed=7)[0]
    for posed in (scene, scene.at({"object_1": pose})):
        boxes = posed.level_boxes
        for number, model in enumerate(np.array([0, 1, 1])):
            shown = []
            for level in range(len(models[model])):
                levels = np.where(np.arange(3) == number, level, -1)
                corners = posed.at_levels(levels).triangles().reshape(-1, 3) + posed.origin
                shown.append([corners.min(axis=0), corners.max(axis=0)])
            low, high = np.min(shown, axis=(0, 1)), np.max(shown, axis=(0, 1))
            assert (boxes[number, 0] <= low + 1e-5).all()
            assert (boxes[number, 1] >= high - 1e-5).all()
            # Boxes around turned boxes are at most √3 times as large as a turned ball needs.
            assert (boxes[number, 1] - boxes[number, 0] <= np.sqrt(3) * (high - low) + 1e-5).all()
    assert not np.array_equal(scene.level_boxes[1], posed.level_boxes[1])
    assert nf.datasets.room(detail=0).level_boxes.shape == (0, 2, 3)
