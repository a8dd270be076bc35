"""Strategies for eyes of headsets."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from hypothesis import strategies as st

import nearfar as nf


def quaternion(axis: Any, degrees: float) -> tuple[float, float, float, float]:
    direction = np.array(axis, float) / np.linalg.norm(axis)
    half = math.radians(degrees) / 2
    x, y, z = (float(v) for v in direction * math.sin(half))
    return x, y, z, math.cos(half)


tangents = st.floats(0.3, 1.8)
fovs = st.builds(lambda a, b, c, d: nf.Fov(-a, b, -c, d), tangents, tangents, tangents, tangents)
axes = st.tuples(st.floats(-1, 1), st.floats(-1, 1), st.floats(0.1, 1))
turns = st.builds(quaternion, axes, st.floats(-14, 14))
places = st.tuples(st.floats(-0.1, 0.1), st.floats(-0.02, 0.02), st.floats(-0.02, 0.02))
eyes = st.builds(nf.hmd.Eye, fovs, places, turns)
