"""Thresholds of `nearfar compare` for measures of the continuous picture."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Annotated, Any

from nearfar._base import check
from nearfar.cli._groups import Options
from nearfar.cli._options import option

BROKEN = 3
"""Exit status of a comparison with an unmet or unchecked threshold; 1 is an error, 2 a wrong command line."""

OPTIONS = {
    "--min-psnr": ("psnr", True),
    "--min-ssim": ("ssim", True),
    "--max-tear": ("tear", False),
    "--max-discontinuity": ("discontinuity", False),
    "--max-boundary-discontinuity": ("boundary", False),
}
"""Measure of each option, and whether the limit is a lower bound."""

UNMEASURED = {
    "tear": "no pixel of the picture has neighbours on both sides of the boundary at r2",
    "discontinuity": "no pixel of the picture has a surface with neighbours",
    "boundary": "the boundary at r2 is not in view",
}
"""Reasons why a measure is missing."""


@dataclass(frozen=True)
class Threshold:
    """Threshold for a measure of the continuous picture."""

    option: str
    limit: float

    def check(self, values: dict[str, Any]) -> dict[str, Any]:
        """Compare a value with the limit; a missing measure does not meet it.

        Only PSNR may be None and meet it: it is infinite for equal pictures.
        """
        measure, least = OPTIONS[self.option]
        value = values[measure]
        kept = measure == "psnr" if value is None else bool(value >= self.limit if least else value <= self.limit)
        return {
            "option": self.option,
            "measure": measure,
            "limit": self.limit,
            "value": value,
            "measured": value is not None or measure == "psnr",
            "kept": kept,
        }


@dataclass(frozen=True, kw_only=True)
class LimitOptions(Options):
    """Limits of the measures."""

    min_psnr: Annotated[float | None, option("--min-psnr", "DB", "Least PSNR in decibels; exit status 3 below it.")] = (
        None
    )
    min_ssim: Annotated[float | None, option("--min-ssim", "VALUE", "Least SSIM; exit status 3 below it.")] = None
    max_tear: Annotated[
        float | None, option("--max-tear", "PIXELS", "Greatest mean tear along the boundary; exit status 3 above it.")
    ] = None
    max_discontinuity: Annotated[
        float | None, option("--max-discontinuity", "VALUE", "Greatest mean discontinuity; exit status 3 above it.")
    ] = None
    max_boundary_discontinuity: Annotated[
        float | None,
        option(
            "--max-boundary-discontinuity",
            "VALUE",
            "Greatest mean discontinuity along the boundary; exit status 3 above it.",
        ),
    ] = None

    @cached_property
    def thresholds(self) -> list[Threshold]:
        """The given limits."""
        limits = {f"--{field.name.replace('_', '-')}": getattr(self, field.name) for field in fields(self)}
        return [Threshold(name, check.number(name, limit)) for name, limit in limits.items() if limit is not None]


def sentence(checked: dict[str, Any]) -> str:
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
