"""Damaged or inconsistent cities: an error that names the file and the place, soon and in little memory."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.city_cases import (
    CUBE,
    SHELL,
    city,
    collection,
    feature,
    parquet,
    polygon_bytes,
    solid,
    square,
    write_json,
)

Json = dict[str, Any]


def message(path: Path, **how: Any) -> str:
    """Message of the error that loading the file raises, without the file's name."""
    with pytest.raises(nf.SceneError) as caught:
        nf.Scene.load(path, **how)
    text = str(caught.value)
    assert text.startswith(f"{path}: ")
    assert len(text) < len(str(path)) + 400
    return text.removeprefix(f"{path}: ")


def geometry(**changes: Any) -> Json:
    return city({"a": {"type": "Building", "geometry": [{**solid(), **changes}]}})


def remove_key(document: Json, key: str) -> Json:
    return {name: value for name, value in document.items() if name != key}


def deep(levels: int) -> Any:
    nested: Any = 0
    for _ in range(levels):
        nested = [nested]
    return nested


PLACE = "CityObjects 'a': geometry[0]"
TREE = {
    "type": "GeometryInstance",
    "template": 0,
    "boundaries": [0],
    "transformationMatrix": np.eye(4).ravel().tolist(),
}
TEMPLATES = {"geometry-templates": {"templates": [solid()], "vertices-templates": CUBE}}


def tree(**changes: Any) -> Json:
    return city({"a": {"type": "Building", "geometry": [{**TREE, **changes}]}}, **TEMPLATES)


CITIES: list[tuple[Json, str]] = [
    (remove_key(city(), "vertices"), "vertices: expected a list, got nothing"),
    (city(vertices=[]), "CityObjects 'house': geometry[0].boundaries: it refers to vertex 0 of 0"),
    (city(vertices=None), "vertices: expected a list, got nothing"),
    (city(vertices={"a": 1}), "vertices: expected a list, got dict"),
    (city(vertices=[[0, 0, 0], [0, 0]]), "vertices: expected rows of 3 numbers, got rows of other sizes"),
    (city(vertices=[[0, 0], [1, 1]]), "vertices: expected rows of 3 numbers, got [0, 0] among them"),
    (city(vertices=[["1", 2, 3]]), "vertices: expected rows of 3 numbers, got ['1', 2, 3] among them"),
    (city(vertices=[[1, 2, None]]), "vertices: expected rows of 3 numbers, got [1, 2, None] among them"),
    (city(vertices=[[1, 2, 10**400]]), "vertices: expected rows of 3 numbers"),
    (city(vertices=[*CUBE[:7], [1e31, 0, 0]]), "vertices[7]: expected numbers up to 1e+30, got 1e+31"),
    (city(vertices=[[True, False, True]]), "vertices: expected rows of 3 numbers"),
    (city(transform={"scale": [1e300, 1, 1], "translate": [0, 0, 0]}), "transform.scale[0]: expected numbers up to"),
    (city(transform={"scale": [1e30, 1, 1], "translate": [1e30, 0, 0]}), "vertices[1]: expected numbers up to 1e+30"),
    (city(transform={"scale": [1, 1], "translate": [0, 0, 0]}), "transform.scale: expected three numbers, got 2"),
    (city(transform={"scale": [1, 1, 1]}), "transform.translate: expected a list, got nothing"),
    (city(transform={"scale": "1", "translate": [0, 0, 0]}), "transform.scale: expected a list, got str '1'"),
    (city(transform=[1]), "transform: expected an object, got list [1]"),
    (city(transform={"scale": [0, 0, 0], "translate": [0, 0, 0]}), "no triangles"),
    (remove_key(city(), "CityObjects"), "CityObjects: expected an object, got nothing"),
    (city(CityObjects=[1]), "CityObjects: expected an object, got list [1]"),
    (city(CityObjects={}), "no triangles"),
    (city(CityObjects={"a": 3}), "CityObjects 'a': expected an object, got int 3"),
    (city({"a": {"type": "Building", "geometry": {}}}), "CityObjects 'a': geometry: expected a list, got dict {}"),
    (city({"a": {"type": "Building", "geometry": [7]}}), "CityObjects 'a': geometry[0]: expected an object, got int 7"),
    (geometry(boundaries=None), f"{PLACE}.boundaries: expected a list, got nothing"),
    (geometry(boundaries=[SHELL[0]]), f"{PLACE}.boundaries: expected nested lists, got int 0 among them"),
    (geometry(boundaries=[[[[0, 1, 8]]]]), f"{PLACE}.boundaries: it refers to vertex 8 of 8"),
    (geometry(boundaries=[[[[0, 1, -1]]]]), f"{PLACE}.boundaries: it refers to vertex -1 of 8"),
    (
        geometry(boundaries=[[[[0, 1, 10**30]]]]),
        f"{PLACE}.boundaries: it refers to vertex 1000000000000000000000000000000",
    ),
    (geometry(boundaries=[[[[0, 1, 2.0]]]]), f"{PLACE}.boundaries: expected numbers of vertices, got float among them"),
    (geometry(boundaries=[[[[0, 1, True]]]]), f"{PLACE}.boundaries: expected numbers of vertices, got bool among them"),
    (geometry(boundaries=[[[[0, 1]]]]), f"{PLACE}.boundaries: surface 0 has a ring of 2 corners"),
    (geometry(boundaries=[[[[]]]]), f"{PLACE}.boundaries: surface 0 has a ring of 0 corners"),
    (geometry(boundaries=[[[]]]), f"{PLACE}.boundaries: surface 0 has no rings"),
    (geometry(boundaries=[[SHELL[0], [[0, 1, 2], [4]]]]), f"{PLACE}.boundaries: surface 1 has a ring of 1 corners"),
    (geometry(boundaries=[[[[0, 0, 0]], [[0, 1, 0, 1]]]]), "no triangles"),
    (geometry(boundaries=deep(300)), f"{PLACE}.boundaries: expected numbers of vertices, got list among them"),
    (geometry(lod="fine"), f"{PLACE}.lod: expected a level of detail such as '2.2', got 'fine'"),
    (geometry(lod=[2]), f"{PLACE}.lod: expected a level of detail"),
    (geometry(lod="nan"), f"{PLACE}.lod: expected a level of detail"),
    (geometry(semantics=[]), f"{PLACE}.semantics: expected an object, got list []"),
    (geometry(semantics={"surfaces": 3}), f"{PLACE}.semantics.surfaces: expected a list, got int 3"),
    (city(version="3.0"), "it is CityJSON '3.0', and 1.0 to 2.0 are read"),
    (remove_key(city(), "version"), "it is CityJSON '', and 1.0 to 2.0 are read"),
    (city(metadata={"referenceSystem": "urn:ogc:def:crs:EPSG::4326"}), "its coordinates are degrees"),
    (city(metadata=[]), "metadata: expected an object, got list []"),
    (city(appearance={"materials": [3]}), "appearance.materials[0]: expected an object, got int 3"),
    (city(appearance={"materials": [{"diffuseColor": [1]}]}), "appearance.materials[0].diffuseColor: expected three"),
    (
        city(appearance={"materials": [{"diffuseColor": "red"}]}),
        "appearance.materials[0].diffuseColor: expected a list",
    ),
    (tree(template=3), f"{PLACE}.template: it refers to template 3 of 1"),
    (tree(template=-1), f"{PLACE}.template: it refers to template -1 of 1"),
    (tree(template="0"), f"{PLACE}.template: expected a whole number, got str '0'"),
    (tree(boundaries=[8]), f"{PLACE}.boundaries: it refers to vertex 8 of 8"),
    (tree(boundaries=[]), f"{PLACE}.boundaries[0]: expected a whole number, got nothing"),
    (tree(transformationMatrix=[1, 0, 0]), f"{PLACE}.transformationMatrix: expected 16 numbers, got 3"),
    (tree(transformationMatrix=[0] * 16), "a transform that is not finite and affine at node 'a'"),
]


@pytest.mark.parametrize(("document", "words"), CITIES, ids=range(len(CITIES)))
def test_damaged_cities_are_an_error_with_a_place(tmp_path: Path, document: Json, words: str) -> None:
    assert words in message(write_json(tmp_path / "a.city.json", document))


POLYGON = {"type": "Polygon", "coordinates": [square(0, 0, 5)]}


def changed_polygon(**changes: Any) -> Json:
    return collection({"type": "Feature", "properties": {}, "geometry": {**POLYGON, **changes}})


DEEP: Json = POLYGON
for _ in range(40):
    DEEP = {"type": "GeometryCollection", "geometries": [DEEP]}

FOOTPRINTS: list[tuple[Any, str]] = [
    ({"type": "FeatureCollection"}, "features: expected a list, got nothing"),
    ({"type": "FeatureCollection", "features": {}}, "features: expected a list, got dict {}"),
    (collection(3), "features[0]: expected an object, got int 3"),  # type: ignore[arg-type]
    (collection({"geometry": 3}), "features[0].geometry: expected an object, got int 3"),
    (collection({"geometry": POLYGON, "properties": 3}), "features[0].properties: expected an object, got int 3"),
    (changed_polygon(type="Sphere"), "features[0].geometry.type: expected a geometry of GeoJSON, got 'Sphere'"),
    (changed_polygon(type=["Polygon"]), "features[0].geometry.type: expected a geometry of GeoJSON, got ['Polygon']"),
    (changed_polygon(coordinates=None), "features[0].geometry.coordinates: expected a list, got nothing"),
    (changed_polygon(coordinates=5), "features[0].geometry.coordinates: expected a list, got int 5"),
    (changed_polygon(coordinates=[5]), "features[0].geometry.coordinates: expected nested lists, got int 5 among them"),
    (
        changed_polygon(coordinates=[[5]]),
        "features[0].geometry.coordinates: expected positions of two or three numbers, got 5",
    ),
    (changed_polygon(coordinates=[[[0, 0], [1], [2, 2]]]), "expected positions of two or three numbers, got [1]"),
    (
        changed_polygon(coordinates=[[[0, 0], ["1", 0], [2, 2]]]),
        "expected positions of two or three numbers, got ['1', 0]",
    ),
    (
        changed_polygon(coordinates=[[[0, 0], [True, 0], [2, 2]]]),
        "expected positions of two or three numbers, got [True, 0]",
    ),
    (changed_polygon(coordinates=[[[0, 0], [1, 0]]]), "feature 0: a ring of 2 points"),
    (changed_polygon(coordinates=[[[0, 0], [1, 0], [0, 0]]]), "feature 0: a ring of 2 points"),
    (changed_polygon(coordinates=[[]]), "feature 0: a ring of 0 points"),
    (
        changed_polygon(coordinates=[[[0, 0], [1e31, 0], [2, 2]]]),
        "feature 0: expected numbers up to 1e+30, got (1e+31, 0)",
    ),
    (changed_polygon(coordinates=[[[0, 0], [10**400, 0], [2, 2]]]), "a coordinate is beyond 1e+30"),
    (
        changed_polygon(coordinates=[[[0, 0], [1, 0], [2, 0]]], type="MultiPolygon"),
        "expected positions of two or three numbers, got 0",
    ),
    (collection({"geometry": {**POLYGON, "coordinates": [square(8e4, 4e5, 1)]}}, epsg=None), "'crs' names a system"),
    (collection({"geometry": DEEP}), "expected geometries nested less than 16 deep"),
    (collection({"geometry": {"type": "Point", "coordinates": [0, 0]}}), "no triangles"),
    (collection(), "no triangles"),
    (collection() | {"crs": 3}, "crs: expected an object, got int 3"),
    ([{"polygon": 3}], "[0].polygon: expected a list, got int 3"),
    ([{"polygon": square(0, 0, 1)}, 3], "[1]: expected an object, got int 3"),
    ([], "its JSON is not a scene that nearfar reads"),
    ({}, "its JSON is not a scene that nearfar reads"),
    (None, "its JSON is not a scene that nearfar reads"),
    ("FeatureCollection", "its JSON is not a scene that nearfar reads"),
]


@pytest.mark.parametrize(("document", "words"), FOOTPRINTS, ids=range(len(FOOTPRINTS)))
def test_damaged_footprints_are_an_error_with_a_place(tmp_path: Path, document: Any, words: str) -> None:
    assert words in message(write_json(tmp_path / "a.json", document))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (b"", "it is not valid JSON"),
        (b"{", "it is not valid JSON"),
        (b"\xff\xfe\x00", "it is not valid JSON"),
        (b'{"type": NaN}', "it is not valid JSON: NaN instead of a number"),
        (b'{"type": -Infinity}', "it is not valid JSON: -Infinity instead of a number"),
        (b"[" * 200_000, "its parts are nested too deeply"),
        (b"[" * 200_000 + b"]" * 200_000, "its parts are nested too deeply"),
        (b'{"type": "CityJSON", "version": "1.0", "CityObjects": {}, "vertices": [[1e999, 0, 0]]}', "expected numbers"),
        (b"9" * 5000, "cannot be read"),
    ],
)
def test_text_that_is_no_document_is_an_error(tmp_path: Path, text: bytes, words: str) -> None:
    path = tmp_path / "a.city.json"
    path.write_bytes(text)
    assert words in message(path)


def test_invalid_surfaces_and_polygons_can_be_omitted(tmp_path: Path) -> None:
    good = feature([square(0, 0, 5)], height=3)
    document = collection(good, feature([[[0, 0], [1, 1]]]), feature([square(0, 0, 9), [[0, 0], [1e31, 0], [1, 1]]]))
    scene = nf.Scene.load(write_json(tmp_path / "a.geojson", document), on_invalid="drop")
    assert scene.triangle_count == 10
    assert "2 polygons left out" in scene.report.notes


ROW = polygon_bytes([square(0, 0, 5)])
GEO = {"version": "1.1.0", "primary_column": "geometry", "columns": {"geometry": {"encoding": "WKB", "crs": None}}}


@pytest.mark.parametrize(
    ("row", "words"),
    [
        (ROW[:-1], "geometry of row 1: it claims 5 parts, more than its bytes can hold"),
        (ROW[:3], "geometry of row 1: it is cut off"),
        (b"\x05" + ROW[1:], "geometry of row 1: its byte order is 5, not 0 or 1"),
        (struct.pack("<BII", 1, 3, 2**32 - 1), "geometry of row 1: it claims 4294967295 parts"),
        (struct.pack("<BII", 1, 6, 2**31) + ROW, "geometry of row 1: it claims 2147483648 parts"),
        (ROW + b"x", "geometry of row 1: 1 bytes follow its geometry"),
        (struct.pack("<BI", 1, 17), "geometry of row 1: geometry type 17 is not read"),
        (polygon_bytes([[[0, 0], [np.nan, 0], [1, 1]]]), "feature 1: expected numbers up to 1e+30, got (nan, 0)"),
        (polygon_bytes([[[0, 0], [1, 0], [0, 0]]]), "feature 1: a ring of 2 points"),
    ],
)
def test_damaged_geometries_of_parquet_name_their_row(tmp_path: Path, row: bytes, words: str) -> None:
    assert words in message(parquet(tmp_path / "a.parquet", [ROW, row, ROW]))


@pytest.mark.parametrize(
    ("geo", "words"),
    [
        (None, "it lacks the metadata 'geo'"),
        (b"{", "its metadata 'geo' is not JSON"),
        ([], "its metadata 'geo' describes no primary column"),
        ({"primary_column": "geometry"}, "its metadata 'geo' describes no primary column"),
        ({"primary_column": 3, "columns": {}}, "its metadata 'geo' describes no primary column"),
        (
            {"primary_column": "shape", "columns": {"shape": {"encoding": "WKB"}}},
            "names the column 'shape', which it lacks",
        ),
        ({"primary_column": "height", "columns": {"height": {"encoding": "WKB"}}}, "geometry column holds int64"),
        ({"primary_column": "geometry", "columns": {"geometry": {"encoding": "point"}}}, "is encoded as 'point'"),
    ],
)
def test_parquet_that_is_no_geoparquet_is_an_error(tmp_path: Path, geo: Any, words: str) -> None:
    text = message(parquet(tmp_path / "a.parquet", [ROW], geo=geo, height=[3]))
    assert words in text
    assert "expected GeoParquet of footprints" in text
    assert text.endswith("got the columns 'geometry, height'")


def test_damaged_parquet_is_an_error(tmp_path: Path) -> None:
    path = parquet(tmp_path / "a.parquet", [ROW] * 50, geo=GEO, height=list(range(50)))
    data = path.read_bytes()
    for cut in (0, 3, 4, 12, len(data) // 2, len(data) - 1):
        path.write_bytes(data[:cut])
        assert "it is not a Parquet file, or it is damaged" in message(path)


def test_lines_of_a_sequence_are_named(tmp_path: Path) -> None:
    path = tmp_path / "a.city.jsonl"
    header = city() | {"CityObjects": {}, "vertices": []}
    for line, words in (
        ("3", "line 2: expected an object, got int 3"),
        ("{", "line 2: it is not valid JSON"),
        ('{"id": "f", "CityObjects": {}}', "feature 'f': vertices: expected a list, got nothing"),
    ):
        path.write_text(f"{json.dumps(header)}\n{line}")
        assert words in message(path)
    path.write_text("\n\n")
    assert "it is empty" in message(path)


def test_rows_that_expand_greatly_are_refused(tmp_path: Path) -> None:
    path = parquet(tmp_path / "a.parquet", [ROW] * 40_000)
    assert path.stat().st_size < 100_000
    assert "it unpacks to more than 2,000,000 bytes" in message(path, max_bytes=2_000_000)
    assert nf.Scene.load(path).triangle_count == 400_000
