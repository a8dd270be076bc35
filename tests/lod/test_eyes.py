"""Levels for two eyes with different views, and for the direction of gaze."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.leveled_cases import frames, leveled
from tests.support.lod_oracle import random_spheres, usual

LENS = nf.RadialLens((0.22, 0.24))
FOV = nf.Fov(-1.0, 0.9, -1.1, 1.05)


# eyes ----------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", ["PIMAX_5K_PLUS", "VIVE_PRO", "INDEX"])
def test_the_finer_level_of_both_eyes_is_used(name: str) -> None:
    hmd = nf.hmd.get(name)
    head = (0.3, 1.6, 0.2)
    pose = nf.Camera.look_at(head, (1, 1, -5), fov=FOV, size=(9, 9)).orientation
    eyes = [hmd.camera(side, head, pose) for side in ("left", "right")]
    centers, radii = random_spheres(4000, 8, nf.Camera(head, pose, fov=FOV, size=(9, 9)), 3)
    options: dict[str, Any] = {"lens": LENS, "lens_radius": hmd.tan_half_angle, "full": True}
    options["reference"] = nf.lod.reference_solid_angle(hmd)
    index = np.arange(4000) % 2
    models = [usual(), usual(5, 3)]
    both = nf.lod.select(models, index, centers, radii, camera=eyes, **options)
    apart = [nf.lod.select(models, index, centers, radii, camera=eye, **options) for eye in eyes]
    levels = np.array([part.level for part in apart])
    seen = levels >= 0
    assert np.array_equal(both.level, np.where(seen.any(axis=0), np.where(seen, levels, 99).min(axis=0), -1))
    assert (seen[0] != seen[1]).any()
    assert (levels[0] != levels[1])[seen.all(axis=0)].any()
    # The columns are those of the eye that required the level.
    first = np.where(levels[0] == both.level, 0, 1)
    seen_size = np.where(first == 0, apart[0].sigma_seen, apart[1].sigma_seen)
    chosen = both.level > 0
    assert np.array_equal(both.sigma_seen[chosen], seen_size[chosen])
    default = nf.lod.select(models, index, centers, radii, camera=eyes, lens=LENS)
    assert np.array_equal(default, both.level)


# a rig with a shared picture ------------------------------------------------------------------------------------------
def test_a_budget_limits_what_a_rig_draws(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, np.arange(40) % 2, frames(40, seed=4))
    objects = leveled(scene)
    # The plane passes through the objects, which lie 6 to 12 m ahead.
    rig = nf.stereo.HybridRig.of(nf.hmd.QUEST_2, mono_plane=9.0, size=(24, 24))
    # A weight of 0 for all objects asks for the coarsest levels.
    nothing = nf.lod.Selector(budget=10**9, weight=np.zeros(40))
    coarsest, full = (rig.render(scene, (0, 0, 0), lod=lod, backend="cpu").left.lod for lod in (nothing, "off"))
    assert coarsest is not None
    assert full is not None
    least = coarsest.selection.spent.drawn
    budget = 2 * least
    assert coarsest.triangles < least < budget < full.triangles
    frame = rig.render(scene, (0, 0, 0), lod=nf.lod.Selector(budget=budget), backend="cpu")
    assert frame.left.lod is not None
    spent = frame.left.lod.selection.spent
    draws = rig._core.draws(scene.level_boxes, ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), (0.1, math.inf)))
    in_view = frame.left.lod.levels >= 0
    triangles = [
        objects.models[m].triangles[n] for m, n in zip(objects.model_index, frame.left.lod.levels, strict=True)
    ]
    assert spent.triangles == np.sum(triangles, where=in_view) == frame.left.lod.triangles
    assert spent.drawn == np.sum(np.maximum(draws, 1) * triangles, where=in_view)
    # The boxes around all levels are not smaller than those of the drawn levels.
    views = frame.stats["triangles"]
    assert spent.triangles < views["left"] + views["right"] + views["center"] <= spent.drawn <= budget
    assert {1, 3} == set(draws[in_view].tolist())
    # Objects counted once would exceed the budget.
    eyes = rig.cameras((0, 0, 0))[:2]
    where = objects.models, objects.model_index, objects.centers, objects.radii
    once = nf.lod.select(*where, camera=eyes, budget=budget).spent
    assert once is not None
    assert spent.triangles < once.triangles == once.drawn <= budget
    # Plain stereo draws each object for both eyes.
    plain = nf.render_eyes(scene, nf.hmd.QUEST_2, (0, 0, 0), size=(24, 24), lod=nf.lod.Selector(budget=budget))
    assert plain.left.lod is not None
    assert plain.left.lod is plain.right.lod
    spent = plain.left.lod.selection.spent
    assert spent.drawn == 2 * spent.triangles == 2 * plain.left.lod.triangles <= budget
    assert spent.triangles < once.triangles


class Coarsest:
    """A selector that knows no budget, and so no numbers of draws."""

    fade = 0.0

    def select(
        self, models: Any, index: Any, centers: Any, radii: Any, *, camera: Any, previous: Any, full: bool
    ) -> Any:
        return np.array([len(models[number]) - 1 for number in index])


def test_draws_are_counted_for_budgets_only(models: list[nf.lod.LodModel]) -> None:
    scene = nf.lod.place(models, [0, 1], frames(2, seed=4))
    rig = nf.stereo.HybridRig.of(nf.hmd.QUEST_2, mono_plane=9.0, size=(24, 24))
    shown = rig.render(scene, (0, 0, 0), lod=Coarsest(), backend="cpu").left.lod
    assert shown is not None
    assert shown.levels.tolist() == [len(model) - 1 for model in leveled(scene).models]


# the eye -------------------------------------------------------------------------------------------------------------
def test_objects_away_from_the_gaze_get_coarser_levels() -> None:
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(100), size=(2000, 2000))
    angles = np.radians(np.linspace(0, 45, 40))
    centers = 8 * np.stack([np.sin(angles), 0 * angles, -np.cos(angles)], axis=1)
    index = np.zeros(40, int)
    plain = nf.lod.select([usual(12)], index, centers, 0.4, camera=camera)
    ahead = nf.lod.select([usual(12)], index, centers, 0.4, camera=camera, mode="fovea", full=True)
    assert (np.diff(ahead.level) >= 0).all()
    assert ahead.level[0] == plain[0]
    assert ahead.level[-1] > plain[-1]
    mu = math.asin(0.4 / 8)
    away = np.degrees(np.maximum(angles - mu, 0))
    pixel = math.degrees(math.atan(2 * math.tan(math.radians(50)) / 2000))
    scale = nf.lod.acuity(away, pixel_deg=pixel)
    np.testing.assert_allclose(ahead.sigma_seen, ahead.sigma * scale**2, rtol=1e-9)
    # With the gaze at the last object the sizes are reversed, and the length of the gaze vector does not matter.
    aside = nf.lod.select(
        [usual(12)], index, centers, 0.4, camera=camera, mode="fovea", gaze=1e-200 * centers[-1], full=True
    )
    np.testing.assert_allclose(aside.sigma_seen, ahead.sigma_seen[::-1], rtol=1e-9)


def test_canted_eyes_look_ahead_together() -> None:
    head = nf.hmd.PIMAX_5K_PLUS
    eyes = [head.camera(side, (0.0, 0.0, 0.0)) for side in ("left", "right")]
    centers = np.array([[0.0, 0.0, -z] for z in (8.0, 10.0, 14.0, 20.0)])
    index = np.zeros(len(centers), int)
    chosen = nf.lod.select([usual(12)], index, centers, 1.0, camera=eyes, mode="fovea", full=True)
    ahead = nf.lod.select([usual(12)], index, centers, 1.0, camera=eyes, mode="fovea", gaze=(0, 0, -1), full=True)
    np.testing.assert_allclose(chosen.sigma_seen, chosen.sigma, rtol=1e-12)
    assert np.array_equal(chosen.level, ahead.level)
    back = nf.Camera((0, 0, 0), (0, 1, 0, 0), fov=eyes[0].fov, size=eyes[0].size)
    front = nf.Camera((0, 0, 0), fov=eyes[0].fov, size=eyes[0].size)
    with pytest.raises(ValueError, match="gaze: expected a direction for cameras that look"):
        nf.lod.select([usual(12)], index, centers, 1.0, camera=[front, back], mode="fovea")
