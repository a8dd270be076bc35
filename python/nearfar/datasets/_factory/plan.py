"""The plan of the hall: its size, its grid of columns, its lanes, and the machines in its slots."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from nearfar.datasets._random import Floats

X, Z, EAVES, RIDGE = 80.0, 60.0, 12.0, 14.0
"""Half the length along x, half the width along z, the heights of the eaves and of the roof's ridges, metres."""
BAY = 10.0
"""Distance of trusses, wall posts and ridges, metres."""
COLUMNS_X = np.arange(-70.0, 71.0, 20.0)
COLUMNS_Z = np.arange(-50.0, 51.0, 20.0)
LANES_X = ((-77.0, 1.5), (-40.0, 2.0), (0.0, 2.4), (40.0, 2.0), (77.0, 1.5))
"""Lanes along z: their x and half their width, metres."""
LANES_Z = ((-40.0, 2.0), (-20.0, 2.0), (0.0, 2.4), (20.0, 2.0), (40.0, 2.0))
"""Lanes along x: their z and half their width, metres."""
BLOCKS = (-59.0, -19.0, 19.0, 59.0)
"""Middles along x of the blocks between the lanes, each with five slots."""
PITCH = 6.0
"""Distance of the slots of a block, metres."""
ASIDE = 3.8
"""Distance of a row of slots from its line of columns, metres."""

# Machines in the four blocks of each row: Lathes, Mills, Presses, Robots at a conveyor, Benches, Tanks, Compressors.
_ROWS = (
    (-53.8, "CTTC"), (-46.2, "TTTT"), (-33.8, "PRRL"), (-26.2, "MLMP"), (-13.8, "LRRB"), (-6.2, "BPML"),
    (6.2, "MLPM"), (13.8, "PRBR"), (26.2, "LMLM"), (33.8, "BPRB"),
)  # fmt: skip


@dataclass(frozen=True)
class Slot:
    """A place for one machine, whose front looks away from the line of columns behind it."""

    x: float
    z: float
    kind: str
    """Letter of the machine kind."""
    column: float
    """The z of the line of columns behind it."""

    @property
    def quarter(self) -> float:
        """Fraction of a full turn that makes +z the machine's front."""
        return 0.0 if self.z > self.column else 0.5


def slots() -> list[Slot]:
    """List all slots, row by row."""
    listed = []
    for z, letters in _ROWS:
        column = z - ASIDE if (z - ASIDE) % 20.0 == 10.0 else z + ASIDE
        for middle, letter in zip(BLOCKS, letters, strict=True):
            listed += [Slot(middle + PITCH * (k - 2), z, letter, column) for k in range(5)]
    return listed


def grid(x: ArrayLike, z: ArrayLike, indexing: Literal["xy", "ij"] = "xy") -> tuple[Floats, Floats]:
    """All pairs of an x and a z, as two arrays (K,); x changes fastest unless `indexing` is "ij"."""
    columns, rows = np.meshgrid(np.asarray(x, float), np.asarray(z, float), indexing=indexing)
    return columns.ravel(), rows.ravel()


def breaks(limit: float, lanes: tuple[tuple[float, float], ...], line: float) -> Floats:
    """Positions across the lanes where the floor changes, with the painted lines of width `line` beside the lanes."""
    ends = [middle + side * (half + more) for middle, half in lanes for side in (-1.0, 1.0) for more in (0.0, line)]
    return np.array(sorted({-limit, limit, *ends, *np.arange(-limit + 5.0, limit, 10.0).tolist()}))
