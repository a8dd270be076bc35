"""Near geometry of the benchmarks' scenes as files: rings in several encodings, and as processed by gltfpack."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

import nearfar as nf
from benchmarks.harness.timing import timed
from nearfar import _core
from nearfar.stream._decode import join_rings, ring_scene
from nearfar.stream._encode import Geometry, TextureFiles, Textures
from nearfar.stream._manifest import geometry_files
from nearfar.stream._radii import PUBLISHED
from nearfar.stream._store import Files

STEP = 2.0**-10
"""Step of positions in metres, as in bundles."""
EYE_HEIGHT = 1.3
"""Height of the user's eyes in CloVR (2024), metres."""

Point = tuple[float, float, float]


@dataclass(frozen=True)
class Place:
    """A scene, and a centre in it."""

    name: str
    make: Callable[..., nf.Scene]
    """Function that makes the scene; it has the parameter `instanced`."""
    center: Point
    users: tuple[Point, ...]
    """Positions of users relative to the centre, metres."""


def large_city(quick: bool, *, instanced: bool = True) -> nf.Scene:
    """The procedural city with 35.6 million triangles, or a small one."""
    return nf.datasets.city(blocks=3 if quick else 9, detail=1 if quick else 3, instanced=instanced)


def street_center() -> Point:
    """The user's eye in the middle of the city's avenue."""
    (x, _, z), _ = nf.datasets.street_view()
    return x, EYE_HEIGHT, z


def places(quick: bool) -> list[Place]:
    """The city at two centres, on a crossing and beside a park, and the factory."""
    city, factory = partial(large_city, quick), partial(nf.datasets.factory, detail=1 if quick else 3)
    x, _, z = nf.datasets.factory_view()[0]
    users = ((-1.0, 0.0, 0.0), (0.0, 0.0, 2.0))
    return [
        Place("city, crossing", city, (0.0, EYE_HEIGHT, 0.0), users),
        Place("city, beside a park", city, (-42.0, EYE_HEIGHT, -64.0), users),
        Place("factory", factory, (x, EYE_HEIGHT, z), ((-0.5, 0.0, 0.0), (1.0, 0.0, 0.0))),
    ]


def exporter(
    scene: nf.Scene, groups: NDArray[np.uint16], count: int, *, named: bool, images: bool, compressed: bool
) -> _core.Export:
    """Exporter of groups of objects, with or without names; images get addresses only, because they are never read."""
    names = list(scene.object_names) if named else []
    addresses = [f"{number}.webp" if images else None for number in range(scene._core.texture_count)]
    encoding = {"step": STEP, "compressed": compressed}
    return _core.Export(scene._core, groups, count, names=names, images=addresses, encoding=encoding)


def encode_groups(
    scene: nf.Scene, groups: NDArray[np.uint16], encoded: range, *, compressed: bool
) -> tuple[list[bytes], list[dict[str, Any]]]:
    """Encode groups of objects after buffers with their shared meshes; return the files and their statistics."""
    count = max(int(groups.max()) + 1, encoded.stop)
    export = exporter(scene, groups, count, named=True, images=True, compressed=compressed)
    shared = [(data, statistics) for data, _, statistics in export.shared()]
    uris: list[str | None] = [f"{number}.bin" for number in range(len(shared))]
    files, statistics = zip(*shared, *(export.glb(group, uris=uris) for group in encoded), strict=True)
    return list(files), list(statistics)


def one_file(scene: nf.Scene, *, named: bool = False, images: bool = False, compressed: bool = False) -> bytes:
    """The whole scene as one file."""
    groups = np.zeros(len(scene.object_names) + 1, np.uint16)
    export = exporter(scene, groups, 1, named=named, images=images, compressed=compressed)
    return bytes(export.glb(0, uris=[None] * len(export.shared()))[0])


def whole_textures(scene: nf.Scene, quality: int | None) -> Textures:
    """Textures in their original size, whatever is visible to a client."""
    return TextureFiles(scene, quality).encode(np.zeros(scene._core.texture_count, np.uint32))


@dataclass(frozen=True)
class Near:
    """Geometry of all rings as files."""

    rings: nf.stream.Rings
    files: Files
    entries: list[dict[str, Any]]
    """Entries of rings in a manifest, without maps."""
    seconds: float
    """Seconds of encoding."""

    @classmethod
    def encode(cls, rings: nf.stream.Rings, *, compressed: bool, quality: int | None = 90) -> Near:
        files = Files()

        def encode() -> list[dict[str, Any]]:
            textures = whole_textures(rings.scene, quality)
            settings = nf.stream.ExportSettings(step=STEP, compression="meshopt" if compressed else None)
            return list(Geometry(rings, files, textures, settings).groups("ring"))

        entries, spent = timed(encode)
        return cls(rings, files, entries, spent.wall)

    def names(self, ring: int, *, images: bool) -> set[str]:
        """Names of a ring's files: textures, or the others."""
        return {name for name in geometry_files(self.entries[ring - 1]) if name.endswith(".webp") == images}

    def bytes_by_ring(self, *, images: bool) -> list[int]:
        """Bytes of each ring from 1 on; each file counts once."""
        counted: set[str] = set()
        sizes = []
        for ring in range(1, len(self.entries) + 1):
            new = self.names(ring, images=images) - counted
            counted |= new
            sizes.append(sum(len(self.files.content[name]) for name in new))
        return sizes

    def scenes(self) -> list[nf.Scene | None]:
        """Decode the geometry of each ring."""
        read = self.files.content.__getitem__
        named = [(entry["geometry"], entry["parts"]) for entry in self.entries]
        return [None if name is None else ring_scene(name, parts, read, name) for name, parts in named]


def one_scene(scenes: Sequence[nf.Scene | None], moving: nf.Scene | None = None) -> nf.Scene:
    """Join dynamic objects and all rings, as a client does."""
    return join_rings(moving, [(f"ring {ring}", scene) for ring, scene in enumerate(scenes, 1) if scene is not None])


def in_front_of_map(near: nf.Scene, env: nf.EnvMap, morph: Literal["cylinder", "none"] = "cylinder") -> nf.ReducedScene:
    """Whole objects in front of a map."""
    zones = nf.partition(near, center=env.center, r1=0.7 * PUBLISHED[-1], r2=PUBLISHED[-1])
    counts = {**zones.summary(), "rays": 0}
    return nf.ReducedScene(near, zones, env, morph=morph, boundary="r2", counts=counts, is_whole=False)


def gltfpack(folder: Path, name: str, *options: str) -> Path | None:
    """Process a file by gltfpack and return its output beside it; None if gltfpack is not on the path."""
    program, output = shutil.which("gltfpack"), folder / "packed.glb"
    if program is None:
        return None
    subprocess.run([program, *options, "-i", folder / name, "-o", output], check=True, capture_output=True)
    return output


def packed_rings(near: Near, folder: Path, *options: str) -> tuple[list[int], list[nf.Scene | None]] | None:
    """Bytes and content of each ring after gltfpack, with instances and with images outside; None without gltfpack.

    `near` has plain files, which are written to the folder.
    """
    for name, data in near.files.content.items():
        (folder / Path(name).name).write_bytes(data)
    sizes, scenes = list[int](), list[nf.Scene | None]()
    for entry in near.entries:
        size, scene = 0, None
        if entry["geometry"] is not None:
            file = gltfpack(folder, Path(entry["geometry"]).name, "-tr", "-mi", *options)
            if file is None:
                return None
            size, scene = file.stat().st_size, nf.Scene.load(file)
        sizes.append(size)
        scenes.append(scene)
    return sizes, scenes


def in_one_file(rings: nf.stream.Rings, folder: Path, *options: str) -> tuple[int, bytes | None]:
    """Bytes of all rings as one plain file, in which a mesh is stored once, and gltfpack's version of it."""
    scene, codes = rings.scene, rings.codes()
    groups = np.where((codes >= 1) & (codes <= rings.count), 1, 0).astype(np.uint16)
    export = exporter(scene, groups, 2, named=False, images=False, compressed=False)
    data, _ = export.glb(1, uris=[None] * len(export.shared()))
    (folder / "one.glb").write_bytes(data)
    packed = gltfpack(folder, "one.glb", "-mi", *options)
    return len(data), None if packed is None else packed.read_bytes()


def error(rings: nf.stream.Rings, ring: int, scene: nf.Scene | None) -> float:
    """Maximum distance in metres from a corner of a ring's objects to the nearest decoded one."""
    if scene is None:
        return 0.0
    original, decoded = (corners(part) for part in (rings.scene.subset(objects=rings.objects(ring)), scene))
    return float(cKDTree(decoded).query(original, workers=-1)[0].max())


def corners(scene: nf.Scene) -> Any:
    """Distinct corners of all triangles in the world, metres."""
    return np.unique(scene.triangles().reshape(-1, 3), axis=0) + scene.origin
