"""Prints the JOD of pictures as JSON: python -m benchmarks.impostor.methods.jod PICTURES.npy PIXELS_PER_DEGREE."""

from __future__ import annotations

import json
import sys

import numpy as np

import nearfar as nf


def main() -> None:
    truth, *pictures = np.load(sys.argv[1])
    density = float(sys.argv[2])
    print(json.dumps([nf.metrics.jod(truth, one, data_range=255, pixels_per_degree=density) for one in pictures]))


if __name__ == "__main__":
    main()
