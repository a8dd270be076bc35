"""`nearfar partition`: counts the triangles that remain geometry."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import typer

import nearfar as nf
from nearfar._base import check, formats
from nearfar._reduce.default_radii import Choice
from nearfar.cli import _options as options
from nearfar.cli._groups import option
from nearfar.cli._output import check_target, count, metres, note_rows, radii_rows, show
from nearfar.cli._scenes import SceneOptions, open_scene
from nearfar.cli._viewpoint import choose

VERSION = 1

CURVE_RADII = (20.0, 30.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0)
"""Radii of the listed points of the load curve, metres."""

MIN_COUNTS = 3
"""Least number of different triangle counts at these radii; with fewer, the list has other radii."""

ROWS = {
    "triangles": "triangles",
    "near": "near, within r1",
    "intermediate": "intermediate, between r1 and r2",
    "far": "far, beyond r2",
    "nsf": "drawn as geometry (near, intermediate, moving)",
    "sf": "baked into the map (reach beyond r2)",
    "straddling": "of these in both (they cross r2)",
    "nsf_at_r1": "drawn as geometry if it ended at r1",
}
"""Labels of the triangle counts."""


def partition(
    *,
    scene: options.Input,
    zones: options.ZoneOptions,
    scene_options: SceneOptions,
    output: Path | None = option(None, "FILE", "Also write the JSON document to a file.", "-o --output"),
    max_triangles: int | None = option(None, "N", "Exit with status 1 if more than N triangles stay geometry."),
    as_json: options.Json = False,
) -> None:
    """Count the triangles that stay geometry, at these radii and along the load curve."""
    if max_triangles is not None:
        check.integer("--max-triangles", max_triangles, 0, 2**63 - 1)
    if output:
        check_target(output, ".json")
    loaded = open_scene(scene, scene_options.loading)
    viewpoint = choose(loaded, scene, zones.point)
    document = describe(loaded, scene, viewpoint.eye, zones.choose_radii(loaded, viewpoint))
    if output:
        formats.write_json(output, document)
    rows = [
        ("centre", metres(viewpoint.eye)),
        *radii_rows(document),
        *((label, count(document["summary"][key])) for key, label in ROWS.items()),
        *((f"within {entry['radius']:g} m", count(entry["triangles"])) for entry in document["load_curve"]),
        *note_rows(document),
    ]
    show(document, rows, title=scene, as_json=as_json)
    nsf = document["summary"]["nsf"]
    if max_triangles is not None and nsf > max_triangles:
        typer.echo(f"nearfar: expected at most {count(max_triangles)} triangles near, got {count(nsf)}", err=True)
        raise typer.Exit(1)


def describe(scene: nf.Scene, source: str, center: options.Point, radii: Choice) -> dict[str, Any]:
    """Return the document of a partition; schema "partition"."""
    parts = nf.partition(scene, center=center, r1=radii.r1, r2=radii.r2)
    curve = nf.load_curve(scene, center=center)
    return formats.header("partition", VERSION, origin=scene.origin.tolist()) | {
        "source": source,
        "notes": list(scene.report.notes),
        "center": list(center),
        "r1": radii.r1,
        "r2": radii.r2,
        "radii_reason": radii.reason,
        "summary": parts.summary(),
        "load_curve": curve_points(curve),
    }


def curve_points(curve: nf.LoadCurve) -> list[dict[str, float | int]]:
    """Return points of a load curve, at `CURVE_RADII`, or in equal steps if most of these would have equal counts."""
    farthest = curve._farthest()
    steps = [float(f"{farthest * step / len(CURVE_RADII):.3g}") for step in range(1, len(CURVE_RADII) + 1)]
    has_few = len({int(curve.count(radius)) for radius in CURVE_RADII}) < MIN_COUNTS
    radii = steps if has_few else CURVE_RADII
    return [{"radius": radius, "triangles": int(curve.count(radius))} for radius in radii]
