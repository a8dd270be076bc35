"""Coordinate reference systems stated by files: degrees, or metres of a projection."""

from __future__ import annotations

import re
from typing import Any

from nearfar._scene.coordinates import is_number

_EPSG = re.compile(r"EPSG(?::|/)+(?:[0-9.]*(?::|/))?([0-9]{4,6})", re.IGNORECASE)

_GEOGRAPHIC = {
    *(4167, 4171, 4230, 4258, 4269, 4283, 4326, 4490, 4612),
    *(4619, 4674, 4937, 4979, 6318, 6319, 6668, 6697, 7844),
}
"""EPSG codes of systems in degrees that city files name; all are within a few metres of WGS84, 4230 within 200 m."""


def epsg(name: str) -> int | None:
    """EPSG code in a name such as "urn:ogc:def:crs:EPSG::7415" or ".../def/crs/EPSG/0/28992"; None without one."""
    match = _EPSG.search(name)
    return int(match[1]) if match else None


def is_degrees(name: str) -> bool:
    """Whether a coordinate system's name means longitude and latitude."""
    return "CRS84" in name.upper() or epsg(name) in _GEOGRAPHIC


def of_projjson(crs: Any) -> tuple[str, bool, float]:
    """Name of a coordinate system in PROJJSON, whether it is in degrees, and metres per unit."""
    if not isinstance(crs, dict):
        return "unknown", False, 1.0
    if crs.get("type") == "BoundCRS":
        return of_projjson(crs.get("source_crs"))
    components = crs.get("components")
    if isinstance(components, list) and components:
        return of_projjson(components[0])
    identity = crs.get("id")
    code = f"{identity.get('authority')}:{identity.get('code')}" if isinstance(identity, dict) else ""
    name = " ".join(filter(None, [code, str(crs.get("name", ""))])) or "unknown"
    return name, str(crs.get("type", "")).startswith("Geographic"), _metres(crs.get("coordinate_system"))


def _metres(system: Any) -> float:
    axes = system.get("axis") if isinstance(system, dict) else None
    unit = axes[0].get("unit") if isinstance(axes, list) and axes and isinstance(axes[0], dict) else None
    factor = unit.get("conversion_factor") if isinstance(unit, dict) else None
    return float(factor) if is_number(factor) and 0 < factor < 1e6 else 1.0
