"""Levels of detail: making them, measuring how good they look over their size, and choosing them."""

from nearfar.lod._fit import Curve4PL, fit_4pl
from nearfar.lod._levels import Level, Levels
from nearfar.lod._model import LodModel
from nearfar.lod._simplify import simplify

__all__ = ["Curve4PL", "Level", "Levels", "LodModel", "fit_4pl", "simplify"]
