"""`nearfar bake`: bakes the part of a scene beyond r2 into an environment map."""

from __future__ import annotations

from pathlib import Path

import nearfar as nf
from nearfar._base import formats
from nearfar.cli import _options as options
from nearfar.cli._groups import flag, option
from nearfar.cli._output import Clock, bytes_text, check_target, count, metres, note_rows, show
from nearfar.cli._scenes import SceneOptions, open_scene
from nearfar.cli._viewpoint import choose

VERSION = 1


def bake(
    *,
    scene: options.Input,
    output: Path = option(..., "FILE", "Map file to write, .exr.", "-o --output"),
    zones: options.MapOptions,
    samples: options.Samples = 4,
    with_range: options.WithRange = False,
    with_ids: bool = flag("--object-id", "Bake object numbers too."),
    equirectangular: Path | None = option(None, "FILE", "Also write the equirectangular map, .exr or .png."),
    backend: options.Backend = None,
    scene_options: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Bake the static part of a scene beyond r2 into a cube map seen from the centre."""
    check_target(output, ".exr")
    if equirectangular is not None:
        check_target(equirectangular, ".exr", ".png")
    loaded = open_scene(scene, scene_options.loading)
    viewpoint = choose(loaded, scene, zones.point)
    radii = zones.choose_radii(loaded, viewpoint)
    channels = ("color", *(("range",) if with_range else ()), *(("object_id",) if with_ids else ()))
    clock = Clock()
    with clock.step("bake"):
        reduced = nf.reduce(
            loaded,
            center=viewpoint.eye,
            r1=radii.r1,
            r2=radii.r2,
            face_size=zones.face_size,
            samples=samples,
            channels=channels,
            morph="none",
            backend=backend,
        )
    if reduced.env is None:
        raise ValueError(f"r2: expected less, there is nothing beyond {radii.r2:g} m to bake")
    reduced.env.save(output)
    if equirectangular is not None:
        reduced.env.save_equirectangular(equirectangular)
    document = formats.header("bake", VERSION, color_space="linear") | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "file": str(output),
        "center": list(viewpoint.eye),
        "r2": radii.r2,
        "face_size": reduced.env.face_size,
        "channels": list(reduced.env.channels),
        "bytes": output.stat().st_size,
        "triangles_left": int(reduced.stats["drawn"]),
        "seconds": clock.seconds["bake"],
    }
    rows = [
        ("centre", metres(viewpoint.eye)),
        ("beyond", f"{radii.r2:g} m"),
        ("map", f"6 × {reduced.env.face_size}², {', '.join(reduced.env.channels)}"),
        ("file", f"{output}, {bytes_text(document['bytes'])}"),
        ("triangles left", count(document["triangles_left"])),
        ("baked in", f"{document['seconds']:.2f} s"),
        *note_rows(document),
    ]
    show(document, rows, title=scene, as_json=as_json)
