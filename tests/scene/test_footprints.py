"""Footprints from GeoJSON and GeoParquet: prisms in metres, heights from properties, and the rows in a box."""

from __future__ import annotations

import gzip
import importlib.util
import json
import struct
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pyproj
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.tokyo import with_buildings
from nearfar._scene.city import heights
from nearfar._scene.city.footprints import BoxIndex, Footprints
from nearfar._scene.city.read import open_footprints
from nearfar._scene.content import assemble
from tests.support import data as data_file, need
from tests.support.city_cases import collection, feature, parquet, polygon_bytes, square, write_json

MANHATTAN = "city/manhattan_deckgl/buildings.json"
TOKYO = "city/tokyo23/tokyo23_buildings.parquet"

X, Y = 85_000.0, 447_000.0
"""A corner in a national grid."""


def volume(scene: nf.Scene) -> float:
    """Volume that the faces enclose, with missing floors at y = 0."""
    corners = scene.triangles().astype(np.float64)
    a, b, c = np.moveaxis(corners + (scene.origin - (X, 0, -Y)), 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def load(tmp_path: Path, document: Any, **how: Any) -> nf.Scene:
    return nf.Scene.load(write_json(tmp_path / "a.geojson", document), **how)


def test_a_block_stands_on_the_ground_in_its_grid(tmp_path: Path) -> None:
    hole = square(X + 2, Y + 2, 6)
    scene = load(tmp_path, collection(feature([square(X, Y, 10), hole], height=7.5)))
    np.testing.assert_array_equal(scene.bounds, [[X, 0, -Y - 10], [X + 10, 7.5, -Y]])
    assert scene.triangle_count == 16 + 8
    assert volume(scene) == pytest.approx((100 - 36) * 7.5)
    assert scene.report.used[0] == "GeoJSON: 1 feature extruded"
    assert "coordinates of EPSG:28992 as they are" in scene.report.used


@pytest.mark.parametrize("turned", [(False, False), (True, False), (False, True), (True, True)])
def test_directions_of_rings_do_not_matter(tmp_path: Path, turned: tuple[bool, bool]) -> None:
    rings = [square(X, Y, 10)[:: -1 if turned[0] else 1], square(X + 2, Y + 2, 6)[:: -1 if turned[1] else 1]]
    assert volume(load(tmp_path, collection(feature(rings, height=2)))) == pytest.approx(128)


def test_raised_buildings_have_a_floor(tmp_path: Path) -> None:
    scene = load(tmp_path, collection(feature([square(X, Y, 10)], height=7, min_height=4)))
    assert scene.triangle_count == 8 + 4
    assert volume(scene) == pytest.approx(300)
    np.testing.assert_array_equal(scene.bounds[:, 1], [4, 7])


@pytest.mark.parametrize(
    ("properties", "expected"),
    [
        ({"height": 12}, 12),
        ({"height": "12.5 m"}, 12.5),
        ({"height": "40 ft"}, 12.192),
        ({"building:height": 9, "building:levels": 2}, 9),
        ({"building:levels": "4"}, 12),
        ({"measuredHeight": 8.25}, 8.25),
        ({"render_height": 5, "height": None}, 5),
        ({"height": "unknown", "levels": 3}, 9),
        ({"height": 0}, 6),
        ({"height": -5}, 6),
        ({"height": True}, 6),
        ({"height": 1e9}, 6),
        ({}, 6),
        ({"height": 3, "min_height": 3}, 9),
    ],
)
def test_heights_come_from_the_properties(tmp_path: Path, properties: dict[str, Any], expected: float) -> None:
    document = collection(feature([square(X, Y, 10)], **properties))
    assert load(tmp_path, document).bounds[1, 1] == pytest.approx(expected)


def test_a_height_can_be_named(tmp_path: Path) -> None:
    document = collection(feature([square(X, Y, 10)], height=3, top=8), feature([square(X, Y, 1)], height=50))
    scene = load(tmp_path, document, height="top")
    assert scene.bounds[1, 1] == 8
    assert "1 feature of unknown height drawn 6 m high" in scene.report.notes


def test_degrees_become_metres_around_the_middle(tmp_path: Path) -> None:
    place = (139.7671, 35.6812)
    document = collection(feature([square(*place, 0.004)], height=100), epsg=None)
    scene = load(tmp_path, document)
    local = pyproj.Transformer.from_pipeline(
        "+proj=pipeline +step +proj=cart +ellps=WGS84 +step +proj=topocentric +ellps=WGS84 "
        f"+lon_0={place[0] + 0.002} +lat_0={place[1] + 0.002} +h_0=0"
    )
    ring = np.radians(square(*place, 0.004)[:4])
    rows = [local.transform(x, y, height, radians=True) for height in (0, 100) for x, y in ring]
    east, north, up = np.array(rows).T
    expected = np.stack([east, up, -north], axis=-1)
    np.testing.assert_allclose(scene.bounds, [expected.min(axis=0), expected.max(axis=0)], atol=1e-4)
    assert "local frame at longitude 139.769°, latitude 35.6832°" in scene.report.notes
    moved = load(tmp_path, document, origin=(139.7671, 35.6812, 20))
    assert moved.bounds[0, 0] == pytest.approx(0, abs=0.02)
    assert moved.bounds[0, 1] == pytest.approx(-20, abs=0.1)


def test_many_polygons_are_one_object(tmp_path: Path) -> None:
    several = {"type": "MultiPolygon", "coordinates": [[square(X, Y, 10)], [square(X + 20, Y, 10)]]}
    inner = {"type": "GeometryCollection", "geometries": [several, {"type": "Point", "coordinates": [X, Y]}]}
    rows: list[dict[str, Any]] = [
        {"type": "Feature", "id": "both", "geometry": inner, "properties": {"height": 3}},
        {"type": "Feature", "id": "none", "geometry": None, "properties": None},
    ]
    scene = load(tmp_path, collection(*rows))
    assert (scene.triangle_count, scene.object_names) == (20, ("both", "none"))
    assert "1 geometry of points or lines ignored" in scene.report.notes


def test_outlines_that_cross_are_counted(tmp_path: Path) -> None:
    bow = [square(X, Y, 10)[number] for number in (0, 2, 1, 3, 0)]
    rows = collection(feature([bow], height=3), feature([square(X + 20, Y, 10)], height=3))
    note = "1 polygon with rings that cross drawn with gaps or overlaps"
    assert note in load(tmp_path, rows).report.notes


def test_objects_without_ids_are_numbered(tmp_path: Path) -> None:
    scene = load(tmp_path, collection(feature([square(X, Y, 10)]), feature([square(X + 20, Y, 10)])))
    assert scene.object_names == ("object_0", "object_1")
    moving = scene.with_dynamic(["object_1"])
    assert moving.subset(objects=["object_1"]).bounds[0, 0] == X + 20


def test_a_single_geometry_and_a_packed_file_are_read(tmp_path: Path) -> None:
    root = {"type": "Polygon", "coordinates": [[[0, 0, 5], [1e-4, 0, 5], [0, 1e-4]]]}
    path = tmp_path / "a.geojson.gz"
    path.write_bytes(gzip.compress(json.dumps(root).encode()))
    assert nf.Scene.load(path).triangle_count == 7
    assert nf.Scene.load(write_json(tmp_path / "b.json", {"type": "Feature", "geometry": root})).triangle_count == 7


def test_manhattan_equals_its_glb(tmp_path: Path) -> None:
    """The GLB was made in metres of UTM's zone 18."""
    path = data_file(MANHATTAN)
    rows = json.loads(path.read_bytes())
    to_utm = pyproj.Transformer.from_crs("EPSG:4326", "EPSG:32618", always_xy=True)
    features = [feature([np.stack(to_utm.transform(*np.array(r["polygon"]).T), 1).tolist()], **r) for r in rows]
    prints = open_footprints(write_json(tmp_path / "a.geojson", collection(*features, epsg=32618)), nf.LoadOptions())
    glb = trimesh.load_scene(data_file("city/manhattan_deckgl/manhattan_core.glb"))
    placed = [glb.graph[f"b{number}"] for number in range(999)]
    other = np.array([trimesh.transform_points(glb.geometry[name].bounds, matrix) for matrix, name in placed])
    shift = prints.boxes[0, 0] - other[0, 0]
    np.testing.assert_allclose(prints.boxes - shift, other, rtol=0, atol=1e-3)
    owner = prints.content().shapes["footprints"].face_object
    assert owner is not None
    assert np.bincount(owner, minlength=999).tolist() == [len(glb.geometry[name].faces) for _, name in placed]


def test_manhattan_in_degrees_differs_by_the_projection_only() -> None:
    prints = open_footprints(data_file(MANHATTAN), nf.LoadOptions())
    glb = trimesh.load_scene(data_file("city/manhattan_deckgl/manhattan_core.glb"))
    placed = [glb.graph[f"b{number}"] for number in range(999)]
    other = np.array(
        [trimesh.transform_points(glb.geometry[name].bounds.mean(axis=0)[None], m)[0] for m, name in placed]
    )
    own = prints.boxes.mean(axis=1)
    fit, *_ = np.linalg.lstsq(np.c_[other, np.ones(999)], own, rcond=None)
    # Boxes rotate with the meridian's convergence of 0.66 degrees, and the Earth's curvature is half a metre.
    np.testing.assert_allclose(own, np.c_[other, np.ones(999)] @ fit, rtol=0, atol=0.6)
    assert np.arctan2(fit[0, 2], fit[0, 0]) == pytest.approx(np.sin(np.radians(40.716)) * np.radians(1.005), rel=0.01)


def rows_of(random: np.random.Generator, count: int) -> tuple[list[bytes], NDArray[np.float64]]:
    """WKB and heights of squares in a grid's square kilometre."""
    # Eighths of a metre are exact in float32 about any origin in whole metres.
    corners, sizes = random.integers(0, 8000, (count, 2)) / 8, random.integers(8, 160, count) / 8
    rows = [polygon_bytes([square(X + x, Y + y, s)]) for (x, y), s in zip(corners, sizes, strict=True)]
    return rows, random.integers(16, 480, count) / 8


def test_geoparquet_equals_geojson(tmp_path: Path) -> None:
    rows, tall = rows_of(np.random.default_rng(1), 50)
    path = parquet(tmp_path / "a.parquet", [*rows, None], height=[*tall, None], id=[f"b{n}" for n in range(51)])
    scene = nf.Scene.load(path)
    features = []
    for row, height in zip(rows, tall, strict=True):
        ring = np.frombuffer(row[13:], "<f8").reshape(-1, 2).tolist()
        assert struct.unpack("<BII", row[:9]) == (1, 3, 1)
        features.append(feature([ring], height=height))
    other = load(tmp_path, collection(*features))
    np.testing.assert_array_equal(scene.triangles(), other.triangles())
    np.testing.assert_array_equal(scene.bounds, other.bounds)
    assert scene.object_names == tuple(f"b{n}" for n in range(51))
    assert scene.report.used[0] == "GeoParquet: 51 features extruded"


@pytest.mark.parametrize(
    ("crs", "words"),
    [
        ({"type": "GeographicCRS", "name": "WGS 84"}, "local frame at"),
        (None, "no coordinate system stated, taken as metres"),
        (
            {"type": "CompoundCRS", "components": [{"type": "ProjectedCRS", "name": "N"}]},
            "coordinates of N as they are",
        ),
    ],
)
def test_coordinate_systems_of_geoparquet_are_read(tmp_path: Path, crs: Any, words: str) -> None:
    column = {"encoding": "WKB", "crs": crs}
    geo = {"version": "1.1.0", "primary_column": "geometry", "columns": {"geometry": column}}
    path = parquet(tmp_path / "a.parquet", [polygon_bytes([square(4, 52, 0.001)])], geo=geo)
    report = nf.Scene.load(path).report
    assert any(words in said for said in (*report.used, *report.notes))
    del column["crs"]
    path = parquet(tmp_path / "a.parquet", [polygon_bytes([square(4, 52, 0.001)])], geo=geo)
    assert "local frame at longitude 4.0005°, latitude 52.0005°" in str(nf.Scene.load(path).report)


def test_feet_are_converted_to_metres(tmp_path: Path) -> None:
    unit = {"type": "LinearUnit", "name": "US survey foot", "conversion_factor": 0.3048006096}
    crs = {"type": "ProjectedCRS", "name": "NAD83 / Texas", "coordinate_system": {"axis": [{"unit": unit}]}}
    geo = {"primary_column": "geometry", "columns": {"geometry": {"encoding": "WKB", "crs": crs}}}
    scene = nf.Scene.load(parquet(tmp_path / "a.parquet", [polygon_bytes([square(100, 0, 10)])], geo=geo))
    np.testing.assert_allclose(scene.bounds[:, 0], [30.48006096, 33.528067056], rtol=1e-6)


def faces_in(scene: nf.Scene) -> set[bytes]:
    """World corners of each triangle."""
    return {row.tobytes() for row in scene.triangles().astype(np.float64) + scene.origin}


def test_rows_of_boxes_equal_a_linear_search(tmp_path: Path) -> None:
    random = np.random.default_rng(2)
    rows, tall = rows_of(random, 3000)
    path = parquet(tmp_path / "a.parquet", rows, height=tall)
    prints = open_footprints(path, nf.LoadOptions())
    whole = nf.Scene.load(path)
    np.testing.assert_allclose(prints.bounds, whole.bounds, atol=2e-3)
    assert (prints.count, prints.names) == (3000, 3000)
    seen: set[bytes] = set()
    for x in range(5):
        for z in range(5):
            box = np.array([[X + 205 * x, -10, -Y - 205 * (z + 1)], [X + 205 * (x + 1), 100, -Y - 205 * z]])
            found = prints.rows_touching(box)
            touch = ((prints.boxes[:, 0] <= box[1]) & (prints.boxes[:, 1] >= box[0])).all(axis=1)
            np.testing.assert_array_equal(found, np.flatnonzero(touch))
            assert len(found) < 400
            cell = nf.Scene(**assemble(prints.content(found), nf.LoadOptions()))
            assert cell.object_names == tuple(f"object_{row}" for row in found)
            seen |= faces_in(cell)
    assert seen == faces_in(whole)


def test_a_box_index_finds_boxes_that_touch_its_border() -> None:
    boxes = np.array([[[0, 0, 0], [1, 1, 1]], [[np.inf] * 3, [-np.inf] * 3], [[1, 1, 1], [2, 2, 2]]], np.float64)
    index = BoxIndex(boxes)
    assert index.touching(np.array([[1.0, 1, 1], [1, 1, 1]])).tolist() == [0, 2]
    assert index.touching(np.array([[1.5, 1, 1], [9, 9, 9]])).tolist() == [2]
    assert index.touching(np.array([[2.1, 1, 1], [9, 9, 9]])).tolist() == []
    assert BoxIndex(np.zeros((0, 2, 3))).touching(np.array([[0.0, 0, 0], [1, 1, 1]])).tolist() == []


def test_no_rows_have_no_triangles(tmp_path: Path) -> None:
    prints = open_footprints(parquet(tmp_path / "a.parquet", [polygon_bytes([square(X, Y, 1)])]), nf.LoadOptions())
    content = prints.content(np.zeros(0, np.int64))
    assert len(content.shapes["footprints"].faces) == 0
    assert prints.content().names == 1


def test_arguments_without_effect_on_a_file_are_refused(tmp_path: Path) -> None:
    path = write_json(tmp_path / "a.geojson", collection(feature([square(X, Y, 1)])))
    with pytest.raises(ValueError, match=r"lod: expected none for a\.geojson"):
        nf.Scene.load(path, lod="2")
    with pytest.raises(ValueError, match=r"lod: expected a level of detail such as '2\.2'"):
        nf.Scene.load(path, lod="high")
    with pytest.raises(ValueError, match=r"height: expected none for x\.glb"):
        nf.Scene.load(tmp_path / "x.glb", height="h")
    with pytest.raises(ValueError, match="origin: expected longitude within"):
        nf.Scene.load(path, origin=(0, 100, 0))
    with pytest.raises(ValueError, match="triangles: expected none with"):
        nf.Scene.load(path, triangles=5)
    with pytest.raises(nf.SceneError, match="it is no tileset: error does not apply to it"):
        nf.Scene.load(write_json(tmp_path / "a.json", collection(feature([square(X, Y, 1)]))), error=2)
    with pytest.raises(nf.SceneError, match="lod does not apply"):
        nf.Scene.load(write_json(tmp_path / "a.json", collection(feature([square(X, Y, 1)]))), lod="2")


def test_text_columns_with_units_are_heights() -> None:
    found = heights.numbers(["3", None, "x", 4.5, True, "1e3 m", "12'", 10**400, "9" * 50])
    assert found is not None
    np.testing.assert_allclose(found, [3, np.nan, np.nan, 4.5, np.nan, 1000, 12 * 0.3048, np.nan, np.nan])
    assert heights.numbers(["x", None]) is None


def tokyo_script() -> ModuleType:
    path = Path(__file__).resolve().parents[2] / "scripts" / "tokyo_geoparquet.py"
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def tokyo(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Footprints]:
    source = data_file(TOKYO)
    target = tmp_path_factory.mktemp("tokyo") / "tokyo.parquet"
    tokyo_script().convert(str(source), str(target))
    return target, open_footprints(target, nf.LoadOptions())


@pytest.mark.stress
def test_the_whole_of_tokyo_equals_the_tool_of_the_data(tokyo: tuple[Path, Footprints]) -> None:
    need("tokyo")
    _, prints = tokyo
    content = prints.content()
    shape = content.shapes["footprints"]
    made = with_buildings()
    assert made is not None
    vertices, faces, building = made
    assert prints.count == 1_768_202
    # Where rings touch themselves, ear clippers disagree on one triangle for 34 buildings.
    assert abs(len(shape.faces) - len(faces)) <= 10
    assert shape.face_object is not None
    counts = [np.bincount(owner, minlength=prints.count) for owner in (shape.face_object, building)]
    assert (counts[0] != counts[1]).sum() < 50
    assert np.abs(counts[0] - counts[1]).max() <= 1
    shift = content.nodes.transforms[0, :3, 3] - (-5993, 0, 35363)
    assert len(shape.vertices) == len(vertices)
    np.testing.assert_allclose(shape.vertices + shift, vertices, atol=4e-3)
    areas = [
        plan_areas(corners.astype(np.float64), rows, owner, prints.count)
        for corners, rows, owner in ((shape.vertices, shape.faces, shape.face_object), (vertices, faces, building))
    ]
    np.testing.assert_allclose(areas[0], areas[1], rtol=1e-2, atol=0.2)


def plan_areas(vertices: NDArray[Any], faces: NDArray[Any], owner: NDArray[Any], count: int) -> NDArray[np.float64]:
    """Area of each object's roofs, seen from above."""
    a, b, c = np.moveaxis(vertices[:, ::2][faces], 1, 0)
    doubled = (b - a)[:, 1] * (c - a)[:, 0] - (b - a)[:, 0] * (c - a)[:, 1]
    return np.asarray(np.bincount(owner, weights=doubled / 2, minlength=count), np.float64)


@pytest.mark.slow
def test_cells_of_tokyo_contain_its_triangles(tokyo: tuple[Path, Footprints]) -> None:
    _, prints = tokyo
    centre = prints.bounds.mean(axis=0)
    whole = prints.content(prints.rows_touching(np.stack([centre - 900, centre + 900])))
    seen = np.zeros(prints.count, np.int64)
    for x in range(6):
        for z in range(6):
            low = centre + np.array([300 * (x - 3), -900, 300 * (z - 3)])
            rows = prints.rows_touching(np.stack([low, low + np.array([300, 1800, 300])]))
            cell = prints.content(rows).shapes["footprints"]
            assert cell.face_object is not None
            seen[rows] = np.bincount(cell.face_object, minlength=len(rows))
    assert seen.sum() == len(whole.shapes["footprints"].faces)


def test_parquet_without_its_package_names_the_extra(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = parquet(tmp_path / "a.parquet", [polygon_bytes([square(X, Y, 1)])])
    monkeypatch.setattr("nearfar._scene.city.geoparquet.find_spec", lambda name: None)
    with pytest.raises(nf.SceneError, match=r'pip install "nearfar\[formats\]"'):
        nf.Scene.load(path)
