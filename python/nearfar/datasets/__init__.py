"""Procedural scenes, from thousands to tens of millions of triangles, and the look-up of data files."""

from nearfar._base.data import find
from nearfar.datasets._city import city, street_view
from nearfar.datasets._forest import forest
from nearfar.datasets._room import room, room_view
from nearfar.datasets._study import SphereTask, TapeTask, sphere_task, tape_task

__all__ = [
    "SphereTask",
    "TapeTask",
    "city",
    "find",
    "forest",
    "room",
    "room_view",
    "sphere_task",
    "street_view",
    "tape_task",
]
