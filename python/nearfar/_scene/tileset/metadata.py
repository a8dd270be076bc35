"""Metadata of implicit tiles: boxes that override the subdivided volumes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from nearfar._base import check
from nearfar._base.errors import UnusableError
from nearfar._scene.entries import typed
from nearfar._scene.tileset import values
from nearfar._scene.tileset.frames import Floats

_SEMANTIC = "TILE_BOUNDING_BOX"
_NUMBERS = 12
"""Numbers of a box: its centre, then half of each edge."""
_TYPES: dict[str, np.dtype[Any]] = {"FLOAT32": np.dtype("<f4"), "FLOAT64": np.dtype("<f8")}


@dataclass(frozen=True)
class BoxProperty:
    """Metadata property of a class that holds boxes."""

    name: str
    dtype: np.dtype[Any]


def box_properties(document: dict[str, Any]) -> dict[str, BoxProperty]:
    """Properties with tiles' boxes in a tileset's schema, by class name."""
    by_class: dict[str, BoxProperty] = {}
    schema = typed(document.get("schema") or {}, dict, "schema")
    for class_name, class_entry in typed(schema.get("classes", {}), dict, "schema.classes").items():
        json_path = f"schema.classes.{check.shortened(class_name)}"
        properties = typed(class_entry, dict, json_path).get("properties", {})
        for name, item in typed(properties, dict, f"{json_path}.properties").items():
            path = f"{json_path}.properties.{check.shortened(name)}"
            if typed(item, dict, path).get("semantic") != _SEMANTIC:
                continue
            component = values.choice(f"{path}.componentType", item.get("componentType"), tuple(_TYPES))
            values.whole(f"{path}.count", item.get("count"), _NUMBERS, _NUMBERS)
            by_class[class_name] = BoxProperty(name, _TYPES[component])
    return by_class


def boxes(
    document: dict[str, Any], properties: dict[str, BoxProperty], count: int, view: Callable[[str, Any], bytes]
) -> Floats | None:
    """Boxes (count, 4, 3) of a subtree's available tiles: the centre, then half of each edge; None if it states none.

    `document` is the subtree's, `properties` the result of `box_properties`; `view` returns the bytes of a buffer view
    by index.
    """
    if not properties or document.get("tileMetadata") is None:
        return None
    tables = typed(document.get("propertyTables"), list, "propertyTables")
    table_path = f"propertyTables[{values.whole('tileMetadata', document['tileMetadata'], 0, len(tables) - 1)}]"
    table = typed(tables[document["tileMetadata"]], dict, table_path)
    property_ = properties.get(str(table.get("class")))
    if property_ is None:
        return None
    if table.get("count") != count:
        got = check.shortened(table.get("count"))
        raise UnusableError(f"{table_path}.count: expected {count}, the number of available tiles, got {got}")
    columns = typed(table.get("properties"), dict, f"{table_path}.properties")
    path = f"{table_path}.properties.{check.shortened(property_.name)}"
    data = view(path, typed(columns.get(property_.name), dict, path).get("values"))
    if len(data) != count * _NUMBERS * property_.dtype.itemsize:
        raise UnusableError(f"{path}: expected {_NUMBERS} numbers for each of {count} tiles, got {len(data)} bytes")
    rows = np.frombuffer(data, property_.dtype).astype(np.float64).reshape(count, 4, 3)
    if not np.isfinite(rows).all():
        raise UnusableError(f"{path}: expected finite numbers")
    return rows
