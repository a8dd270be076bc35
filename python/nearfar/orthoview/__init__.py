"""Worlds of any size as an octree of orthographic depth images (Chaudhuri et al.)."""

from __future__ import annotations

from nearfar.orthoview._build import build
from nearfar.orthoview._choose_cell import CellChoice, choose_cell
from nearfar.orthoview._cut import OrthoCut
from nearfar.orthoview._flight import Flight
from nearfar.orthoview._prefetch import PrefetchQueue
from nearfar.orthoview._settings import FlightSettings, ViewSettings, size_for
from nearfar.orthoview._simulate import FlightLog, simulate
from nearfar.orthoview._steady import Steady, motion_blur
from nearfar.orthoview._tree import OrthoTree, open  # noqa: A004 - a public name

__all__ = [
    "CellChoice",
    "Flight",
    "FlightLog",
    "FlightSettings",
    "OrthoCut",
    "OrthoTree",
    "PrefetchQueue",
    "Steady",
    "ViewSettings",
    "build",
    "choose_cell",
    "motion_blur",
    "open",
    "simulate",
    "size_for",
]
