"""Bundles: rings of near geometry and their maps as files, and the images that a client renders from them."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from nearfar._base import card, check, formats
from nearfar._camera.camera import Camera
from nearfar._cubemap.envmap import EnvMap
from nearfar._partition.partition import partition
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._render.showing import View, show as make_view
from nearfar._scene.report import count
from nearfar.stream import _manifest, _store
from nearfar.stream._decode import Layout, decode_map, join_rings, moving_scene, ring_scene
from nearfar.stream._growth import Growth
from nearfar.stream._manifest import NEAR_SHARE, geometry_files, layout_of, names_of
from nearfar.stream._regions import BundleRegions
from nearfar.stream._strategies import Strategy

LOSSLESS = b"VP8L"
"""First chunk of a lossless WebP file."""


@dataclass(frozen=True, eq=False, repr=False)
class Bundle(BundleRegions):
    """A bundle of files that `export` wrote, opened by `open`. Files are read and checked when they are needed.

    A `Bundle` describes one region. `open` selects the first region, and `region` any other. `files`, `nbytes`, `read`
    and `verify` cover all regions.
    """

    _reader: _store.Reader
    _manifest: dict[str, Any]
    number: int = 0
    """Number of the described region."""
    _contents: dict[str, bytes] = field(default_factory=dict)
    """Contents of read files, by name."""

    @property
    def center(self) -> tuple[float, float, float]:
        """World position of the region's centre O, metres."""
        return check.vector("center", self._region["center"])

    @property
    def radii(self) -> tuple[float, ...]:
        """Radii of the rings 1 to n in metres."""
        return tuple(float(ring["radius"]) for ring in self._rings[1:])

    @property
    def growth(self) -> Growth:
        """Growth of a client's morph after a ring has arrived."""
        entry = self._manifest["growth"]
        return Growth(self.radii, **{name: entry[name] for name in ("speed", "reach", "fade")})

    @property
    def triangle_count(self) -> int:
        """Number of triangles of the whole scene."""
        return int(self._manifest["triangles"])

    @property
    def notes(self) -> tuple[str, ...]:
        """Parts of the scene's file that are ignored or drawn differently, a sentence each."""
        return tuple(self._manifest["notes"])

    @property
    def face_size(self) -> int:
        """Texels along the edge of a face of the maps."""
        return self._layout.face_size

    @property
    def pixels_per_degree(self) -> float | None:
        """Pixels per degree of the display for which textures were halved; None if they have full size."""
        return self._display.get("pixels_per_degree")

    @property
    def split_px(self) -> float | None:
        """Maximum error of the vertex morph after splitting triangles, in pixels of the display; None if not split."""
        return self._display.get("split_px")

    @property
    def _display(self) -> dict[str, float | None]:
        """Display that the files were made for; empty for bundles written before the manifest had this entry."""
        return dict(self._manifest.get("display", {}))

    @property
    def losses(self) -> tuple[str, ...]:
        """Approximations in the region's files, a sentence each: colours, ranges, positions, textures.

        Reads a file of map 0 to see whether its images are lossless.
        """
        color, ranges = self._rings[0]["map"]["color"][0], self._region["range"]["error"]
        positions = max((ring.get("error", 0.0) for ring in self._rings), default=0.0)
        is_lossless = self.read(color)[12:16] == LOSSLESS
        losses = ["colours are 8-bit sRGB" if is_lossless else "colours are lossy WebP images"]
        losses.append(f"ranges of maps have a relative error of at most {ranges:.2g}")
        if positions > 0.0:
            losses.append(f"positions are rounded by at most {positions:.2g} m")
        if self.pixels_per_degree is not None:
            losses.append(f"textures suffice for {self.pixels_per_degree:g} pixels per degree")
        return tuple(losses)

    @property
    def count(self) -> int:
        """Number of rings n, without ring 0."""
        return len(self._rings) - 1

    @property
    def files(self) -> tuple[str, ...]:
        """Names of the files that clients load: all but `manifest.json` and `tileset.json`."""
        return tuple(self._manifest["files"])

    @property
    def nbytes(self) -> int:
        """Size of the files that clients load, in bytes."""
        return sum(entry["bytes"] for entry in self._manifest["files"].values())

    @property
    def _file_entries(self) -> dict[str, dict[str, Any]]:
        return _manifest.file_entries(self._manifest)

    @property
    def _rings(self) -> list[dict[str, Any]]:
        return list(self._region["rings"])

    def summary(self) -> list[dict[str, Any]]:
        """Count what each ring adds to the region.

        The row of each ring, from 0 on, has `radius` in metres, its static `objects` and their `triangles`, and the
        bytes of its `geometry` with textures, of `color` and `range` of its map, and of `dynamic` objects. Dynamic
        objects come with ring 0, because every picture shows them. A file counts only in the first ring and column that
        uses it. So the bytes of a bundle with one region add up to `nbytes`, unless the bundle also has objects by
        footprint.
        """
        counted: set[str] = set()
        rows = []
        for number, ring in enumerate(self._rings):
            row = {name: ring[name] for name in ("radius", "objects", "triangles")}
            files = {
                "dynamic": () if number else geometry_files(self._manifest["dynamic"]),
                "geometry": geometry_files(ring),
                **{kind: names_of(ring["map"].get(kind)) for kind in ("color", "range")},
            }
            for kind, names in files.items():
                row[kind] = sum(self._manifest["files"][name]["bytes"] for name in {*names} - counted)
                counted |= {*names}
            rows.append(row)
        return rows

    def read(self, name: str) -> bytes:
        """Return the bytes of a file of the manifest, or of "tileset.json", checked against their size and hash.

        FormatError for a file that is missing or differs; the message names it.
        """
        if check.text("name", name) not in self._file_entries:
            raise ValueError(f"name: expected a file of the manifest, got {check.shortened(name)}")
        if name not in self._contents:
            self._contents[name] = self._read_again(name)
        return self._contents[name]

    def verify(self) -> None:
        """Read every file again and check its size and hash; FormatError that names the first wrong one."""
        for name in self._file_entries:
            self._read_again(name)

    def map(self, ring: int) -> EnvMap:
        """Return a client's map of the scene beyond a ring, 0 to n; rings from 1 on have range too.

        FormatError for files that are missing or damaged.
        """
        number = check.integer("ring", ring, 0, self.count)
        maps = [entry["map"] for entry in self._rings[: number + 1]]
        color, ranges = decode_map(maps, self._layout, self._decode_file)
        return EnvMap(self.center, color=color, range=ranges)

    def at(self, ring: int, radius: float | None = None, strength: float = 1.0) -> ReducedScene:
        """Return the scene of a client that has all rings up to `ring`, at a state of the morph's growth.

        Returns a scene for `nearfar.render`; its dynamic objects can be posed. Static objects of ring i are called
        "ring i". FormatError for files that are missing or damaged.

        Parameters
        ----------
        ring
            0 to n. The geometry of rings up to this one is drawn in front of its map.
        radius
            Radius R of the morph in metres, from 0, where everything is shown as the centre sees it, to the ring's own
            radius, the default. In a client that has received ring i, R grows from the radius of ring i − 1.
        strength
            Strength of the morph, from 0, where everything is shown as the centre sees it, to 1. In a client it grows
            once, from 0 to 1, after ring 1 has arrived. `growth` has the times of both.
        """
        number = check.integer("ring", ring, 0, self.count)
        max_radius = self.radii[max(number, 1) - 1]
        full = max_radius if number else 0.0
        morph_radius = full if radius is None else check.in_range("radius", radius, 0.0, max_radius)
        share = check.in_range("strength", strength, 0.0, 1.0)
        rings = [
            (f"ring {n}", ring_scene(name, entry["parts"], self.read, self._location_of(name)))
            for n, entry in enumerate(self._rings[1 : number + 1], 1)
            if (name := entry["geometry"]) is not None
        ]
        scene = join_rings(self._moving, rings)
        zones = partition(scene, center=self.center, r1=NEAR_SHARE * max_radius, r2=max_radius)
        counts = {**zones.summary(), "triangles": self._manifest["triangles"], "rays": 0}
        settings: dict[str, Any] = {"morph": "cylinder", "boundary": "r2", "counts": counts, "is_whole": False}
        return ReducedScene(scene, zones, self.map(number), **settings).with_growth(morph_radius, share)

    def show(
        self, *, size: tuple[int, int] = (640, 400), camera: Camera | None = None, strategy: Strategy = "clovr"
    ) -> View:
        """Show the bundle in a notebook, as `nearfar.ReducedScene.show` shows a reduced scene.

        `strategy` is "clovr": rings that arrive fade in, and the morph grows; "clovrd": rings are shown at once; or
        "vis0" or "vis1", described in docs/view.md, which need `export(by_footprint=True)`.
        """
        return make_view(self, center=self.center, size=size, camera=camera, strategy=strategy)

    @cached_property
    def _layout(self) -> Layout:
        return layout_of(self._manifest, self._region)

    @cached_property
    def _moving(self) -> Any:
        entry = self._manifest["dynamic"]
        return None if entry is None else moving_scene(entry, self.read, self._location_of(entry["geometry"]))

    def _read_again(self, name: str) -> bytes:
        location = self._reader.location
        try:
            data = self._reader.read(name)
        except FileNotFoundError:
            raise _store.missing_error(location, name) from None
        return _store.verify(location, name, data, self._file_entries[name])

    def _decode_file(self, name: str, decode: Callable[[bytes], Any]) -> Any:
        data = self.read(name)
        with formats.guarded(self._location_of(name)):
            return decode(data)

    def _location_of(self, name: str) -> str:
        return f"{self._reader.location}/{name}"

    @card.repr_html
    def _repr_html_(self) -> str:
        facts = [("region", f"{self.number} of {len(self.centers)}"), ("centre", card.point(self.center))]
        facts.append(("bytes of all", f"{self.nbytes:,}"))
        if self.pixels_per_degree is not None:
            facts.append(("textures for", f"{self.pixels_per_degree:g} pixels a degree"))
        if self.split_px is not None:
            facts.append(("triangles split to", f"{self.split_px:g} px"))
        for number, row in enumerate(self.summary()):
            if row["dynamic"]:
                moving = self._manifest["dynamic"]["triangles"]
                facts.append(("dynamic objects", f"{moving:,} triangles, {row['dynamic']:,} bytes"))
            text = f"{row['triangles']:,} triangles, {row['geometry']:,} + {row['color']:,} + {row['range']:,} bytes"
            facts.append((f"ring {number}, to {row['radius']:g} m", text))
        facts += [("note", finding) for finding in self.findings]
        return card.page("Bundle", facts)

    def __repr__(self) -> str:
        region = f"region {self.number} of {len(self.centers)}, {count(self.count, 'ring')} to {self.radii[-1]:g} m"
        split = "" if self.split_px is None else f", split to {self.split_px:g} px"
        return f"Bundle({self._reader.location!r}: {region}{split}, {self.nbytes:,} bytes)"


def open(path: str | os.PathLike[str]) -> Bundle:  # noqa: A001
    """Open a bundle that `export` wrote; files are read and checked when they are needed.

    In a local folder all files must be present with the listed sizes. FormatError if the manifest is damaged or newer
    than this version, or if a file of a local folder is missing or has another size; the message names the file.
    ValueError for a URL with an unknown file system, and if fsspec or a package that it needs is missing. OSError if
    there is no manifest, or a server does not answer.

    Parameters
    ----------
    path
        The folder or its `manifest.json`; or a URL of either, which needs fsspec and its package for the URL's scheme:
        'fsspec[http]' for web servers, s3fs for ``s3://``.
    """
    reader = _store.reader(path)
    manifest = _manifest.read(reader)
    _store.check_presence(reader, _manifest.file_entries(manifest))
    return Bundle(reader, manifest)
