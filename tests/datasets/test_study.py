"""Tests of the user study's scenes: bytes, answers, arguments."""

from __future__ import annotations

import hashlib
import itertools

import numpy as np
import pytest

import nearfar as nf
from nearfar.datasets import count_task, sphere_task, tape_task


def digest(scene: nf.Scene) -> str:
    return hashlib.sha256(np.ascontiguousarray(scene.triangles()).tobytes()).hexdigest()[:16]


def test_the_same_seed_gives_the_same_bytes() -> None:
    scenes = [tape_task(7), tape_task(7, 7, ends="far"), sphere_task(7), sphere_task(7, straight=False), count_task(7)]
    assert [digest(scene) for scene, _ in scenes] == [
        "d6f08ba1b65b724b",
        "6e1beedd15b5ed82",
        "0e71e006a71808c9",
        "7604fa7b245a7311",
        "af7e92cf0fed1b05",
    ]
    assert tape_task(7)[1] == tape_task(7)[1] != tape_task(8)[1]
    assert sphere_task(7)[1] == sphere_task(7)[1] != sphere_task(8)[1]


@pytest.mark.parametrize(("count", "ends"), [(2, "near"), (7, "near"), (7, "far"), (15, "far")])
def test_every_rectangle_can_be_the_answer_and_the_tape_leads_to_it(count: int, ends: str) -> None:
    asked: set[str] = set()
    for seed in itertools.takewhile(lambda _: len(asked) < count, range(5 * count)):
        scene, task = tape_task(seed, count, ends=ends)
        if task.answer in asked:
            continue
        start, end = np.array(task.start), np.array(task.end)
        away = (end - start) / np.linalg.norm(end - start)
        # At half a metre above the ground the rest of the way meets nothing but a rectangle.
        hit = nf.cast_rays(scene, [np.add(end, (0.0, 0.4, 0.0))], [away])
        face = hit.triangle_index[0]
        # 2 triangles of ground, then 12 of each rectangle.
        assert task.rectangles[(face - 2) // 12] == task.answer
        at = np.add(end, (0.0, 0.4, 0.0)) + hit.t_hit[0] * away
        zones = nf.partition(scene, center=task.center, r1=task.r1, r2=task.r2)
        assert set(zones.far.tolist()) >= set(range(2, 2 + 12 * count))
        assert np.hypot(*start[[0, 2]]) < task.r1 < np.hypot(*end[[0, 2]]) < np.hypot(*at[[0, 2]])
        assert (np.hypot(*end[[0, 2]]) < task.r2) == (ends == "near")
        asked.add(task.answer)
    assert len(asked) == count


@pytest.mark.parametrize(("count", "straight"), [(2, True), (7, False), (7, True), (15, False)])
def test_every_box_can_be_the_answer_and_the_ball_lands_on_it(count: int, straight: bool) -> None:
    asked: set[str] = set()
    for seed in itertools.takewhile(lambda _: len(asked) < count, range(5 * count)):
        task = sphere_task(seed, count, straight=straight)[1]
        if task.answer in asked:
            continue
        # Boxes are 5 m apart, 2.5 m wide and 2 m high.
        landed = task.position(task.duration)
        assert task.boxes[round(landed[0] / 5.0 + 0.5 * (count - 1))] == task.answer
        # Rounding of a flight of 70 m.
        assert landed[1] - task.radius == pytest.approx(2.0, abs=1e-12)
        asked.add(task.answer)
        # On its way down to the box the ball does not touch it.
        times = np.linspace(0.0, task.duration, 200)
        places = np.array([task.position(t) for t in times])
        above = np.abs(places[:, 2] + 80.0) < 1.25
        assert (places[above, 1] >= landed[1] - 1e-9).all()
        steps = np.linalg.norm(np.diff(places, n=2, axis=0), axis=1).max()
        assert (steps < 1e-12) == straight
    assert len(asked) == count
