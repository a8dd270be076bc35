"""`nearfar compare`: compares conventional and continuous method with the truth and checks thresholds."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import typer

import nearfar as nf
from nearfar._base import check as checks
from nearfar._base import files, formats
from nearfar._trace import viewpoint
from nearfar.cli import _comparison_page, _report_page
from nearfar.cli import _options as options
from nearfar.cli._methods import METHODS, render_all
from nearfar.cli._options import option
from nearfar.cli._output import Clock, count, metres, note_rows, show
from nearfar.cli._partition import curve_points
from nearfar.cli._render import camera
from nearfar.cli._viewpoint import choose

VERSION = 1

BROKEN = 3
"""Exit status of a comparison that broke a threshold; 1 is an error, 2 a wrong command line."""


@dataclass(frozen=True)
class Threshold:
    """A limit for a measure of the continuous picture."""

    option: str
    measure: str
    limit: float
    least: bool
    """True if the limit is the least allowed value, False if it is the greatest."""

    def check(self, values: dict[str, Any]) -> dict[str, Any]:
        """Compare a value with the limit; a measure that the picture lacks (None) does not break it."""
        value = values[self.measure]
        holds = value is None or (value >= self.limit if self.least else value <= self.limit)
        return {
            "option": self.option,
            "measure": self.measure,
            "limit": self.limit,
            "value": value,
            "kept": bool(holds),
        }


def compare(
    scene: options.Input,
    output: options.Folder,
    center: options.Center = None,
    user: Annotated[
        str | None, option("--user", "X,Y,Z", "User's eye U in metres. By default beside the centre.")
    ] = None,
    distance: Annotated[float, option("--distance", "METRES", "Distance of U from O without --user.")] = 6.0,
    target: options.Target = None,
    fov: options.Degrees = 90.0,
    r1: options.Inner = 30.0,
    r2: options.Outer = 50.0,
    face_size: options.FaceSize = 1024,
    size: options.Size = "960x600",
    samples: options.Samples = 4,
    exact: Annotated[
        bool, typer.Option("--exact", help="Bend a ray for every pixel; trace the far part instead of using the map.")
    ] = False,
    min_psnr: Annotated[
        float | None, option("--min-psnr", "DB", "Least PSNR in decibels; exit status 3 below it.")
    ] = None,
    min_ssim: Annotated[float | None, option("--min-ssim", "VALUE", "Least SSIM; exit status 3 below it.")] = None,
    max_discontinuity: Annotated[
        float | None, option("--max-discontinuity", "VALUE", "Greatest mean discontinuity; exit status 3 above it.")
    ] = None,
    max_boundary: Annotated[
        float | None,
        option(
            "--max-boundary-discontinuity",
            "VALUE",
            "Greatest mean discontinuity along the boundary; exit status 3 above it.",
        ),
    ] = None,
    backend: options.Backend = "auto",
    up: options.Up = "y",
    scale: options.Scale = None,
    on_invalid: options.Invalid = "raise",
    as_json: options.Json = False,
) -> None:
    """Compare the conventional and the continuous method with the truth, seen from one eye.

    Thresholds apply to the continuous method; the exit status is 3 if one is broken.
    """
    checks.radii(r1, r2)
    options.check_backend(backend)
    thresholds = [
        Threshold(option, measure, checks.number(option, limit), least)
        for option, measure, limit, least in (
            ("--min-psnr", "psnr", min_psnr, True),
            ("--min-ssim", "ssim", min_ssim, True),
            ("--max-discontinuity", "discontinuity", max_discontinuity, False),
            ("--max-boundary-discontinuity", "boundary", max_boundary, False),
        )
        if limit is not None
    ]
    pixels, middle = options.read_size("--size", size), options.read_point("--center", center)
    eye, aim = options.read_point("--user", user), options.read_point("--target", target)
    away, clock = checks.positive("--distance", distance), Clock()
    output.parent.mkdir(parents=True, exist_ok=True)
    with files.atomic_folder(output, marker="compare.json") as folder:
        with clock.step("scene"):
            loaded = options.open_scene(scene, up=up, on_invalid=on_invalid, scale=scale)
        with clock.step("place"):
            place = choose(loaded, scene, middle)
            eye = eye or viewpoint.beside(loaded, place, away)
            view = camera(loaded, eye, aim or viewpoint.ahead(eye, place.forward), fov, pixels)
        with clock.step("load curve"):
            curve = nf.load_curve(loaded, center=place.eye)
        # The discontinuity of far pixels needs their scene points, which follow from the map's range.
        place_and_map = {"center": place.eye, "r1": r1, "r2": r2, "channels": ("color", "range")}
        frames, reduced = render_all(
            loaded,
            view,
            clock,
            pictures={"samples": samples, "channels": ("color", "position")},
            reduction=place_and_map | {"face_size": face_size, "backend": backend},
            drawing={"method": "exact", "env": False} if exact else None,
        )
        with clock.step("measures"):
            measured = {
                name: nf.compare(frames["truth"], frames[name], center=place.eye, radius=r2) for name in METHODS
            }
            values = {name: _document(comparison) for name, comparison in measured.items()}
        with clock.step("pictures"):
            _report_page.save_pictures(folder, {name: frame.to_image() for name, frame in frames.items()})
            plotted = _report_page.save_curve(folder, curve, r2)
            if plotted:
                _comparison_page.save_heat_maps(
                    folder, {name: comparison.torn for name, comparison in measured.items()}
                )
        margin = nf.fold_margin(eye, center=place.eye, r1=r1, r2=r2)
        checked = [threshold.check(values["continuous"]) for threshold in thresholds]
        document = formats.header("compare", VERSION, origin=[float(v) for v in loaded.origin], color_space="sRGB") | {
            "source": scene,
            "unit_note": loaded.report.unit_note,
            "notes": list(loaded.report.notes),
            "triangles": int(loaded.triangle_count),
            "triangles_left": int(reduced.stats["drawn"]),
            "map_bytes": int(reduced.stats["map_bytes"]),
            "center": list(place.eye),
            "user": list(eye),
            "fold_margin": round(margin, 3) if math.isfinite(margin) else None,
            "r1": r1,
            "r2": r2,
            "face_size": face_size,
            "samples": samples,
            "size": list(pixels),
            "method": "exact" if exact else "vertex",
            "pictures": values,
            "thresholds": checked,
            "load_curve": curve_points(curve),
            "seconds": clock.seconds,
            "files": sorted([path.name for path in folder.iterdir()] + ["compare.json", "report.html", "report.md"]),
        }
        _comparison_page.save(folder, document)
    if not plotted:
        typer.echo("nearfar: left plots out, because matplotlib is not installed", err=True)
    show(document, _rows(document, output), title=scene, as_json=as_json)
    broken = [check for check in checked if not check["kept"]]
    for check in broken:
        sentence = f"{check['option']}: {check['measure']} is {check['value']:.4g}, the limit {check['limit']:.4g}"
        typer.echo(f"nearfar: {sentence}", err=True)
    if broken:
        raise typer.Exit(BROKEN)


def _document(measured: nf.Comparison) -> dict[str, Any]:
    """Rounded measures for the report, without the map of discontinuity."""
    return {
        "psnr": round(measured.psnr, 4) if math.isfinite(measured.psnr) else None,
        "ssim": round(measured.ssim, 6),
        "rmse": round(measured.rmse, 6),
        "discontinuity": _rounded(measured.discontinuity),
        "discontinuity_p99": _rounded(measured.discontinuity_p99),
        "boundary": _rounded(measured.boundary),
        "boundary_pixels": measured.boundary_pixels,
    }


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 6)


def _rows(document: dict[str, Any], output: Path) -> list[tuple[str, str]]:
    pictures = document["pictures"]
    both = [
        (label, " → ".join(_comparison_page.text(pictures[name][key]) for name in METHODS))
        for key, label in _comparison_page.MEASURES.items()
    ]
    return [
        ("triangles", f"{count(document['triangles'])} → {count(document['triangles_left'])}"),
        ("centre, user", f"{metres(document['center'])}; {metres(document['user'])}"),
        ("", "conventional → continuous"),
        *both,
        ("written to", str(output)),
        *note_rows(document["notes"]),
    ]
