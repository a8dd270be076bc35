"""`nearfar export`: writes a scene as a bundle of plain files, which a client refines ring by ring."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Annotated

import typer

import nearfar as nf
from nearfar._base import check, formats
from nearfar.cli import _options as options
from nearfar.cli._options import option
from nearfar.cli._output import bytes_text, count, metres, note_rows, show
from nearfar.cli._viewpoint import choose

VERSION = 1


def export(
    scene: options.Input,
    output: Annotated[Path, option("-o --output", "FOLDER", "Folder to write; its parent must exist.")],
    center: options.Center = None,
    radii: Annotated[
        str | None,
        option("--radii", "R1,R2,...", "Radii of the rings in metres, ascending; chosen for the scene by default."),
    ] = None,
    face_size: options.FaceSize = None,
    samples: options.Samples = 4,
    quality: Annotated[int, option("--quality", "NUMBER", "Quality of the maps' pictures, 0 to 100.")] = 90,
    lossless: Annotated[bool, typer.Option("--lossless", help="Store the maps' pictures without loss.")] = False,
    up: options.Up = "y",
    scale: options.Scale = None,
    max_bytes: options.MaxBytes = None,
    on_invalid: options.Invalid = "raise",
    as_json: options.Json = False,
) -> None:
    """Write near geometry in rings about a centre, each with the map of what lies beyond it, as files for the web."""
    middle, chosen = options.read_point("--center", center), _read_radii(radii)
    loaded = options.open_scene(scene, up=up, on_invalid=on_invalid, scale=scale, max_bytes=max_bytes)
    place = choose(loaded, scene, middle)
    started = time.perf_counter()
    bundle = nf.stream.export(
        loaded,
        output,
        center=place.eye,
        radii=chosen,
        face_size=options.faces(face_size),
        samples=samples,
        quality=None if lossless else quality,
    )
    seconds = time.perf_counter() - started
    rings = bundle.summary()
    document = formats.header("export", VERSION) | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "findings": list(bundle.findings),
        "folder": str(output),
        "center": list(bundle.center),
        "triangles": loaded.triangle_count,
        "bytes": bundle.nbytes,
        "rings": rings,
        "seconds": round(seconds, 3),
    }
    rows = [
        ("centre", metres(bundle.center)),
        ("folder", f"{output}, {bytes_text(bundle.nbytes)}"),
        *((_title(number, ring["radius"]), _text(ring)) for number, ring in enumerate(rings)),
        ("exported in", f"{seconds:.2f} s"),
        *note_rows(document),
    ]
    show(document, rows, title=scene, as_json=as_json)


def _read_radii(text: str | None) -> list[float] | None:
    if text is None:
        return None
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        got = check.shortened(text)
        raise ValueError(f"--radii: expected metres such as 10,22,63, got {got}") from None


def _title(number: int, radius: float) -> str:
    return "first picture" if number == 0 else f"ring {number}, to {radius:.3g} m"


def _text(ring: dict[str, float]) -> str:
    parts = [f"map {bytes_text(int(ring['color'] + ring['range']))}"]
    if ring["geometry"]:
        parts.insert(0, f"{count(int(ring['triangles']))} triangles {bytes_text(int(ring['geometry']))}")
    return ", ".join(parts)
