"""Reads footprints from GeoJSON, and from the lists of polygons in deck.gl's examples."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import UnusableError
from nearfar._scene.city import crs, heights
from nearfar._scene.city.outlines import Outlines, Table, offsets
from nearfar._scene.entries import entry, flattened, typed

_MAX_NESTING = 16
"""Maximum nesting depth of geometry collections."""

GEOMETRIES = {"Point", "MultiPoint", "LineString", "MultiLineString", "Polygon", "MultiPolygon", "GeometryCollection"}


def read(root: Any) -> Table:
    """Read the features of a document: a FeatureCollection, a Feature, a geometry, or deck.gl's list."""
    if isinstance(root, list):
        return _polygon_list(root)
    kind = root.get("type")
    if kind == "FeatureCollection":
        features = [typed(item, dict, f"features[{n}]") for n, item in enumerate(entry(root, "features", list, ""))]
    elif kind == "Feature":
        features = [root]
    else:
        features = [{"geometry": root}]
    collector = _Collector()
    for number, feature in enumerate(features):
        geometry = entry(feature, "geometry", dict, f"features[{number}].", {})
        collector.add_feature(geometry, f"features[{number}].geometry")
    properties = [entry(f, "properties", dict, f"features[{n}].", {}) for n, f in enumerate(features)]
    system, is_in_degrees = _system(root)
    return Table(collector.outlines(), system, is_in_degrees, _Columns(properties, features), skipped=collector.skipped)


def is_polygon_list(root: Any) -> bool:
    """Whether a document is a list of objects with a polygon each, as in deck.gl's examples."""
    return isinstance(root, list) and bool(root) and isinstance(root[0], dict) and "polygon" in root[0]


def _polygon_list(root: list[Any]) -> Table:
    collector = _Collector()
    rows = [typed(item, dict, f"[{number}]") for number, item in enumerate(root)]
    for number, row in enumerate(rows):
        polygon = entry(row, "polygon", list, f"[{number}].")
        start = polygon[0] if polygon else None
        is_ring = isinstance(start, list) and bool(start) and not isinstance(start[0], list)
        collector.add_polygons([[polygon] if is_ring else polygon], f"[{number}].polygon")
    return Table(collector.outlines(), "WGS84", True, _Columns(rows, []), format="list of polygons")


def _system(root: dict[str, Any]) -> tuple[str, bool]:
    """Name of the coordinate system in the member ``crs``, else WGS84, and whether it is in degrees."""
    member = entry(root, "crs", dict, "", {})
    name = entry(member, "properties", dict, "crs.", {}).get("name")
    if not isinstance(name, str):
        return "WGS84", True
    code = crs.epsg(name)
    return f"EPSG:{code}" if code else check.shortened(name), crs.is_degrees(name)


class _Columns:
    """Properties of features."""

    def __init__(self, properties: list[dict[str, Any]], features: list[dict[str, Any]]) -> None:
        self._properties, self._features = properties, features

    def __call__(self, name: str) -> NDArray[np.float64] | None:
        if not any(name in properties for properties in self._properties):
            return None
        return heights.numbers(properties.get(name) for properties in self._properties)

    def texts(self, name: str | None) -> list[str] | None:
        """Features' names: a property, or the ids if `name` is None; None if any feature lacks one."""
        values = [p.get(name) for p in self._properties] if name else [f.get("id") for f in self._features]
        if not values or not all(isinstance(v, str | int) and not isinstance(v, bool) for v in values):
            return None
        return [str(value) for value in values]


class _Collector:
    def __init__(self) -> None:
        self._points: list[Any] = []
        self._ring_sizes: list[int] = []
        self._polygon_rings: list[int] = []
        self._feature_polygons: list[int] = []
        self.skipped = 0

    def add_feature(self, geometry: dict[str, Any], json_path: str) -> None:
        """Add the polygons of a feature, which may have none."""
        previous_count = len(self._polygon_rings)
        for polygons, polygon_path in self._polygons_of(geometry, json_path, 0) if geometry else ():
            self._add(polygons, polygon_path)
        self._feature_polygons.append(len(self._polygon_rings) - previous_count)

    def add_polygons(self, polygons: list[Any], json_path: str) -> None:
        """Add a feature with these polygons."""
        self._add(polygons, json_path)
        self._feature_polygons.append(len(polygons))

    def _polygons_of(self, geometry: dict[str, Any], json_path: str, depth: int) -> Iterator[tuple[list[Any], str]]:
        kind = geometry.get("type")
        if kind == "GeometryCollection":
            if depth == _MAX_NESTING:
                raise UnusableError(f"{json_path}: expected geometries nested less than {_MAX_NESTING} deep")
            for number, item in enumerate(entry(geometry, "geometries", list, f"{json_path}.")):
                item_path = f"{json_path}.geometries[{number}]"
                yield from self._polygons_of(typed(item, dict, item_path), item_path, depth + 1)
        elif kind in ("Polygon", "MultiPolygon"):
            coordinates = entry(geometry, "coordinates", list, f"{json_path}.")
            yield ([coordinates] if kind == "Polygon" else coordinates), f"{json_path}.coordinates"
        elif isinstance(kind, str) and kind in GEOMETRIES:
            self.skipped += 1
        else:
            raise UnusableError(f"{json_path}.type: expected a geometry of GeoJSON, got {check.shortened(kind)}")

    def _add(self, polygons: list[Any], json_path: str) -> None:
        rings = flattened(polygons, 1, json_path)
        points = flattened(rings, 1, json_path)
        sizes = set(map(len, points)) if set(map(type, points)) <= {list} else {0}
        if points and (min(sizes) < 2 or {type(value) for point in points for value in point[:2]} - {int, float}):
            flaw = check.shortened(next((point for point in points if not _is_position(point)), points[0]))
            raise UnusableError(f"{json_path}: expected positions of two or three numbers, got {flaw}")
        self._points += points if sizes <= {2} else [point[:2] for point in points]
        self._ring_sizes += map(len, rings)
        self._polygon_rings += map(len, polygons)

    def outlines(self) -> Outlines:
        """Return all features in flat arrays."""
        try:
            points = np.array(self._points, np.float64).reshape(-1, 2)
        except OverflowError:
            raise UnusableError(f"a coordinate is beyond {check.FARTHEST:g}") from None
        levels = (offsets(counts) for counts in (self._ring_sizes, self._polygon_rings, self._feature_polygons))
        return Outlines(points, *levels).without_closing_points()


def _is_position(point: Any) -> bool:
    return isinstance(point, list) and len(point) >= 2 and all(type(value) in (int, float) for value in point[:2])
