"""The manifest of a bundle: its format, and checks of one that was read."""

from __future__ import annotations

from typing import Any

import numpy as np

from nearfar._base import check, formats
from nearfar.stream import _store
from nearfar.stream._decode import Layout

NAME, VERSION = "bundle", 1
"""Name of the manifest's format without "nearfar.", and its version."""

NEAR_SHARE = 0.7
"""Part of a ring's radius inside which nothing is morphed, as CloVR (2024) chose it."""


def read(reader: _store.Reader) -> dict[str, Any]:
    """Read the manifest of a bundle and check it; FormatError that names it if it is damaged or newer."""
    where = f"{reader.place}/{_store.MANIFEST}"
    data = reader.read(_store.MANIFEST)
    with formats.guarded(where):
        document = formats.from_json(data)
    manifest = formats.check(document, NAME, VERSION, where)
    with formats.guarded(where):
        _check(manifest)
    return manifest


def names_of(value: Any) -> list[str]:
    """Names of the files of an entry: one, several or none."""
    if value is None:
        return []
    return [value] if isinstance(value, str) else list(value)


def layout_of(manifest: dict[str, Any], region: dict[str, Any]) -> Layout:
    """How the maps of a region are divided into files; ValueError for values that cannot be."""
    return Layout.of({**manifest["map"], "range": region["range"]})


def _check(manifest: dict[str, Any]) -> None:
    """Raise one of the errors of damage for a manifest that cannot be used."""
    check.integer("triangles", manifest["triangles"], 0, 2**62)
    check.texts("notes", manifest["notes"])
    files = manifest["files"]
    for name, entry in files.items():
        check.integer(f"{name}: bytes", entry["bytes"], 0, 2**50)
        check.text(f"{name}: sha256", entry["sha256"])
        if not name.startswith(f"{_store.FOLDER}/") or ".." in name or "\\" in name:
            raise ValueError(f"files: expected names below {_store.FOLDER}/, got {check.shortened(name)}")
    regions = check.items("regions", manifest["regions"], dict, "descriptions of regions")
    if not regions:
        raise ValueError("regions: expected at least one")
    for number, region in enumerate(regions):
        check.vector("center", region["center"])
        check.at_least_zero("fold_margin", region["fold_margin"])
        check.texts("findings", region["findings"])
        near = [check.integer("neighbours", value, 0, len(regions) - 1) for value in region["neighbours"]]
        if near != sorted({*near} - {number}):
            raise ValueError(f"neighbours: expected ascending numbers of other regions, got {check.shortened(near)}")
        _check_rings(region, layout_of(manifest, region), files)
    dynamic = manifest["dynamic"]
    if dynamic is not None and dynamic["geometry"] not in files:
        raise ValueError("files: expected the file of dynamic objects")


def _check_rings(region: dict[str, Any], layout: Layout, files: dict[str, Any]) -> None:
    """Raise one of the errors of damage for a region whose rings cannot be used."""
    rings = check.items("rings", region["rings"], dict, "descriptions of rings")
    radii = [check.at_least_zero("radius", ring["radius"]) for ring in rings]
    if len(radii) < 2 or radii[0] != 0.0 or (np.diff(radii) <= 0).any():
        raise ValueError(f"rings: expected radii that ascend from 0, got {check.shortened(radii)}")
    for ring in rings:
        for name in ("objects", "triangles"):
            check.integer(name, ring[name], 0, 2**62)
        parts = check.texts("parts", ring["parts"])
        for value in (ring["geometry"], parts, ring["map"].get("color"), ring["map"].get("range")):
            for name in names_of(value):
                if name not in files:
                    raise ValueError(f"files: expected a file {check.shortened(name)}, which a ring needs")
    layout.check([ring["map"] for ring in rings])
