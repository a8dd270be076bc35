"""`nearfar reduce`: reduces a scene to a folder for thin clients and writes a report; `nearfar demo`."""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import Any

import numpy as np
import typer
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import check, files, formats
from nearfar._metrics.comparison import visible_difference
from nearfar._trace import viewpoint
from nearfar.cli import _options as options
from nearfar.cli import _report_page
from nearfar.cli._methods import METHODS, render_all
from nearfar.cli._output import Clock, bytes_text, count, metres, note_rows, show
from nearfar.cli._partition import curve_points
from nearfar.cli._render import camera
from nearfar.cli._viewpoint import choose

VERSION = 1

ASIDE = 0.4
"""Distance of the pictures' user U from O as a share of r2 − r1; the picture does not fold there."""


def reduce(
    scene: options.Input,
    output: options.Folder,
    center: options.Center = None,
    r1: options.Inner = 30.0,
    r2: options.Outer = 50.0,
    face_size: options.FaceSize = 1024,
    size: options.Size = "960x600",
    samples: options.Samples = 4,
    backend: options.Backend = "auto",
    up: options.Up = "y",
    scale: options.Scale = None,
    on_invalid: options.Invalid = "raise",
    as_json: options.Json = False,
) -> None:
    """Reduce a scene to near.glb, far.exr and reduced.json for a client, and write a report with pictures.

    The pictures show the truth, the conventional and the continuous method for a user beside the centre.
    `nearfar.ReducedScene.load` reads the folder.
    """
    check.radii(r1, r2)
    options.check_backend(backend)
    clock, pixels, middle = Clock(), options.read_size("--size", size), options.read_point("--center", center)
    output.parent.mkdir(parents=True, exist_ok=True)
    with files.atomic_folder(output, marker="reduced.json") as folder:
        with clock.step("scene"):
            loaded = options.open_scene(scene, up=up, on_invalid=on_invalid, scale=scale)
        with clock.step("place"):
            place = choose(loaded, scene, middle)
            user = viewpoint.beside(loaded, place, ASIDE * (r2 - r1))
        view = camera(loaded, user, viewpoint.ahead(user, place.forward), 90.0, pixels)
        with clock.step("load curve"):
            curve = nf.load_curve(loaded, center=place.eye)
        reduction = {"center": place.eye, "r1": r1, "r2": r2, "face_size": face_size, "samples": samples}
        pictures_of = {"samples": samples, "channels": ("color",)}
        frames, reduced = render_all(
            loaded, view, clock, pictures=pictures_of, reduction=reduction | {"backend": backend}
        )
        with clock.step("files"):
            reduced.save(folder)
        with clock.step("pictures"):
            pictures = {name: frame.to_image() for name, frame in frames.items()}
            _report_page.save_pictures(folder, pictures)
            plotted = _report_page.save_curve(folder, curve, r2)
        document = formats.header(
            "report", VERSION, origin=[float(value) for value in loaded.origin], color_space="sRGB"
        ) | {
            "source": scene,
            "unit_note": loaded.report.unit_note,
            "notes": list(loaded.report.notes),
            "triangles": int(loaded.triangle_count),
            "triangles_left": int(reduced.stats["drawn"]),
            "map_bytes": int(reduced.stats["map_bytes"]),
            "pictures": {name: _difference(pictures["truth"], pictures[name]) for name in METHODS},
            "seconds": clock.seconds,
            "center": list(place.eye),
            "user": list(user),
            "r1": r1,
            "r2": r2,
            "face_size": face_size,
            "samples": samples,
            "size": list(pixels),
            "load_curve": curve_points(curve),
            "files": sorted([*(path.name for path in folder.iterdir()), "report.json", "report.md"]),
        }
        _report_page.save(folder, document)
    if not plotted:
        typer.echo("nearfar: left load_curve.png out, because matplotlib is not installed", err=True)
    show(document, _rows(document, output), title=scene, as_json=as_json)


def demo(**settings: Any) -> None:
    """Reduce the procedural city or another scene: `nearfar reduce` with defaults for scene and folder."""
    reduce(**settings)


DEFAULTS = {"scene": "city", "output": Path("out/demo")}
"""Defaults of `demo`; all its other options are those of `reduce`."""
_options = [
    option.replace(default=DEFAULTS.get(name, option.default), kind=option.KEYWORD_ONLY)
    for name, option in inspect.signature(reduce, eval_str=True).parameters.items()
]
demo.__signature__ = inspect.Signature(_options)  # type: ignore[attr-defined]
demo.__annotations__ = reduce.__annotations__


def _difference(reference: NDArray[np.uint8], test: NDArray[np.uint8]) -> dict[str, float | int]:
    pixels, share, rmse = visible_difference(reference, test)
    return {"pixels": pixels, "share": round(share, 6), "rmse": round(rmse, 6)}


def _rows(document: dict[str, Any], output: Path) -> list[tuple[str, str]]:
    return [
        ("triangles", f"{count(document['triangles'])} → {count(document['triangles_left'])}"),
        ("centre", metres(document["center"])),
        ("map", bytes_text(document["map_bytes"])),
        *((f"{name} differs in", f"{100 * p['share']:.2f} % of pixels") for name, p in document["pictures"].items()),
        ("took", f"{sum(document['seconds'].values()):.1f} s"),
        ("written to", str(output)),
        *note_rows(document["notes"]),
    ]
