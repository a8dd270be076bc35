"""Features of a file: outlines, coordinate system and properties."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.city.outlines import Outlines


class Columns(Protocol):
    """Properties of all features."""

    def __call__(self, name: str) -> NDArray[np.float64] | None:
        """Numbers of a property (F,), NaN where missing; None if no feature has it."""

    def texts(self, name: str | None) -> list[str] | None:
        """Names by a property, or by the features' identifiers; None if any feature lacks one."""


@dataclass(frozen=True)
class Table:
    """Features of a file."""

    outlines: Outlines
    system: str
    """Name of the coordinate system."""
    degrees: bool
    """Whether its coordinates are longitudes and latitudes."""
    columns: Columns
    metres: float = 1.0
    """Metres per unit of projected coordinates."""
    skipped: int = 0
    """Number of geometries that are not polygons."""
    notes: tuple[str, ...] = ()
    format: str = "GeoJSON"
