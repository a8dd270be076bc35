"""CloVR (2024): rings of near geometry about a centre, each with the map of what lies beyond it."""

from __future__ import annotations

from nearfar.stream._assign import Rings, assign
from nearfar.stream._footprints import footprints
from nearfar.stream._maps import RingMaps, bake_maps
from nearfar.stream._radii import rings

__all__ = ["RingMaps", "Rings", "assign", "bake_maps", "footprints", "rings"]
