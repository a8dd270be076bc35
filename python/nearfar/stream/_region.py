"""One region of a bundle: the rings about a centre and their maps, as files and as an entry of the manifest."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from nearfar.stream._assign import Rings
from nearfar.stream._by_footprint import Portions, encode_whole
from nearfar.stream._encode import Files, Geometry, Groups, Textures, encode_maps, scale_of
from nearfar.stream._manifest import NEAR_SHARE
from nearfar.stream._maps import bake_maps
from nearfar.stream._notes import findings_of
from nearfar.stream._settings import Settings


@dataclass(frozen=True)
class Writer:
    """Encodes regions; equal files are kept once."""

    settings: Settings
    textures: Textures
    files: Files = field(default_factory=Files)

    def geometry(self, groups: Groups) -> Geometry:
        """Return what encodes the objects of groups."""
        step, compressed = self.settings.step, self.settings.compressed
        return Geometry(groups, self.files, self.textures, step=step, compressed=compressed)

    def region(self, rings: Rings, shown: Rings, geometry: Geometry) -> dict[str, Any]:
        """Bake and encode the maps and the geometry of rings; the region's entry without its neighbours.

        `shown` has the rings as they are sent, and `geometry` encodes those.
        """
        settings = self.settings
        maps = bake_maps(rings, face_size=settings.face_size, samples=settings.samples)
        scale = scale_of(maps, settings.range_error)
        pictures = encode_maps(maps, self.files, quality=settings.quality, scale=scale)
        counts = dict.fromkeys(("objects", "triangles", "stored"), 0)
        listed = [{"radius": 0.0, **counts, "geometry": None, "parts": []}, *geometry.groups("ring")]
        by_footprint = None
        if settings.by_footprint:
            portions = self.geometry(Portions.of(rings, scene=shown.scene)).groups("portion")
            last = encode_whole(maps.map(rings.count), self.files, settings.quality, scale)
            by_footprint = {"portions": portions, "map": last}
        return {
            "center": list(rings.center),
            "fold_margin": NEAR_SHARE * rings.radii[-1],
            "findings": findings_of(rings),
            "range": {"least": scale.least, "step": scale.step, "error": scale.error},
            "rings": [{**ring, "map": picture} for ring, picture in zip(listed, pictures, strict=True)],
            "by_footprint": by_footprint,
        }
