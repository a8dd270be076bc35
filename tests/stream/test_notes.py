"""Notes on probably unintended centres and rings; sensible ones have none."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar.stream._notes import _endless_objects, _sphere, findings_of
from tests.support import valid


def box(low: Any, high: Any) -> tuple[Any, Any]:
    made = trimesh.creation.box(bounds=[low, high])
    return made.vertices, made.faces


def scene(*parts: tuple[str, Any, Any], dynamic: tuple[str, ...] = ()) -> nf.Scene:
    builder = nf.SceneBuilder()
    for name, low, high in parts:
        builder.instance(builder.mesh(*box(low, high)), name=name)
    return builder.build(dynamic=dynamic)


def street(*more: tuple[str, Any, Any], **settings: Any) -> nf.Scene:
    """Ground of 60 m below walls at 3 m and 12 m."""
    parts = [("ground", (-30, -0.5, -30), (30, 0, 30)), ("wall", (-20, 0, 3), (20, 5, 3.5))]
    return scene(*parts, ("house", (-9, 0, -20), (9, 9, -12)), *more, **settings)


def findings(of: nf.Scene, center: Any, radii: Any = (5.0, 15.0)) -> list[str]:
    return findings_of(nf.stream.assign(of, center=center, radii=radii))


ENDLESS = "'ground' (12 triangles) and 'wall' (12 triangles) reach from within ring 1 beyond the last ring"


@pytest.mark.parametrize(
    ("center", "start"),
    [
        ((0, 2, 3.2), "the centre seems to lie inside 'wall'"),
        ((4, 5, -15), "the centre seems to lie inside 'house'"),
        ((0, -0.2, 0), "the centre seems to lie inside 'ground'"),
        ((0, -2.5, 0), "the centre lies 2 m below the scene's lowest point"),
        ((0, 59, 0), "the centre lies 50 m above the scene's highest point"),
        ((43, 1, 0), "the centre lies 13 m outside the bounds of the scene"),
        ((7000, 1, 0), "the centre lies 6,970 m outside the bounds of the scene"),
    ],
)
def test_centres_in_walls_and_outside_are_noted(center: Any, start: str) -> None:
    assert any(sentence.startswith(start) for sentence in findings(street(), center)), findings(street(), center)


def test_a_sensible_centre_has_only_notes_on_long_objects() -> None:
    (sentence,) = findings(street(), (0, 1.7, 0))
    assert sentence == f"{ENDLESS}, 24 triangles together: they are sent whole with ring 1"
    assert findings(street(), (0, 1.7, 0), (5.0, 45.0)) == []
    # Far above the ground, like a drone, and within a moving object.
    assert findings(street(), (0, 20, 0), (5.0, 45.0)) == []
    assert findings(street(("car", (-2, 0, -2), (2, 3, 2)), dynamic=("car",)), (0, 1.7, 0), (5.0, 45.0)) == []
    assert any(
        "inside 'car'" in sentence for sentence in findings(street(("car", (-2, 0, -2), (2, 3, 2))), (0, 1.7, 0))
    )


def test_a_ground_sheet_is_noted_only_from_below() -> None:
    faces = [[0, 1, 2], [0, 2, 3]]
    corners = np.array([[-40, 0, -40], [-40, 0, 40], [40, 0, 40], [40, 0, -40]], float)
    sheet = nf.Scene.from_arrays(corners, faces)
    assert not any("seems" in sentence for sentence in findings(sheet, (0, 1.7, 0)))
    below = findings(sheet, (0, -1, 0))
    assert below[0] == "the centre lies 1 m below the scene's lowest point"
    assert below[1].startswith("the centre seems to lie under ")


def test_empty_rings_are_named() -> None:
    one = "ring 2 (5 to 5.5 m) is empty: no object begins there, so that the previous map stays"
    assert one in findings(street(), (0, 1.7, 0), (5.0, 5.5, 15.0))
    many = findings(street(), (0, 1.7, 0), (1, 1.5, 2, 2.5, 2.6, 2.7, 15))[0]
    assert many.startswith("ring 2 (1 to 1.5 m), ring 3 (1.5 to 2 m), ring 4 (2 to 2.5 m) and 2 more are empty")
    far = findings(street(), (100, 1.7, 0), (5.0, 20.0))
    assert "all rings are empty: no static object lies within 20 m of the centre's vertical axis" in far


def test_units_that_look_wrong_are_noted() -> None:
    tall = scene(("tower", (-5, 0, -9000), (5, 9500, -4)))
    assert tall.report.unit_note
    assert findings(tall, (0, 1.7, 0))[0] == tall.report.unit_note


def test_long_objects_are_measured_over_all_corners() -> None:
    """The oracle extracts the triangles of each object from the scene."""
    city = nf.datasets.city(blocks=2, detail=0)
    corners = np.add(city.triangles().reshape(-1, 3), (60_000.0, 0, 0))
    moved = nf.Scene.from_arrays(corners, np.arange(len(corners)).reshape(-1, 3))
    for of, center, radii in (
        (city, (3.0, 1.7, -2.0), (4.0, 9.0)),
        (city, (3.0, 1.7, -2.0), (60.0, 70.0)),
        (nf.datasets.room(), (0.0, 1.7, 0.0), (1.0, 1.5)),
        (moved, (60_003.0, 1.7, -2.0), (4.0, 9.0)),
    ):
        rings = nf.stream.assign(of, center=center, radii=radii)
        expected = {}
        for number, name in enumerate(of.object_names):
            corners = of.subset(objects=[name]).triangles() + of.origin - center
            reach = np.hypot(corners[..., 0], corners[..., 2]).max(initial=0.0)
            if rings.ring[number] == 1 and reach > radii[-1]:
                expected[number] = len(corners)
        assert _endless_objects(rings) == expected
        assert expected


def test_faces_without_an_object_count_as_one() -> None:
    corners = np.array([[-40, 0, -40], [-40, 0, 40], [40, 0, 40]], np.float32)
    flat = nf.Scene.from_arrays(corners, [[0, 1, 2]], face_object=[-1])
    assert findings(flat, (-10, 1.7, 10))[-1].startswith("faces without an object (1 triangle) reaches")


def test_rays_cover_the_sphere() -> None:
    rays = _sphere(500)
    np.testing.assert_allclose(np.linalg.norm(rays, axis=1), 1.0, atol=1e-12)
    assert np.abs(rays.mean(axis=0)).max() < 2e-3
    # 500 caps of 4π/500 have a radius of 5°; no gap is wider than three of them.
    anywhere = np.random.default_rng(1).normal(size=(2000, 3))
    anywhere /= np.linalg.norm(anywhere, axis=1, keepdims=True)
    assert np.degrees(np.arccos((anywhere @ rays.T).max(axis=1))).max() < 15.0


def test_a_bundle_stores_its_notes(tmp_path: Path) -> None:
    """Each region has its own, and walls that face the centre of a room surround no solid."""
    centers = [(0, 2, 3.2), (0, 1.7, 0)]
    given: dict[str, Any] = {"center": centers, "radii": [5.0, 15.0], "face_size": 64, "samples": 1}
    bundle = nf.stream.export(street(), tmp_path / "b", **given)
    assert list(bundle.region(1).findings) == findings(street(), centers[1])
    corners, faces = box((-9, -9, -9), (9, 9, 9))
    seems = [findings(nf.Scene.from_arrays(corners, own), (0, 0, 0))[0] for own in (faces, faces[:, ::-1])]
    assert ["seems to lie inside" in finding for finding in seems] == [True, False]
    assert bundle.findings[0].startswith("the centre seems to lie inside 'wall'")
    assert list(bundle.findings) == findings(street(), (0, 2, 3.2))
    manifest = json.loads((tmp_path / "b" / "manifest.json").read_text())
    assert valid(manifest, "bundle")
    assert manifest["regions"][0]["findings"] == list(bundle.findings)
    assert "inside &#x27;wall&#x27;" in bundle._repr_html_() or "inside 'wall'" in bundle._repr_html_()


def test_a_scene_in_ring_1_alone_is_noted() -> None:
    room = scene(("floor", (-2, -0.5, -2), (2, 0, 2)), ("table", (0.5, 0, 0.5), (1, 1, 1)))
    expected = "ring 1 (to 63 m) has the whole scene, 24 triangles: smaller radii divide it into several rings"
    assert findings(room, (0, 1.7, 0), (63.0,)) == [expected]
    assert expected not in findings(room, (0, 1.7, 0), (0.4, 63.0))
    assert not any("whole scene" in finding for finding in findings(street(), (0, 1.7, 0)))
