"""`nearfar render`: renders a picture of a scene or of its reduction."""

from __future__ import annotations

import math
import time
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any

import nearfar as nf
from nearfar._base import check, formats
from nearfar._reduce import findings
from nearfar.cli import _headset, _options as options, _source, _viewpoint
from nearfar.cli._groups import Options
from nearfar.cli._methods import METHODS, morph_of
from nearfar.cli._options import option
from nearfar.cli._output import bytes_text, check_target, metres, note_rows, show
from nearfar.cli._scenes import SceneOptions, is_reduced, open_scene

VERSION = 1


@dataclass(frozen=True, kw_only=True)
class ViewOptions(Options):
    """A user's view, and the pixels of its picture."""

    eye: Annotated[
        str | None,
        option("--eye", "X,Y,Z", "User's eye U in metres. By default over open ground or before an object."),
    ] = None
    target: Annotated[
        str | None,
        option(
            "--target", "X,Y,Z", "Point to look at, metres. By default the longest open view or the boundary at r2."
        ),
    ] = None
    fov: Annotated[
        float | None, option("--fov", "DEGREES", "Horizontal field of view, 90 by default; a headset has its own.")
    ] = None
    size: Annotated[
        str | None,
        option("--size", "WxH", "Pixels, 1280x720 by default; for a headset those of an eye, by default its own."),
    ] = None
    samples: options.Samples = 4

    def __post_init__(self) -> None:
        options.check_angle(self.degrees)
        super().__post_init__()

    @property
    def degrees(self) -> float:
        """Horizontal field of view without a headset."""
        return 90.0 if self.fov is None else self.fov

    @cached_property
    def user(self) -> options.Point | None:
        """The eye; None for the default."""
        return options.read_point("--eye", self.eye)

    @cached_property
    def aim(self) -> options.Point | None:
        """The point to look at; None for the default."""
        return options.read_point("--target", self.target)


@dataclass(frozen=True, kw_only=True)
class HeadsetOptions(Options):
    """A headset and its lens."""

    hmd: Annotated[
        str | None,
        option("--hmd", "NAME", "Render both eyes of a headset, a name or a .json file; --eye is then the head."),
    ] = None
    lens: Annotated[
        str, option("--lens", "own|generic", "Lens that --hmd warps for: the headset's, if known, or a generic one.")
    ] = "own"

    def device(self, fov: float | None) -> nf.Hmd | None:
        """Return the headset; None without one. `fov` must then be None."""
        if self.hmd is not None:
            return _headset.headset(self.hmd, self.lens, fov)
        if self.lens != "own":
            raise ValueError(f"--lens: expected it with --hmd only, got {check.shortened(self.lens)}")
        return None


def render(
    *,
    scene: options.SceneOrFolder,
    output: Annotated[Path, option("-o --output", "FILE", "Picture to write, .png or .exr.")],
    view: ViewOptions,
    method: Annotated[
        str | None,
        option(
            "--method",
            "truth|continuous|conventional",
            "Full scene, or a method of near-far reduction. By default truth, for a folder continuous.",
        ),
    ] = None,
    headset: HeadsetOptions,
    zones: options.MapOptions,
    backend: options.Backend = None,
    file: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Render a scene, or a folder that `nearfar reduce` wrote, from one eye to a PNG or EXR file, or for a headset.

    For FILE.png, --hmd writes the eyes side by side there, FILE_left.png and FILE_right.png, and, warped for the
    headset's lens, FILE_left_warped.png and FILE_right_warped.png.
    """
    device = headset.device(view.fov)
    options.check_backend(backend)
    if method is not None and method != "truth" and method not in METHODS:
        raise ValueError(f"--method: expected truth, continuous or conventional, got {check.shortened(method)}")
    pixels, user, aim, middle = _headset.pixels_of(view.size, device), view.user, view.aim, zones.point
    targets = {"side_by_side": output} if device is None else _headset.targets_of(output, device)
    for path in targets.values():
        check_target(path, ".png", *((".exr",) if device is None else ()))
    saved = None
    if is_reduced(scene):
        if method == "truth":
            raise ValueError("--method: expected continuous or conventional with a folder, whose far geometry is gone")
        _source.refuse("which has its own", **asdict(zones))
        saved = nf.ReducedScene.load(scene)
        method = method or ("conventional" if saved.morph == "none" else "continuous")
        loaded, middle = saved.scene, saved.center
    else:
        method = method or "truth"
        loaded = open_scene(scene, file.loading)
    stand = None
    place = _viewpoint.choose(loaded, scene, user if method == "truth" else middle)
    if method == "truth":
        seen = (place.eye, aim or place.target)
    else:
        radii = saved or zones.choose_radii(loaded, place)
        inner, outer = radii.r1, radii.r2
        stand = _source.view_of(scene) if saved is not None and user is None and aim is None else None
        stand = stand or _viewpoint.stand(loaded, place, inner, outer, fov=view.degrees, user=user, target=aim)
        seen = (stand.user, stand.target)
    lacks: list[str] = [] if device is None else _headset.stretching(pixels, device)
    shot = camera(*seen, view.degrees, pixels)
    started = time.perf_counter()
    source: nf.Scene | nf.ReducedScene = loaded
    channels: tuple[str, ...] = ("color",)
    if stand is None:
        channels = ("color", "range", "object_id") if output.suffix.lower() == ".exr" else channels
    else:
        if saved is None:
            reduced = nf.reduce(
                loaded,
                center=place.eye,
                r1=inner,
                r2=outer,
                face_size=zones.texels,
                morph=METHODS[method],
                backend=backend,
            )
        else:
            reduced = saved.with_morph(morph_of(method, saved))
        margin = nf.fold_margin(shot.position, center=place.eye, r1=inner, r2=outer)
        lacks += findings.of_reduction(reduced.stats, outer) + findings.of_view(
            crosses=stand.crosses or saved is not None,
            fold_margin=margin if method == "continuous" else math.inf,
            r2=outer,
        )
        source = reduced
    asked: dict[str, Any] = {"samples": view.samples, "channels": channels, "backend": backend}
    result: nf.Frame | nf.StereoFrame
    if device is None:
        result = nf.render(source, shot, **asked)
    else:
        result = nf.render_eyes(source, device, shot.position, orientation=shot.orientation, size=pixels, **asked)
    seconds = time.perf_counter() - started
    _headset.save(result, targets)
    document = formats.header("render", VERSION, color_space="sRGB" if output.suffix == ".png" else "linear") | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "file": str(output),
        "bytes": output.stat().st_size,
        "method": method,
        "eye": list(shot.position),
        "findings": lacks,
        "size": list(pixels),
        "samples": view.samples,
        "seconds": round(seconds, 3),
    }
    rows = [
        ("eye" if device is None else "head", metres(shot.position)),
        ("picture", f"{pixels[0]} × {pixels[1]}, {method}" + ("" if device is None else ", for each eye")),
        *((name.replace("_", " "), str(path)) for name, path in targets.items() if path != output),
        ("file" if device is None else "side by side", f"{output}, {bytes_text(document['bytes'])}"),
        ("rendered in", f"{seconds:.2f} s"),
        *note_rows(document),
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


def camera(eye: options.Point, target: options.Point, fov: float, size: tuple[int, int]) -> nf.Camera:
    """Make a camera at an eye that looks at a target; `fov` in degrees."""
    return nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(fov, size[0] / size[1]), size=size)
