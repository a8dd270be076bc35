"""Levels of detail: simplification, measurement of their quality over size, and selection."""

from nearfar.lod._export import export
from nearfar.lod._levels import Level, Levels
from nearfar.lod._measure.fit import Curve4PL, fit_4pl
from nearfar.lod._measure.measure import measure
from nearfar.lod._measure.settings import MeasureSettings
from nearfar.lod._measure.statistic import Samples
from nearfar.lod._model import LodModel
from nearfar.lod._place import place
from nearfar.lod._select.rules import LodRules
from nearfar.lod._select.select import Selector, select
from nearfar.lod._select.selection import Selection, Spent
from nearfar.lod._select.size import acuity, distortion, panel_magnification, reference_solid_angle
from nearfar.lod._select.switches import Switches, switches
from nearfar.lod._select.threshold import LodThreshold
from nearfar.lod._simplify.simplify import simplify

__all__ = [
    "Curve4PL",
    "Level",
    "Levels",
    "LodModel",
    "LodRules",
    "LodThreshold",
    "MeasureSettings",
    "Samples",
    "Selection",
    "Selector",
    "Spent",
    "Switches",
    "acuity",
    "distortion",
    "export",
    "fit_4pl",
    "measure",
    "panel_magnification",
    "place",
    "reference_solid_angle",
    "select",
    "simplify",
    "switches",
]
