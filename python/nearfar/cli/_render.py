"""`nearfar render`: renders a picture of a scene or of its reduction."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Annotated

import nearfar as nf
from nearfar._base import check, formats
from nearfar._trace import viewpoint
from nearfar.cli import _options as options
from nearfar.cli._methods import METHODS
from nearfar.cli._options import option
from nearfar.cli._output import bytes_text, check_target, metres, show
from nearfar.cli._viewpoint import choose

VERSION = 1


def render(
    scene: options.Input,
    output: Annotated[Path, option("-o --output", "FILE", "Picture to write, .png or .exr.")],
    eye: Annotated[
        str | None, option("--eye", "X,Y,Z", "User's eye U in metres. By default over open ground in the middle.")
    ] = None,
    target: options.Target = None,
    fov: options.Degrees = 90.0,
    size: options.Size = "1280x720",
    samples: options.Samples = 4,
    method: Annotated[
        str, option("--method", "truth|continuous|conventional", "Full scene, or a method of near-far reduction.")
    ] = "truth",
    center: options.Center = None,
    r1: options.Inner = 30.0,
    r2: options.Outer = 50.0,
    face_size: options.FaceSize = 1024,
    backend: options.Backend = "auto",
    up: options.Up = "y",
    scale: options.Scale = None,
    on_invalid: options.Invalid = "raise",
    as_json: options.Json = False,
) -> None:
    """Render a scene from one eye to a PNG or EXR file."""
    check.radii(r1, r2)
    options.check_backend(backend)
    if method != "truth" and method not in METHODS:
        raise ValueError(f"--method: expected truth, continuous or conventional, got {method!r}")
    pixels, aim = options.read_size("--size", size), options.read_point("--target", target)
    user, middle = options.read_point("--eye", eye), options.read_point("--center", center)
    check_target(output, ".png", ".exr")
    loaded = options.open_scene(scene, up=up, on_invalid=on_invalid, scale=scale)
    place = choose(loaded, scene) if user is None or (middle is None and method != "truth") else None
    user = user or (place.eye if place else (0.0, 0.0, 0.0))
    view = camera(loaded, user, aim, fov, pixels)
    started = time.perf_counter()
    if method == "truth":
        channels = ("color", "range", "object_id") if output.suffix.lower() == ".exr" else ("color",)
        frame = nf.render(loaded, view, samples=samples, channels=channels, backend=backend)
    else:
        middle = middle or (place.eye if place else user)
        reduced = nf.reduce(
            loaded, center=middle, r1=r1, r2=r2, face_size=face_size, morph=METHODS[method], backend=backend
        )
        frame = reduced.render(view, samples=samples, channels=("color",))
    seconds = time.perf_counter() - started
    frame.save(output)
    document = formats.header("render", VERSION, color_space="sRGB" if output.suffix == ".png" else "linear") | {
        "source": scene,
        "file": str(output),
        "bytes": output.stat().st_size,
        "method": method,
        "eye": list(user),
        "size": list(pixels),
        "samples": samples,
        "seconds": round(seconds, 3),
    }
    rows = [
        ("eye", metres(user)),
        ("picture", f"{pixels[0]} × {pixels[1]}, {method}"),
        ("file", f"{output}, {bytes_text(document['bytes'])}"),
        ("rendered in", f"{seconds:.2f} s"),
    ]
    show(document, rows, title=scene, as_json=as_json)


def camera(
    scene: nf.Scene, eye: options.Point, target: options.Point | None, fov: float, size: tuple[int, int]
) -> nf.Camera:
    """Make a camera that looks at `target`, by default horizontally along the longest open view; `fov` in degrees."""
    if target is None:
        target = viewpoint.ahead(eye, viewpoint.open_direction(scene, eye), rise=0.0)
    if not 0.0 < fov < 180.0 or not math.isfinite(fov):
        raise ValueError(f"--fov: expected degrees between 0 and 180, got {fov:g}")
    width, height = size
    aspect = width / height if height > 0 else 1.0
    return nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(fov, max(aspect, 1e-9)), size=size)
