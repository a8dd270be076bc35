"""`nearfar render`: renders a picture of a scene or of its reduction."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import nearfar as nf
from nearfar._base import check, files, formats
from nearfar._reduce import default_radii, findings
from nearfar.cli import _options as options, _viewpoint
from nearfar.cli._groups import Options, choice, option
from nearfar.cli._methods import METHODS, morph_of
from nearfar.cli._output import Clock, bytes_text, check_target, metres, note_rows, show
from nearfar.cli._scenes import SceneOptions, is_reduced, open_reduced, open_scene

VERSION = 1

MAX_STRETCH = 0.03
"""Greatest relative difference of aspect ratios that is not reported."""


@dataclass(frozen=True, kw_only=True)
class ViewOptions(options.EyeOptions):
    """A user's view, and the pixels of its picture."""

    fov: float | None = option(None, "DEGREES", "Horizontal field of view, 90 by default; a headset has its own.")
    samples: options.Samples = 4

    def __post_init__(self) -> None:
        options.check_angle(self.degrees)
        super().__post_init__()

    @property
    def degrees(self) -> float:
        return 90.0 if self.fov is None else self.fov


@dataclass(frozen=True, kw_only=True)
class HeadsetOptions(Options):
    """A headset and its lens."""

    hmd: str | None = option(None, "NAME", "Render both eyes of a headset, a name or .json file; --eye is the head.")
    lens: Literal["own", "generic"] = choice("own", "Lens that --hmd warps for: the headset's, if known, or generic.")

    def device(self, fov: float | None) -> nf.Hmd | None:
        """Return the headset, with the generic lens if requested; None without --hmd. A headset needs `fov` None."""
        if self.hmd is None:
            if self.lens != "own":
                raise ValueError(f"lens: expected it with --hmd only, got {check.shortened(self.lens)}")
            return None
        if fov is not None:
            raise ValueError(f"fov: expected none with --hmd, which sets the field of view, got {fov:g}")
        device = options.headset(self.hmd)
        return device if self.lens == "own" else device.with_lens()


def render(
    *,
    scene: options.SceneOrFolder,
    output: Path = option(..., "FILE", "Picture to write, .png or .exr.", "-o --output"),
    view: ViewOptions,
    method: Literal["truth", "impostors", "continuous", "conventional"] | None = choice(
        None, "Full scene, or a near-far reduction. By default truth; for a folder impostors, if it has them."
    ),
    headset: HeadsetOptions,
    zones: options.MapOptions,
    backend: options.Backend = None,
    scene_options: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Render a scene, or a folder that `nearfar reduce` wrote, from one eye to a PNG or EXR file, or for a headset.

    For FILE.png, --hmd writes the eyes side by side there, FILE_left.png and FILE_right.png, and, warped for the
    headset's lens, FILE_left_warped.png and FILE_right_warped.png.
    """
    device = headset.device(view.fov)
    pixels, user, aim, center = view.pixels(device), view.user, view.aim, zones.point
    targets = {"side_by_side": output} if device is None else _targets_of(output, device)
    for path in targets.values():
        check_target(path, ".png", *((".exr",) if device is None else ()))
    saved: nf.ReducedScene | nf.Impostors | None = None
    if is_reduced(scene):
        if method == "truth":
            raise ValueError("method: expected impostors, continuous or conventional with a folder, got truth")
        zones.refuse("with a folder as -i, which has its own")
        saved = open_reduced(scene)
        if isinstance(saved, nf.Impostors) and method in ("continuous", "conventional"):
            saved = saved.published
        if isinstance(saved, nf.ReducedScene) and method == "impostors":
            raise ValueError(f"method: expected a folder with impostors, got {check.shortened(scene)} with a map alone")
        is_torn = isinstance(saved, nf.ReducedScene) and saved.morph == "none"
        method = (
            "impostors" if isinstance(saved, nf.Impostors) else method or ("conventional" if is_torn else "continuous")
        )
        loaded, center = saved.scene, saved.center
    else:
        method = method or "truth"
        if method == "truth":
            zones.refuse("with --method truth (the default), which shows the full scene")
        loaded = open_scene(scene, scene_options.loading)
    notes = [] if device is None else _stretching(pixels, device)
    is_exr = output.suffix.lower() == ".exr"
    source: nf.Renderable = loaded
    channels: tuple[str, ...] = ("color",)
    clock = Clock()
    viewpoint = _viewpoint.choose(loaded, scene, user if method == "truth" else center)
    if method == "truth":
        shot = camera(viewpoint.eye, aim or viewpoint.target, view.degrees, pixels)
        channels = ("color", "range", "object_id") if is_exr else channels
    else:
        published = saved.published if isinstance(saved, nf.Impostors) else saved
        radii = published or zones.choose_radii(loaded, viewpoint)
        r1, r2 = radii.r1, radii.r2
        reach = saved.reach if isinstance(saved, nf.Impostors) else min(default_radii.REACH, 0.5 * r2)
        within = min(default_radii.user_distance(r1, r2), reach) if method == "impostors" else None
        stand = _viewpoint.view_of(scene) if saved is not None and user is None and aim is None else None
        angles: dict[str, Any] = {"fov": view.degrees, "user": user, "target": aim, "distance": within}
        stand = stand or _viewpoint.stands(loaded, viewpoint, r1, r2, **angles)[0]
        shot = camera(stand.user, stand.target, view.degrees, pixels)
        with clock.step("reduce"):
            if isinstance(saved, nf.Impostors):
                source = saved
            elif method == "impostors":
                settings = nf.ImpostorSettings(face_size=max(zones.face_size, 64))
                source = nf.reduce(loaded, center=viewpoint.eye, r2=r2, far="impostors", settings=settings)
            elif saved is None:
                radii_and_map: dict[str, Any] = {"r1": r1, "r2": r2, "face_size": zones.face_size, "backend": backend}
                source = nf.reduce(loaded, center=viewpoint.eye, morph=METHODS[method], **radii_and_map)
            else:
                source = saved.with_morph(morph_of(method, saved))
        margin = (
            nf.fold_margin(shot.position, center=viewpoint.eye, r1=r1, r2=r2) if method == "continuous" else math.inf
        )
        if isinstance(source, nf.ReducedScene):
            notes += findings.of_reduction(source.stats, r2)
        notes += findings.of_view(crosses=stand.shows_boundary or saved is not None, fold_margin=margin, r2=r2)
    drawing = nf.RenderSettings(samples=view.samples, channels=channels, backend=backend)
    result: nf.Frame | nf.StereoFrame
    with clock.step("render"):
        if device is None:
            result = nf.render(source, shot, settings=drawing)
        else:
            result = nf.render_eyes(
                source, device, shot.position, orientation=shot.orientation, size=pixels, settings=drawing
            )
    _save(result, targets)
    document = formats.header("render", VERSION, color_space="sRGB" if output.suffix == ".png" else "linear") | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "file": str(output),
        "bytes": output.stat().st_size,
        "method": method,
        "eye": list(shot.position),
        "findings": notes,
        "size": list(pixels),
        "samples": view.samples,
        "seconds": round(sum(clock.seconds.values()), 3),
    }
    rows = [
        ("eye" if device is None else "head", metres(shot.position)),
        ("picture", f"{pixels[0]} × {pixels[1]}, {method}" + ("" if device is None else ", for each eye")),
        *((name.replace("_", " "), str(path)) for name, path in targets.items() if path != output),
        ("file" if device is None else "side by side", f"{output}, {bytes_text(document['bytes'])}"),
        ("rendered in", f"{document['seconds']:.2f} s"),
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


def _stretching(pixels: tuple[int, int], device: nf.Hmd) -> list[str]:
    """Report a headset's pictures whose aspect ratio differs from the headset's."""
    width, height = device.render_size
    if abs(pixels[0] * height / (pixels[1] * width) - 1.0) <= MAX_STRETCH:
        return []
    fitting = f"{round(pixels[1] * width / height)}x{pixels[1]}"
    return [f"the picture is stretched: an eye has {width} × {height} pixels, and {fitting} would keep its shape"]


def _targets_of(output: Path, device: nf.Hmd) -> dict[str, Path]:
    """Return the files of a headset's pictures by content."""
    names = ["left", "right", *(("left_warped", "right_warped") if device.lens else ())]
    return {"side_by_side": output} | {name: output.with_stem(f"{output.stem}_{name}") for name in names}


def _save(result: nf.Frame | nf.StereoFrame, targets: dict[str, Path]) -> None:
    """Write the picture, or the pictures of both eyes, to files by content."""
    result.save(targets["side_by_side"])
    if isinstance(result, nf.Frame):
        return
    result.left.save(targets["left"])
    result.right.save(targets["right"])
    if result.hmd is not None and result.hmd.lens is not None:
        for name, picture in zip(("left_warped", "right_warped"), result.warped(), strict=True):
            files.write_png(targets[name], picture)
