"""Levels of detail: how good a level looks over its size, as curves."""

from nearfar.lod._fit import Curve4PL, fit_4pl

__all__ = ["Curve4PL", "fit_4pl"]
