"""Manifest of a bundle: its format, and validation after reading."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from nearfar._base import check, formats
from nearfar.stream import _store
from nearfar.stream._decode import Layout

FORMAT, VERSION = "bundle", 1
"""Format name of the manifest without "nearfar.", and format version."""

_FILE_NAME = re.compile(r"[\w.-]+", re.ASCII)
"""Pattern of file names that are safe on every system and in every URL."""

_HASH = re.compile("[0-9a-f]{64}")

ORIENTATION = "Vulkan/WebGPU cube faces"
"""Order and directions of the maps' faces."""

MAX_COUNT = 2**62
"""Greatest number of triangles and objects."""

NEAR_SHARE = 0.7
"""Share n of a ring's radius inside which nothing is morphed, as in CloVR (2024)."""


EMPTY_RING: dict[str, Any] = {"radius": 0.0, "objects": 0, "triangles": 0, "stored": 0, "geometry": None, "parts": []}
"""Entry of ring 0, which has no geometry."""


def read(reader: _store.Reader) -> dict[str, Any]:
    """Read and check the manifest of a bundle; FormatError that names it if it is damaged or newer."""
    where = f"{reader.location}/{_store.MANIFEST}"
    data = reader.read(_store.MANIFEST)
    with formats.guarded(where):
        document = formats.from_json(data)
    manifest = formats.check(document, FORMAT, VERSION, where)
    with formats.guarded(where):
        _check(manifest)
    return manifest


def file_entries(manifest: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """Return size and hash of every file of a bundle except the manifest, by name."""
    return {**manifest["files"], _store.TILESET: manifest["tileset"]}


def names_of(value: Any) -> list[str]:
    """Return the file names of an entry: one, several or none."""
    if value is None:
        return []
    return [value] if isinstance(value, str) else list(value)


def geometry_files(entry: Mapping[str, Any] | None) -> tuple[str, ...]:
    """Return the file names of an entry with a GLB: the GLB, its buffers and its images."""
    return () if entry is None else (*names_of(entry["geometry"]), *entry["parts"])


def layout_of(manifest: Mapping[str, Any], region: Mapping[str, Any]) -> Layout:
    """Return the division of a region's maps into files; ValueError for impossible values."""
    return Layout.parse({**manifest["map"], "range": region["range"]})


def _check(manifest: dict[str, Any]) -> None:
    """Raise an error for a manifest that cannot be used; the caller converts it to FormatError."""
    check.integer("triangles", manifest["triangles"], 0, MAX_COUNT)
    check.texts("notes", manifest["notes"])
    low, high = manifest["bounds"]
    check.vector("bounds", low), check.vector("bounds", high)
    check.choice("color_space", manifest["color_space"], ("sRGB",))
    if check.choice("unit", manifest.get("unit", "object"), ("object", "triangle")) == "triangle":
        raise ValueError(
            "unit: expected rings of objects, got a reduced scene for the page; read it with nearfar.ReducedScene.load"
        )
    check.choice("morph", manifest["morph"]["kind"], ("cylinder",))
    if check.positive("near_share", manifest["morph"]["near_share"]) != NEAR_SHARE:
        raise ValueError(f"near_share: expected {NEAR_SHARE}, got {manifest['morph']['near_share']}")
    growth = manifest["growth"]
    check.choice("growth", growth["first"], ("strength",))
    for name in ("speed", "reach"):
        check.positive(name, growth[name])
    check.at_least_zero("fade", growth["fade"])
    if "display" in manifest:
        for name in ("pixels_per_degree", "split_px"):
            if manifest["display"][name] is not None:
                check.positive(name, manifest["display"][name])
    files = manifest["files"]
    for name, entry in files.items():
        folder, _, file_name = name.partition("/")
        if folder != _store.FOLDER or file_name in ("", ".", "..") or not _FILE_NAME.fullmatch(file_name):
            raise ValueError(f"files: expected names below {_store.FOLDER}/, got {check.shortened(name)}")
        _check_file_entry(name, entry)
    _check_file_entry(_store.TILESET, manifest["tileset"])
    regions = check.items("regions", manifest["regions"], dict, "descriptions of regions")
    if not regions:
        raise ValueError("regions: expected at least one")
    for number, region in enumerate(regions):
        _check_region(region, number, len(regions))
        _check_rings(region, layout_of(manifest, region), files)
    check.choice("orientation", manifest["map"]["orientation"], (ORIENTATION,))
    if (dynamic := manifest["dynamic"]) is not None:
        check.integer("triangles", dynamic["triangles"], 0, MAX_COUNT)
        check.items("instances", dynamic["instances"], dict, "descriptions of instances")
        check.text("geometry", dynamic["geometry"])
        _check_geometry(dynamic, files)


def _check_region(region: dict[str, Any], number: int, count: int) -> None:
    check.vector("center", region["center"])
    check.at_least_zero("fold_margin", region["fold_margin"])
    check.texts("findings", region["findings"])
    numbers = check.items("neighbours", region["neighbours"], int, "numbers of regions")
    near = [check.integer("neighbours", value, 0, count - 1) for value in numbers]
    if near != sorted({*near} - {number}):
        raise ValueError(f"neighbours: expected ascending numbers of other regions, got {check.shortened(near)}")


def _check_rings(region: dict[str, Any], layout: Layout, files: dict[str, Any]) -> None:
    rings = check.items("rings", region["rings"], dict, "descriptions of rings")
    radii = [check.at_least_zero("radius", ring["radius"]) for ring in rings]
    if len(radii) < 2 or radii[0] != 0.0 or (np.diff(radii) <= 0).any():
        raise ValueError(f"rings: expected radii that ascend from 0, got {check.shortened(radii)}")
    for ring in rings:
        _check_counts(ring)
        _check_geometry(ring, files)
        for name in ("color", "range"):
            _check_listed_files(ring["map"].get(name), files, name)
    layout.check([ring["map"] for ring in rings])
    check.positive("error", region["range"]["error"])
    if region["by_footprint"] is not None:
        _check_by_footprint(region["by_footprint"], layout, files)


def _check_by_footprint(entry: dict[str, Any], layout: Layout, files: dict[str, Any]) -> None:
    for portion in check.items("portions", entry["portions"], dict, "descriptions of portions"):
        _check_counts(portion)
        _check_geometry(portion, files)
    color, ranges = (entry["map"][name] for name in ("color", "range"))
    # The colours are divided into files like those of ring 0, the ranges like those of a later ring.
    layout.check([{"color": color}, {"tiles": [], "color": None, "range": ranges}])
    _check_listed_files(color, files, "color")
    _check_listed_files(ranges, files, "range")


def _check_counts(entry: dict[str, Any]) -> None:
    for name in ("objects", "triangles", "stored"):
        check.integer(name, entry[name], 0, MAX_COUNT)


def _check_file_entry(name: str, entry: dict[str, Any]) -> None:
    check.integer(f"{name}: bytes", entry["bytes"], 0, 2**50)
    if not _HASH.fullmatch(check.text(f"{name}: sha256", entry["sha256"])):
        raise ValueError(f"{name}: sha256: expected 64 digits of 0-9a-f, got {check.shortened(entry['sha256'])}")


def _check_geometry(entry: dict[str, Any], files: dict[str, Any]) -> None:
    """Check the file names of a GLB: the GLB, its buffers and its images."""
    name = entry["geometry"]
    if not (name is None or isinstance(name, str)):
        raise TypeError(f"geometry: expected the name of a file, got {check.type_and_value(name)}")
    _check_listed_files(name, files, "geometry")
    _check_listed_files(check.texts("parts", entry["parts"]), files, "parts")
    if "error" in entry:
        check.at_least_zero("error", entry["error"])


def _check_listed_files(value: Any, files: dict[str, Any], kind: str) -> None:
    for name in names_of(value):
        if name not in files:
            raise ValueError(f"files: expected a file {check.shortened(name)}, which {kind} of the manifest needs")
