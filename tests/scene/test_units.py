"""Tests of units: stated by trimesh's objects and files or by the caller, and extents that suggest
another unit."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar._scene.units import extent_note, metres_in

ROOM = np.array([(4000.0, 2500.0, 5000.0), (300.0, 1800.0, 600.0)])
"""Sides of two boxes, millimetres."""


def boxes(unit: str | None = None) -> trimesh.Scene:
    """Two boxes that stand on the ground; the second is placed by a rotated node."""
    scene = trimesh.Scene()
    for name, sides, turn in zip(("room", "shelf"), ROOM, (0.0, 0.5), strict=True):
        placed = trimesh.transformations.rotation_matrix(turn, (0, 1, 0))
        placed[:3, 3] = (100.0 * turn, sides[1] / 2, 0.0)
        scene.add_geometry(trimesh.creation.box(sides), node_name=name, transform=placed)
    if unit is not None:
        scene.units = unit
    return scene


def test_a_scene_in_millimetres_keeps_its_near_triangles() -> None:
    scene = nf.Scene.from_trimesh(boxes("mm"))
    assert np.allclose(scene.bounds, [(-2.0, 0.0, -2.5), (2.0, 2.5, 2.5)])
    assert nf.reduce(scene, center=(0, 1.7, 0), r1=30, r2=50, face_size=16).stats["drawn"] == 24
    assert "unit 'mm' converted, 0.001 m" in str(scene.report)
    assert scene.report.unit_note == ""


@pytest.mark.parametrize(
    ("unit", "metres"),
    [("mm", 0.001), ("inches", 0.0254), ("feet", 0.3048), ("km", None), ("m", 1.0), ("0.5 * meters", 0.5)],
)
def test_units_have_trimeshs_factors(unit: str, metres: float | None) -> None:
    if metres is None:
        with pytest.raises(nf.SceneError, match=r"trimesh object: expected a unit .* got 'km'; scale="):
            nf.Scene.from_trimesh(boxes(unit))
        return
    assert metres_in("it", [unit]) == metres
    plain = nf.Scene.from_trimesh(boxes())
    assert np.allclose(nf.Scene.from_trimesh(boxes(unit)).bounds, plain.bounds * metres, rtol=1e-6, atol=1e-3)


@pytest.mark.parametrize("unit", ["0 * meters", "-1 * meters", "nan * meters", "1e999 * meters"])
def test_units_without_a_length_are_refused(unit: str) -> None:
    with pytest.raises(nf.SceneError, match="expected a unit that trimesh knows"):
        metres_in("it", [unit])


def test_meshes_of_several_units_are_refused_unless_the_scale_is_stated() -> None:
    scene = boxes("mm")
    next(iter(scene.geometry.values())).metadata.pop("units")
    with pytest.raises(nf.SceneError, match="trimesh object: expected meshes of one unit, got none, mm"):
        nf.Scene.from_trimesh(scene)
    assert nf.Scene.from_trimesh(scene, scale=0.01).bounds[1, 1] == pytest.approx(25.0)


def test_meshes_without_a_unit_are_in_metres() -> None:
    scene = boxes("meters")
    next(iter(scene.geometry.values())).metadata.pop("units")
    report = nf.Scene.from_trimesh(scene).report
    assert (report.triangles, report.notes) == (24, ())


def test_the_callers_scale_replaces_the_stated_unit() -> None:
    scene = nf.Scene.from_trimesh(boxes("inches"), scale=0.001)
    assert scene.bounds[1, 1] == pytest.approx(2.5)
    assert scene.report.notes == ()


@pytest.mark.parametrize("kind", ["glb", "obj", "ply", "stl", "3mf"])
def test_files_are_scaled(tmp_path: Path, kind: str) -> None:
    path = tmp_path / f"room.{kind}"
    boxes().export(path)
    scene = nf.Scene.load(path, scale=0.001)
    assert np.allclose(scene.bounds, [(-2.0, 0.0, -2.5), (2.0, 2.5, 2.5)])


def test_a_file_states_its_unit(tmp_path: Path) -> None:
    path = tmp_path / "room.3mf"
    boxes().export(path)  # 3MF is in millimetres unless it states another unit.
    assert nf.Scene.load(path).bounds[1, 1] == pytest.approx(2.5)


def test_scaled_objects_are_posed_in_metres() -> None:
    """Their own axes are scaled, not their transforms, so that a pose is a rotation and a position."""
    scene = nf.Scene.from_trimesh(boxes("mm")).with_dynamic(["shelf"])
    pose = scene.transform("shelf")
    assert np.allclose(pose[:3, :3] @ pose[:3, :3].T, np.eye(3))
    assert np.allclose(pose[:3, 3], (0.05, 0.9, 0.0))
    there = np.eye(4)
    there[:3, 3] = (10.0, 0.9, 0.0)
    moved = scene.at({"shelf": there}).subset(objects=["shelf"])
    assert np.allclose(moved.bounds, [(9.85, 0.0, -0.3), (10.15, 1.8, 0.3)], atol=1e-5)


def test_up_and_scale_combine() -> None:
    scene = nf.Scene.from_trimesh(boxes("mm"), up="z")
    assert np.allclose(scene.bounds, [(-2.0, -2.5, -2.5), (2.0, 2.5, 0.0)])


def test_a_scale_beyond_float32_is_an_error_of_the_source() -> None:
    with pytest.raises(nf.SceneError, match=r"too large for 32-bit floats, up to 2.5e\+41, in mesh"):
        nf.Scene.from_trimesh(boxes(), scale=1e38)


@pytest.mark.parametrize(
    ("sides", "said"),
    [
        ((4, 2.5, 5), ""),  # a room in metres
        ((4000, 2500, 5000), "higher than"),  # in millimetres
        ((12_000, 2500, 8000), "higher than"),  # a flat in millimetres
        ((400, 250, 500), ""),  # in centimetres: a building's size
        ((60_000, 700, 50_000), ""),  # a city
        ((20_000, 3500, 20_000), ""),  # a landscape in the Himalaya
        ((1e9, 20_000, 1e9), "higher than"),  # a city in millimetres
        ((0.004, 0.0025, 0.005), "less than"),  # a room in kilometres
        ((0.0, 0.0, 0.0), ""),
        ((0.3, 0.0, 0.3), ""),
    ],
)
def test_extents_that_suggest_another_unit_are_noted(sides: tuple[float, ...], said: str) -> None:
    note = extent_note(np.array([np.zeros(3), sides]))
    assert (said in note) if said else note == ""
    assert extent_note(np.array([np.full(3, np.inf), np.full(3, -np.inf)])) == ""


def test_the_report_notes_the_unit_that_the_extent_suggests() -> None:
    plain: Any = nf.Scene.from_trimesh(boxes())
    assert plain.report.unit_note.startswith("the scene has 4,000 × 2,500 × 5,000 m, higher than buildings")
    assert plain.report.unit_note in str(plain.report)
    assert nf.datasets.city(blocks=1, detail=0).report.unit_note == ""
