"""Reads points from a file of raw float64 triples; for each input line it prints the radius of their sphere."""

import sys

import cyminiball
import numpy as np

points = np.fromfile(sys.argv[1]).reshape(-1, 3)
for _ in sys.stdin:
    _, square = cyminiball.compute(points)
    print(repr(float(square) ** 0.5), flush=True)
