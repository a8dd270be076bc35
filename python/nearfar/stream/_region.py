"""One region of a bundle: the rings about a centre and their maps, as files and as an entry of the manifest."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, SupportsFloat, SupportsIndex

from nearfar._base import check
from nearfar.stream._assign import Rings
from nearfar.stream._encode import Files, Geometry, encode_maps, scale_of
from nearfar.stream._manifest import NEAR_SHARE
from nearfar.stream._maps import MOST_SAMPLES, TILE, bake_maps
from nearfar.stream._notes import findings_of

MOST_FACE_SIZE = 4096


@dataclass(frozen=True)
class Settings:
    """How maps and geometry become files; the arguments of `export`, checked."""

    face_size: int
    samples: int
    quality: int | None
    range_error: float
    step: float
    compressed: bool
    pixels_per_degree: float | None

    @classmethod
    def checked(
        cls,
        face_size: SupportsIndex,
        samples: SupportsIndex,
        quality: SupportsIndex | None,
        range_error: SupportsFloat,
        step: SupportsFloat,
        compression: str | None,
        pixels_per_degree: SupportsFloat | None,
    ) -> Settings:
        """Check them; ValueError or TypeError for settings that cannot be."""
        size = check.integer("face_size", face_size, TILE, MOST_FACE_SIZE)
        if size % TILE:
            raise ValueError(f"face_size: expected a multiple of {TILE}, got {size}")
        if compression is not None:
            check.choice("compression", compression, ("meshopt",))
        return cls(
            face_size=size,
            samples=check.integer("samples", samples, 1, MOST_SAMPLES),
            quality=None if quality is None else check.integer("quality", quality, 0, 100),
            range_error=check.within("range_error", range_error, 1e-6, 0.1),
            step=check.within("step", step, 1e-6, 1.0),
            compressed=compression is not None,
            pixels_per_degree=(
                None if pixels_per_degree is None else check.within("pixels_per_degree", pixels_per_degree, 1.0, 500.0)
            ),
        )


def encode_region(rings: Rings, files: Files, settings: Settings, geometry: Geometry) -> dict[str, Any]:
    """Bake and encode the maps and the geometry of rings; the region's entry without its neighbours."""
    maps = bake_maps(rings, face_size=settings.face_size, samples=settings.samples)
    scale = scale_of(maps, settings.range_error)
    pictures = encode_maps(maps, files, quality=settings.quality, scale=scale)
    nothing: dict[str, Any] = {"radius": 0.0, "objects": 0, "triangles": 0, "stored": 0, "geometry": None, "parts": []}
    listed = [nothing, *geometry.rings()]
    return {
        "center": list(rings.center),
        "fold_margin": NEAR_SHARE * rings.radii[-1],
        "findings": findings_of(rings),
        "range": {"least": scale.least, "step": scale.step, "error": scale.error},
        "rings": [{**ring, "map": picture} for ring, picture in zip(listed, pictures, strict=True)],
    }
