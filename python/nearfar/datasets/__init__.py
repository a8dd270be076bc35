"""Procedural scenes, from thousands to tens of millions of triangles, and access to data files.

The same arguments give the same bytes on every run and every platform.
"""

from nearfar._base.data import find
from nearfar.datasets._asteroids import Asteroids, asteroids
from nearfar.datasets._city import city, street_view
from nearfar.datasets._factory.hall import factory, factory_view
from nearfar.datasets._forest import forest
from nearfar.datasets._room import room, room_view
from nearfar.datasets._stereo_scenes import beams, landscape, spheres
from nearfar.datasets._study.ball import SphereTask, sphere_task
from nearfar.datasets._study.count import CountTask, count_task
from nearfar.datasets._study.tape import TapeTask, tape_task
from nearfar.datasets._world.source import World, world

__all__ = [
    "Asteroids",
    "CountTask",
    "SphereTask",
    "TapeTask",
    "World",
    "asteroids",
    "beams",
    "city",
    "count_task",
    "factory",
    "factory_view",
    "find",
    "forest",
    "landscape",
    "room",
    "room_view",
    "sphere_task",
    "spheres",
    "street_view",
    "tape_task",
    "world",
]
