"""`nearfar demo`: the main job from end to end, into one folder."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import check, files, formats
from nearfar._trace.viewpoint import Place, ahead, choose, open_direction, walk
from nearfar.cli import _report
from nearfar.cli._options import (
    Backend,
    Center,
    FaceSize,
    Inner,
    Invalid,
    Json,
    Outer,
    Point,
    Samples,
    Size,
    Up,
    check_backend,
    open_scene,
    read_point,
    read_size,
)
from nearfar.cli._output import Clock, bytes_text, count, metres, show
from nearfar.cli._partition import curve_points
from nearfar.cli._render import camera

VERSION = 1

VISIBLE = 8
"""Levels of 255 from which a pixel counts as different from the truth."""


def demo(
    output: Annotated[Path, typer.Option("-o", "--output", metavar="FOLDER", help="Folder to write.")] = Path(
        "out/demo"
    ),
    scene: Annotated[
        str, typer.Option("-i", "--input", metavar="SCENE", help="Scene file; by default the procedural city.")
    ] = "city",
    center: Center = None,
    r1: Inner = 30.0,
    r2: Outer = 50.0,
    face_size: FaceSize = 1024,
    size: Size = "960x600",
    samples: Samples = 4,
    backend: Backend = "auto",
    up: Up = "y",
    on_invalid: Invalid = "raise",
    as_json: Json = False,
) -> None:
    """Make a scene light: pictures of truth, conventional and continuous, the load curve, and a report."""
    check.radii(r1, r2)
    check_backend(backend)
    clock, pixels, middle = Clock(), read_size("--size", size), read_point("--center", center)
    output.parent.mkdir(parents=True, exist_ok=True)
    with files.atomic_folder(output, marker="report.json") as folder:
        with clock.step("scene"):
            loaded = open_scene(scene, up=up, on_invalid=on_invalid)
        with clock.step("place"):
            place = Place(middle, open_direction(loaded, middle)) if middle else choose(loaded, scene)
            user = walk(loaded, place, 0.4 * (r2 - r1))
        view = camera(loaded, user, ahead(user, place.forward), 90.0, pixels)
        with clock.step("load curve"):
            curve = nf.load_curve(loaded, center=place.eye)
        pictures, reduced = render_all(loaded, view, place.eye, r1, r2, face_size, samples, clock, backend)
        with clock.step("pictures"):
            _report.save_pictures(folder, pictures)
            plotted = _report.save_curve(folder, curve, r2)
        document = describe(loaded, scene, reduced, pictures, clock) | {
            "center": list(place.eye),
            "user": list(user),
            "r1": r1,
            "r2": r2,
            "face_size": face_size,
            "samples": samples,
            "size": list(pixels),
            "load_curve": curve_points(curve),
            "files": [*sorted(path.name for path in folder.iterdir()), "report.json", "report.md"],
        }
        _report.save(folder, document)
    rows = [
        ("triangles", f"{count(document['triangles'])} → {count(document['triangles_left'])}"),
        ("centre", metres(place.eye)),
        ("map", bytes_text(document["map_bytes"])),
        *((f"{name} differs in", f"{100 * p['share']:.2f} % of pixels") for name, p in document["pictures"].items()),
        ("took", f"{sum(clock.seconds.values()):.1f} s"),
        ("written to", str(output)),
    ]
    if not plotted:
        typer.echo("nearfar: left load_curve.png out, because matplotlib is not installed", err=True)
    show(document, rows, title=scene, as_json=as_json)


def render_all(
    scene: nf.Scene,
    view: nf.Camera,
    center: Point,
    r1: float,
    r2: float,
    face_size: int,
    samples: int,
    clock: Clock,
    backend: str,
) -> tuple[dict[str, NDArray[np.uint8]], nf.ReducedScene]:
    """Pictures of the truth, the conventional and the continuous method from the same eye, and the reduced scene."""
    with clock.step("truth"):
        truth = nf.render(scene, view, samples=samples, channels=("color",), backend=backend)
        pictures = {"truth": truth.to_image()}
    with clock.step("reduce"):
        reduced = nf.reduce(scene, center=center, r1=r1, r2=r2, face_size=face_size, samples=samples, backend=backend)
    # Both methods show the same map: it is baked once.
    conventional = reduced.with_morph("none")
    for name, light in (("conventional", conventional), ("continuous", reduced)):
        with clock.step(name):
            pictures[name] = light.render(view, samples=samples, channels=("color",)).to_image()
    return pictures, reduced


def describe(
    scene: nf.Scene, source: str, reduced: nf.ReducedScene, pictures: dict[str, NDArray[np.uint8]], clock: Clock
) -> dict[str, Any]:
    """Document of a demo; schema "report", less the settings."""
    left = int(reduced.stats["drawn"])
    return formats.header("report", VERSION, origin=[float(v) for v in scene.origin], color_space="sRGB") | {
        "source": source,
        "triangles": int(scene.triangle_count),
        "triangles_left": left,
        "map_bytes": int(reduced.stats["map_bytes"]),
        "pictures": {name: difference(pictures["truth"], pictures[name]) for name in ("conventional", "continuous")},
        "seconds": clock.seconds,
    }


def difference(reference: NDArray[np.uint8], test: NDArray[np.uint8]) -> dict[str, float | int]:
    """How far a picture is from the reference, both sRGB of 8 bits."""
    error = np.abs(reference.astype(np.int16) - test)
    pixels = int((error.max(axis=-1) >= VISIBLE).sum())
    rmse = float(np.sqrt(np.mean(error.astype(np.float64) ** 2)) / 255.0)
    return {"pixels": pixels, "share": round(pixels / error[..., 0].size, 6), "rmse": round(rmse, 6)}
