"""Bytes and loading times of the same near geometry with instances, and with each copy as a separate mesh."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import best
from benchmarks.stream._near import Near, Place, one_scene
from nearfar import _core
from nearfar.stream._radii import PUBLISHED

RATES = (50e6, 100e6)
"""Rates of links, bits per second."""


@dataclass(frozen=True)
class Loading:
    """Bytes needed by a client: geometry with textures, and maps."""

    name: str
    encode: float
    """Seconds of encoding geometry on the server."""
    geometry: int
    maps: int
    """Bytes of maps."""
    decode_geometry: float
    decode_maps: float
    """Seconds of decoding by nearfar's own reader."""

    def total(self, rate: float) -> float:
        """Seconds until the last ring is available: all bytes over the link, then decoding, without overlap."""
        return 8.0 * (self.geometry + self.maps) / rate + self.decode_geometry + self.decode_maps


def measure(place: Place, bundle: nf.stream.Bundle) -> tuple[list[Loading], float]:
    """Loading of four encodings of the same rings, and MB of their plain vertices and corners with copies expanded.

    A vertex takes 32 bytes (position, normal and texture coordinates in float32), a triangle 12.
    """
    maps = sum(row["color"] + row["range"] for row in bundle.summary())
    decode_maps = best(lambda: bundle.map(bundle.count), repeat=3, warm=False).wall
    loadings = []
    for instanced in (True, False):
        rings = nf.stream.assign(place.make(instanced=instanced), center=place.center, radii=PUBLISHED)
        for compressed in (True, False):
            near = min((Near.encode(rings, compressed=compressed) for _ in range(2)), key=lambda near: near.seconds)
            name = f"{'instances' if instanced else 'copies'}, {'meshopt' if compressed else 'plain'}"
            sent = sum(near.bytes_by_ring(images=False)) + sum(near.bytes_by_ring(images=True))
            seconds = best(partial(decode, near), repeat=3, warm=False).wall
            loadings.append(Loading(name, near.seconds, sent, maps, seconds, decode_maps))
    meshes = (mesh for scene in near.scenes() if scene for mesh in _core.scene_parts(scene._core)["meshes"])
    return loadings, sum(32 * mesh.vertex_count + 12 * mesh.face_count for mesh in meshes) / 1e6


def decode(near: Near) -> nf.Scene:
    """Decode the scene that a client draws."""
    return one_scene(near.scenes())


HEADER = (
    "geometry | kB {:,.0f} | encode, s {:.2f} | decode, s {:.2f} | 50 Mbit/s, s {:.2f} | 100 Mbit/s, s {:.2f}"
    " | ratio at 50 {:.2f} | at 100 {:.2f}"
)


def rows(loadings: list[Loading]) -> list[list[object]]:
    """Make a row for each encoding; the last columns are loading times relative to the first encoding's."""
    totals = [[each.total(rate) for rate in RATES] for each in loadings]
    return [
        [each.name, each.geometry / 1e3, each.encode, each.decode_geometry, *times, *np.divide(times, totals[0])]
        for each, times in zip(loadings, totals, strict=True)
    ]
