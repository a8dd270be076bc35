"""Measures of simulated clients: pictures of rings against `nf.reduce`, completion, continuity, rendering."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.stream._client_pictures import Pictures, SceneParts
from nearfar.stream._growth import PictureState
from nearfar.stream._strategies import Strategy
from tests.support.bundle_cases import village, write

LINK = nf.stream.Link(1.0)
EYE = (1.0, 1.7, 0.5)
SIZE = 32


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return village()


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    return write(tmp_path_factory.mktemp("seen") / "b", by_footprint=True)


def simulate(bundle: nf.stream.Bundle, scene: nf.Scene, strategy: Strategy, **more: Any) -> nf.stream.Timeline:
    given: dict[str, Any] = {"head_path": EYE, "size": SIZE, "every": 10.0, **more}
    return nf.stream.simulate(bundle, link=LINK, strategy=strategy, scene=scene, **given)


@pytest.mark.parametrize(("ring", "radius"), [(1, 5.0), (2, 12.0), (2, 7.0)])
def test_pictures_of_rings_equal_a_reduced_scene(
    bundle: nf.stream.Bundle, scene: nf.Scene, ring: int, radius: float
) -> None:
    camera = nf.Camera.look_at(EYE, (0.0, 1.0, -9.0), fov=nf.Fov.symmetric(90.0), size=(96, 64))
    parts = SceneParts.bake(scene, bundle, camera, SIZE)
    found = Pictures(parts, by_footprint=False).picture(PictureState(ring, radius, 1.0), EYE)
    own = bundle.radii[ring - 1]
    reduced = nf.reduce(
        scene, center=bundle.center, r1=0.7 * own, r2=own, unit="object", morph="cylinder",
        channels=("color", "range", "object_id"), face_size=bundle._manifest["map"]["face_size"], samples=1,
    )  # fmt: skip
    frame = reduced.with_growth(radius).render(camera, channels=("color", "object_id"))
    assert (found.objects != frame.require("object_id")).mean() < 0.002


def test_the_first_map_shows_the_view_from_the_centre(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    line = simulate(bundle, scene, "clovr", head_path=bundle.center)
    # Seen from the centre all states equal the truth, except for texels.
    assert (line.pictures["ovc"][1:] == 1.0).all()
    assert line.pictures["ofc"][1:].min() > 0.9


def test_vis0_shows_nothing_until_the_end_and_vis1_increases(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    whole, parts = (simulate(bundle, scene, strategy).pictures for strategy in ("vis0", "vis1"))
    assert whole["ovc"][0] == 0.0
    assert len(whole["ovc"]) == 2
    assert (np.diff(parts["ovc"]) >= 0.0).all()
    assert parts["ovc"][1] < 0.5
    # The same objects at the end.
    for kind in ("ovc", "ofc"):
        assert whole[kind][-1] == parts[kind][-1] > 0.8


@pytest.mark.slow
def test_growth_is_smooth_where_switches_jump(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    smooth, hard = (simulate(bundle, scene, strategy) for strategy in ("clovr", "clovrd"))
    least = [line.pictures["continuity"][line.pictures["time"] > line.picture + 0.02].min() for line in (smooth, hard)]
    assert least[0] > 0.999 > 0.99 > least[1]
    # Both end with the same picture.
    for kind in ("ovc", "ofc"):
        assert smooth.pictures[kind][-1] == hard.pictures[kind][-1]


def test_equal_pictures_are_rendered_once(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    line = simulate(bundle, scene, "clovrd", every=0.01, duration=3600.0)
    # Three rings, and the truth.
    assert line.renders == 4
    x, y, z = bundle.center
    path = [[0.0, x, y, z], [1.0, x, y, z], [2.0, x + 1.0, y, z]]
    walked = simulate(bundle, scene, "clovrd", head_path=path, every=0.5)
    assert walked.pictures["time"][-1] == 2.0
    assert walked.pictures["continuity"][-1] < 1.0


def test_measures_are_written(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    found = simulate(bundle, scene, "vis0").to_dict()
    assert found["renders"] == 2
    assert len(found["pictures"]["ovc"]) == 2


def test_faces_without_objects_are_refused(bundle: nf.stream.Bundle) -> None:
    loose = nf.Scene.from_arrays(np.array([[0.0, 0, 0], [1, 0, 0], [0, 0, 1]]), np.array([[0, 1, 2]]), face_object=[-1])
    with pytest.raises(ValueError, match="scene: expected faces that all belong to objects"):
        simulate(bundle, loose, "clovr")


def test_a_user_outside_the_region_has_valid_measures(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    x, y, z = bundle.center
    far = (x + 10.0, y, z)
    with pytest.warns(UserWarning, match="the picture folds") as told:
        bundle.at(2).render(nf.Camera.look_at(far, (0, 1, 0), fov=nf.Fov.symmetric(90), size=(8, 8)))
    with pytest.warns(UserWarning, match="the picture folds") as simulated:
        simulate(bundle, scene, "clovrd", head_path=far)
    assert str(simulated[-1].message) == str(told[-1].message)
