"""Settings of maps and geometry: the checked arguments of `export`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import SupportsFloat, SupportsIndex

from nearfar._base import check
from nearfar.stream._maps import MAX_SAMPLES, TILE

MAX_FACE_SIZE = 4096


@dataclass(frozen=True)
class Settings:
    """Settings that determine how maps and geometry become files."""

    face_size: int
    samples: int
    quality: int | None
    range_error: float
    step: float
    compressed: bool
    pixels_per_degree: float | None
    by_footprint: bool
    split_px: float | None

    @classmethod
    def validate(
        cls,
        face_size: SupportsIndex,
        samples: SupportsIndex,
        quality: SupportsIndex | None,
        range_error: SupportsFloat,
        step: SupportsFloat,
        compression: str | None,
        pixels_per_degree: SupportsFloat | None,
        by_footprint: bool,
        split_px: SupportsFloat | None = None,
    ) -> Settings:
        """Check the arguments; ValueError or TypeError for invalid ones."""
        size = check.integer("face_size", face_size, TILE, MAX_FACE_SIZE)
        if size % TILE:
            raise ValueError(f"face_size: expected a multiple of {TILE}, got {size}")
        if compression is not None:
            check.choice("compression", compression, ("meshopt",))
        return cls(
            face_size=size,
            samples=check.integer("samples", samples, 1, MAX_SAMPLES),
            quality=None if quality is None else check.integer("quality", quality, 0, 100),
            range_error=check.in_range("range_error", range_error, 1e-6, 0.1),
            step=check.in_range("step", step, 1e-6, 1.0),
            compressed=compression is not None,
            pixels_per_degree=(
                None
                if pixels_per_degree is None
                else check.in_range("pixels_per_degree", pixels_per_degree, 1.0, 500.0)
            ),
            by_footprint=check.flag("by_footprint", by_footprint),
            split_px=None if split_px is None else check.in_range("split_px", split_px, 1e-3, 1e3),
        )
