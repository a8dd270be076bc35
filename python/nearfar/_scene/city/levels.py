"""Levels of detail of city objects: chooses which geometries of each object are drawn."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Iterator
from typing import Any

from nearfar._base import check
from nearfar._base.errors import UnusableError
from nearfar._scene.entries import entry, typed
from nearfar._scene.report import count

_LARGEST = 9.0
"""Greatest valid level."""

_NEXT = 0.999
"""Added to an integer level, because level 2 includes 2.0 to 2.3."""


def level_of(value: Any, json_path: str) -> float:
    """Parse a level of detail, a number or text such as "2.2"; UnusableError for anything else."""
    if isinstance(value, str | int | float) and not isinstance(value, bool):
        try:
            number = float(value)
        except (ValueError, OverflowError):
            number = math.nan
        if 0 <= number <= _LARGEST:
            return number
    raise UnusableError(f"{json_path}: expected a level of detail such as '2.2', got {check.shortened(value)}")


def parse_max_level(lod: str | float) -> float:
    """Convert the argument `lod` to the greatest level to draw: 2 includes all of 2.x; ValueError or TypeError."""
    if not isinstance(lod, str | int | float) or isinstance(lod, bool):
        raise TypeError(f"lod: expected a level of detail such as '2.2', got {check.type_and_value(lod)}")
    try:
        level = level_of(lod, "lod")
    except UnusableError as error:
        raise ValueError(str(error)) from None
    # 2, 2.0, "2" and "2.0" include all of 2.x; "2.00" names the level 2 itself.
    return level + _NEXT if level == int(level) and "." not in str(lod).removesuffix(".0") else level


class Levels:
    """Chooses the geometries of each object's highest level, at most `max_level`; None sets no limit."""

    def __init__(self, max_level: float | None) -> None:
        self._max_level = math.inf if max_level is None else max_level
        self._level_names = set[str]()
        self._omissions = Counter[tuple[str, str]]()

    def select_geometries(
        self, objects: dict[str, dict[str, Any]], drawn: Collection[str]
    ) -> Iterator[tuple[str, tuple[int, dict[str, Any]]]]:
        """Yield the name of an object, and number and entry of its geometry, for each geometry to draw."""
        best: dict[str, float] = {}
        usable: dict[str, list[tuple[float, int, dict[str, Any]]]] = {}
        for name, item in objects.items():
            prefix = f"CityObjects {check.shortened(name)}: "
            usable[name] = list(self._usable(entry(item, "geometry", list, prefix, []), drawn, prefix))
            if levels := [level for level, _, _ in usable[name] if level <= self._max_level]:
                best[name] = max(levels)
            elif usable[name]:
                self._omissions["object", "left out: no level up to the limit"] += 1
        for name, item in objects.items():
            if name not in best:
                continue
            if any(best.get(part, -1) > best[name] for part in _parts(item, objects)):
                self._omissions["object", "drawn by its parts, which have more detail"] += 1
                continue
            yield from ((name, (number, geometry)) for level, number, geometry in usable[name] if level == best[name])

    def _usable(
        self, geometries: list[Any], drawn: Collection[str], prefix: str
    ) -> Iterator[tuple[float, int, dict[str, Any]]]:
        for number, item in enumerate(geometries):
            geometry = typed(item, dict, f"{prefix}geometry[{number}]")
            if geometry.get("type") not in drawn:
                self._omissions["geometry", "of points, lines or an unknown type ignored"] += 1
                continue
            level = level_of(geometry.get("lod", 0), f"{prefix}geometry[{number}].lod")
            self._level_names.add(f"{level:g}")
            yield level, number, geometry

    def notes(self) -> list[str]:
        """Notes on parts left out, and on the levels if there are several."""
        plurals = {"geometry": "geometries"}
        notes = [f"{count(n, noun, plurals.get(noun, ''))} {ending}" for (noun, ending), n in self._omissions.items()]
        if len(self._level_names) > 1:
            listed = ", ".join(sorted(self._level_names))
            notes.append(f"levels of detail {listed}: each object is drawn at its highest; lod limits the level")
        return notes


def _parts(item: dict[str, Any], objects: dict[str, dict[str, Any]]) -> list[str]:
    """Children of an object that are parts of it, such as building parts; installations are not."""
    children = item.get("children")
    names = [name for name in children if isinstance(name, str)] if isinstance(children, list) else []
    return [name for name in names if str(objects.get(name, {}).get("type", "")).endswith("Part")]
