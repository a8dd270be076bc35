"""The street with a car, reduced with either morph, for users whose morph grows."""

from __future__ import annotations

from typing import Any

import numpy as np

import nearfar as nf
from nearfar._reduce.drawing import MorphKind
from tests.support.reduce_cases import CENTER, R1, R2, place, street

USER = CENTER + np.array([5.0, 0.3, 4.0])
AHEAD = (0.6, -0.15, -1.0)
CAR = {"car": place(12.0, 0.75, -16.0)}
"""Between r1 and r2 of the whole reduction, beyond the smaller radii."""
KINDS = ("blend", "cylinder")


def reduced(kind: MorphKind, radius: float = R2, **settings: Any) -> nf.ReducedScene:
    """The street, reduced to this radius and r1 in proportion."""
    scene = street(dynamic=True).at(CAR)
    share = radius / R2
    return nf.reduce(
        scene,
        center=CENTER,
        r1=R1 * share,
        r2=radius,
        face_size=64,
        morph=kind,
        channels=("color", "range"),
        **settings,
    )
