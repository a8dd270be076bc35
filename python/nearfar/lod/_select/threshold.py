"""The least sufficient score of a level, as a function of the object's solid angle."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal, SupportsFloat, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._base.settings import set_fields

Kind = Literal["anchored", "literal", "normalized", "constant"]

STUDY_SOLID_ANGLE = 0.209
"""Mean σ₁/₁₆ of the two headsets in Liebisch's study, steradians (Table 5.9): Rift S 0.179 and Vive Pro 0.238."""


@dataclass(frozen=True)
class LodThreshold:
    """SSIM threshold f(σ) as a function of solid angle: a level is good enough where its score is at least f(σ).

    σ is in steradians, and σ₁/₁₆ is `reference_solid_angle`. The defaults are the means of a study with 24 people, who
    wore a Rift S (σ₁/₁₆ = 0.179, d = 0.905, k = 0.268) and a Vive Pro (0.238, 0.897, 0.279). ValueError and TypeError
    for invalid numbers or kinds. Source: Liebisch (2021), Sec. 3.1.4.1, Eq. 3.1, which prints y = kx + d without a
    definition of x, and Table 5.9.

    Parameters
    ----------
    k
        Slope of the threshold with size: SSIM per steradian, for "normalized" per σ₁/₁₆. With a negative slope, objects
        may get finer levels as they shrink.
    d
        SSIM at `anchor`, for "literal" at σ = 0, for "normalized" at σ₁/₁₆, for "constant" at all sizes.
    kind
        Form of f: "anchored" is d + k (σ − anchor). With it d is the score that viewers accepted at 1/16 of the study's
        screens, and an object needs the same score in every headset. "literal" is kσ + d, "normalized" is
        d + k (σ/σ₁/₁₆ − 1). "constant" is d without k, also above σ₁/₁₆, where the other kinds allow only level 0.
    anchor
        Solid angle at which "anchored" equals d, steradians, above 0: the study's mean σ₁/₁₆ by default. The other
        kinds ignore it.
    """

    k: float = 0.27
    d: float = 0.90
    kind: Kind = "anchored"
    anchor: float = STUDY_SOLID_ANGLE

    def __post_init__(self) -> None:
        anchor = check.positive("anchor", self.anchor)
        set_fields(self, k=check.number("k", self.k), d=check.number("d", self.d), anchor=anchor)
        check.choice("kind", self.kind, get_args(Kind))

    def line(self, reference: float) -> tuple[float, float]:
        """Return f as a line: its score at σ = 0, and its slope in SSIM per steradian.

        `reference` is σ₁/₁₆ of the view in steradians, which only "normalized" depends on.
        """
        reference = check.positive("reference", reference)
        match self.kind:
            case "anchored":
                return self.d - self.k * self.anchor, self.k
            case "literal":
                return self.d, self.k
            case "constant":
                return self.d, 0.0
            case _:
                return self.d - self.k, self.k / reference

    def limit(self, reference: float) -> float:
        """Return the greatest solid angle of levels other than 0, steradians: `reference`, or 4π for "constant"."""
        reference = check.positive("reference", reference)
        return 4 * math.pi if self.kind == "constant" else reference

    def __call__(self, sigma: ArrayLike, reference: float) -> NDArray[np.float64]:
        """Return f(σ) for solid angles of any shape; both in steradians."""
        start, slope = self.line(reference)
        return np.asarray(start + slope * check.array("sigma", sigma, columns=None, dtype=np.float64))


def threshold_of(
    threshold: LodThreshold | Kind | None,
    k: SupportsFloat | None,
    d: SupportsFloat | None,
    quality: SupportsFloat | None = None,
) -> LodThreshold:
    """Convert keywords to a threshold: a `LodThreshold` as it is, the name of a kind with k and d, or a quality."""
    if quality is not None:
        for name, value in (("threshold", threshold), ("k", k), ("d", d)):
            if value is not None:
                raise ValueError(f"{name}: expected None beside a quality, got {check.value_or_type(value)}")
        return LodThreshold(0.0, check.in_range("quality", quality, 0.0, 1.0), "constant")
    if isinstance(threshold, LodThreshold):
        for name, value in (("k", k), ("d", d)):
            if value is not None:
                raise ValueError(
                    f"{name}: expected None beside a LodThreshold, which has its own, got {check.value_or_type(value)}"
                )
        return threshold
    kind = None if threshold is None else check.choice("threshold", threshold, get_args(Kind))
    fields: dict[str, Any] = {"k": k, "d": d, "kind": kind}
    return LodThreshold(**{name: value for name, value in fields.items() if value is not None})
