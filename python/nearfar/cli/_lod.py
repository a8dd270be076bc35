"""`nearfar lod`: levels of detail of one object, and the size from which on each is good enough."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import check, formats
from nearfar.cli import _options as options
from nearfar.cli._options import option
from nearfar.cli._output import bytes_text, check_target, count, note_rows, show

VERSION = 1

# Defaults of their fields are the defaults of the options.
Settings, Threshold = nf.lod.MeasureSettings, nf.lod.LodThreshold


def lod(
    scene: options.Input,
    output: Annotated[Path, option("-o --output", "FILE", "The model: .glb with its levels, or .json without.")],
    hmd: Annotated[
        str, option("--hmd", "NAME", "Headset that levels are measured for: a name or a .json file.")
    ] = "quest_2",
    ratios: Annotated[str | None, option("--ratios", "R,R,…", "Shares of the triangles, as in 0.5,0.2,0.05.")] = None,
    method: Annotated[str, option("--method", "fast|meshopt", "The simplifier: see nf.lod.simplify.")] = "fast",
    normals: Annotated[
        str, option("--normals", "keep|smooth|flat", "How levels are shaded: see nf.lod.simplify.")
    ] = "keep",
    views: Annotated[int, option("--views", "N", "Number of sides to look at levels from.")] = Settings.views,
    directions: Annotated[
        str, option("--directions", "even|published", "How they are spread: see nf.lod.MeasureSettings.")
    ] = Settings.directions,
    distances: Annotated[int, option("--distances", "N", "Number of sizes to measure levels at.")] = Settings.distances,
    k: Annotated[float, option("--k", "K", "Slope of the threshold.")] = Threshold.k,
    d: Annotated[float, option("--d", "D", "The threshold at 1/16 of the screen.")] = Threshold.d,
    threshold: Annotated[
        str, option("--threshold", "KIND", "Its formula: anchored, literal or normalized.")
    ] = Threshold.kind,
    all_levels: Annotated[bool, typer.Option("--all-levels", help="Write levels that are never shown, too.")] = False,
    backend: options.Backend = None,
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
    """Simplify an object, measure the SSIM of each level over its size, and write the model with sizes to switch at."""
    options.check_backend(backend)
    check_target(output, ".glb", ".json")
    device = options.headset(hmd)
    shares = None if ratios is None else read_ratios(ratios)
    parts = options.parts_of(tile_error, tile_triangles, tile_origin, city_lod, city_height)
    loaded = options.open_scene(
        scene, up=up, on_invalid=on_invalid, scale=scale, max_bytes=max_bytes, blend=blend, parts=parts
    )
    started = time.perf_counter()
    name = Path(scene.partition(":")[0]).stem
    shaped: dict[str, Any] = {"method": method, "normals": normals} | ({} if shares is None else {"ratios": shares})
    levels = nf.lod.simplify(loaded, name=name, **shaped)
    simplified = time.perf_counter()
    sides: dict[str, Any] = {"views": views, "directions": directions, "distances": distances}
    model = nf.lod.measure(levels, hmd=device, backend=backend, **sides)
    seconds = {"simplify": simplified - started, "measure": time.perf_counter() - simplified}
    seen: dict[str, Any] = {"view": device, "k": k, "d": d, "threshold": threshold}
    model.export(output, all_levels=all_levels, **seen)
    switches = nf.lod.switches(model, **seen)
    written = np.ones(len(model), bool) if all_levels else switches.is_ever_shown
    document = describe(model, switches, written) | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "file": str(output),
        "bytes": output.stat().st_size,
        "hmd": device.name,
        "seconds": {step: round(value, 3) for step, value in seconds.items()},
    }
    rows = [
        *((f"level {number}", _text(level)) for number, level in enumerate(document["levels"])),
        ("headset", device.name),
        ("file", f"{output}, {bytes_text(document['bytes'])}"),
        *((step, f"{value:.2f} s") for step, value in seconds.items()),
        *note_rows(document),
    ]
    show(document, rows, title=scene, as_json=as_json)


def read_ratios(text: str) -> list[float]:
    """Parse a list of numbers such as "0.5,0.2"."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise ValueError(f"--ratios: expected numbers such as 0.5,0.2,0.05, got {check.shortened(text)}") from None


def describe(model: nf.lod.LodModel, switches: nf.lod.Switches, written: NDArray[np.bool_]) -> dict[str, Any]:
    """Return the document of a model's levels; `written` (K,) marks those in the file; schema "levels"."""
    statuses = [None, *model.curves.status.tolist()]
    never = switches.solid_angle == 0
    geometry = model.levels or ()
    return formats.header("levels", VERSION) | {
        "name": model.name,
        "radius": float(model.radius),
        "levels": [
            {
                "triangles": int(model.triangles[number]),
                "error": float(model.errors[number]),
                "note": geometry[number].note if geometry else "",
                "curve": statuses[number],
                "solid_angle": float(switches.solid_angle[number]),
                "screen_coverage": float(switches.screen_coverage[number]),
                "shown": bool(switches.is_ever_shown[number]),
                "written": bool(written[number]),
                "limit_of_measurement": bool(switches.is_limit[number]),
                "distance": None if never[number] else float(switches.distance[number] * model.radius),
            }
            for number in range(len(model))
        ],
        "screen_coverage": switches.of_levels(np.flatnonzero(written)).coverages(),
    }


def _text(level: dict[str, Any]) -> str:
    parts = [f"{count(level['triangles'])} triangles", f"error {level['error']:.3g} m"]
    if level["curve"] is not None:
        where = "never" if level["distance"] is None else f"from {level['distance']:.3g} m on"
        share = f"{level['screen_coverage']:.2%} of the picture"
        if level["limit_of_measurement"]:
            where, share = f"at all sizes measured, {where}", f"{share}; larger is beyond what was measured"
        parts.append(f"good enough {where} ({share})")
    if not level["shown"]:
        parts.append("never shown" + ("" if level["written"] else ", left out of the file"))
    return ", ".join(parts) + (f"; {level['note']}" if level["note"] else "")
