"""Levels that modes, selectors and functions choose while scenes and paths are rendered."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from tests.support import need
from tests.support.leveled_cases import bytes_of, frames, leveled, view

Array = NDArray[np.float64]


def test_without_lod_everything_is_at_level_0(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, [0, 1, 0], frames(3, seed=2))
    plain = nf.render(scene, view(), backend="cpu")
    assert plain.lod is None
    assert bytes_of(nf.render(scene, view(), lod=[0, 0, 0], backend="cpu")) == bytes_of(plain)
    assert bytes_of(nf.render(scene, view(), lod={"object_1": 0}, backend="cpu")) == bytes_of(plain)
    assert bytes_of(nf.render(scene, view(), lod={"object_1": 1}, backend="cpu")) != bytes_of(plain)


class Remembering:
    """A selector that records its arguments."""

    fade = 0.5

    def __init__(self, answers: list[list[int]]) -> None:
        self.answers, self.asked = answers, []  # type: ignore[var-annotated]

    def select(self, *where: Any, camera: nf.Camera, previous: Any, full: bool) -> Any:
        self.asked.append((where, camera, previous, full))
        return np.array(self.answers[len(self.asked) - 1])


def test_paths_pass_the_previous_levels(models: list[nf.lod.LodModel]) -> None:
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


def test_any_function_may_select_levels(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, [0, 1], frames(2, seed=12))

    def nearest_only(models: Any, index: Any, centers: Array, radii: Array, *, camera: nf.Camera) -> NDArray[np.int64]:
        return np.where(centers[:, 2] == centers[:, 2].max(), 0, -1)

    frame = nf.render(scene, view(), lod=nearest_only, backend="cpu")
    assert sorted(frame.lod.levels) == [-1, 0]
    assert frame.lod.selection.tolist() == frame.lod.levels.tolist()


def crowd(models: list[nf.lod.LodModel]) -> nf.Scene:
    """Return objects all around the eye, most of them out of view."""
    rng = np.random.default_rng(15)
    transforms = frames(60, seed=15)
    transforms[:, :3, 3] = rng.normal(size=(60, 3)) * 12
    return nf.lod.place(models, rng.integers(0, 2, 60), transforms)


@pytest.mark.parametrize("mode", ["off", "depth", "depth+eccentricity", "fovea"])
def test_modes_equal_select(models: list[nf.lod.LodModel], mode: Any) -> None:
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


def test_selectors_report_fades_with_the_picture(models: list[nf.lod.LodModel]) -> None:
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


def test_scenes_are_pickled_with_their_levels(models: list[nf.lod.LodModel]) -> None:
    scene = crowd(models)
    back = pickle.loads(pickle.dumps(scene))
    levels = np.arange(60) % 2
    pictures = [nf.render(s, view(), lod=levels, backend="cpu") for s in (scene, back)]
    assert bytes_of(pictures[0]) == bytes_of(pictures[1])
    assert leveled(back).radii.tolist() == leveled(scene).radii.tolist()


def test_budgets_hold_in_each_picture_and_keep_the_price(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, np.arange(12) % 2, frames(12, seed=4))
    cameras = [view(), view(), view()]
    coarsest = nf.render(scene, view(), lod=nf.lod.Selector(budget=10**9, weight=np.zeros(12)), backend="cpu").lod
    full = nf.render(scene, view(), lod="off", backend="cpu").lod
    assert coarsest is not None
    assert full is not None
    assert coarsest.triangles < full.triangles
    budget = (coarsest.triangles + full.triangles) // 2
    selector = nf.lod.Selector(budget=budget, hysteresis=0.9)
    shown = [frame.lod for frame in nf.render_path(scene, cameras, lod=selector, backend="cpu")]
    prices = [each.selection.spent.price for each in shown if each is not None]
    assert len(set(prices)) == 1
    for each in shown:
        assert each is not None
        assert coarsest.triangles <= each.triangles == each.selection.spent.triangles <= budget


@pytest.mark.slow
def test_weights_by_pixels_give_the_best_pictures() -> None:
    """27 comparisons (nine scenes, three budgets): one object fills the view; weights are equal, or by screen error."""
    need("fast_simplification")
    screen: dict[str, Any] = {"fov": nf.Fov.symmetric(90), "size": (240, 240)}
    models = [
        nf.lod.measure(nf.lod.simplify(stone(number, *shape), ratios=(0.25, 0.06, 0.015)), **screen)
        for number, shape in enumerate([(0.3, 3.0), (0.25, 6.0), (0.15, 12.0), (0.05, 20.0)])
    ]
    camera = nf.Camera.look_at((0, 0, 0), (0, 0, -1), **screen)
    found = []
    for seed in range(9):
        random = np.random.default_rng(seed)
        away, distances = random.normal(size=(40, 3)), random.uniform(4, 25, 40)
        away[:, 2] = -np.abs(away[:, 2])
        away[0], distances[0] = (0, 0, -1), 1.6
        places = away * (distances / np.linalg.norm(away, axis=1))[:, None]
        index = random.integers(0, len(models), len(places)).tolist()
        poses = np.tile(np.eye(4), (len(places), 1, 1))
        poses[:, :3, 3] = places
        scene = nf.lod.place(models, index, poses)

        def picture(lod: Any, scene: nf.Scene = scene) -> nf.Frame:
            return nf.render(scene, camera, samples=4, channels=("color",), lod=lod, backend="cpu")

        truth = picture(None)
        errors = [models[n].errors * 120 / (distance - 1.2) for n, distance in zip(index, distances, strict=True)]
        for pixels in (1, 2, 4):
            rule = [int(np.flatnonzero(error <= pixels).max()) for error in errors]
            by_rule = picture(rule)
            is_seen = picture(nf.lod.Selector(budget=10**9)).lod.levels >= 0
            budget = sum(
                int(models[n].triangles[level]) for n, level, seen in zip(index, rule, is_seen, strict=True) if seen
            )
            frames = [
                by_rule,
                *(picture(nf.lod.Selector(budget=budget, weight=weight)) for weight in ("object", "pixels")),
            ]
            found.append([nf.ssim(truth, frame) for frame in frames])
    rule, objects, ours = np.array(found).T
    assert (ours >= objects - 0.002).all()
    # Scores are measured for objects alone, without what hides them.
    assert (ours >= rule - 0.003).all()
    assert ours.mean() > objects.mean() + 0.05
    assert ours.mean() > rule.mean()


def stone(seed: int, roughness: float, waves: float) -> nf.Scene:
    """A ball of 5,120 triangles with waves in random directions."""
    ball = trimesh.creation.icosphere(4)
    axes = np.random.default_rng(seed + 1).normal(size=(8, 3))
    heights = np.cos(waves * ball.vertices @ axes.T).mean(axis=1)
    return nf.Scene.from_trimesh(
        trimesh.Trimesh(ball.vertices * (1 + roughness * heights)[:, None], ball.faces, process=False)
    )
