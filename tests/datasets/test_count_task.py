"""Tests of the counting task: only the conventional method shows spheres twice."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import nearfar as nf
from nearfar.datasets import count_task
from tests.support.study_cases import ASIDE, HOW, USERS, Ids, pieces, reduce_task

# A texel of the map is 0.11°, a sphere 2°.
FOV, SIZE = nf.Fov.symmetric(100, 4.0), (1200, 300)


def pieces_of_spheres(reduced: nf.ReducedScene, user: tuple[float, float, float], **how: object) -> list[int]:
    """Return the number of pieces in which a user who looks ahead sees each sphere, in order."""
    eye = np.add(reduced.center, user)
    view = nf.Camera.look_at(eye, np.add(eye, (0.0, 3.0, -50.0)), fov=FOV, size=SIZE)
    ids: Ids = reduced.render(view, channels=("object_id",), **how).require("object_id")  # type: ignore[arg-type]
    names = reduced.scene.object_names
    spheres = [pieces(ids, n) for n, name in enumerate(names) if name.startswith("sphere")]
    # The map reaches two texels into r₂, measured on the surface: single texels of a near sphere's rim are in it.
    return [sum(int(mask.sum()) > 9 for mask in masks) for masks in spheres]


@pytest.mark.slow
def test_only_the_conventional_method_adds_spheres() -> None:
    scene, task = count_task(5)
    reduced = reduce_task(scene, task, 1024)
    conventional = reduced.with_morph("none")
    for user in USERS:
        for how in HOW:
            assert pieces_of_spheres(reduced, user, **how) == [1] * task.answer, (user, how)
    for user in ASIDE:
        assert sum(pieces_of_spheres(conventional, user)) == task.answer + len(task.across), user


def test_counts_and_places() -> None:
    asked: set[tuple[int, int]] = set()
    for seed in itertools.takewhile(lambda _: len(asked) < 6, range(60)):
        scene, task = count_task(seed)
        if (task.answer, len(task.across)) in asked:
            continue
        asked.add((task.answer, len(task.across)))
        assert len(task.spheres) == task.answer
        assert scene.object_names == ("ground", *task.spheres)
        zones = nf.partition(scene, center=task.center, r1=task.r1, r2=task.r2)
        both = np.intersect1d(zones.nsf, zones.sf)
        assert task.radius == 1.0
        # 2 triangles of ground, then 1,280 of each sphere.
        cut = {task.spheres[(n - 2) // 1280] for n in both[both >= 2].tolist()}
        assert cut == set(task.across)
    assert asked == {(n, across) for n in (11, 12, 13) for across in (1, 2)}
    assert count_task(7)[1] == count_task(7)[1]
