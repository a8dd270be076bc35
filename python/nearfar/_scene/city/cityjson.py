"""Reads CityJSON 1.0 to 2.0 and CityJSONSeq: surfaces of city objects, coloured by material or class."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import UnusableError
from nearfar._scene.city import crs
from nearfar._scene.city.collector import Collector, Part
from nearfar._scene.city.levels import Levels
from nearfar._scene.content import Content, Nodes, translation
from nearfar._scene.entries import check_range, document, entry, flattened, numbers, typed
from nearfar._scene.frames import Z_UP_TO_SCENE
from nearfar._scene.materials import PLAIN, BaseColor
from nearfar._scene.report import count
from nearfar._scene.srgb import to_linear

_DEPTHS = {"MultiSurface": 0, "CompositeSurface": 0, "Solid": 1, "MultiSolid": 2, "CompositeSolid": 2}
"""Depth of nested lists above the surfaces, by geometry type."""

_INSTANCE = "GeometryInstance"
DRAWN = (*_DEPTHS, _INSTANCE)


def _from_srgb(srgb: tuple[float, float, float]) -> BaseColor:
    """Return the base colour for sRGB values in 0..1."""
    red, green, blue = to_linear(np.array(srgb)).tolist()
    return BaseColor(factor=(red, green, blue, 1.0))


def _color(code: str) -> BaseColor:
    red, green, blue = (int(code[start : start + 2], 16) / 255 for start in (1, 3, 5))
    return _from_srgb((red, green, blue))


_WALL, _ROOF, _GROUND, _PAVED, _ROAD = (_color(c) for c in ("#d9cfbd", "#a5533c", "#77706a", "#9c9a96", "#5f6064"))
_WATER, _GREEN, _GRASS = (_color(code) for code in ("#4d7ba6", "#4f7a3d", "#93a36a"))

SURFACES = {
    "RoofSurface": _ROOF,
    **dict.fromkeys(("WallSurface", "ClosureSurface", "InteriorWallSurface", "CeilingSurface"), _WALL),
    **dict.fromkeys(("GroundSurface", "OuterCeilingSurface", "WaterGroundSurface", "TransportationHole"), _GROUND),
    **dict.fromkeys(("OuterFloorSurface", "FloorSurface"), _PAVED),
    **dict.fromkeys(("WaterSurface", "WaterClosureSurface"), _WATER),
    "Window": _color("#6d8ea6"),
    "Door": _color("#6b4a33"),
    "TrafficArea": _ROAD,
    "AuxiliaryTrafficArea": _GRASS,
    "TransportationMarking": _color("#e8e8e2"),
}
"""Colours of surfaces by semantic class."""

OBJECTS = {
    **{f"Building{part}": _WALL for part in ("", "Part", "Installation", "Room", "Storey", "Unit")},
    **dict.fromkeys(("Bridge", "BridgePart", "Tunnel", "TunnelPart", "TransportSquare"), _PAVED),
    "Road": _ROAD,
    "Railway": _GROUND,
    **dict.fromkeys(("LandUse", "TINRelief"), _GRASS),
    **dict.fromkeys(("PlantCover", "SolitaryVegetationObject"), _GREEN),
    **dict.fromkeys(("WaterBody", "Waterway"), _WATER),
}
"""Colours by type of city object, for surfaces without semantics; other types have the plain colour."""


def color_of_surface(surface: str | None, kind: str) -> BaseColor:
    """Return the colour of a surface's class, else that of its object's type."""
    return SURFACES.get(surface or "", OBJECTS.get(kind, PLAIN))


def read(label: str, header: dict[str, Any], lod: float | None, *, drop: bool) -> Content:
    """Convert a document whose type is CityJSON; `label` is the name of its file.

    `lod` is the greatest level of detail to draw; None draws each object at its highest. With `drop`, unusable
    surfaces are left out instead of raising an error.
    """
    return _Reader(label, header, lod, drop).content([header])


def read_sequence(label: str, data: bytes, lod: float | None, *, drop: bool) -> Content:
    """Convert a CityJSONSeq, lines of JSON: a CityJSON without objects, then features with their own vertices."""
    lines = [line for line in data.splitlines() if line.strip()]
    if not lines:
        raise UnusableError("it is empty")
    header = typed(document(lines[0], "line 1: "), dict, "line 1")
    if header.get("type") != "CityJSON":
        raise UnusableError(f"line 1: expected the type CityJSON, got {check.shortened(header.get('type'))}")
    features = (
        typed(document(line, f"line {number}: "), dict, f"line {number}") for number, line in enumerate(lines[1:], 2)
    )
    return _Reader(label, header, lod, drop).content([header, *features] if "CityObjects" in header else features)


class _Reader:
    def __init__(self, label: str, header: dict[str, Any], lod: float | None, drop: bool) -> None:
        version = str(header.get("version", ""))
        if version.split(".")[0] not in ("1", "2"):
            raise UnusableError(f"it is CityJSON {check.shortened(version)}, and 1.0 to 2.0 are read")
        self._label, self._header, self._drop = label, header, drop
        self._levels = Levels(lod)
        self._system = _system(header)
        self._collector, self._templates = Collector(), Collector()
        self._template_names: list[str | None] = []
        self._placed: list[tuple[str, NDArray[np.float64], str]] = []
        self._omissions = Counter[tuple[str, str]]()

    def content(self, parts: Iterable[dict[str, Any]]) -> Content:
        self._read_templates()
        for part in parts:
            self._read_part(part)
        shapes, nodes = {}, []
        objects, object_counts = self._collector.shapes(drop=self._drop)
        templates, template_counts = self._templates.shapes(drop=self._drop)
        for name, (shape, base) in objects.items():
            nodes.append((name, translation(base), name))
            shapes[name] = shape
        for template, (shape, base) in templates.items():
            key = f"{template} of geometry-templates"
            shapes[key] = shape
            nodes += [
                (name, matrix @ translation(base), key) for name, matrix, owner in self._placed if owner == template
            ]
        for ending, number in (object_counts + template_counts).items():
            self._omissions["surface", ending] += number
        shapes = {name: shape for name, shape in shapes.items() if len(shape.faces)}
        used = [f"CityJSON {self._header['version']}", *self._system]
        notes = [f"{count(number, noun)} {ending}" for (noun, ending), number in self._omissions.items()]
        return Content(self._label, shapes, Nodes.from_rows(nodes), self._levels.notes() + notes, used)

    def _read_part(self, part: dict[str, Any]) -> None:
        prefix = "" if part is self._header else f"feature {check.shortened(part.get('id', ''))}: "
        vertices = self._placed_vertices(numbers(entry(part, "vertices", list, prefix), f"{prefix}vertices", 3), prefix)
        self._collector.add_vertices(vertices)
        objects = {
            name: typed(item, dict, f"{prefix}CityObjects {check.shortened(name)}")
            for name, item in entry(part, "CityObjects", dict, prefix).items()
        }
        appearance = Appearance(part if "appearance" in part else self._header)
        for name, (number, geometry) in self._levels.select_geometries(objects, DRAWN):
            json_path = f"CityObjects {check.shortened(name)}: geometry[{number}]"
            if geometry["type"] == _INSTANCE:
                self._place(name, geometry, vertices, json_path)
            else:
                self._add(self._collector, Part(name, json_path), geometry, str(objects[name].get("type")), appearance)
        self._omissions.update(appearance.notes)

    def _add(
        self, collector: Collector, part: Part, geometry: dict[str, Any], kind: str, appearance: Appearance
    ) -> None:
        boundaries = entry(geometry, "boundaries", list, f"{part.json_path}.")
        depth = _DEPTHS[geometry["type"]]
        surfaces = flattened(boundaries, depth, f"{part.json_path}.boundaries")
        colors = appearance.colors(geometry, boundaries, depth, kind, f"{part.json_path}.")
        collector.add_surfaces(Part(part.owner, f"{part.json_path}.boundaries"), surfaces, colors)

    def _placed_vertices(self, vertices: NDArray[np.float64], prefix: str) -> NDArray[np.float64]:
        transform = entry(self._header, "transform", dict, "", {})
        for key in ("scale", "translate") if transform else ():
            row = numbers(entry(transform, key, list, "transform."), f"transform.{key}", None)
            if len(row) != 3:
                raise UnusableError(f"transform.{key}: expected three numbers, got {len(row)}")
            vertices = vertices * row if key == "scale" else vertices + row
        check_range(vertices, f"{prefix}vertices")
        return vertices

    def _read_templates(self) -> None:
        templates = entry(self._header, "geometry-templates", dict, "", {})
        if not templates:
            return
        prefix = "geometry-templates."
        self._templates.add_vertices(
            numbers(entry(templates, "vertices-templates", list, prefix), f"{prefix}vertices-templates", 3)
        )
        appearance = Appearance(self._header)
        for number, item in enumerate(entry(templates, "templates", list, prefix)):
            geometry = typed(item, dict, f"{prefix}templates[{number}]")
            part = Part(f"template {number}", f"{prefix}templates[{number}]")
            drawn = geometry.get("type") in _DEPTHS
            self._template_names.append(part.owner if drawn else None)
            if drawn:
                self._add(self._templates, part, geometry, "", appearance)

    def _place(self, name: str, geometry: dict[str, Any], vertices: NDArray[np.float64], json_path: str) -> None:
        number = entry(geometry, "template", int, f"{json_path}.")
        if not 0 <= number < len(self._template_names):
            raise UnusableError(f"{json_path}.template: it refers to template {number} of {len(self._template_names)}")
        boundaries = entry(geometry, "boundaries", list, f"{json_path}.")
        vertex = typed(boundaries[0] if len(boundaries) == 1 else None, int, f"{json_path}.boundaries[0]")
        if not 0 <= vertex < len(vertices):
            raise UnusableError(f"{json_path}.boundaries: it refers to vertex {vertex} of {len(vertices)}")
        rows = numbers(
            entry(geometry, "transformationMatrix", list, f"{json_path}."), f"{json_path}.transformationMatrix", None
        )
        if rows.shape != (16,):
            raise UnusableError(f"{json_path}.transformationMatrix: expected 16 numbers, got {len(rows)}")
        matrix = rows.reshape(4, 4)
        owner = self._template_names[number]
        if owner is None:
            self._omissions["instance", "of points or lines ignored"] += 1
            return
        matrix[:3, 3] += vertices[vertex]
        self._placed.append((name, Z_UP_TO_SCENE @ matrix @ Z_UP_TO_SCENE.T, owner))


def _system(header: dict[str, Any]) -> list[str]:
    """Notes on the stated coordinate system and extent; UnusableError if coordinates are in degrees."""
    metadata = entry(header, "metadata", dict, "", {})
    name = metadata.get("referenceSystem")
    notes = []
    if isinstance(name, str) and name:
        if crs.is_degrees(name):
            raise UnusableError(
                f"its coordinates are degrees ({check.shortened(name)}): cjio reproject gives them in metres"
            )
        code = crs.epsg(name)
        notes.append(f"coordinates of {f'EPSG:{code}' if code else check.shortened(name)} as they are")
    extent = metadata.get("geographicalExtent")
    if isinstance(extent, list) and len(extent) == 6 and all(isinstance(value, int | float) for value in extent):
        sides = (f"{low:,.0f} to {high:,.0f}" for low, high in zip(extent[:3], extent[3:], strict=True))
        notes.append("stated extent " + ", ".join(f"{axis} {side}" for axis, side in zip("xyz", sides, strict=True)))
    return notes


class Appearance:
    """Materials that the entry ``appearance`` of a document or a feature lists, and notes on undrawn parts."""

    def __init__(self, feature: dict[str, Any]) -> None:
        appearance = entry(feature, "appearance", dict, "", {})
        self._theme = appearance.get("default-theme-material")
        self._materials = [
            self._color(item, f"appearance.materials[{number}]")
            for number, item in enumerate(entry(appearance, "materials", list, "appearance.", []))
        ]
        self.notes = Counter[tuple[str, str]]()
        """Numbers of parts that are not drawn, by the noun and the rest of the note."""
        if textures := len(entry(appearance, "textures", list, "appearance.", [])):
            self.notes["texture", "not drawn"] = textures

    def _color(self, item: Any, json_path: str) -> BaseColor:
        material = typed(item, dict, json_path)
        diffuse = material.get("diffuseColor")
        values = numbers([0.8, 0.8, 0.8] if diffuse is None else diffuse, f"{json_path}.diffuseColor", None)
        if values.shape != (3,):
            raise UnusableError(f"{json_path}.diffuseColor: expected three numbers, got {len(values)}")
        red, green, blue = values.clip(0, 1).tolist()
        color = _from_srgb((red, green, blue))
        transparency = material.get("transparency")
        is_clear = isinstance(transparency, int | float) and transparency > 0
        return replace(color, notes=("with transparency drawn opaque",)) if is_clear else color

    def colors(
        self, geometry: dict[str, Any], boundaries: list[Any], depth: int, kind: str, prefix: str
    ) -> list[BaseColor]:
        """Colour of each surface of a geometry, whose boundaries nest surfaces `depth` lists deep."""
        semantics = entry(geometry, "semantics", dict, prefix, {})
        surfaces = entry(semantics, "surfaces", list, f"{prefix}semantics.", [])
        types = [item.get("type") if isinstance(item, dict) else None for item in surfaces]
        class_colors = [color_of_surface(name if isinstance(name, str) else None, kind) for name in types]
        plain = color_of_surface(None, kind)
        labels = _labels(semantics.get("values"), boundaries, depth)
        colors = [_index_or_default(class_colors, label, plain) for label in labels]
        if not self._materials:
            return colors
        theme = self._theme_of(entry(geometry, "material", dict, prefix, {}))
        label = theme.get("value")
        labels = [label] * len(colors) if isinstance(label, int) else _labels(theme.get("values"), boundaries, depth)
        return [_index_or_default(self._materials, label, color) for label, color in zip(labels, colors, strict=True)]

    def _theme_of(self, themes: dict[str, Any]) -> dict[str, Any]:
        """Return the material entry of the default theme, else that of the first theme."""
        theme = themes.get(self._theme) if isinstance(self._theme, str) else None
        theme = next(iter(themes.values()), None) if theme is None else theme
        return theme if isinstance(theme, dict) else {}


def _index_or_default(items: list[BaseColor], number: int | None, default: BaseColor) -> BaseColor:
    return items[number] if number is not None and 0 <= number < len(items) else default


def _labels(values: Any, boundaries: list[Any], depth: int) -> list[int | None]:
    """Index for each surface from lists nested like the boundaries; None where missing."""
    parts = values if isinstance(values, list) else []
    padded = [*parts[: len(boundaries)], *[None] * (len(boundaries) - len(parts))]
    if depth:
        pairs = zip(padded, boundaries, strict=True)
        return [label for part, inner_boundaries in pairs for label in _labels(part, inner_boundaries, depth - 1)]
    return [part if isinstance(part, int) and not isinstance(part, bool) else None for part in padded]
