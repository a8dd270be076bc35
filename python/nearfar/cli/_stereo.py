"""`nearfar stereo`: renders a scene in hybrid mono-stereo, and measures savings and errors."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any

import typer

import nearfar as nf
from nearfar._base import check, files, formats
from nearfar.cli import _headset, _options as options, _page, _pictures, _source, _stereo_page, _viewpoint
from nearfar.cli._groups import Options
from nearfar.cli._options import option
from nearfar.cli._output import Clock, count, metres, note_rows, show
from nearfar.cli._scenes import SceneOptions, is_reduced, open_scene
from nearfar.stereo._differences import EyeDifference, compare_eye

VERSION = 1
NEAR = 0.1
"""Near plane, metres."""


@dataclass(frozen=True, kw_only=True)
class RigOptions(Options):
    """A headset and its mono plane."""

    hmd: Annotated[str, option("--hmd", "NAME", "Headset, a name or a .json file.")] = "VIVE"
    mono_plane: Annotated[
        float | None,
        option("--mono-plane", "METRES", "Distance from which on both eyes share a picture. By default 8."),
    ] = None
    max_error: Annotated[
        float | None,
        option(
            "--max-error",
            "PIXELS",
            "Greatest error of the shared picture; chooses the nearest mono plane within it, instead of --mono-plane.",
        ),
    ] = None
    zone_end: Annotated[
        float | None,
        option("--zone-end", "METRES", "Bend lines smoothly from the mono plane to here, instead of at the plane."),
    ] = None

    def make(self, device: nf.Hmd, size: tuple[int, int]) -> nf.stereo.HybridRig:
        """Return the rig of a headset with eyes of this size."""
        plane = _plane(device, size, self.mono_plane, self.max_error)
        rig = nf.stereo.HybridRig.of(device, mono_plane=plane, size=size)
        return rig if self.zone_end is None else _with_zone(rig, self.zone_end)


@dataclass(frozen=True, kw_only=True)
class ViewOptions(Options):
    """Place and direction of the head, and the pixels of its pictures."""

    eye: Annotated[
        str | None, option("--eye", "X,Y,Z", "Head in metres. By default over open ground or before an object.")
    ] = None
    target: Annotated[
        str | None, option("--target", "X,Y,Z", "Point to look at, metres. By default the longest open view.")
    ] = None
    size: Annotated[str | None, option("--size", "WxH", "Pixels of an eye. By default the headset's.")] = None
    samples: options.Samples = 1

    @cached_property
    def head(self) -> options.Point | None:
        """The head; None for the default."""
        return options.read_point("--eye", self.eye)

    @cached_property
    def aim(self) -> options.Point | None:
        """The point to look at; None for the default."""
        return options.read_point("--target", self.target)


def stereo(
    *,
    scene: options.SceneOrFolder,
    output: options.Folder,
    rig: RigOptions,
    view: ViewOptions,
    assembly: Annotated[
        str, option("--assembly", "bilinear|resolved", "How each eye reads the shared picture.")
    ] = "bilinear",
    cull: Annotated[
        str, option("--cull", "frustum|discard|occlusion", "Which parts of the shared picture are not drawn.")
    ] = "occlusion",
    backend: options.Backend = None,
    file: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Render near geometry for each eye of a headset and all else once, and compare with plain stereo."""
    options.check_backend(backend)
    check.choice("--assembly", assembly, ("bilinear", "resolved"))
    check.choice("--cull", cull, ("frustum", "discard", "occlusion"))
    device, clock, head, aim = options.headset(rig.hmd), Clock(), view.head, view.aim
    pixels = _headset.pixels_of(view.size, device)
    made = rig.make(device, pixels)
    output.parent.mkdir(parents=True, exist_ok=True)
    with files.atomic_folder(output, marker="stereo.json") as folder:
        with clock.step("scene"):
            source: nf.Scene | nf.ReducedScene
            if is_reduced(scene):
                source = nf.ReducedScene.load(scene)
                loaded, head = source.scene, head or source.center
            else:
                source = loaded = open_scene(scene, file.loading)
            place = _viewpoint.choose(loaded, scene, head)
            stand = _source.view_of(scene) if is_reduced(scene) and (view.head, aim) == (None, None) else None
        where, towards = (place.eye, aim or place.target) if stand is None else (stand.user, stand.target)
        way = nf.Camera.look_at(where, towards, fov=made.center_fov, size=(1, 1)).orientation
        settings: dict[str, Any] = {"samples": view.samples, "channels": ("color",), "backend": backend}
        # The first picture builds the scene's trees, which both methods need; it is not timed.
        nf.render(source, nf.Camera(where, way, fov=made.center_fov, size=(8, 8)), channels=("color",), backend=backend)
        hybrid, hybrid_seconds = _timed(
            lambda: made.render(source, where, way, assembly=assembly, cull=cull, near=NEAR, **settings)
        )
        ahead = made.clip(where, way, near=NEAR)
        plain, plain_seconds = _timed(
            lambda: nf.render_eyes(source, device, where, orientation=way, size=pixels, clip=ahead, **settings)
        )
        with clock.step("measures"):
            compared = {side: compare_eye(getattr(plain, side), getattr(hybrid, side)) for side in SIDES}
        with clock.step("pictures"):
            plotted = _pictures.save_eyes(folder, hybrid, plain, compared, made)
        clock.seconds |= {"hybrid": round(hybrid_seconds, 3), "plain": round(plain_seconds, 3)}
        counted = made.triangles(source, where, way, near=NEAR) if isinstance(source, nf.Scene) else None
        document = formats.header("stereo", VERSION, color_space="sRGB") | {
            "source": scene,
            "notes": list(loaded.report.notes),
            "findings": _findings(source, made, hybrid, counted),
            "hmd": device.name,
            "head": list(where),
            "target": list(towards),
            "size": list(pixels),
            "samples": view.samples,
            "mono_plane": made.planes[0],
            "zone_end": made.planes[1] if made.has_zone else None,
            "assembly": assembly,
            "cull": cull,
            "error": {name: round(made.max_error(axis=name), 4) for name in ("horizontal", "vertical", "both")},
            "eyes": {side: _measures(compared[side]) for side in SIDES},
            "pixels": dict(hybrid.stats["pixels"]),
            "triangles": counted,
            "stages": {name: round(seconds, 4) for name, seconds in hybrid.stats["seconds"].items()},
            "seconds": clock.seconds,
            "files": sorted([path.name for path in folder.iterdir()] + ["stereo.json", "report.html", "report.md"]),
        }
        _page.save(folder, "stereo.json", document, _stereo_page.page(document, made))
    if not plotted:
        typer.echo("nearfar: left plots out, because matplotlib is not installed", err=True)
    show(document, _rows(document, output), title=scene, as_json=as_json)


SIDES = ("left", "right")


def _measures(difference: EyeDifference) -> dict[str, float | None]:
    """Return rounded measures for the report; None for an infinite one."""
    return {
        "ssim": round(difference.ssim, 6),
        "psnr": round(difference.psnr, 4) if math.isfinite(difference.psnr) else None,
    }


def _plane(device: nf.Hmd, size: tuple[int, int], mono_plane: float | None, max_error: float | None) -> float:
    """Return the distance of the mono plane, as given or from the greatest error."""
    if max_error is None:
        plane = 8.0 if mono_plane is None else check.positive("--mono-plane", mono_plane)
        if plane <= NEAR:
            raise ValueError(f"--mono-plane: expected more than {NEAR:g} metres, got {plane:g}")
        return plane
    if mono_plane is not None:
        raise ValueError(f"--max-error: expected none with --mono-plane, got {max_error:g}")
    return nf.stereo.mono_plane_for(hmd=device, error_px=check.positive("--max-error", max_error), size=size)


def _with_zone(rig: nf.stereo.HybridRig, end: float) -> nf.stereo.HybridRig:
    """Return the rig with a zone beyond its plane."""
    plane = rig.planes[0]
    if not check.number("--zone-end", end) > plane:
        raise ValueError(f"--zone-end: expected more than the mono plane's {plane:g} metres, got {end:g}")
    return rig.with_plane((plane, end))


def _timed(draw: Any) -> tuple[nf.StereoFrame, float]:
    started = time.perf_counter()
    frame: nf.StereoFrame = draw()
    return frame, time.perf_counter() - started


def _findings(
    source: nf.Scene | nf.ReducedScene,
    rig: nf.stereo.HybridRig,
    frame: nf.StereoFrame,
    counted: dict[str, int] | None,
) -> list[str]:
    """Report pictures that gain nothing from a shared one."""
    found, plane = [], rig.planes[1]
    if frame.center is None:
        found.append("nothing lies beyond the mono plane, so the picture is plain stereo")
    elif "left" not in frame.stats["seconds"]:
        found.append("nothing lies before the mono plane, so both eyes share the whole picture")
    elif counted is not None and counted["left"] + counted["right"] + counted["center"] > counted["plain"]:
        found.append("three pictures draw more triangles than two: a nearer plane would save geometry")
    if isinstance(source, nf.ReducedScene) and plane >= source.r2:
        shares = f"the mono plane, {plane:g} m, lies beyond r2 = {source.r2:g} m"
        found.append(f"{shares}: only the map is shared, which saves nothing")
    return found


def _rows(document: dict[str, Any], output: Path) -> list[tuple[str, str]]:
    eyes, seconds = document["eyes"], document["seconds"]
    pixels = document["pixels"]
    total = pixels.get("center", 0) + pixels.get("discarded", 0)
    return [
        ("headset", f"{document['hmd']}, {document['size'][0]} × {document['size'][1]} pixels an eye"),
        ("head", metres(document["head"])),
        ("mono plane", _stereo_page.plane_of(document)),
        ("greatest error", f"{document['error']['horizontal']:.3g} pixels to the side"),
        *((f"SSIM, {side} eye", f"{eyes[side]['ssim']:.5f}, PSNR {_decibels(eyes[side]['psnr'])}") for side in SIDES),
        *([("shared pixels drawn", f"{count(pixels['center'])} of {count(total)}")] if total else []),
        ("rendered in", f"{seconds['hybrid']:.2f} s; plain stereo {seconds['plain']:.2f} s"),
        *note_rows(document),
        ("written to", str(output)),
    ]


def _decibels(value: float | None) -> str:
    return "infinite" if value is None else f"{value:.2f} dB"
