"""Hybrid mono-stereo rendering: near geometry for each eye, one shared picture beyond a plane (Fink et al. 2019)."""

from __future__ import annotations

from nearfar.stereo._layer import QuadLayer
from nearfar.stereo._plane import AdaptivePlane, mono_plane_for
from nearfar.stereo._rig import HybridRig
from nearfar.stereo._settings import HybridSettings
from nearfar.stereo._temporal import TemporalAntialiasing
from nearfar.stereo._view_vectors import view_vector_shader

__all__ = [
    "AdaptivePlane",
    "HybridRig",
    "HybridSettings",
    "QuadLayer",
    "TemporalAntialiasing",
    "mono_plane_for",
    "view_vector_shader",
]
