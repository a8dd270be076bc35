"""`nearfar export`: writes a scene as a bundle of plain files, which a client refines ring by ring."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any

import typer

import nearfar as nf
from nearfar._base import formats
from nearfar.cli import _options as options
from nearfar.cli._groups import Options
from nearfar.cli._options import option
from nearfar.cli._output import bytes_text, count, metres, note_rows, show
from nearfar.cli._scenes import SceneOptions, open_scene
from nearfar.cli._viewpoint import choose

VERSION = 1


@dataclass(frozen=True, kw_only=True)
class RegionOptions(Options):
    """Centres of the regions."""

    center: Annotated[
        list[str] | None,
        option(
            "-c --center",
            "X,Y,Z",
            "Centre O in metres; repeat the option for further regions, which share equal files. By default one "
            "centre 1.7 m above open ground near the scene's middle, or in front of an object.",
        ),
    ] = None
    grid: Annotated[
        float | None,
        option(
            "--grid",
            "METRES",
            "Spacing of a horizontal grid. Each centre moves to a point of the grid; centres at one point are merged.",
        ),
    ] = None

    @cached_property
    def points(self) -> list[options.Point]:
        """The centres; empty for the default centre."""
        points = (options.read_point("--center", text) for text in self.center or ())
        return [point for point in points if point is not None]


@dataclass(frozen=True, kw_only=True)
class EncodingOptions(Options):
    """How pictures and geometry are stored."""

    quality: Annotated[
        int, option("--quality", "NUMBER", "Quality of the pictures of maps and textures, 0 to 100.")
    ] = 90
    lossless: Annotated[
        bool, typer.Option("--lossless", help="Store the pictures of maps and textures without loss.")
    ] = False
    pixels_per_degree: Annotated[
        float,
        option(
            "--pixels-per-degree",
            "NUMBER",
            "Pixels per degree of the client's display, to which textures are reduced by halves; 0 keeps their size.",
        ),
    ] = 25.0
    split: Annotated[
        float | None,
        option(
            "--split",
            "PIXELS",
            "Maximum error in pixels of the display, for clients that morph only vertices: triangles with a larger "
            "error are split. By default none is split.",
        ),
    ] = None
    by_footprint: Annotated[
        bool,
        typer.Option(
            "--by-footprint",
            help="Also write near objects in the order of their footprints, for the strategies vis0 and vis1.",
        ),
    ] = False


def export(
    *,
    scene: options.Input,
    output: Annotated[
        str,
        option(
            "-o --output",
            "FOLDER",
            "Folder to write, whose parent must exist; or a URL that fsspec can write, such as s3://bucket/city.",
        ),
    ],
    regions: RegionOptions,
    rings: options.RingOptions,
    encoding: EncodingOptions,
    file: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Write near geometry in rings about centres, each with a map of the scene beyond it, as files for the web."""
    input_scene = open_scene(scene, file.loading)
    started = time.perf_counter()
    with _replace_parameter_names():
        bundle = nf.stream.export(
            input_scene,
            output,
            center=regions.points or choose(input_scene, scene).eye,
            grid=regions.grid,
            radii=rings.metres,
            face_size=rings.texels,
            samples=rings.samples,
            quality=None if encoding.lossless else encoding.quality,
            pixels_per_degree=encoding.pixels_per_degree or None,
            split_px=encoding.split,
            by_footprint=encoding.by_footprint,
        )
    seconds = time.perf_counter() - started
    exported = [bundle.region(number) for number in range(len(bundle.centers))]
    document = formats.header("export", VERSION) | {
        "source": scene,
        "notes": list(input_scene.report.notes),
        "findings": list(dict.fromkeys(finding for region in exported for finding in region.findings)),
        "folder": output,
        "triangles": input_scene.triangle_count,
        "bytes": bundle.nbytes,
        "regions": [_region_entry(region) for region in exported],
        "seconds": round(seconds, 3),
    }
    rows = [
        ("folder", f"{output}, {bytes_text(bundle.nbytes)}"),
        *(row for region in exported for row in _rows(region)),
        ("exported in", f"{seconds:.2f} s"),
        *note_rows(document),
    ]
    show(document, rows, title=scene, as_json=as_json)


@contextmanager
def _replace_parameter_names() -> Iterator[None]:
    """Replace parameter names in errors by names of options."""
    try:
        yield
    except ValueError as error:
        text = str(error).replace("split_px", "--split").replace("pixels_per_degree", "--pixels-per-degree")
        if text == str(error):
            raise
        raise ValueError(text) from None


def _region_entry(region: nf.stream.Bundle) -> dict[str, Any]:
    return {
        "center": list(region.center),
        "fold_margin": float(region.fold_margins[region.number]),
        "neighbours": list(region.neighbours(region.number)),
        "rings": region.summary(),
    }


def _rows(region: nf.stream.Bundle) -> list[tuple[str, str]]:
    """Return table rows for the centre of a region and its rings."""
    rings = [(_ring_title(number, ring["radius"]), _ring_text(ring)) for number, ring in enumerate(region.summary())]
    return [("centre", metres(region.center)), *rings]


def _ring_title(number: int, radius: float) -> str:
    return "first picture" if number == 0 else f"ring {number}, to {radius:.3g} m"


def _ring_text(ring: dict[str, float]) -> str:
    parts = [f"map {bytes_text(int(ring['color'] + ring['range']))}"]
    if ring["geometry"]:
        parts.insert(0, f"{count(int(ring['triangles']))} triangles {bytes_text(int(ring['geometry']))}")
    if ring["dynamic"]:
        parts.append(f"dynamic objects {bytes_text(int(ring['dynamic']))}")
    return ", ".join(parts)
