"""Reads the geometry of leaves near the viewer, and joins the leaves of a picture into one scene."""

from __future__ import annotations

import re
import threading
from collections import defaultdict
from collections.abc import Collection, Sequence

from nearfar._base import formats, glb
from nearfar._base.errors import UnusableError
from nearfar._base.recent import Recent
from nearfar._scene.arrays import origin_for
from nearfar._scene.budget import Budget
from nearfar._scene.content import assemble
from nearfar._scene.gltf.document import read as read_gltf
from nearfar._scene.joined import join_scenes
from nearfar._scene.materials import Materials
from nearfar._scene.options import LoadOptions
from nearfar._scene.scene import Scene
from nearfar.orthoview._chunks import Chunks
from nearfar.orthoview._geometry_store import FOLDER, IMAGES, names
from nearfar.orthoview._grid import Grid, Place

_TEXTURE = re.compile("[0-9a-f]+[.]webp")


class Near:
    """Reads the geometry of leaves, and caches the most recently used ones; thread-safe.

    Caches scenes of up to `max_bytes` bytes, or more if one picture needs them, and texture files of up to `max_bytes`.
    Messages name the store by `address`, its folder or URL.
    """

    def __init__(self, address: str, chunks: Chunks, grid: Grid, max_bytes: int) -> None:
        self._address, self._chunks, self._grid = address, chunks, grid
        self.max_bytes = max_bytes
        """Bytes of scenes, and of texture files, that are cached."""
        self.origin = origin_for(grid.bounds)
        """World position (3,) that the scenes' positions are relative to, metres."""
        self.cache: Recent[Place, Scene | None] = Recent(lambda scene: 0 if scene is None else scene._core.bytes())
        """Scenes of leaves, None for empty leaves; its `read_bytes` include textures."""
        self.images: Recent[str, bytes] = Recent(len)
        """Texture files by name."""
        self._joined: tuple[tuple[Place, ...], Scene | None] = ((), None)
        self._lock = threading.Lock()
        self._lock_by_image: defaultdict[str, threading.Lock] = defaultdict(threading.Lock)

    def scene(self, places: Sequence[Place]) -> Scene | None:
        """Return the geometry of leaves as one scene, None if all are empty; read leaves that are not cached."""
        self.load(places)
        scene = self.cached_scene(places)
        self.trim(set(places))
        return scene

    def cached_scene(self, places: Sequence[Place]) -> Scene | None:
        """Geometry of cached leaves as one scene; None if all are empty."""
        leaf_places = tuple(sorted(places))
        leaves = [self.cache.get(place) for place in leaf_places]
        if leaf_places != self._joined[0]:
            parts = [leaf for leaf in leaves if leaf is not None]
            self._joined = leaf_places, join_scenes(parts) if parts else None
        return self._joined[1]

    def trim(self, needed: Collection[Place]) -> None:
        """Evict the least recently used leaves, except needed ones, until the cache fits its size."""
        self.cache.trim(needed, self.max_bytes)

    def load(self, places: Sequence[Place]) -> bool:
        """Read the leaves that are not cached; return whether any of them has a file."""
        has_file = False
        for place in places:
            if place not in self.cache:
                with formats.guarded(self._address, "orthoviews"):
                    parts = [part for name in names(self._grid, place) if (part := self._read_file(name)) is not None]
                has_file |= bool(parts)
                self.cache.put(place, join_scenes(parts) if parts else None)
                with self._lock:
                    if place in self._joined[0]:
                        self._joined = ((), None)
        return has_file

    def read_undecoded(self, place: Place) -> None:
        """Read the files that `load` reads for one leaf, none of which is cached, without decoding them."""
        for name in names(self._grid, place):
            if (data := self._chunks.geometry(name)) is not None:
                with formats.guarded(f"{self._address}/{name}"):
                    for image in glb.header(data)[0].get("images", []):
                        _Images(self).get(image["uri"])
        self.images.trim((), 0)

    def _read_file(self, name: str) -> Scene | None:
        data = self._chunks.geometry(name)
        if data is None:
            return None
        self.cache.count_bytes(len(data))
        budget, file = Budget(), f"{self._address}/{name}"
        with formats.guarded(file):
            content = read_gltf(file, data, "glb", _Images(self), Materials(budget), budget)
        return Scene(**assemble(content, LoadOptions(), origin=self.origin))

    def image(self, name: str) -> bytes:
        """Return the bytes of a texture file; if several threads need the same file, only the first one reads it."""
        with self._lock:
            lock = self._lock_by_image[name]
        with lock:
            if (content := self.images.get(name)) is not None:
                return content
            content = self._chunks.geometry(f"{FOLDER}/{IMAGES}/{name}")
            if content is None:
                raise UnusableError(f"{FOLDER}/{IMAGES}/{name}: the file is gone")
            self.cache.count_bytes(len(content))
            self.images.put(name, content)
            self.images.trim((), self.max_bytes)
            return content


class _Images:
    """Resolver of the textures that leaves share, for the glTF reader."""

    parent = FOLDER

    def __init__(self, near: Near) -> None:
        self._near = near

    def get(self, uri: str) -> bytes:
        """Bytes of a texture file, by its URI relative to a leaf's GLB."""
        folder, _, name = uri.rpartition("/")
        if folder.rpartition("/")[2] != IMAGES or not _TEXTURE.fullmatch(name):
            raise UnusableError(f"expected a texture in {IMAGES}, got {uri!r}")
        return self._near.image(name)
