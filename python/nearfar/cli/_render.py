"""`nearfar render`: renders a picture of a scene or of its reduction, or one for each eye of a headset."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Annotated, Any

import nearfar as nf
from nearfar._base import check, files, formats
from nearfar._trace import viewpoint
from nearfar.cli import _options as options
from nearfar.cli._methods import METHODS
from nearfar.cli._options import option
from nearfar.cli._output import bytes_text, check_target, metres, note_rows, show
from nearfar.cli._viewpoint import choose

VERSION = 1


def render(
    scene: options.Input,
    output: Annotated[Path, option("-o --output", "FILE", "Picture to write, .png or .exr.")],
    eye: Annotated[
        str | None, option("--eye", "X,Y,Z", "User's eye U in metres. By default over open ground in the middle.")
    ] = None,
    target: options.Target = None,
    fov: Annotated[
        float | None, option("--fov", "DEGREES", "Horizontal field of view, 90 by default; a headset has its own.")
    ] = None,
    size: Annotated[
        str | None,
        option("--size", "WxH", "Pixels, 1280x720 by default; for a headset those of an eye, by default its own."),
    ] = None,
    samples: options.Samples = 4,
    method: Annotated[
        str, option("--method", "truth|continuous|conventional", "Full scene, or a method of near-far reduction.")
    ] = "truth",
    hmd: Annotated[
        str | None,
        option("--hmd", "NAME", "Render both eyes of a headset, a name or a .json file; --eye is then the head."),
    ] = None,
    lens: Annotated[
        str, option("--lens", "own|generic", "Lens that --hmd warps for: the headset's, if known, or a generic one.")
    ] = "own",
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
    """Render a scene from one eye to a PNG or EXR file, or from both eyes of a headset to PNG files.

    For FILE.png, --hmd writes the eyes side by side there, FILE_left.png and FILE_right.png, and, warped for the
    headset's lens, FILE_left_warped.png and FILE_right_warped.png.
    """
    check.radii(r1, r2)
    device = None if hmd is None else _headset(hmd, lens, fov)
    if device is None and lens != "own":
        raise ValueError(f"--lens: expected it with --hmd only, got {lens!r}")
    options.check_backend(backend)
    if method != "truth" and method not in METHODS:
        raise ValueError(f"--method: expected truth, continuous or conventional, got {method!r}")
    pixels, aim = _pixels(size, device), options.read_point("--target", target)
    user, middle = options.read_point("--eye", eye), options.read_point("--center", center)
    targets = {"side_by_side": output} if device is None else _targets(output, device)
    for path in targets.values():
        check_target(path, ".png", *((".exr",) if device is None else ()))
    loaded = options.open_scene(scene, up=up, on_invalid=on_invalid, scale=scale)
    place = choose(loaded, scene) if user is None or (middle is None and method != "truth") else None
    user = user or (place.eye if place else (0.0, 0.0, 0.0))
    view = camera(loaded, user, aim, 90.0 if fov is None else fov, pixels)
    started = time.perf_counter()
    source: nf.Scene | nf.ReducedScene = loaded
    channels: tuple[str, ...] = ("color",)
    if method == "truth":
        channels = ("color", "range", "object_id") if output.suffix.lower() == ".exr" else channels
    else:
        middle = middle or (place.eye if place else user)
        source = nf.reduce(
            loaded, center=middle, r1=r1, r2=r2, face_size=face_size, morph=METHODS[method], backend=backend
        )
    asked: dict[str, Any] = {"samples": samples, "channels": channels, "backend": backend}
    result: nf.Frame | nf.StereoFrame
    if device is None:
        result = nf.render(source, view, **asked)
    else:
        result = nf.render_eyes(source, device, user, orientation=view.orientation, size=pixels, **asked)
    seconds = time.perf_counter() - started
    _save(result, targets)
    document = formats.header("render", VERSION, color_space="sRGB" if output.suffix == ".png" else "linear") | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "file": str(output),
        "bytes": output.stat().st_size,
        "method": method,
        "eye": list(user),
        "size": list(pixels),
        "samples": samples,
        "seconds": round(seconds, 3),
    }
    rows = [
        ("eye" if device is None else "head", metres(user)),
        ("picture", f"{pixels[0]} × {pixels[1]}, {method}" + ("" if device is None else ", for each eye")),
        *((name.replace("_", " "), str(path)) for name, path in targets.items() if path != output),
        ("file" if device is None else "side by side", f"{output}, {bytes_text(document['bytes'])}"),
        ("rendered in", f"{seconds:.2f} s"),
        *note_rows(document["notes"]),
    ]
    if device is not None:
        document |= {
            "hmd": device.name,
            "lens": device.lens_source or None,
            "files": {name: str(path) for name, path in targets.items()},
        }
        unknown = "unknown, so nothing is warped; --lens generic takes a generic one"
        rows[:0] = [("headset", device.name), ("lens", device.lens_source or unknown)]
    show(document, rows, title=scene, as_json=as_json)


def _headset(name: str, lens: str, fov: float | None) -> nf.Hmd:
    """Return the headset, with the generic lens if that is asked for."""
    check.choice("--lens", lens, ("own", "generic"))
    if fov is not None:
        raise ValueError(f"--fov: expected none with --hmd, which has fields of view of its own, got {fov:g}")
    device = options.headset(name)
    return device if lens == "own" else device.with_lens()


def _pixels(size: str | None, device: nf.Hmd | None) -> tuple[int, int]:
    if size is None and device is not None:
        return device.render_size
    return options.read_size("--size", "1280x720" if size is None else size)


def _targets(output: Path, device: nf.Hmd) -> dict[str, Path]:
    """Files of a headset's pictures by content."""
    names = ["left", "right", *(("left_warped", "right_warped") if device.lens else ())]
    return {"side_by_side": output} | {name: output.with_stem(f"{output.stem}_{name}") for name in names}


def _save(result: nf.Frame | nf.StereoFrame, targets: dict[str, Path]) -> None:
    result.save(targets["side_by_side"])
    if isinstance(result, nf.Frame):
        return
    result.left.save(targets["left"])
    result.right.save(targets["right"])
    if result.hmd.lens is not None:
        from PIL import Image

        for name, picture in zip(("left_warped", "right_warped"), result.warped(), strict=True):
            with files.atomic_file(targets[name]) as temporary:
                Image.fromarray(picture).save(temporary, format="PNG")


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
