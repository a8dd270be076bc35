"""Thresholds of `nearfar compare` for measures of the continuous picture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from nearfar._base import check
from nearfar.cli._groups import Options, option

BROKEN = 3
"""Exit status of a comparison with a threshold that is not met or not measured; 1: error, 2: wrong command line."""

MEASURES = {
    "min_psnr": "psnr",
    "min_ssim": "ssim",
    "max_tear": "tear",
    "max_discontinuity": "discontinuity",
    "max_boundary_discontinuity": "boundary",
}
"""Measure of each limit."""

_NO_BOUNDARY = "no pixel of the picture has neighbours on both sides of the boundary at r2"
_NO_SURFACE = "no pixel of the picture has a surface with neighbours"
UNMEASURED = {
    "tear": _NO_BOUNDARY,
    "tear_kink": _NO_BOUNDARY,
    "boundary": _NO_BOUNDARY,
    "discontinuity": _NO_SURFACE,
    "discontinuity_p99": _NO_SURFACE,
    "flip": 'the package flip-evaluator is not installed: pip install "nearfar[flip]"',
}
"""Reasons why a measure is missing."""

UNMEASURED_IMPOSTORS = (
    "tear and discontinuity compare the true places of surfaces in neighbouring pixels, and a pixel of impostors only "
    "knows the place of its quad"
)
"""Reason why a measure of `UNMEASURED` other than FLIP is missing for impostors."""


@dataclass(frozen=True, kw_only=True)
class LimitOptions(Options):
    """Limits of the measures of the continuous picture."""

    min_psnr: float | None = option(None, "DB", "Least PSNR in decibels; exit status 3 below it.")
    min_ssim: float | None = option(None, "VALUE", "Least SSIM; exit status 3 below it.")
    max_tear: float | None = option(None, "PIXELS", "Greatest mean tear along the boundary; exit status 3 above it.")
    max_discontinuity: float | None = option(None, "VALUE", "Greatest mean discontinuity; exit status 3 above it.")
    max_boundary_discontinuity: float | None = option(
        None, "VALUE", "Greatest mean discontinuity along the boundary; exit status 3 above it."
    )

    def __post_init__(self) -> None:
        for name in self.given_options():
            limit = getattr(self, name)
            match name:
                case "min_psnr":
                    check.number(name, limit)
                case "min_ssim":
                    check.in_range(name, limit, -1.0, 1.0)
                case _:
                    check.at_least_zero(name, limit)

    def results(self, values: dict[str, Any]) -> list[dict[str, Any]]:
        """Compare measures with the given limits; a missing measure does not meet its limit.

        PSNR is the exception: None stands for the infinite PSNR of equal pictures, which meets every limit.
        """
        results = []
        for name in self.given_options():
            measure, limit = MEASURES[name], getattr(self, name)
            value = values[measure]
            is_measured = value is not None or measure == "psnr"
            is_met = is_measured
            if value is not None:
                is_met = bool(value >= limit if name.startswith("min") else value <= limit)
            option_and_measure = {"option": f"--{name.replace('_', '-')}", "measure": measure, "limit": limit}
            results.append(option_and_measure | {"value": value, "measured": is_measured, "kept": is_met})
        return results


def describe_failure(checked: dict[str, Any]) -> str:
    """Describe how a threshold was not met."""
    if not checked["measured"]:
        reason = UNMEASURED.get(checked["measure"], "the picture has none")
        return f"{checked['option']}: {checked['measure']} was not measured, because {reason}"
    return f"{checked['option']}: {checked['measure']} is {checked['value']:.4g}, the limit {checked['limit']:.4g}"


def result(checked: dict[str, Any]) -> str:
    """Return in a word or two whether a threshold was met."""
    if not checked["measured"]:
        return "not measured"
    return "met" if checked["kept"] else "not met"
