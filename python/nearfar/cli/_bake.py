"""`nearfar bake`: bakes the part of a scene beyond r2 into an environment map."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Annotated

import typer

import nearfar as nf
from nearfar._base import formats
from nearfar.cli import _options as options
from nearfar.cli._options import option
from nearfar.cli._output import bytes_text, check_target, count, metres, note_rows, show
from nearfar.cli._scenes import SceneOptions, open_scene
from nearfar.cli._viewpoint import choose

VERSION = 1


def bake(
    *,
    scene: options.Input,
    output: Annotated[Path, option("-o --output", "FILE", "Map file to write, .exr.")],
    zones: options.MapOptions,
    samples: options.Samples = 1,
    with_range: options.WithRange = False,
    with_ids: Annotated[bool, typer.Option("--object-id", help="Bake object numbers too.")] = False,
    equirectangular: Annotated[
        Path | None,
        option("--equirectangular", "FILE", "Also write the map as one equirectangular picture, .exr or .png."),
    ] = None,
    backend: options.Backend = None,
    file: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Bake the static part of a scene beyond r2 into a cube map seen from the centre."""
    options.check_backend(backend)
    check_target(output, ".exr")
    if equirectangular is not None:
        check_target(equirectangular, ".exr", ".png")
    loaded = open_scene(scene, file.loading)
    place = choose(loaded, scene, zones.point)
    radii = zones.choose_radii(loaded, place)
    channels = ("color", *(("range",) if with_range else ()), *(("object_id",) if with_ids else ()))
    started = time.perf_counter()
    reduced = nf.reduce(
        loaded,
        center=place.eye,
        r1=radii.r1,
        r2=radii.r2,
        face_size=zones.texels,
        samples=samples,
        channels=channels,
        morph="none",
        backend=backend,
    )
    seconds = time.perf_counter() - started
    if reduced.env is None:
        raise ValueError(f"r2: expected less, there is nothing beyond {radii.r2:g} m to bake")
    reduced.env.save(output)
    if equirectangular is not None:
        reduced.env.save_equirectangular(equirectangular)
    document = formats.header("bake", VERSION, color_space="linear") | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "file": str(output),
        "center": list(place.eye),
        "r2": radii.r2,
        "face_size": reduced.env.face_size,
        "channels": list(reduced.env.channels),
        "bytes": output.stat().st_size,
        "triangles_left": int(reduced.stats["drawn"]),
        "seconds": round(seconds, 3),
    }
    rows = [
        ("centre", metres(place.eye)),
        ("beyond", f"{radii.r2:g} m"),
        ("map", f"6 × {reduced.env.face_size}², {', '.join(reduced.env.channels)}"),
        ("file", f"{output}, {bytes_text(document['bytes'])}"),
        ("triangles left", count(document["triangles_left"])),
        ("baked in", f"{seconds:.2f} s"),
        *note_rows(document),
    ]
    show(document, rows, title=scene, as_json=as_json)
