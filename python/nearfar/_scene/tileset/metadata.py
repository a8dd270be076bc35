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
    for class_name, described in typed(schema.get("classes", {}), dict, "schema.classes").items():
        place = f"schema.classes.{check.shortened(class_name)}"
        properties = typed(described, dict, place).get("properties", {})
        for name, stated in typed(properties, dict, f"{place}.properties").items():
            here = f"{place}.properties.{check.shortened(name)}"
            if typed(stated, dict, here).get("semantic") != _SEMANTIC:
                continue
            component = values.choice(f"{here}.componentType", stated.get("componentType"), tuple(_TYPES))
            values.whole(f"{here}.count", stated.get("count"), _NUMBERS, _NUMBERS)
            by_class[class_name] = BoxProperty(name, _TYPES[component])
    return by_class


def boxes(
    document: dict[str, Any], known: dict[str, BoxProperty], count: int, view: Callable[[str, Any], bytes]
) -> Floats | None:
    """Boxes (count, 4, 3) of a subtree's available tiles: the centre, then half of each edge; None if it states none.

    `document` is the subtree's, `known` the result of `box_properties`; `view` returns the bytes of a buffer view by
    index.
    """
    if not known or document.get("tileMetadata") is None:
        return None
    tables = typed(document.get("propertyTables"), list, "propertyTables")
    place = f"propertyTables[{values.whole('tileMetadata', document['tileMetadata'], 0, len(tables) - 1)}]"
    table = typed(tables[document["tileMetadata"]], dict, place)
    property_ = known.get(str(table.get("class")))
    if property_ is None:
        return None
    if table.get("count") != count:
        raise UnusableError(
            f"{place}.count: expected {count}, the tiles that are there, got {check.shortened(table.get('count'))}"
        )
    columns = typed(table.get("properties"), dict, f"{place}.properties")
    column = f"{place}.properties.{check.shortened(property_.name)}"
    data = view(column, typed(columns.get(property_.name), dict, column).get("values"))
    if len(data) != count * _NUMBERS * property_.dtype.itemsize:
        raise UnusableError(f"{column}: expected {_NUMBERS} numbers for each of {count} tiles, got {len(data)} bytes")
    rows = np.frombuffer(data, property_.dtype).astype(np.float64).reshape(count, 4, 3)
    if not np.isfinite(rows).all():
        raise UnusableError(f"{column}: expected finite numbers")
    return rows
