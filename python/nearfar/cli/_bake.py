"""`nearfar bake`: bakes the part of a scene beyond r2 into an environment map."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Annotated

import typer

import nearfar as nf
from nearfar._base import check, formats
from nearfar.cli import _options as options
from nearfar.cli._options import option
from nearfar.cli._output import bytes_text, check_target, count, metres, note_rows, show
from nearfar.cli._viewpoint import choose

VERSION = 1


def bake(
    scene: options.Input,
    output: Annotated[Path, option("-o --output", "FILE", "Map file to write, .exr.")],
    center: options.Center = None,
    r1: options.Inner = 30.0,
    r2: options.Outer = 50.0,
    face_size: options.FaceSize = 1024,
    samples: options.Samples = 1,
    with_range: Annotated[bool, typer.Option("--range", help="Bake range in metres too.")] = False,
    with_ids: Annotated[bool, typer.Option("--object-id", help="Bake object numbers too.")] = False,
    backend: options.Backend = "auto",
    up: options.Up = "y",
    scale: options.Scale = None,
    on_invalid: options.Invalid = "raise",
    as_json: options.Json = False,
) -> None:
    """Bake the static part of a scene beyond r2 into a cube map seen from the centre."""
    check.radii(r1, r2)
    options.check_backend(backend)
    middle = options.read_point("--center", center)
    check_target(output, ".exr")
    loaded = options.open_scene(scene, up=up, on_invalid=on_invalid, scale=scale)
    middle = middle or choose(loaded, scene).eye
    channels = ("color", *(("range",) if with_range else ()), *(("object_id",) if with_ids else ()))
    started = time.perf_counter()
    reduced = nf.reduce(
        loaded,
        center=middle,
        r1=r1,
        r2=r2,
        face_size=face_size,
        samples=samples,
        channels=channels,
        morph="none",
        backend=backend,
    )
    seconds = time.perf_counter() - started
    if reduced.env is None:
        raise ValueError(f"r2: expected less, there is nothing beyond {r2:g} m to bake")
    reduced.env.save(output)
    document = formats.header("bake", VERSION, color_space="linear") | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "file": str(output),
        "center": list(middle),
        "r2": r2,
        "face_size": face_size,
        "channels": list(reduced.env.channels),
        "bytes": output.stat().st_size,
        "triangles_left": int(reduced.stats["drawn"]),
        "seconds": round(seconds, 3),
    }
    rows = [
        ("centre", metres(middle)),
        ("beyond", f"{r2:g} m"),
        ("map", f"6 × {face_size} × {face_size}, {', '.join(reduced.env.channels)}"),
        ("file", f"{output}, {bytes_text(document['bytes'])}"),
        ("triangles left", count(document["triangles_left"])),
        ("baked in", f"{seconds:.2f} s"),
        *note_rows(document["notes"]),
    ]
    show(document, rows, title=scene, as_json=as_json)
