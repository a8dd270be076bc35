"""`nearfar export`: writes a scene as a bundle of plain files, which a client refines ring by ring."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Annotated, Any

import typer

import nearfar as nf
from nearfar._base import formats
from nearfar.cli import _options as options
from nearfar.cli._options import option
from nearfar.cli._output import bytes_text, count, metres, note_rows, show
from nearfar.cli._viewpoint import choose

VERSION = 1


def export(
    scene: options.Input,
    output: Annotated[
        str,
        option(
            "-o --output",
            "FOLDER",
            "Folder to write, whose parent must exist; or a URL that fsspec can write, such as s3://bucket/city.",
        ),
    ],
    center: Annotated[
        list[str] | None,
        option(
            "-c --center",
            "X,Y,Z",
            "Centre O in metres; give it again for further regions, which share equal files. By default one 1.7 m "
            "above open ground near the scene's middle, or in front of an object.",
        ),
    ] = None,
    grid: Annotated[
        float | None,
        option("--grid", "METRES", "Spacing of a horizontal grid to which centres move; those that meet become one."),
    ] = None,
    radii: options.RingRadii = None,
    face_size: options.FaceSize = None,
    samples: options.Samples = 4,
    quality: Annotated[
        int, option("--quality", "NUMBER", "Quality of the pictures of maps and textures, 0 to 100.")
    ] = 90,
    lossless: Annotated[
        bool, typer.Option("--lossless", help="Store the pictures of maps and textures without loss.")
    ] = False,
    pixels_per_degree: Annotated[
        float,
        option(
            "--pixels-per-degree",
            "NUMBER",
            "Of the client's display: textures are halved while texels suffice for its pixels; 0 keeps them whole.",
        ),
    ] = 25.0,
    split: Annotated[
        float | None,
        option(
            "--split",
            "PIXELS",
            "Split large triangles for clients that move vertices, to this error of their display; by default none.",
        ),
    ] = None,
    by_footprint: Annotated[
        bool,
        typer.Option(
            "--by-footprint", help="Write near objects in the order of their footprints too, for vis0 and vis1."
        ),
    ] = False,
    up: options.Up = "y",
    scale: options.Scale = None,
    max_bytes: options.MaxBytes = None,
    blend: options.Blend = "opaque",
    tile_error: options.TileError = None,
    tile_triangles: options.TileTriangles = None,
    tile_origin: options.TileOrigin = None,
    city_lod: options.CityLod = None,
    city_height: options.CityHeight = None,
    on_invalid: options.Invalid = "raise",
    as_json: options.Json = False,
) -> None:
    """Write near geometry in rings about centres, each with the map of what lies beyond it, as files for the web."""
    centers, chosen = _read_centers(center), options.read_radii(radii)
    parts = options.parts_of(tile_error, tile_triangles, tile_origin, city_lod, city_height)
    loaded = options.open_scene(
        scene, up=up, on_invalid=on_invalid, scale=scale, max_bytes=max_bytes, blend=blend, parts=parts
    )
    started = time.perf_counter()
    with _options_named():
        bundle = nf.stream.export(
            loaded,
            output,
            center=centers or choose(loaded, scene).eye,
            grid=grid,
            radii=chosen,
            face_size=options.faces(face_size),
            samples=samples,
            quality=None if lossless else quality,
            pixels_per_degree=pixels_per_degree or None,
            split_px=split,
            by_footprint=by_footprint,
        )
    seconds = time.perf_counter() - started
    regions = [bundle.region(number) for number in range(len(bundle.centers))]
    document = formats.header("export", VERSION) | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "findings": list(dict.fromkeys(finding for region in regions for finding in region.findings)),
        "folder": output,
        "triangles": loaded.triangle_count,
        "bytes": bundle.nbytes,
        "regions": [_region_entry(region) for region in regions],
        "seconds": round(seconds, 3),
    }
    rows = [
        ("folder", f"{output}, {bytes_text(bundle.nbytes)}"),
        *(row for region in regions for row in _rows(region)),
        ("exported in", f"{seconds:.2f} s"),
        *note_rows(document),
    ]
    show(document, rows, title=scene, as_json=as_json)


@contextmanager
def _options_named() -> Iterator[None]:
    """Replace parameter names in errors by names of options."""
    try:
        yield
    except ValueError as error:
        text = str(error).replace("split_px", "--split").replace("pixels_per_degree", "--pixels-per-degree")
        if text == str(error):
            raise
        raise ValueError(text) from None


def _read_centers(texts: list[str] | None) -> list[options.Point]:
    points = (options.read_point("--center", text) for text in texts or ())
    return [point for point in points if point is not None]


def _region_entry(region: nf.stream.Bundle) -> dict[str, Any]:
    return {
        "center": list(region.center),
        "fold_margin": float(region.fold_margins[region.number]),
        "neighbours": list(region.neighbours(region.number)),
        "rings": region.summary(),
    }


def _rows(region: nf.stream.Bundle) -> list[tuple[str, str]]:
    """Return table rows for the centre of a region and its rings."""
    rings = [(_title(number, ring["radius"]), _text(ring)) for number, ring in enumerate(region.summary())]
    return [("centre", metres(region.center)), *rings]


def _title(number: int, radius: float) -> str:
    return "first picture" if number == 0 else f"ring {number}, to {radius:.3g} m"


def _text(ring: dict[str, float]) -> str:
    parts = [f"map {bytes_text(int(ring['color'] + ring['range']))}"]
    if ring["geometry"]:
        parts.insert(0, f"{count(int(ring['triangles']))} triangles {bytes_text(int(ring['geometry']))}")
    if ring["dynamic"]:
        parts.append(f"dynamic objects {bytes_text(int(ring['dynamic']))}")
    return ", ".join(parts)
