"""The `OrthoTree` class: an open tree of orthoviews."""

from __future__ import annotations

import os
from typing import SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import card, check
from nearfar._camera.camera import Camera, Fov
from nearfar._source.protocol import SceneSource, source_of
from nearfar.orthoview import _compact, _splat_export, _update
from nearfar.orthoview._files import Local
from nearfar.orthoview._grid import places_of
from nearfar.orthoview._near_far import NearFarTree
from nearfar.orthoview._renderable_tree import CACHE_BYTES
from nearfar.orthoview._splat_cells import Cells
from nearfar.orthoview._view import sheet


class OrthoTree(NearFarTree):
    """A world as an octree of orthographic depth images, built by `nearfar.orthoview.build`.

    FileNotFoundError for a path without a store; FormatError for a store of another kind, or of a newer version;
    ValueError for a URL that fsspec cannot open; ImportError if the package zarr is missing. A store in a folder may be
    opened while it is being built, or after its build was interrupted: the tree shows what was built until then, and
    `unbuilt` counts the missing leaves. Behind a URL such a store can be opened but not read. Source: Chaudhuri et al.
    (2009), Image-Based Exploration of Massive Online Environments, section 4: pictures, flights and prefetching.

    Parameters
    ----------
    path
        The store's folder, or the URL of one: https://…, s3://… or any other that fsspec knows.
    cache_bytes
        Size of the cache of views, bytes, and of the cache of leaves' geometry; all parts of one picture are cached,
        even beyond it.
    """

    def preview(
        self, level: SupportsIndex | None = None, place: tuple[int, int, int] | None = None
    ) -> NDArray[np.uint8]:
        """Return the views of a cell side by side, sRGB (H, W, 3). Errors as in `view`.

        By default the cell is the root; before the build has ended, one of the largest finished cells.
        """
        number = self.levels - 1 if level is None else check.integer("level", level, 0, self.levels - 1)
        cell_place = (0, 0, 0) if place is None else place
        if level is None and place is None and self.unbuilt:
            any_camera = Camera(self.bounds[0], fov=Fov.symmetric(90.0), size=(1, 1))
            coarsest = self.cut(any_camera, error_px=1e30, geometry=False, around=True)
            if len(coarsest):
                largest = int(coarsest.level.argmax())
                number, cell_place = int(coarsest.level[largest]), places_of(coarsest.place[largest : largest + 1])[0]
        return sheet([self.view(number, cell_place, direction) for direction in range(len(self.directions))], self.size)

    def update(self, aabb: ArrayLike, source: SceneSource) -> OrthoTree:
        """Write a new generation of the tree after the world has changed within a box (2, 3), metres.

        `source` is the whole changed world. The update renders the leaves that the box touches, and composes the cells
        above them: about k + log n cells for k of n leaves. It writes their views beside those of older generations,
        and finally changes one document, which makes them visible. Trees that are already open keep showing the older
        generation. An interrupted update leaves the store as it was. Returns the tree of the new generation; its `done`
        counts the leaves rendered and the cells composed.

        ValueError for a store behind a URL, an incomplete store, or a world that extends beyond the tree's `bounds`
        within the box; TypeError for a value that is not a source; FormatError for a damaged shard; BlockingIOError if
        a build or another update writes into the store; and any exception of the source.
        """
        box, world = check.box("aabb", aabb), source_of("source", source)
        if not isinstance(self._files, Local):
            raise ValueError(f"path: expected a local folder to update, got {check.shortened(self.path)}")
        _update.update(self._files.folder, box, world)
        return OrthoTree(self.path)

    def compact(self, path: str | os.PathLike[str]) -> OrthoTree:
        """Write this generation as a new store, which any reader of Zarr v3 opens, into a new or empty folder.

        Shards that no update touched are hard-linked instead of copied if both stores are on one disk. The files have
        the same bytes as those of a store built from the changed world. ValueError for an incomplete store, or the
        folder of this store; FormatError for a damaged or missing shard; OSError for files that cannot be
        written.
        """
        target = check.path("path", path)
        self._require_complete()
        if isinstance(self._files, Local) and target.resolve() == self._files.folder.resolve():
            raise ValueError("path: expected another folder than the tree's own, which other programs may be reading")
        _compact.compact(self._files, self._attributes, target)
        return OrthoTree(target)

    def export_splats(
        self,
        path: str | os.PathLike[str],
        *,
        format: str | None = None,  # noqa: A002
        level: SupportsIndex = 0,
        aabb: ArrayLike | None = None,
        light: str | ArrayLike | None = "sun",
        compression: str | None = None,
    ) -> dict[str, int]:
        """Write this generation for viewers of Gaussian splats: each pixel of the views becomes a Gaussian.

        Surfaces that several views of a cell show are written once. Shading by one light is part of the colours. The
        files are written to temporary names and renamed. Returns the numbers of `cells` or `tiles`, of `splats`, of the
        `pixels` that they represent, of `bytes`, of leaves that `failed` in the build, and of leaves `unbuilt` because
        the build has not ended: both are missing. ValueError for arguments out of range, an empty box, or more splats
        than a file holds: 10,000,000 in SPZ, 4 GiB in a GLB; FormatError for a damaged shard; OSError for files that
        cannot be read or written. Source: Kerbl et al., 3D Gaussian Splatting for Real-Time Radiance Field Rendering.

        Parameters
        ----------
        path
            File or folder to create or replace; a folder must be empty or an older export.
        format
            "spz": one file of SPZ version 3, in world metres. "gltf": one GLB with KHR_gaussian_splatting. "tiles": a
            folder with a tileset of 3D Tiles 1.1, with a GLB for each cell of each level. By default the suffixes .spz
            and .glb select the format, and a path without a suffix is a folder of tiles.
        level
            Level of the cells in a file, or of the finest tiles.
        aabb
            World box (2, 3) of the splats' centres, metres; by default everything.
        light
            "sun": the light of all pictures. A vector (3,) towards the sun: the same light with another sun. None:
            unshaded colours.
        compression
            "spz" puts an SPZ file of version 2 into each GLB (KHR_gaussian_splatting_compression_spz_2, a draft). By
            default the attributes are plain.
        """
        target, lowest = check.path("path", path), check.integer("level", level, 0, self.levels - 1)
        box = np.array([[-np.inf] * 3, [np.inf] * 3]) if aabb is None else check.box("aabb", aabb)
        self._require_records()
        cells = Cells(self._files, self._layout, self.generation, box, _splat_export.sun_of(light))
        counts = _splat_export.export(cells, target, format=format, level=lowest, compression=compression)
        return {**counts, "failed": len(self._failed), "unbuilt": self.unbuilt}

    def verify(self) -> int:
        """Read every shard and compare its size and hash with the store's records.

        Returns the number of shards and geometry files, including those of older generations. FormatError that names
        the first record or file that is missing or differs. Before the build has ended, files of unfinished subtrees
        are compared by size alone; `unbuilt` and `failed` say which leaves are missing.
        """
        self._require_records()
        return _compact.verify(self._files, self.generation)

    @card.repr_html
    def _repr_html_(self) -> str:
        facts = [
            ("leaves", f"{' × '.join(map(str, self.cells(0)))} of {self.cell:g} m, {self.held['leaves']:,} not empty"),
            ("levels", str(self.levels)),
            ("views", f"{len(self.directions)} of {self.size} × {self.size} pixels for each cell"),
            ("cells", f"{self.held['cells']:,}, {self.held['bytes']:,} bytes"),
            ("updates", str(self.generation)),
        ]
        if not self.is_complete:
            missing = f"{len(self.failed):,} leaves failed, {self.unbuilt:,} are not built yet"
            return card.page("OrthoTree", [*facts, ("incomplete", missing)])
        picture = card.picture(self.preview(), "views of the whole world", "from all directions, without light")
        return card.page("OrthoTree", facts, picture)

    def __repr__(self) -> str:
        missing = f": {self.unbuilt:,} leaves are not built yet" if self.unbuilt else ""
        state = "" if self.is_complete else f", incomplete{missing}"
        name = self.path.rpartition("/")[2]
        return (
            f"OrthoTree({name!r}, {self.levels} levels of {self.cells(0)} leaves of {self.cell:g} m, "
            f"{len(self.directions)} directions of {self.size} × {self.size} pixels{state})"
        )


def open(path: str | os.PathLike[str], *, cache_bytes: SupportsIndex = CACHE_BYTES) -> OrthoTree:  # noqa: A001 - a public name
    """Open a store of orthoviews; parts of shards are read on demand. Errors as in `OrthoTree`.

    Parameters
    ----------
    path, cache_bytes
        As in `OrthoTree`.
    """
    return OrthoTree(path, cache_bytes=cache_bytes)
