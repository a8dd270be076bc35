"""CloVR (2024): rings of near geometry about a centre, each with a map of the scene beyond it, as files.

Arguments out of range raise ValueError, arguments of another type TypeError; both name the argument.
"""

from __future__ import annotations

from nearfar._render.frame import blend
from nearfar.stream import client, collect
from nearfar.stream._assign import Rings, assign
from nearfar.stream._bundle import Bundle, open  # noqa: A004
from nearfar.stream._by_footprint import footprints
from nearfar.stream._growth import Growth
from nearfar.stream._link import Link
from nearfar.stream._maps import RingMaps, bake_maps
from nearfar.stream._radii import ring_radii
from nearfar.stream._regions import snap
from nearfar.stream._settings import ExportSettings
from nearfar.stream._simulate import radius_for, simulate
from nearfar.stream._stages import export
from nearfar.stream._strategies import ClientSettings
from nearfar.stream._timeline import Timeline

__all__ = [
    "Bundle",
    "ClientSettings",
    "ExportSettings",
    "Growth",
    "Link",
    "RingMaps",
    "Rings",
    "Timeline",
    "assign",
    "bake_maps",
    "blend",
    "client",
    "collect",
    "export",
    "footprints",
    "open",
    "radius_for",
    "ring_radii",
    "simulate",
    "snap",
]
