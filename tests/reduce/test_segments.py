"""Ray segments and maps: near geometry and moving objects by their displayed distances, the map by its range."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._render.backend import Backend
from tests.support import render_oracle as oracle
from tests.support.gpu_cases import ADAPTERS, adapter, backend_of, check_color, check_ids, check_range, edges
from tests.support.morphed_oracle import AHEAD, ALL, APART, PLACES, USER, check_near, pictures, reduced_street
from tests.support.reduce_cases import CENTER, R1, R2, camera, place, street

KINDS = ["blend", "cylinder", "none"]
SEGMENTS: list[dict[str, Any]] = [{"t_max": 35.0}, {"t_min": 35.0}, {"t_min": 27.0, "t_max": 46.0}]


@pytest.mark.parametrize(
    ("kind", "where", "segment"),
    [(kind, where, SEGMENTS[(i + j) % 3]) for i, kind in enumerate(KINDS) for j, where in enumerate(PLACES)],
)
def test_near_and_moving_objects_are_visible_between_two_distances(
    kind: str, where: str, segment: dict[str, Any]
) -> None:
    view = camera(USER + np.array(APART[0]), AHEAD)
    frame, expected, radii = pictures(kind, view, where, **segment)
    check_near(frame, expected, radii, least=300)
    if kind == "none" and where in ("across", "beyond"):
        # Beyond the near part it is shown in the direction in which the centre sees it.
        return
    cars = [picture.require("object_id") == 3 for picture in (frame, expected)]
    assert not ((cars[0] != cars[1]) & ~edges(cars[1])).any()


@pytest.mark.parametrize("kind", KINDS)
def test_the_map_is_visible_on_unlimited_rays_that_reach_its_range(kind: str) -> None:
    reduced, view = reduced_street(kind), camera(USER, (1, 0.02, 0.6))
    whole = reduced.render(view, channels=ALL, backend="cpu")
    far, away = whole.require("face_id") < 0, whole.require("range")
    t_min = float(np.median(away[far & np.isfinite(away)]))
    part = reduced.render(view, channels=ALL, backend="cpu", t_min=t_min)
    end = reduced.render(view, channels=ALL, backend="cpu", t_max=1e6)
    nothing = oracle.background(view.rays()[1].reshape(-1, 3)).reshape(*far.shape, 3)
    for picture, seen in ((part, far & (away >= t_min)), (end, np.zeros_like(far))):
        hidden = far & ~seen
        assert hidden.sum() > 100
        for channel in ALL:
            np.testing.assert_array_equal(picture.require(channel)[seen], whole.require(channel)[seen])
        assert not np.isfinite(picture.require("range")[hidden]).any()
        assert (picture.require("object_id")[hidden] == -1).all()
        np.testing.assert_allclose(picture.require("color")[hidden], nothing[hidden], atol=1e-6)
    np.testing.assert_array_equal(end.require("range")[~far], away[~far])


@pytest.mark.parametrize("name", ["cpu", *ADAPTERS])
@pytest.mark.parametrize("kind", KINDS)
def test_invisible_map_surfaces_occlude_nothing(kind: str, name: str) -> None:
    """A car behind the tower is visible once the segment begins behind the tower's front."""
    reduced = reduced_street(kind)
    offset = USER - CENTER if kind != "none" else 0.0
    spot = np.array([130.0, 6.0, 84.0])
    view = nf.Camera.look_at(USER, spot + offset, fov=nf.Fov.symmetric(30, 16 / 9), size=(160, 90))
    with backend_of(name) as backend:
        settings: dict[str, Any] = {"at": {"car": place(*spot)}, "channels": ALL, "backend": backend}
        seen = [
            (reduced.render(view, t_min=t_min, t_max=t_max, **settings).require("object_id") == 3).sum()
            for t_min, t_max in ((0.0, np.inf), (135.0, np.inf), (0.0, 135.0), (0.0, 200.0))
        ]
    assert seen[1] > 20
    # Up to an end behind the car the tower still occludes it, although maps are not visible there.
    assert seen[0] == seen[2] == seen[3] == 0


def test_a_map_without_range_is_at_infinity() -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=64, samples=1, channels=("color",))
    view = camera(USER, AHEAD)
    channels = ("color", "face_id")
    segments: list[dict[str, Any]] = [{}, {"t_min": 1e5}, {"t_max": 1e5}]
    whole, part, end = (reduced.render(view, channels=channels, backend="cpu", **segment) for segment in segments)
    assert (part.require("face_id") < 0).all()
    far = whole.require("face_id") < 0
    assert 0.1 < far.mean() < 0.9
    np.testing.assert_array_equal(part.require("color")[far], whole.require("color")[far])
    nothing = oracle.background(view.rays()[1].reshape(-1, 3)).reshape(*far.shape, 3)
    np.testing.assert_allclose(end.require("color")[far], nothing[far], atol=1e-6)
    np.testing.assert_array_equal(end.require("color")[~far], whole.require("color")[~far])


@pytest.mark.parametrize(
    ("name", "kind", "segment"),
    [
        (ADAPTERS[(i + j) % 2], kind, segment)
        for i, kind in enumerate(KINDS)
        for j, segment in enumerate([*SEGMENTS, {"t_min": 70.0}])
    ],
    ids=str,
)
def test_adapters_agree_with_the_tracer_on_segments(name: str, kind: str, segment: dict[str, Any]) -> None:
    reduced = reduced_street(kind)
    for where, eye in (("between", USER), ("beyond", USER + np.array(APART[1]))):
        view = camera(eye, AHEAD, (320, 180))
        settings: dict[str, Any] = {"at": {"car": place(*PLACES[where])}, "channels": ALL, "tolerance_px": np.inf}
        with adapter(name):
            cpu, gpu = (
                reduced.render(view, user=USER, backend=backend, **settings, **segment) for backend in ("cpu", "gpu")
            )
        check_ids(cpu.require("object_id"), gpu.require("object_id"))
        check_ids(cpu.require("face_id"), gpu.require("face_id"))
        check_color(cpu, gpu)
        check_range(cpu, gpu, worst=1e-3)
        finite = [np.isfinite(picture.require("range")) for picture in (cpu, gpu)]
        assert (finite[0] == finite[1]).mean() > 0.999


@pytest.mark.parametrize("backend", ["cpu", "auto"])
def test_methods_without_ray_segments_refuse_them(backend: Backend) -> None:
    reduced, view = reduced_street("blend"), camera(USER, AHEAD)
    with pytest.raises(ValueError, match="t_min: expected 0 with method='exact'; method='vertex' takes any, got 2"):
        reduced.render(view, method="exact", t_min=2.0, backend=backend)
    with pytest.raises(ValueError, match="t_max: expected infinity with env=False; env=True takes any, got 20"):
        reduced.render(view, env=False, t_max=20.0, backend=backend)
