"""Reads city models and footprints; the file's suffix or its JSON content selects the reader."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget, read_file
from nearfar._scene.city import cityjson, geojson, geoparquet
from nearfar._scene.city.footprints import Footprints
from nearfar._scene.city.outlines import Table
from nearfar._scene.content import Content
from nearfar._scene.entries import document
from nearfar._scene.options import LoadOptions
from nearfar._scene.reasons import explained

KINDS = ("geojson", "jsonl", "parquet", "geoparquet")
"""Suffixes that only city files have; .json files are recognised by their content."""

_PACKED = ".gz"

_UNKNOWN = "its JSON is not a scene that nearfar reads: neither CityJSON, nor GeoJSON, nor a tileset of 3D Tiles"


def check_options(path: str | Path, options: LoadOptions) -> None:
    """Reject options of cities that do not apply to this kind of file; ValueError."""
    name = Path(path).name
    kind = name.lower().removesuffix(_PACKED).rpartition(".")[2]
    if options.lod is not None and kind not in ("json", "jsonl"):
        raise ValueError(f"lod: expected none for {name}, because only CityJSON has levels of detail")
    if options.height is not None and kind not in ("json", "geojson", "parquet", "geoparquet"):
        raise ValueError(f"height: expected none for {name}, because only GeoJSON and GeoParquet are extruded")


def read(label: str, kind: str, data: bytes, options: LoadOptions, budget: Budget) -> Content:
    """Read a file of one of `KINDS`, or JSON of a city; UnusableError for anything else."""
    if kind == "jsonl":
        return cityjson.read_sequence(label, data, options.max_level, drop=options.drops)
    root = _root(kind, data)
    if isinstance(root, dict) and root.get("type") == "CityJSON":
        if options.height is not None:
            raise UnusableError("it is CityJSON, which is not extruded: height does not apply to it")
        return cityjson.read(label, root, options.max_level, drop=options.drops)
    if options.lod is not None:
        raise UnusableError("it has footprints and no levels of detail: lod does not apply to it")
    return Footprints(label, _table(root, data, budget), options).content()


def open_footprints(path: Path, options: LoadOptions) -> Footprints:
    """Open the footprints of a GeoJSON or GeoParquet file; SceneError with its name if it is neither."""
    label, kind = os.fspath(path), path.suffix.lower().lstrip(".")
    budget = Budget(options.max_bytes)
    with explained(label, passed=OSError):
        data = read_file(path, budget)
    with explained(label):
        return Footprints(label, _table(_root(kind, data), data, budget), options)


def _root(kind: str, data: bytes) -> Any:
    """Parse JSON; None for Parquet."""
    if kind in ("parquet", "geoparquet"):
        return None
    root = document(data)
    if root is None:
        raise UnusableError(_UNKNOWN)
    return root


def _table(root: Any, data: bytes, budget: Budget) -> Table:
    """Read the features of parsed JSON, or of Parquet data if there is no JSON."""
    if root is None:
        return geoparquet.read(data, budget)
    kinds = ("FeatureCollection", "Feature", *geojson.GEOMETRIES)
    if geojson.is_polygon_list(root) or (isinstance(root, dict) and root.get("type") in kinds):
        return geojson.read(root)
    raise UnusableError(_UNKNOWN)
