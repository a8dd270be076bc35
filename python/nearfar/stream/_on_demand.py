"""Regions of a scene that are made on request: parts of a bundle, each sent as soon as it is ready."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any, SupportsFloat, Unpack

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check, formats, progress
from nearfar._base.settings import gather
from nearfar._render.level_choice import Lod
from nearfar._scene.scene import Scene, core_of
from nearfar.stream import _stages, _store
from nearfar.stream._assign import Rings, check_radii
from nearfar.stream._detail import Detail
from nearfar.stream._encode import Geometry, TextureFiles
from nearfar.stream._manifest import EMPTY_RING
from nearfar.stream._notes import findings_of
from nearfar.stream._pieces import divide
from nearfar.stream._radii import REACH
from nearfar.stream._regions import reach_of, snap
from nearfar.stream._settings import ExportKeywords, ExportSettings
from nearfar.stream._store import Files
from nearfar.stream._tiles import Tiles

COARSE_FACE_SIZE = 512
"""Face size in texels of the coarse maps, which are shown until the full-size maps arrive; one sample per texel."""

LAST_STAGE = 1
"""Number of the last stage, which has full-size maps."""


@dataclass(frozen=True)
class Part:
    """A part of a region that is ready."""

    stage: int
    """0 for coarse maps, 1 for full-size maps."""
    line: bytes
    """JSON line that announces the part to a waiting client."""
    files: dict[str, bytes]
    """Files of the part that no earlier part contained; the last part also has the manifest and the tileset."""
    next: int | None
    """Stage of the next part; None after the last part."""


class OnDemand:
    """Makes the region of a bundle for any centre, ring 0 first.

    A region comes in two stages: first with maps of 512² texels and one sample, which take a fraction of the time, then
    with full-size maps. Geometry is the same in both.

    `grid` is the spacing in metres of the horizontal grid to which centres move (`snap`). `radii` are the rings' radii
    in metres, ascending; by default those of `nearfar.stream.ring_radii` for each centre. `lod`, `settings`, `keywords`
    and errors are those of `nearfar.stream.export`; `split_px` and `by_footprint` are refused.

    CloVR (2024): a client gets the rings of its own centre at the start and after a teleport. Coarse maps first are
    our addition.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        grid: SupportsFloat = 2.0,
        radii: Iterable[float] | None = None,
        lod: Lod | None = None,
        settings: ExportSettings | None = None,
        **keywords: Unpack[ExportKeywords],
    ) -> None:
        core_of(scene)
        self.grid = check.in_range("grid", grid, 1e-3, 1e6)
        self._radii = None if radii is None else check_radii("radii", radii)
        self.settings = fine = gather(ExportSettings, settings, keywords)
        for name in ("split_px", "by_footprint"):
            if getattr(fine, name):
                raise ValueError(f"{name}: expected none for regions on demand, got {getattr(fine, name)}")
        self._coarse = replace(fine, face_size=min(COARSE_FACE_SIZE, fine.face_size), samples=1)
        # Built after the settings are checked, because it takes seconds.
        self._tiles = Tiles.divide(divide(scene))
        self.scene = self._tiles.scene
        self._detail = Detail.from_options(self.scene.leveled, lod, fine.pixels_per_degree, reach_of(self.grid))
        self._textures = TextureFiles(self.scene, fine.quality)
        self._moving = Files()
        self._dynamic = self._encode_moving()

    def parts(self, center: ArrayLike) -> Iterator[Part]:
        """Make the region of a world position in metres, moved to the grid, part by part.

        Each stage begins with a part without a ring, then has one part for each ring from 0 on. The last part has the
        `manifest.json` and the `tileset.json` of a bundle with this one region. ValueError for a centre that is not
        finite, and for one without surrounding objects if radii are to be chosen.
        """
        point = snap(center, self.grid)
        scene = self._tiles.scene_about(point, REACH if self._radii is None else self._radii[-1])
        (rings,) = _stages.rings_about(scene, [point], self._radii)
        geometry, sent_names = Files(dict(self._moving.content)), set[str]()
        near: Iterable[dict[str, Any]] = self._encode_near(rings, geometry)
        for stage, settings in enumerate((self._coarse, self.settings)):
            files = Files()
            maps, scale = _stages.bake(rings, settings)
            # Findings take another 0.1 s, so that only the last stage has them.
            region = _stages.region_entry(rings, scale, _outline(rings), findings_of(rings) if stage else [])
            manifest = self._manifest(settings, region, self._moving)
            yield _make_part(
                stage, stage, {"event": "begin", "manifest": manifest}, self._moving, sent_names=sent_names
            )
            entries = []
            for ring, entry in enumerate(_stages.ring_entries(maps, scale, near, files, settings)):
                entries.append(entry)
                next_stage = min(stage + (ring == rings.count), LAST_STAGE)
                event = {"event": "ring", "ring": ring, "entry": entry}
                yield _make_part(stage, next_stage, event, geometry, files, sent_names=sent_names)
            near = [{name: value for name, value in entry.items() if name != "map"} for entry in entries[1:]]
        all_files = Files({**geometry.content, **files.content})
        manifest = self._manifest(self.settings, {**region, "rings": entries}, all_files)
        closing = _stages.closing_files(manifest, all_files)
        yield Part(LAST_STAGE, _line({"event": "end", "stage": LAST_STAGE}), closing, None)

    def _manifest(self, settings: ExportSettings, region: dict[str, Any], files: Files) -> dict[str, Any]:
        facts = _stages.scene_facts(self.scene, settings)
        return _stages.manifest_of(facts, settings.face_size, [region], self._dynamic, self.scene._notes, files)

    def _encode_near(self, rings: Rings, files: Files) -> Iterator[dict[str, Any]]:
        """Encode the geometry of the rings in order, as a generator: nothing is encoded before the map of ring 0."""
        textures = self._textures.encode(self._detail.halvings([rings]))
        yield from Geometry(self._detail.select_levels(rings), files, textures, self.settings).groups("ring")

    def _encode_moving(self) -> dict[str, Any] | None:
        """Encode the dynamic objects, which are the same in all regions."""
        (rings,) = _stages.rings_about(self.scene, [(0.0, 0.0, 0.0)], (1.0,))
        alone = replace(rings, ring=np.where(rings.ring > 0, 2, 0).astype(np.int32), rest=2)
        textures = self._textures.encode(self._detail.halvings([alone]))
        return Geometry(alone, self._moving, textures, self.settings).moving()


def next_part(parts: Iterator[Part], look: Callable[[], None]) -> Part | None:
    """Make the next part of a region; None after the last one.

    Meanwhile `look` is called several times a second. An exception that it raises ends the work and is raised here;
    then the iterator must not be used again.
    """
    with progress.hidden(), progress.watched(look):
        return next(parts, None)


def _outline(rings: Rings) -> list[dict[str, Any]]:
    """Return the entries of rings before any file is ready."""
    rows = rings.summary()[: rings.count]
    return [{**EMPTY_RING, "map": None}, *({**row, "geometry": None, "parts": [], "map": None} for row in rows)]


def _make_part(stage: int, next_stage: int, event: dict[str, Any], *files: Files, sent_names: set[str]) -> Part:
    """Make a part with the files that were not sent yet, and a line that describes them."""
    new_files = {name: data for each in files for name, data in each.content.items() if name not in sent_names}
    sent_names.update(new_files)
    entries = {name: _store.file_entry(data) for name, data in new_files.items()}
    return Part(stage, _line({**event, "stage": stage, "files": entries}), new_files, next_stage)


def _line(event: dict[str, Any]) -> bytes:
    return formats.to_json(event, compact=True).encode()
