"""Levels of detail: making them, measuring how good they look over their size, and choosing them."""

from nearfar.lod._fit import Curve4PL, fit_4pl
from nearfar.lod._levels import Level, Levels
from nearfar.lod._model import LodModel
from nearfar.lod._select import select
from nearfar.lod._selection import Selection
from nearfar.lod._selector import Selector
from nearfar.lod._size import acuity, distortion, reference_solid_angle

__all__ = [
    "Curve4PL",
    "Level",
    "Levels",
    "LodModel",
    "Selection",
    "Selector",
    "acuity",
    "distortion",
    "fit_4pl",
    "reference_solid_angle",
    "select",
]
