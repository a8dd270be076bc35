"""Small cities as files, and their known numbers."""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

Json = dict[str, Any]

CUBE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
"""Corners of a cube; z points up."""

SHELL = [[[0, 3, 2, 1]], [[4, 5, 6, 7]], [[0, 1, 5, 4]], [[1, 2, 6, 5]], [[2, 3, 7, 6]], [[3, 0, 4, 7]]]
"""Its faces from outside: ground, roof, south, east, north, west."""

SEMANTICS = {
    "surfaces": [{"type": "GroundSurface"}, {"type": "RoofSurface"}, {"type": "WallSurface"}],
    "values": [[0, 1, 2, 2, 2, 2]],
}


def solid(lod: Any = "2", **more: Any) -> Json:
    """The cube as a solid."""
    return {"type": "Solid", "lod": lod, "boundaries": [SHELL], **more}


def city(objects: Json | None = None, **more: Any) -> Json:
    """A CityJSON whose cube has 10 m sides and its corner at (85000, 447000, 2) of a national grid."""
    document = {
        "type": "CityJSON",
        "version": "2.0",
        "transform": {"scale": [10.0, 10.0, 10.0], "translate": [85000.0, 447000.0, 2.0]},
        "metadata": {"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/7415"},
        "CityObjects": objects or {"house": {"type": "Building", "geometry": [solid(semantics=SEMANTICS)]}},
        "vertices": CUBE,
    }
    return document | more


def everything() -> Json:
    """A CityJSON with semantics, materials, templates, parts and two levels."""
    matrix = [1, 0, 0, 3, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    tree = {"type": "GeometryInstance", "template": 0, "boundaries": [6], "transformationMatrix": matrix}
    painted = solid("2.2", semantics=SEMANTICS, material={"t": {"values": [[0, 0, None, 0, 0, 0]]}})
    flat = {"type": "MultiSurface", "lod": "0", "boundaries": [SHELL[0]]}
    objects = {
        "house": {"type": "Building", "children": ["part"], "geometry": [flat]},
        "part": {"type": "BuildingPart", "parents": ["house"], "geometry": [painted, flat]},
        "tree": {"type": "SolitaryVegetationObject", "geometry": [tree]},
    }
    templates = {"templates": [solid()], "vertices-templates": CUBE}
    appearance = {"materials": [{"diffuseColor": [1, 0, 0]}]}
    return city(objects, appearance=appearance, **{"geometry-templates": templates})


def square(x: float, y: float, size: float) -> list[list[float]]:
    """A closed ring."""
    return [[x, y], [x + size, y], [x + size, y + size], [x, y + size], [x, y]]


def feature(rings: Sequence[Sequence[Sequence[float]]], **properties: Any) -> Json:
    """A polygon of GeoJSON."""
    geometry = {"type": "Polygon", "coordinates": rings}
    return {"type": "Feature", "geometry": geometry, "properties": properties}


def collection(*features: Json, epsg: int | None = 28992) -> Json:
    """A FeatureCollection, in metres of a grid or with no number in degrees."""
    crs = {"crs": {"type": "name", "properties": {"name": f"urn:ogc:def:crs:EPSG::{epsg}"}}} if epsg else {}
    return {"type": "FeatureCollection", "features": list(features), **crs}


def write_json(path: Path, document: Any) -> Path:
    """The path of a file with JSON."""
    path.write_text(json.dumps(document))
    return path


def polygon_bytes(rings: Sequence[Sequence[Sequence[float]]]) -> bytes:
    """WKB of a polygon of closed rings."""
    data = struct.pack("<BII", 1, 3, len(rings))
    for ring in rings:
        data += struct.pack("<I", len(ring)) + b"".join(struct.pack("<2d", *point) for point in ring)
    return data


def parquet(path: Path, rows: Sequence[bytes | None], geo: Any = "", **columns: Any) -> Path:
    """A GeoParquet of rows in WKB, in metres of a grid unless `geo` specifies otherwise."""
    crs = {"type": "ProjectedCRS", "name": "Amersfoort / RD New", "id": {"authority": "EPSG", "code": 28992}}
    column = {"encoding": "WKB", "geometry_types": [], "crs": crs}
    stated = {"version": "1.1.0", "primary_column": "geometry", "columns": {"geometry": column}} if geo == "" else geo
    table = pa.table({"geometry": pa.array(rows, pa.binary()), **columns})
    metadata = None if stated is None else {"geo": stated if isinstance(stated, bytes) else json.dumps(stated)}
    pq.write_table(table.replace_schema_metadata(metadata), path)
    return path
