"""CityJSON: surfaces of every kind of geometry, their colours, levels, templates and positions in national grids."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._scene.city.cityjson import OBJECTS, SURFACES, Appearance, read
from nearfar._scene.city.collector import Collector, Part, Surfaces
from tests.support import data as data_file
from tests.support.city_cases import CUBE, SHELL, city, solid, write_json
from tests.support.solids import area_vectors

THREE = "city/cityjson/3dbag_sub.city.json"


def load(tmp_path: Path, document: Any, **how: Any) -> nf.Scene:
    return nf.Scene.load(write_json(tmp_path / "a.city.json", document), **how)


def test_a_cube_in_a_national_grid_keeps_its_position(tmp_path: Path) -> None:
    scene = load(tmp_path, city())
    np.testing.assert_array_equal(scene.bounds, [[85000, 2, -447010], [85010, 12, -447000]])
    assert np.abs(scene.origin - scene.bounds.mean(axis=0)).max() <= 0.5
    assert scene.object_names == ("house",)
    assert scene.triangle_count == 12
    vectors = area_vectors(scene)
    np.testing.assert_allclose(vectors.sum(axis=0), 0, atol=1e-9)
    corners = scene.triangles().astype(np.float64) - (scene.bounds.mean(axis=0) - scene.origin)
    assert np.einsum("ij,ij->", corners[:, 0], vectors) / 3 == pytest.approx(1000)
    assert scene.report.used[:2] == ("CityJSON 2.0", "coordinates of EPSG:7415 as they are")
    assert scene.report.notes == ()


def test_surfaces_have_the_colours_of_their_classes(tmp_path: Path) -> None:
    scene = load(tmp_path, city())
    assert scene.report.materials == 3
    up = nf.Camera.look_at(
        (85005, 60, -447005), (85005, 0, -447005), up=(0, 0, -1), fov=nf.Fov.symmetric(5, 1), size=(8, 8)
    )
    colors = nf.render(scene, up, samples=1).color
    assert colors is not None
    color = colors[4, 4]
    roof = np.array(SURFACES["RoofSurface"].factor[:3])
    np.testing.assert_allclose(color / color[0], roof / roof[0], rtol=0.05)


@pytest.mark.parametrize(
    ("geometry", "triangles"),
    [
        ({"type": "MultiSurface", "boundaries": SHELL}, 12),
        ({"type": "CompositeSurface", "boundaries": SHELL[:2]}, 4),
        ({"type": "Solid", "boundaries": [SHELL, SHELL]}, 24),
        ({"type": "MultiSolid", "boundaries": [[SHELL], [SHELL]]}, 24),
        ({"type": "CompositeSolid", "boundaries": [[SHELL]]}, 12),
    ],
)
def test_every_kind_of_geometry_is_drawn(tmp_path: Path, geometry: Any, triangles: int) -> None:
    objects = {"a": {"type": "Building", "geometry": [{"lod": 1, **geometry}]}}
    scene = load(tmp_path, city(objects))
    assert scene.triangle_count == triangles
    assert area_vectors(scene).shape == (triangles, 3)


def test_points_and_lines_are_counted(tmp_path: Path) -> None:
    points = {"type": "MultiPoint", "lod": "3", "boundaries": [0, 1]}
    objects = {"a": {"type": "Building", "geometry": [points, solid("1")]}}
    assert "1 geometry of points, lines or an unknown type ignored" in load(tmp_path, city(objects)).report.notes


def test_holes_stay_open_in_any_plane(tmp_path: Path) -> None:
    vertices = [[0, 0, 0], [4, 0, 3], [4, 4, 3], [0, 4, 0], [1, 1, 0.75], [1, 3, 0.75], [3, 3, 2.25], [3, 1, 2.25]]
    geometry = {"type": "MultiSurface", "lod": "1", "boundaries": [[[0, 1, 2, 3], [4, 5, 6, 7]]]}
    objects = {"a": {"type": "Building", "geometry": [geometry]}}
    scene = load(tmp_path, city(objects, vertices=vertices, transform={"scale": [1, 1, 1], "translate": [0, 0, 0]}))
    vectors = area_vectors(scene)
    assert np.linalg.norm(vectors, axis=1).sum() == pytest.approx(20 - 5)
    np.testing.assert_allclose(vectors.sum(axis=0), [-9, 12, 0], atol=1e-6)


def test_levels_are_chosen(tmp_path: Path) -> None:
    flat = {"type": "MultiSurface", "lod": "0", "boundaries": [SHELL[0]]}
    five = {"type": "MultiSurface", "lod": 1.2, "boundaries": SHELL[:5]}
    document = city({"a": {"type": "Building", "geometry": [flat, solid("2.2"), five]}})
    counts = {
        lod: load(tmp_path, document, lod=lod).triangle_count for lod in (None, "2.2", "2", 2, "1.3", "1", 1.2, 0)
    }
    assert counts == {None: 12, "2.2": 12, "2": 12, 2: 12, "1.3": 10, "1": 10, 1.2: 10, 0: 2}
    assert "levels of detail 0, 1.2, 2.2: each object is drawn at its highest" in str(load(tmp_path, document).report)
    document["CityObjects"]["b"] = {"type": "Building", "geometry": [solid("3")]}
    assert "1 object left out: no level up to the limit" in load(tmp_path, document, lod="1").report.notes


def test_parts_replace_their_building(tmp_path: Path) -> None:
    flat = {"type": "MultiSurface", "lod": "0", "boundaries": [SHELL[0]]}
    building = {"type": "Building", "children": ["part"], "geometry": [flat]}
    document = city({"whole": building, "part": {"type": "BuildingPart", "parents": ["whole"], "geometry": [solid()]}})
    scene = load(tmp_path, document)
    assert (scene.triangle_count, scene.object_names) == (12, ("part",))
    assert "1 object drawn by its parts, which have more detail" in scene.report.notes
    assert load(tmp_path, document, lod="0").object_names == ("whole",)


def test_templates_are_instances(tmp_path: Path) -> None:
    matrix = [2, 0, 0, 1, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1]
    tree = {"type": "GeometryInstance", "template": 0, "boundaries": [1], "transformationMatrix": matrix}
    templates = {"templates": [solid()], "vertices-templates": CUBE}
    trees = {
        f"tree {n}": {"type": "SolitaryVegetationObject", "geometry": [{**tree, "boundaries": [n]}]} for n in (0, 6)
    }
    scene = load(tmp_path, city(trees, **{"geometry-templates": templates}))
    assert (scene.report.instances, scene.report.meshes, scene.triangle_count) == (2, 1, 24)
    assert scene.object_names == ("tree 0", "tree 6")
    np.testing.assert_allclose(scene.bounds, [[85001, 2, -447012], [85013, 14, -447000]], atol=1e-3)


def test_materials_override_classes(tmp_path: Path) -> None:
    appearance = {"materials": [{"diffuseColor": [1, 0, 0], "transparency": 0.5}, {"name": "plain"}], "textures": [{}]}
    whole = solid(material={"a": {"value": 0}})
    each = solid(material={"b": {"values": [[0, 1, None, 1, 1, 1]]}})
    objects = {"x": {"type": "Building", "geometry": [whole]}, "y": {"type": "Building", "geometry": [each]}}
    scene = load(tmp_path, city(objects, appearance=appearance))
    assert scene.report.materials == 3
    assert "1 texture not drawn" in scene.report.notes
    assert "1 material with transparency drawn opaque" in scene.report.notes


def test_themes_are_chosen_by_the_document() -> None:
    holder = {
        "appearance": {
            "materials": [{"diffuseColor": [1, 0, 0]}, {"diffuseColor": [0, 1, 0]}],
            "default-theme-material": "second",
        }
    }
    geometry: Any = {"material": {"first": {"value": 0}, "second": {"value": 1}}}
    appearance = Appearance(holder)
    assert [c.factor[:2] for c in appearance.colors(geometry, SHELL, 0, "Road", "")] == [(0, 1)] * 6
    geometry = {"material": {"second": {"values": [9, None, 0]}}}
    road = OBJECTS["Road"].factor[:2]
    expected = [road, road, (1, 0), road, road, road]
    assert [c.factor[:2] for c in appearance.colors(geometry, SHELL, 0, "Road", "")] == expected


def test_a_sequence_is_read_line_by_line(tmp_path: Path) -> None:
    header = city({"x": {"type": "Building"}}) | {"CityObjects": {}, "vertices": []}
    features = [
        {
            "type": "CityJSONFeature",
            "id": f"h{n}",
            "CityObjects": {f"h{n}": {"type": "Building", "geometry": [solid()]}},
            "vertices": [[x + 3 * n, y, z] for x, y, z in CUBE],
        }
        for n in range(3)
    ]
    path = tmp_path / "a.city.jsonl"
    path.write_text("\n".join(map(json.dumps, [header, *features])) + "\n")
    scene = nf.Scene.load(path)
    assert (scene.object_names, scene.triangle_count) == (("h0", "h1", "h2"), 36)
    np.testing.assert_array_equal(scene.bounds[:, 0], [85000, 85070])
    (tmp_path / "a.city.jsonl").write_text(json.dumps(features[0]))
    with pytest.raises(nf.SceneError, match="line 1: expected the type CityJSON, got 'CityJSONFeature'"):
        nf.Scene.load(path)


def test_a_plain_json_is_read_by_its_type(tmp_path: Path) -> None:
    assert nf.Scene.load(write_json(tmp_path / "a.json", city())).triangle_count == 12


def surfaces_of(document: Any) -> Surfaces:
    """All surfaces of a document of solids and multi-surfaces, collected in the plain way."""
    transform = document["transform"]
    vertices = np.array(document["vertices"]) * transform["scale"] + transform["translate"]
    collector = Collector()
    collector.add_vertices(vertices)
    for name, item in document["CityObjects"].items():
        for geometry in item["geometry"]:
            shells = geometry["boundaries"] if geometry["type"] == "Solid" else [geometry["boundaries"]]
            for shell in shells:
                collector.add_surfaces(Part(name, name), shell, [OBJECTS["Road"]] * len(shell))
    return collector._usable_surfaces(False)[0]


def test_areas_of_a_real_model_equal_newell() -> None:
    document = json.loads(data_file(THREE).read_bytes())
    surfaces = surfaces_of(document)
    faces, ends, crossing = surfaces.triangles()
    assert crossing == 0
    local = surfaces.local()
    off = 0
    assert len(surfaces.surfaces) - 1 > 5000
    for number in np.random.default_rng(4).choice(len(surfaces.surfaces) - 1, 300, replace=False):
        newell = np.zeros(3)
        for ring in range(surfaces.surfaces[number], surfaces.surfaces[number + 1]):
            corners = local[surfaces.rings[ring] : surfaces.rings[ring + 1]]
            for (x0, y0, z0), (x1, y1, z1) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
                newell += ((y0 - y1) * (z0 + z1), (z0 - z1) * (x0 + x1), (x0 - x1) * (y0 + y1))
        newell /= 2
        a, b, c = np.moveaxis(local[faces[ends[number] : ends[number + 1]]], 1, 0)
        summed = np.cross(b - a, c - a).sum(axis=0) / 2
        area = np.linalg.norm(newell)
        off += bool(np.linalg.norm(summed - newell) > 1e-9 * area)
    assert off == 0


def test_a_real_model_keeps_its_names_and_places() -> None:
    path = data_file(THREE)
    document = json.loads(path.read_bytes())
    scene = nf.Scene.load(path)
    assert set(scene.object_names) == set(document["CityObjects"])
    extent = np.array(document["metadata"]["geographicalExtent"]).reshape(2, 3)
    expected = np.stack([extent[:, 0], extent[:, 2], -extent[::-1, 1]], axis=-1)
    np.testing.assert_allclose(scene.bounds, expected, atol=2e-3)


def test_the_document_is_not_modified() -> None:
    document = city()
    before = copy.deepcopy(document)
    read("a", document, None, drop=False)
    assert document == before


def test_invalid_surfaces_are_an_error_or_omitted(tmp_path: Path) -> None:
    document = city({"a": {"type": "Building", "geometry": [solid(), {**solid(), "boundaries": [[*SHELL, [[0, 1]]]]}]}})
    place = r"CityObjects 'a': geometry\[1\]\.boundaries: surface 6 has a ring of 2 corners"
    with pytest.raises(nf.SceneError, match=place):
        load(tmp_path, document)
    scene = load(tmp_path, document, on_invalid="drop")
    assert scene.triangle_count == 24
    assert "1 surface with rings of fewer than three corners left out" in scene.report.notes


def test_surfaces_with_rings_that_cross_are_counted(tmp_path: Path) -> None:
    bows = {"type": "MultiSurface", "lod": "2", "boundaries": [[[0, 2, 1, 3]], [[4, 6, 5, 7]], [[0, 1, 5, 4]]]}
    scene = load(tmp_path, city({"a": {"type": "Building", "geometry": [bows]}}))
    assert "2 surfaces with rings that cross drawn with gaps or overlaps" in scene.report.notes
