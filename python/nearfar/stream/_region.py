"""Regions of a bundle: the rings about a centre and their maps, as files and as manifest entries."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

from nearfar._base import formats
from nearfar._scene.scene import Scene
from nearfar.stream._assign import Rings
from nearfar.stream._by_footprint import Portions, encode_whole
from nearfar.stream._encode import ACROSS, Files, Geometry, Groups, Textures, encode_maps, scale_of
from nearfar.stream._growth import Growth
from nearfar.stream._manifest import NAME, NEAR_SHARE, ORIENTATION, VERSION
from nearfar.stream._map_files import RangeScale
from nearfar.stream._maps import TILE, RingMaps, bake_maps
from nearfar.stream._notes import findings_of
from nearfar.stream._settings import Settings

NOTHING: dict[str, Any] = {"radius": 0.0, "objects": 0, "triangles": 0, "stored": 0, "geometry": None, "parts": []}
"""Manifest entry of ring 0, which has no geometry."""


@dataclass(frozen=True)
class Baked:
    """Maps of a region, and the scale of their ranges."""

    maps: RingMaps
    scale: RangeScale

    def head(self, findings: list[str]) -> dict[str, Any]:
        """Return a region's entry without its rings."""
        rings = self.maps.rings
        return {
            "center": list(rings.center),
            "fold_margin": NEAR_SHARE * rings.radii[-1],
            "findings": findings,
            "range": {"least": self.scale.least, "step": self.scale.step, "error": self.scale.error},
        }


@dataclass(frozen=True)
class Writer:
    """Encodes regions; equal files are stored once."""

    settings: Settings
    textures: Textures
    files: Files = field(default_factory=Files)

    def geometry(self, groups: Groups) -> Geometry:
        """Return the encoder of a group's objects."""
        step, compressed = self.settings.step, self.settings.compressed
        return Geometry(groups, self.files, self.textures, step=step, compressed=compressed)

    def bake(self, rings: Rings) -> Baked:
        """Bake the maps of rings."""
        maps = bake_maps(rings, face_size=self.settings.face_size, samples=self.settings.samples)
        return Baked(maps, scale_of(maps, self.settings.range_error))

    def rings(self, baked: Baked, near: Iterable[dict[str, Any]]) -> Iterator[dict[str, Any]]:
        """Encode the rings in order, from ring 0 on; `near` has the geometry entries of rings 1 to n."""
        pictures = encode_maps(baked.maps, self.files, quality=self.settings.quality, scale=baked.scale)
        yield {**NOTHING, "map": next(pictures)}
        for ring, picture in zip(near, pictures, strict=True):
            yield {**ring, "map": picture}

    def region(self, rings: Rings, shown: Rings, geometry: Geometry) -> dict[str, Any]:
        """Bake and encode the maps and the geometry of rings; return the region's entry without its neighbours.

        `shown` has the rings at the levels that are sent, and `geometry` encodes them.
        """
        baked = self.bake(rings)
        listed = list(self.rings(baked, geometry.groups("ring")))
        by_footprint = None
        if self.settings.by_footprint:
            portions = list(self.geometry(Portions.from_rings(rings, scene=shown.scene)).groups("portion"))
            last = encode_whole(baked.maps.map(rings.count), self.files, self.settings.quality, baked.scale)
            by_footprint = {"portions": portions, "map": last}
        return {**baked.head(findings_of(rings)), "rings": listed, "by_footprint": by_footprint}


def manifest_of(scene: Scene, settings: Settings, *, growth: Growth, files: Files, **parts: Any) -> dict[str, Any]:
    """Return the manifest of a bundle."""
    return formats.header(
        NAME,
        VERSION,
        color_space="sRGB",
        morph={"kind": "cylinder", "near_share": NEAR_SHARE},
        growth=growth.to_manifest(),
        triangles=scene.triangle_count,
        bounds=scene.bounds.tolist(),
        display={"pixels_per_degree": settings.pixels_per_degree, "split_px": settings.split_px},
        map={"face_size": settings.face_size, "orientation": ORIENTATION, "tile": TILE, "across": ACROSS},
        **parts,
        notes=list(scene._notes),
        files=files.file_entries(),
    )
