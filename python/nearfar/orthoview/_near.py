"""Reads leaves near the viewer as geometry, and joins those that are drawn into one scene."""

from __future__ import annotations

import re
import threading
from collections import OrderedDict
from collections.abc import Callable, Collection, Sequence

from nearfar._base import formats
from nearfar._base.errors import UnusableError
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

MAX_LEAVES = 256
"""Maximum number of cached leaves besides those that are needed."""

MAX_TEXTURES = 256
"""Maximum number of cached texture files, which leaves share."""


class Near:
    """Reads the geometry of leaves; thread-safe.

    Parameters
    ----------
    place
        Folder or URL of the store, for messages.
    chunks
        Chunks of the store.
    grid
        Grid of the tree's cells.
    """

    def __init__(self, place: str, chunks: Chunks, grid: Grid) -> None:
        self._place, self._chunks, self._grid = place, chunks, grid
        self.origin = origin_for(grid.bounds)
        """World position (3,) that the scenes' positions are relative to, metres."""
        self._leaves: OrderedDict[Place, Scene | None] = OrderedDict()
        self._images: OrderedDict[str, bytes] = OrderedDict()
        self._last: tuple[tuple[Place, ...], Scene | None] = ((), None)
        self._old: set[Place] = set()
        """Cached leaves that an update has changed since they were read."""
        self._lock = threading.Lock()
        self.read_bytes = 0
        """Bytes read so far."""
        self.reads = 0
        """Number of leaves read so far."""

    def __contains__(self, place: Place) -> bool:
        """Whether a leaf is cached in its newest version."""
        return place in self._leaves and place not in self._old

    def keeps(self, place: Place) -> bool:
        """Whether a leaf is cached, in any version."""
        return place in self._leaves

    def take_over(self, older: Near, changed: Callable[[Place], bool]) -> None:
        """Take the cached leaves of an older generation; changed ones serve until they are read again."""
        self._leaves.update(older._leaves)
        self._old = {place for place in self._leaves if place in older._old or changed(place)}
        self.read_bytes, self.reads = older.read_bytes, older.reads

    def scene(self, places: Sequence[Place]) -> Scene | None:
        """Geometry of leaves as one scene; leaves that are not cached are read. None if all are empty."""
        self.load(places)
        scene = self.cached_scene(places)
        self.trim(set(places))
        return scene

    def cached_scene(self, places: Sequence[Place]) -> Scene | None:
        """Geometry of cached leaves as one scene; None if all are empty."""
        wanted = tuple(sorted(places))
        leaves = [self._leaf(place) for place in wanted]
        if wanted != self._last[0]:
            parts = [leaf for leaf in leaves if leaf is not None]
            self._last = wanted, join_scenes(parts) if parts else None
        return self._last[1]

    def trim(self, needed: Collection[Place]) -> None:
        """Evict the least recently used leaves, but none that are needed, down to `MAX_LEAVES` others."""
        with self._lock:
            surplus = max(len(self._leaves) - len(needed) - MAX_LEAVES, 0)
            for place in [place for place in self._leaves if place not in needed][:surplus]:
                del self._leaves[place]
                self._old.discard(place)

    def load(self, places: Sequence[Place]) -> None:
        """Read the leaves that are not cached."""
        for place in places:
            if place not in self:
                with formats.guarded(self._place, "orthoviews"):
                    parts = [part for name in names(self._grid, place) if (part := self._file(name)) is not None]
                leaf = join_scenes(parts) if parts else None
                with self._lock:
                    self._leaves[place] = leaf
                    self._old.discard(place)
                    self.reads += 1
                    if place in self._last[0]:
                        self._last = ((), None)

    def _leaf(self, place: Place) -> Scene | None:
        with self._lock:
            self._leaves.move_to_end(place)
            return self._leaves[place]

    def _file(self, name: str) -> Scene | None:
        data = self._chunks.geometry(name)
        if data is None:
            return None
        self._count(data)
        budget = Budget()
        label = f"{self._place}/{name}"
        with formats.guarded(label):
            content = read_gltf(label, data, "glb", _Images(self), Materials(budget), budget)
        return Scene._from_assembled(assemble(content, LoadOptions(), origin=self.origin))

    def image(self, name: str) -> bytes:
        """Bytes of a texture."""
        content = self._images.get(name)
        if content is None:
            content = self._chunks.geometry(f"{FOLDER}/{IMAGES}/{name}")
            if content is None:
                raise UnusableError(f"{FOLDER}/{IMAGES}/{name}: the file is gone")
            self._count(content)
        with self._lock:
            self._images[name] = content
            self._images.move_to_end(name)
            while len(self._images) > MAX_TEXTURES:
                self._images.popitem(last=False)
        return content

    def _count(self, content: bytes) -> None:
        with self._lock:
            self.read_bytes += len(content)


class _Images:
    """Resolver of the textures that leaves share, for trimesh."""

    parent = FOLDER

    def __init__(self, near: Near) -> None:
        self._near = near

    def get(self, uri: str) -> bytes:
        """Bytes of a texture file, by its URI relative to a leaf's GLB."""
        folder, _, name = uri.rpartition("/")
        if folder.rpartition("/")[2] != IMAGES or not _TEXTURE.fullmatch(name):
            raise UnusableError(f"expected a texture in {IMAGES}, got {uri!r}")
        return self._near.image(name)
