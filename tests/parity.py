"""How far pictures of two back ends may be apart: by rounding at edges, and by nothing else."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf


def edges(ids: NDArray[Any]) -> NDArray[np.bool_]:
    """Pixels with another number among their eight neighbours: an edge is within a pixel of them."""
    height, width = ids.shape
    padded = np.pad(ids, 1, mode="edge")
    shifted = [padded[y : y + height, x : x + width] for y in range(3) for x in range(3)]
    return np.asarray(np.any([neighbour != ids for neighbour in shifted], axis=0))


def codes_apart(reference: nf.Frame, test: nf.Frame) -> NDArray[np.int64]:
    """Greatest difference of a pixel's three sRGB codes."""
    return np.asarray(np.abs(reference.to_image().astype(int) - test.to_image().astype(int)).max(axis=-1))


def check_ids(reference: NDArray[Any], test: NDArray[Any], share: float = 0.999) -> None:
    """Numbers are equal but for a share of pixels, and every other one lies at an edge of one of the pictures."""
    differ = reference != test
    assert differ.mean() <= 1 - share, f"{differ.sum()} of {differ.size} differ"
    assert not (differ & ~edges(reference) & ~edges(test)).any()


def check_range(reference: nf.Frame, test: nf.Frame, *, tolerance: float = 1e-5, worst: float = 1e-4) -> None:
    """Where both show one face, all but a thousandth show it as far away, relative to the distance, and none is off.

    The exceptions are large faces seen at a slant and slivers, where float32 has no more digits on either back end.
    """
    same = (reference.face_id == test.face_id) & (reference.require("face_id") >= 0)
    expected, got = reference.require("range")[same], test.require("range")[same]
    apart = np.abs(got - expected) / expected
    if apart.size:
        assert np.percentile(apart, 99.9) <= tolerance
        assert apart.max() <= worst, f"{apart.max()} at {np.argmax(apart)} of {apart.size}"


def check_color(reference: nf.Frame, test: nf.Frame, codes: int = 2, percentile: float = 99.9) -> None:
    """All but a share of pixels have colours that nobody tells apart."""
    assert np.percentile(codes_apart(reference, test), percentile) <= codes
