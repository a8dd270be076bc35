"""Regions of a scene that are made on request: parts of a bundle, each sent as soon as it is ready."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any, SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check, formats, progress
from nearfar._render.level_choice import Lod
from nearfar._scene.scene import Scene, core_of
from nearfar.stream import _store, _tileset
from nearfar.stream._assign import Rings, ascending, assign
from nearfar.stream._centers import Point, snap
from nearfar.stream._detail import Detail
from nearfar.stream._encode import Files, Geometry, TextureFiles
from nearfar.stream._growth import Growth
from nearfar.stream._notes import findings_of
from nearfar.stream._radii import REACH, choose_radii
from nearfar.stream._region import NOTHING, Writer, manifest_of
from nearfar.stream._settings import Settings
from nearfar.stream._tiles import Tiles

COARSE = 512
"""Face size in texels of the coarse maps, which are shown until the full-size maps arrive; one sample per texel."""

NO_TILESET = b""
"""Content of the tileset of an incomplete region."""


@dataclass(frozen=True)
class Part:
    """A part of a region that is ready."""

    stage: int
    """0 for coarse maps, 1 for full-size maps."""
    line: bytes
    """JSON line that announces the part to a waiting client."""
    files: dict[str, bytes]
    """Files that the part names and that no earlier part had; the last part also has the manifest and the tileset."""
    next: int | None
    """Stage of the next part; None after the last part."""


class OnDemand:
    """Makes the region of a bundle for any centre, ring 0 first.

    A region comes in two stages: with maps of 512² texels and one sample, which take a small part of the time, and
    with full-size maps. Geometry is the same in both.

    Parameters
    ----------
    scene
        The scene.
    grid
        Spacing in metres of the horizontal grid to which centres move (`snap`).
    radii
        Radii of the rings in metres, ascending; by default those of `nearfar.stream.rings` for each centre.
    face_size, samples, quality, range_error, step, compression, pixels_per_degree, lod, speed
        As for `nearfar.stream.export`.

    Raises
    ------
    ValueError, TypeError
        As `nearfar.stream.export` does.

    References
    ----------
    CloVR (2024): a client gets the rings of its own centre at the start and after a teleport. Coarse maps first are
    our addition.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        grid: SupportsFloat = 2.0,
        radii: Iterable[float] | None = None,
        face_size: SupportsIndex = 1024,
        samples: SupportsIndex = 4,
        quality: SupportsIndex | None = 90,
        range_error: SupportsFloat = 2.0**-11,
        step: SupportsFloat = 2.0**-10,
        compression: str | None = "meshopt",
        pixels_per_degree: SupportsFloat | None = 25.0,
        lod: Lod | None = None,
        speed: SupportsFloat = 0.7,
    ) -> None:
        core_of(scene)
        self.grid = check.in_range("grid", grid, 1e-3, 1e6)
        self._radii = None if radii is None else ascending("radii", radii)
        fine = Settings.validate(face_size, samples, quality, range_error, step, compression, pixels_per_degree, False)
        coarse = replace(fine, face_size=min(COARSE, fine.face_size), samples=1)
        self._stages = (coarse, fine)
        # Built after the settings are checked, because it takes seconds.
        self._tiles = Tiles.divide(scene)
        self.scene = scene = self._tiles.scene
        reach = Growth.reach + math.sqrt(0.5) * self.grid
        self._detail = Detail.from_options(scene, lod, fine.pixels_per_degree, reach)
        self._speed = check.positive("speed", speed)
        self._textures = TextureFiles(scene, fine.quality)
        self._moving = Files()
        self._dynamic = self._encoded_moving()

    def snapped(self, center: ArrayLike) -> Point:
        """Return the centre of the region that serves a position."""
        return snap(center, self.grid)

    def parts(self, center: ArrayLike) -> Iterator[Part]:
        """Make the region of a position, part by part.

        Parameters
        ----------
        center
            World position in metres; `snapped` moves it.

        Yields
        ------
        Part
            For each stage one part that begins it, then one for each ring from 0 on. The last part has the
            `manifest.json` and the `tileset.json` of a bundle with this one region.

        Raises
        ------
        ValueError
            For a centre that is not finite, and one without surrounding objects if radii are to be chosen.
        """
        place = self.snapped(center)
        scene = self._tiles.about(place, REACH if self._radii is None else self._radii[-1])
        radii = choose_radii(scene, np.array([place]))[0] if self._radii is None else self._radii
        rings = assign(scene, center=place, radii=radii)
        geometry, sent = Files(dict(self._moving.content)), set[str]()
        near: Iterable[dict[str, Any]] = self._near(rings, geometry)
        last = len(self._stages) - 1
        for stage, settings in enumerate(self._stages):
            maps = Files()
            writer = Writer(settings, [], maps)
            baked = writer.bake(rings)
            # Findings take an additional 0.1 s.
            head = baked.head(findings_of(rings) if stage else [])
            outline = _region(head, _outline(rings))
            manifest = self._manifest(settings, radii, outline, self._moving, NO_TILESET)
            yield _part(stage, stage, {"event": "begin", "manifest": manifest}, self._moving, sent=sent)
            entries = []
            for ring, entry in enumerate(writer.rings(baked, near)):
                entries.append(entry)
                then = min(stage + (ring == rings.count), last)
                yield _part(stage, then, {"event": "ring", "ring": ring, "entry": entry}, geometry, maps, sent=sent)
            near = [{name: value for name, value in entry.items() if name != "map"} for entry in entries[1:]]
        whole = Files({**geometry.content, **maps.content})
        tileset = _tileset.encode(place, entries, self._dynamic, whole.content)
        manifest = self._manifest(settings, radii, _region(head, entries), whole, tileset)
        text = formats.to_json(manifest, compact=True).encode()
        line = {"event": "end", "stage": last}
        yield Part(last, _line(line), {_store.TILESET: tileset, _store.MANIFEST: text}, None)

    def _near(self, rings: Rings, files: Files) -> Iterator[dict[str, Any]]:
        """Encode the geometry of the rings in order."""
        textures = self._textures.halved(self._detail.halvings([rings]))
        step, compressed = self._stages[0].step, self._stages[0].compressed
        yield from Geometry(
            self._detail.select_levels(rings), files, textures, step=step, compressed=compressed
        ).groups("ring")

    def _manifest(
        self, settings: Settings, radii: tuple[float, ...], region: dict[str, Any], files: Files, tileset: bytes
    ) -> dict[str, Any]:
        return manifest_of(
            self.scene,
            settings,
            growth=Growth(radii, speed=self._speed),
            regions=[region],
            dynamic=self._dynamic,
            tileset=_store.file_entry(tileset),
            files=files,
        )

    def _encoded_moving(self) -> dict[str, Any] | None:
        """Encode the dynamic objects, which are the same in all regions."""
        rings = assign(self.scene, center=(0.0, 0.0, 0.0), radii=[1.0])
        alone = replace(rings, ring=np.where(rings.ring > 0, 2, 0).astype(np.int32), rest=2)
        textures = self._textures.halved(self._detail.halvings([alone]))
        step, compressed = self._stages[0].step, self._stages[0].compressed
        return Geometry(alone, self._moving, textures, step=step, compressed=compressed).moving()


def next_part(parts: Iterator[Part], look: Callable[[], None]) -> Part | None:
    """Make the next part of a region; None after the last one.

    `look` is called several times a second meanwhile; an exception that it raises ends the work and is raised here.
    After that the iterator must not be used again.
    """
    with progress.hidden(), progress.watched(look):
        return next(parts, None)


def _region(head: dict[str, Any], rings: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the entry of a bundle's only region."""
    return {**head, "rings": rings, "by_footprint": None, "neighbours": []}


def _outline(rings: Rings) -> list[dict[str, Any]]:
    """Return the entries of rings before any file is ready."""
    rows = rings.summary()[: rings.count]
    return [{**NOTHING, "map": None}, *({**row, "geometry": None, "parts": [], "map": None} for row in rows)]


def _part(stage: int, then: int, told: dict[str, Any], *files: Files, sent: set[str]) -> Part:
    """Make a part with the files that were not sent yet, and a line that describes them."""
    new = {name: data for each in files for name, data in each.content.items() if name not in sent}
    sent.update(new)
    described = {name: _store.file_entry(data) for name, data in new.items()}
    return Part(stage, _line({**told, "stage": stage, "files": described}), new, then)


def _line(told: dict[str, Any]) -> bytes:
    return formats.to_json(told, compact=True).encode()
