"""Tests of radii chosen by the shear of the ground."""

from __future__ import annotations

import numpy as np
import pytest

import nearfar as nf

CENTER = np.array([3.0, 1.7, -2.0])


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return nf.datasets.city(blocks=4, detail=1)


def seen_shear(radii: nf.Radii, azimuth: float) -> float:
    """Greatest shear of the ground seen by a user `reach` beside the centre, by small steps along the ground.

    A step towards a point of the ground moves its picture upwards; the morph moves it sideways as well.
    """
    user = CENTER + np.array([0.0, 0.0, radii.reach])
    rho = np.linspace(radii.r1, radii.r2, 2001)
    forward = np.array([np.cos(azimuth), np.sin(azimuth)])
    ground = np.column_stack([rho * forward[0], np.full_like(rho, -radii.eye_height), rho * forward[1]]) + CENTER
    shown = nf.morph(ground, user=user, center=CENTER, r1=radii.r1, r2=radii.r2) - user
    x, y = shown[:, 2] / shown[:, 0], shown[:, 1] / shown[:, 0]
    truth = ground - user
    at = truth[:, 2] / truth[:, 0], truth[:, 1] / truth[:, 0]
    # Sideways per upward step, minus that of the true picture.
    return float(np.abs(np.diff(x) / np.diff(y) - np.diff(at[0]) / np.diff(at[1])).max())


@pytest.mark.parametrize(("reach", "height", "shear", "r2"), [(8, 1.7, 1, 50), (2, 1.7, 0.5, 100), (0.5, 1.2, 2, 30)])
def test_the_ground_has_the_requested_shear(
    scene: nf.Scene, reach: float, height: float, shear: float, r2: float
) -> None:
    radii = nf.choose_radii(scene, CENTER, r2=r2, reach=reach, eye_height=height, shear=shear)
    assert radii.r1 == pytest.approx(shear * height * r2 / (reach + shear * height))
    assert radii.shear == pytest.approx(shear)
    assert radii.remarks == ()
    # The formula holds for ground far away compared with the reach; nearer ground is seen from more above.
    assert seen_shear(radii, 0.0) == pytest.approx(shear, rel=0.35)


def test_the_documented_example(scene: nf.Scene) -> None:
    radii = nf.choose_radii(scene, CENTER, r2=50, reach=8, eye_height=1.7, shear=1)
    assert (round(radii.r1, 1), radii.r2) == (8.8, 50.0)
    margin = nf.fold_margin(CENTER, center=CENTER, r1=radii.r1, r2=radii.r2)
    assert radii.fold_margin == pytest.approx(margin, abs=1e-3 * 50)


def test_a_small_r2_exceeds_the_shear_with_a_note(scene: nf.Scene) -> None:
    radii = nf.choose_radii(scene, CENTER, r2=20)
    assert radii.r1 == 8.0
    assert radii.shear == pytest.approx(8**2 / (12 * 1.7))
    assert radii.remarks == (
        "the ground between the radii is sheared by up to 3.1 instead of 1: that needs r2 of at least 45.6 m",
    )
    assert nf.choose_radii(scene, CENTER, r2=45.7).remarks == ()


def test_a_budget_determines_the_greatest_r2(scene: nf.Scene) -> None:
    budget = scene.triangle_count // 2
    radii = nf.choose_radii(scene, CENTER, budget=budget)
    curve = nf.load_curve(scene, center=CENTER)
    assert radii.r2 == curve.radius(budget)
    everything = nf.choose_radii(scene, CENTER, budget=scene.triangle_count)
    assert curve.count(everything.r2) == scene.triangle_count
    parts = nf.partition(scene, center=CENTER, r1=radii.r1, r2=radii.r2).summary()
    assert parts["nsf"] <= budget


def test_radii_that_would_fold_are_refused(scene: nf.Scene) -> None:
    for r2 in (5, 8, 16.4):
        with pytest.raises(ValueError, match=f"r2: expected an r2 of at least 16.46 m for a reach of 8 m.*, got {r2}"):
            nf.choose_radii(scene, CENTER, r2=r2)
    assert nf.choose_radii(scene, CENTER, r2=16.46).fold_margin >= 8.0
    with pytest.raises(ValueError, match=r"budget: expected an r2 of at least .*, which gives"):
        nf.choose_radii(scene, CENTER, budget=nf.load_curve(scene, center=CENTER).count(10))


def test_either_a_radius_or_a_budget_is_required(scene: nf.Scene) -> None:
    with pytest.raises(ValueError, match="r2: expected either r2 or budget, got neither"):
        nf.choose_radii(scene, CENTER)
    with pytest.raises(ValueError, match="budget"):
        nf.choose_radii(scene, CENTER, budget=-1)


def test_low_places_do_not_fold_within_reach() -> None:
    """For an r2 slightly above its minimum the formula alone gives an r1 at which the picture would fold."""
    scene = nf.datasets.city(blocks=1, detail=0)
    chosen = nf.choose_radii(scene, (0, 1.7, 0), r2=2.1, reach=1.0)
    assert 1.0 <= chosen.r1 < 1.7 * 2.1 / 2.7
    assert chosen.fold_margin == pytest.approx(1.0, abs=1e-6)
    with pytest.raises(ValueError, match=r"r2: expected an r2 of at least 2\.057 m"):
        nf.choose_radii(scene, (0, 1.7, 0), r2=2.05, reach=1.0)
