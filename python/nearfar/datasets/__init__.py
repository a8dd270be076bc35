"""Procedural scenes: deterministic, from thousands to tens of millions of triangles."""

from nearfar.datasets._city import city, street_view
from nearfar.datasets._forest import forest
from nearfar.datasets._room import room, room_view

__all__ = ["city", "forest", "room", "room_view", "street_view"]
