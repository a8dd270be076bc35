"""Levels in scenes: what stands where, what is drawn, and what it costs."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from tests.support.gpu_cases import ADAPTERS, adapter
from tests.support.leveled_cases import (
    GREY,
    RED,
    SIZE,
    ball,
    bytes_of,
    checkers,
    frames,
    model_from,
    model_of,
    same_triangles,
    view,
)

Array = NDArray[np.float64]


def by_hand(models: list[nf.lod.LodModel], index: Sequence[int], transforms: Array, levels: Sequence[int]) -> nf.Scene:
    """The chosen levels' own triangles as instances of grey meshes, in the order of the objects."""
    builder = SceneBuilder()
    material = builder.material(GREY)
    handles: dict[tuple[int, int], int] = {}
    for number, (which, level, matrix) in enumerate(zip(index, levels, transforms, strict=True)):
        builder.object(f"object_{number}")
        if level < 0:
            continue
        if (which, level) not in handles:
            handles[which, level] = add(builder, geometry(models[which])[level].scene, material)
        builder.instance(handles[which, level], matrix, name=f"object_{number}")
    # Moving objects are instances of meshes of their own, as objects with levels are.
    return builder.build(dynamic=[f"object_{number}" for number, level in enumerate(levels) if level >= 0])


def add(builder: SceneBuilder, scene: nf.Scene, material: int) -> int:
    vertices, faces = np.unique(scene.triangles().reshape(-1, 3), axis=0, return_inverse=True)
    return builder.mesh(vertices, faces.reshape(-1, 3).astype(np.uint32), material=material)


def geometry(model: nf.lod.LodModel) -> nf.lod.Levels:
    assert model.levels is not None
    return model.levels


def leveled(scene: nf.Scene) -> Any:
    assert scene.leveled is not None
    return scene.leveled


@pytest.fixture(scope="module")
def models() -> list[nf.lod.LodModel]:
    return [model_of((4, 3, 2), name="ball"), model_of((3, 1), name="egg", stretch=(0.5, 1.5, 0.7))]


LEVELS = [0, 1, 2, 0, -1, 1, 1, -1, 2, 0, 0, 1]
INDEX = [0, 1] * 6


@pytest.mark.parametrize("mirrored", [False, True])
def test_a_picture_of_levels_is_that_of_a_scene_built_from_them(models: list[nf.lod.LodModel], mirrored: bool) -> None:
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


def test_without_lod_everything_is_at_level_0(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, [0, 1, 0], frames(3, seed=2))
    plain = nf.render(scene, view(), backend="cpu")
    assert plain.lod is None
    assert bytes_of(nf.render(scene, view(), lod=[0, 0, 0], backend="cpu")) == bytes_of(plain)
    assert bytes_of(nf.render(scene, view(), lod={"object_1": 0}, backend="cpu")) == bytes_of(plain)
    assert bytes_of(nf.render(scene, view(), lod={"object_1": 1}, backend="cpu")) != bytes_of(plain)


def street() -> tuple[nf.Scene, Array]:
    """A floor and a ball that are merged into one mesh, and two chairs of one mesh."""
    builder = SceneBuilder()
    floor = builder.material(RED)
    sheet = builder.mesh([[-9, -2, -19], [9, -2, -19], [0, -2, 9]], [[0, 2, 1]], material=floor)
    builder.instance(sheet, name="floor")
    place = np.eye(4)
    place[:3, 3] = (0.5, 0.5, -5.0)
    builder.instance(add(builder, ball(3), builder.material(GREY)), place, name="ball")
    chair = add(builder, ball(1), builder.material(GREY))
    builder.place_many(chair, frames(2, seed=8), ["chair_0", "chair_1"])
    return builder.build(), place


def test_levels_take_the_place_of_a_merged_object_and_leave_the_rest() -> None:
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


def test_surfaces_of_levels_come_with_them() -> None:
    plain = model_of((2, 1), color=RED)
    painted = model_of((2, 1), texture=checkers())
    transforms = np.tile(np.eye(4), (2, 1, 1))
    transforms[:, :3, 3] = (-1.5, 0, -5), (1.5, 0, -5)
    scene = nf.lod.place([plain, painted], [0, 1], transforms)
    # One texture for both levels, and of materials each once: red, textured grey, and the unused green.
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
    # Poses go through the inverse of where the object was loaded, so that digits differ by rounding.
    np.testing.assert_allclose(here.require("color"), there.require("color"), atol=1e-4)
    assert np.array_equal(here.require("object_id"), there.require("object_id"))
    # Objects left out of a picture stay out of the poses of the others.
    assert posed.at_levels([0, -1, 0, 0]).at({"object_2": before[2]}).triangle_count > 0
    # Levels that are given later stand where the object is now, and go where it goes.
    late = scene.at({"object_1": after[1]}).with_levels({"object_1": models[0]})
    np.testing.assert_allclose(leveled(late).centers[1], after[1, :3, 3], atol=1e-12)
    back = late.at({"object_1": late.transform("object_1")})
    np.testing.assert_allclose(leveled(back).centers[1], before[1, :3, 3], atol=1e-12)
    later = nf.lod.place(models, [0, 1, 0, 1], before).with_dynamic(["object_3"]).at({"object_3": after[3]})
    np.testing.assert_allclose(leveled(later).centers[3], after[3, :3, 3], atol=1e-12)


def test_spheres_hold_what_stands_in_them_and_no_more(models: list[nf.lod.LodModel]) -> None:
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


def test_scenes_far_from_the_middle_keep_their_digits(models: list[nf.lod.LodModel]) -> None:
    transforms, away = frames(4, seed=7), np.array([3e6, -200.0, 1e6])
    moved = transforms.copy()
    moved[:, :3, 3] += away
    near, far = (nf.lod.place(models, [0, 1, 1, 0], matrices) for matrices in (transforms, moved))
    np.testing.assert_allclose(leveled(far).centers - away, leveled(near).centers, atol=1e-9)
    here = nf.render(near, view(), lod=[1, 1, 0, 2], backend="cpu")
    there = nf.render(far, view(tuple(away)), lod=[1, 1, 0, 2], backend="cpu")
    assert (here.require("object_id") == there.require("object_id")).mean() > 0.999


def test_parts_of_scenes_keep_whole_objects_levels_and_no_others(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, [0, 1, 0], frames(3, seed=9))
    two = scene.subset(objects=["object_0", "object_2"])
    assert leveled(two).names == ("object_0", "object_2")
    assert two.at_levels([2, -1]).triangle_count == models[0].triangles[2]
    assert scene.subset(triangles=[0, 5]).leveled is None
    assert scene.at_levels([0, 0, 1]).leveled is None
    assert nf.lod.place(models, [], np.zeros((0, 4, 4))).triangle_count == 0


class Remembering:
    """A selector that says what it was asked."""

    fade = 0.5

    def __init__(self, answers: list[list[int]]) -> None:
        self.answers, self.asked = answers, []  # type: ignore[var-annotated]

    def select(self, *where: Any, camera: nf.Camera, previous: Any, full: bool) -> Any:
        self.asked.append((where, camera, previous, full))
        return np.array(self.answers[len(self.asked) - 1])


def test_paths_remember_what_was_shown(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, [0, 1], frames(2, seed=10), dynamic=["object_0"])
    selector = Remembering([[2, 1], [1, -1], [0, 0]])
    cameras = [view((0.1 * number, 0.0, 0.0)) for number in range(3)]
    pose = frames(1, seed=11)[0]
    poses = [{}, {"object_0": pose}, {}]
    seen = list(nf.render_path(scene, cameras, at=poses, lod=selector, backend="cpu"))
    assert [frame.lod.levels.tolist() for frame in seen] == selector.answers
    assert [None if before is None else before.tolist() for _, _, before, _ in selector.asked] == [
        None,
        [2, 1],
        [1, -1],
    ]
    assert [full for *_, full in selector.asked] == [True] * 3
    (_, _, centers, radii), camera, _, _ = selector.asked[1]
    posed = scene.at({"object_0": pose})
    assert np.array_equal(centers, leveled(posed).centers)
    assert np.array_equal(radii, leveled(posed).radii)
    assert camera is cameras[1]
    alone = nf.render(posed, cameras[1], lod=[1, -1], backend="cpu")
    assert bytes_of(seen[1]) == bytes_of(alone)
    assert seen[1].lod.triangles == alone.lod.triangles == models[0].triangles[1]


def test_any_function_may_choose(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, [0, 1], frames(2, seed=12))

    def nearest_only(models: Any, index: Any, centers: Array, radii: Array, *, camera: nf.Camera) -> NDArray[np.int64]:
        return np.where(centers[:, 2] == centers[:, 2].max(), 0, -1)

    frame = nf.render(scene, view(), lod=nearest_only, backend="cpu")
    assert sorted(frame.lod.levels) == [-1, 0]
    assert frame.lod.selection.tolist() == frame.lod.levels.tolist()


WRONG: list[tuple[str, Callable[[nf.Scene, nf.lod.LodModel], Any], type[Exception], str]] = [
    ("unknown object", lambda s, m: s.with_levels({"bell": m}), ValueError, "models: the scene has no object 'bell'"),
    ("no mapping", lambda s, m: s.with_levels([m]), TypeError, "models: expected models by name"),  # type: ignore[arg-type]
    (
        "no model",
        lambda s, m: s.with_levels({"ball": 3}),
        TypeError,
        "models\\['ball'\\]: expected a LodModel, got int",
    ),
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
    ("half", lambda s, m: s.with_levels({"ball": m}).at_levels([0.5]), TypeError, "levels"),
    ("name", lambda s, m: s.with_levels({"ball": m}).at_levels({"floor": 0}), ValueError, "levels: .* got 'floor'"),
    ("in render", lambda s, m: nf.render(s.with_levels({"ball": m}), view(), lod=[7]), ValueError, "lod: expected -1"),
    ("index", lambda s, m: nf.lod.place([m], [1], np.eye(4)[None]), ValueError, "model_index: expected 0 to 0"),
    ("indices", lambda s, m: nf.lod.place([m], [0, 0], np.eye(4)[None]), ValueError, "model_index: expected one"),
    ("matrix", lambda s, m: nf.lod.place([m], [0], np.eye(4)), ValueError, "transforms: expected shape"),
    ("flat", lambda s, m: nf.lod.place([m], [0], [np.diag([1, 0, 1, 1])]), ValueError, "flat one for 'object_0'"),
    ("names", lambda s, m: nf.lod.place([m], [0], [np.eye(4)], names=["a", "b"]), ValueError, "names: expected 1"),
    ("a model", lambda s, m: nf.lod.place(m, [0], [np.eye(4)]), TypeError, "models: expected a sequence"),  # type: ignore[arg-type]
]


@pytest.mark.parametrize(("call", "error", "message"), [row[1:] for row in WRONG], ids=[row[0] for row in WRONG])
def test_what_cannot_be_is_said(call: Any, error: type[Exception], message: str) -> None:
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
        # Level 0 of the ball alone has 5,120 faces of 12 bytes; an instance's record and its part have some 100 bytes.
        assert sent < 3 * 40 * 400
        assert sent < int(models[0].triangles[0]) * 12


def test_levels_of_several_pieces_are_one() -> None:
    def pair(detail: int) -> nf.Scene:
        builder = SceneBuilder()
        piece = add(builder, ball(detail), builder.material(RED))
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


def crowd(models: list[nf.lod.LodModel]) -> nf.Scene:
    """Objects all around the eye, most of them out of view."""
    rng = np.random.default_rng(15)
    transforms = frames(60, seed=15)
    transforms[:, :3, 3] = rng.normal(size=(60, 3)) * 12
    return nf.lod.place(models, rng.integers(0, 2, 60), transforms)


@pytest.mark.parametrize("mode", ["off", "depth", "depth+eccentricity", "fovea"])
def test_modes_are_those_of_select(models: list[nf.lod.LodModel], mode: str) -> None:
    scene = crowd(models)
    objects = leveled(scene)
    expected = nf.lod.select(
        objects.models, objects.model_index, objects.centers, objects.radii, camera=view(), mode=mode
    )
    frame = nf.render(scene, view(), lod=mode, backend="cpu")
    assert frame.lod.levels.tolist() == expected.tolist()
    assert bytes_of(frame) == bytes_of(nf.render(scene.at_levels(expected), view(), backend="cpu"))
    # Objects out of view change nothing in the picture.
    everywhere = scene.at_levels(np.maximum(expected, 0))
    assert bytes_of(frame) == bytes_of(nf.render(everywhere, view(), backend="cpu"))
    if mode == "off":
        assert bytes_of(frame) == bytes_of(nf.render(scene, view(), backend="cpu"))
    else:
        assert (expected == -1).sum() > 20
        assert (expected > 0).any()
        assert frame.lod.triangles < frame.lod.full_triangles / 2


def test_selectors_fade_beside_the_picture(models: list[nf.lod.LodModel]) -> None:
    scene = crowd(models)
    selector = nf.lod.Selector(mode="depth", fade=0.5, hysteresis=0.02)
    frame = nf.render(scene, view(), lod=selector, backend="cpu")
    selection = frame.lod.selection
    assert isinstance(selection, nf.lod.Selection)
    assert selection.level.tolist() == frame.lod.levels.tolist()
    assert (selection.shown <= selection.level).all()
    cameras = [view((0.0, 0.0, 0.4 * step)) for step in range(4)]
    objects = leveled(scene)
    before = None
    for camera, picture in zip(cameras, nf.render_path(scene, cameras, lod=selector, backend="cpu"), strict=True):
        where = (objects.models, objects.model_index, objects.centers, objects.radii)
        before = selector.select(*where, camera=camera, previous=before)
        assert picture.lod.levels.tolist() == before.tolist()


def test_scenes_travel_with_their_levels(models: list[nf.lod.LodModel]) -> None:
    scene = crowd(models)
    back = pickle.loads(pickle.dumps(scene))
    levels = np.arange(60) % 2
    pictures = [nf.render(s, view(), lod=levels, backend="cpu") for s in (scene, back)]
    assert bytes_of(pictures[0]) == bytes_of(pictures[1])
    assert leveled(back).radii.tolist() == leveled(scene).radii.tolist()


def test_levels_of_an_object_of_a_scene_stand_where_it_stands() -> None:
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
        # Placed by hand they are what they are.
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


@pytest.mark.parametrize("name", ADAPTERS)
def test_meshes_that_come_later_share_a_page(name: str) -> None:
    """Levels are sent one frame after the other, and cost no more buffers than levels that are there already."""
    levels = nf.lod.simplify(ball(4), [0.8**n for n in range(1, 13)], method="meshopt")
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
