"""`nearfar export`: writes a scene as a bundle of plain files, which a client refines ring by ring."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import nearfar as nf
from nearfar._base import formats
from nearfar.cli import _options as options
from nearfar.cli._groups import Options, flag, option
from nearfar.cli._output import Clock, bytes_text, count, metres, note_rows, show
from nearfar.cli._scenes import SceneOptions, open_scene
from nearfar.cli._viewpoint import choose
from nearfar.stream import _store
from nearfar.stream._manifest import FORMAT

VERSION = 1


@dataclass(frozen=True, kw_only=True)
class RegionOptions(Options):
    """Centres of the regions."""

    center: list[str] | None = option(
        None,
        "X,Y,Z",
        "Centre O in metres; repeat the option for further regions, which share equal files. By default one "
        "centre 1.7 m above open ground near the scene's middle, or in front of an object.",
        "-c --center",
    )
    grid: float | None = option(
        None, "METRES", "Spacing of a horizontal grid to which centres move; centres at one point are merged."
    )

    @cached_property
    def points(self) -> list[options.Point]:
        """The centres; empty for the default centre."""
        points = (options.read_point("--center", text) for text in self.center or ())
        return [point for point in points if point is not None]


@dataclass(frozen=True, kw_only=True)
class BundleOptions(options.RingOptions):
    """Rings of a region, and how their pictures and geometry are stored."""

    quality: int | None = option(None, "0-100", "Quality of the pictures of maps and textures; 90 by default.")
    lossless: bool = flag("--lossless", "Store the pictures of maps and textures without loss.")
    pixels_per_degree: float = option(
        25.0, "NUMBER", "Pixels per degree of the client's display, to which textures are halved; 0 keeps their size."
    )
    split_px: float | None = option(
        None,
        "PIXELS",
        "Maximum error in pixels of the display, for clients that morph only vertices: triangles with a larger "
        "error are split. By default none is split.",
        "--split",
    )
    by_footprint: bool = flag(
        "--by-footprint", "Also write near objects in the order of their footprints, for the strategies vis0 and vis1."
    )

    @cached_property
    def settings(self) -> nf.stream.ExportSettings:
        if self.lossless and self.quality is not None:
            raise ValueError(f"quality: expected none with --lossless, got {self.quality}")
        return nf.stream.ExportSettings(
            face_size=self.face_size,
            samples=self.samples,
            quality=None if self.lossless else 90 if self.quality is None else self.quality,
            pixels_per_degree=self.pixels_per_degree or None,
            split_px=self.split_px,
            by_footprint=self.by_footprint,
        )


def export(
    *,
    scene: options.Input,
    output: str = option(
        ...,
        "FOLDER",
        "Folder to write, whose parent must exist; or a URL that fsspec can write, such as s3://bucket/city.",
        "-o --output",
    ),
    regions: RegionOptions,
    content: BundleOptions,
    scene_options: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Write near geometry in rings about centres, each with a map of the scene beyond it, as files for the web."""
    _store.check_target(output, f"nearfar.{FORMAT}")
    loaded, clock = open_scene(scene, scene_options.loading), Clock()
    with clock.step("export"):
        bundle = nf.stream.export(
            loaded,
            output,
            center=regions.points or choose(loaded, scene).eye,
            grid=regions.grid,
            radii=content.metres,
            settings=content.settings,
        )
    document = formats.header("export", VERSION) | {
        "source": scene,
        "folder": output,
        **describe(bundle),
        "seconds": clock.seconds["export"],
    }
    rows = [
        ("folder", f"{output}, {bytes_text(bundle.nbytes)}"),
        *content_rows(bundle),
        ("exported in", f"{document['seconds']:.2f} s"),
        *note_rows(document),
    ]
    show(document, rows, title=scene, as_json=as_json)


def describe(bundle: nf.stream.Bundle) -> dict[str, Any]:
    """Return the part of the document that describes a bundle."""
    regions = _regions(bundle)
    return {
        "notes": list(bundle.notes),
        "findings": list(dict.fromkeys(finding for region in regions for finding in region.findings)),
        "triangles": bundle.triangle_count,
        "bytes": bundle.nbytes,
        "regions": [
            {
                "center": list(region.center),
                "fold_margin": float(region.fold_margins[number]),
                "neighbours": list(region.neighbours(number)),
                "rings": region.summary(),
            }
            for number, region in enumerate(regions)
        ],
    }


def content_rows(bundle: nf.stream.Bundle) -> list[tuple[str, str]]:
    """Return table rows for the regions and rings of a bundle."""
    return [row for region in _regions(bundle) for row in _rows(region)]


def _regions(bundle: nf.stream.Bundle) -> list[nf.stream.Bundle]:
    return [bundle.region(number) for number in range(len(bundle.centers))]


def _rows(region: nf.stream.Bundle) -> list[tuple[str, str]]:
    first, *rings = region.summary()
    return [
        ("centre", metres(region.center)),
        ("first picture", _ring_text(first)),
        *((f"ring {number}, to {ring['radius']:.3g} m", _ring_text(ring)) for number, ring in enumerate(rings, 1)),
    ]


def _ring_text(ring: dict[str, float]) -> str:
    parts = [f"map {bytes_text(int(ring['color'] + ring['range']))}"]
    if ring["geometry"]:
        parts.insert(0, f"{count(int(ring['triangles']))} triangles {bytes_text(int(ring['geometry']))}")
    if ring["dynamic"]:
        parts.append(f"dynamic objects {bytes_text(int(ring['dynamic']))}")
    return ", ".join(parts)
