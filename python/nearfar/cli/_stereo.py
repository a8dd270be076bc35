"""`nearfar stereo`: renders a scene in hybrid mono-stereo, and measures savings and errors."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import typer

import nearfar as nf
from nearfar._base import check, files, formats
from nearfar.cli import _options as options, _page, _viewpoint
from nearfar.cli._groups import Options, choice, option
from nearfar.cli._output import Clock, count, metres, note_rows, rounded, show
from nearfar.cli._scenes import SceneOptions, is_reduced, open_reduced, open_scene
from nearfar.stereo._differences import compare_eye
from nearfar.stereo._settings import Assembly, Cull

VERSION = 1
NEAR = 0.1
"""Near plane, metres."""

SIDES = ("left", "right")
AXES: tuple[Literal["horizontal", "vertical"], ...] = ("horizontal", "vertical")

DEPTHS = (1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 1000.0, math.inf)
"""Depths of the listed errors, metres."""

CAPTIONS = {
    "side_by_side.png": "Left and right eye",
    "anaglyph.png": "Both eyes, for red–cyan glasses",
    "center.png": "The shared picture; pixels that no eye looks up are black",
    "differences.png": "Difference from plain stereo, and (1 − SSIM) × 10, of both eyes",
    "error.png": "Error against depth",
}

_PIXELS = {
    "left": "left eye, own surfaces",
    "right": "right eye, own surfaces",
    "center": "shared, drawn",
    "discarded": "shared, not looked up",
}
_TRIANGLES = {
    "left": "the left eye",
    "right": "the right eye",
    "center": "the shared picture",
    "thrice": "all three, across the plane",
    "plain": "plain stereo, both eyes",
}


@dataclass(frozen=True, kw_only=True)
class RigOptions(Options):
    """A headset and its mono plane."""

    hmd: str = option(options.HEADSET, "NAME", "Headset, a name or a .json file.")
    mono_plane: float | None = option(None, "METRES", "Distance from which on both eyes share a picture. By default 8.")
    max_error: float | None = option(
        None, "PIXELS", "Greatest error of the shared picture, instead of --mono-plane: the nearest plane within it."
    )
    zone_end: float | None = option(
        None, "METRES", "Bend lines smoothly from the mono plane to here, instead of at the plane."
    )

    def make(self, device: nf.Hmd, size: tuple[int, int]) -> nf.stereo.HybridRig:
        """Return the rig of a headset with eyes of this size."""
        plane = self._plane(device, size)
        rig = nf.stereo.HybridRig.of(device, mono_plane=plane, size=size)
        if self.zone_end is None:
            return rig
        if not check.number("--zone-end", self.zone_end) > plane:
            got = f"{self.zone_end:g}"
            raise ValueError(f"--zone-end: expected more than the mono plane's {plane:g} metres, got {got}")
        return rig.with_plane((plane, self.zone_end))

    def _plane(self, device: nf.Hmd, size: tuple[int, int]) -> float:
        """Return the distance of the mono plane, as given or from the greatest error."""
        if self.max_error is None:
            plane = 8.0 if self.mono_plane is None else check.positive("--mono-plane", self.mono_plane)
            if plane <= NEAR:
                raise ValueError(f"--mono-plane: expected more than {NEAR:g} metres, got {plane:g}")
            return plane
        if self.mono_plane is not None:
            raise ValueError(f"--max-error: expected none with --mono-plane, got {self.max_error:g}")
        return nf.stereo.mono_plane_for(hmd=device, error_px=check.positive("--max-error", self.max_error), size=size)


@dataclass(frozen=True, kw_only=True)
class ViewOptions(options.EyeOptions):
    """Place and direction of the head, and the pixels of its pictures."""

    samples: options.Samples = 4


def stereo(
    *,
    scene: options.SceneOrFolder,
    output: options.Folder,
    rig: RigOptions,
    view: ViewOptions,
    assembly: Assembly = choice("bilinear", "How each eye reads the shared picture."),
    cull: Cull = choice("occlusion", "Which parts of the shared picture are not drawn."),
    backend: options.Backend = None,
    scene_options: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Render near geometry for each eye of a headset and all else once, and compare with plain stereo."""
    device, clock = options.headset(rig.hmd), Clock()
    pixels = view.pixels(device)
    hybrid_rig = rig.make(device, pixels)
    with files.atomic_folder(output, marker="stereo.json") as folder:
        with clock.step("scene"):
            saved = open_reduced(scene) if is_reduced(scene) else None
            loaded = open_scene(scene, scene_options.loading) if saved is None else saved.scene
            source: nf.Renderable = saved or loaded
            head = view.user if saved is None else view.user or saved.center
            viewpoint = _viewpoint.choose(loaded, scene, head)
            has_view = saved is not None and view.user is None and view.aim is None
            saved_view = _viewpoint.view_of(scene) if has_view else None
        eye, target = (
            (saved_view.user, saved_view.target) if saved_view else (viewpoint.eye, view.aim or viewpoint.target)
        )
        orientation = nf.Camera.look_at(eye, target, fov=hybrid_rig.center_fov, size=(1, 1)).orientation
        settings: dict[str, Any] = {"samples": view.samples, "channels": ("color",), "backend": backend}
        # The first picture builds the scene's trees, which both methods need; it is not timed.
        small = nf.Camera(eye, orientation, fov=hybrid_rig.center_fov, size=(8, 8))
        nf.render(source, small, **settings | {"samples": 1})
        with clock.step("hybrid"):
            hybrid = hybrid_rig.render(source, eye, orientation, assembly=assembly, cull=cull, near=NEAR, **settings)
        clip = hybrid_rig.clip(eye, orientation, near=NEAR)
        with clock.step("plain"):
            plain = nf.render_eyes(source, device, eye, orientation=orientation, size=pixels, clip=clip, **settings)
        with clock.step("measures"):
            differences = {side: compare_eye(getattr(plain, side), getattr(hybrid, side)) for side in SIDES}
        with clock.step("pictures"):
            has_plot = _page.save_eyes(folder, hybrid, plain, differences, hybrid_rig)
        triangles = None
        if isinstance(source, nf.Scene):
            triangles = hybrid_rig.triangles(source, eye, orientation, near=NEAR)
        document = formats.header("stereo", VERSION, color_space="sRGB") | {
            "source": scene,
            "notes": list(loaded.report.notes),
            "findings": _findings(source, hybrid_rig, hybrid, triangles),
            "hmd": device.name,
            "head": list(eye),
            "target": list(target),
            "size": list(pixels),
            "samples": view.samples,
            "mono_plane": hybrid_rig.planes[0],
            "zone_end": hybrid_rig.planes[1] if hybrid_rig.has_zone else None,
            "assembly": assembly,
            "cull": cull,
            "error": {name: round(hybrid_rig.max_error(axis=name), 4) for name in ("horizontal", "vertical", "both")},
            "eyes": {
                side: {"ssim": rounded(difference.ssim), "psnr": rounded(difference.psnr, 4)}
                for side, difference in differences.items()
            },
            "pixels": dict(hybrid.stats["pixels"]),
            "triangles": triangles,
            "stages": {name: round(seconds, 4) for name, seconds in hybrid.stats["seconds"].items()},
            "seconds": clock.seconds,
            "files": sorted([path.name for path in folder.iterdir()] + ["stereo.json", "report.html", "report.md"]),
        }
        _report(document, hybrid_rig).save(folder, "stereo.json")
    if not has_plot:
        typer.echo("nearfar: left plots out, because matplotlib is not installed", err=True)
    show(document, _rows(document, output), title=scene, as_json=as_json)


def _findings(
    source: nf.Renderable,
    rig: nf.stereo.HybridRig,
    frame: nf.StereoFrame,
    triangles: dict[str, int] | None,
) -> list[str]:
    """Report reasons why a shared picture saves nothing."""
    findings, plane = [], rig.planes[1]
    if frame.center is None:
        findings.append("nothing lies beyond the mono plane, so the picture is plain stereo")
    elif "left" not in frame.stats["seconds"]:
        findings.append("nothing lies before the mono plane, so both eyes share the whole picture")
    elif triangles and triangles["left"] + triangles["right"] + triangles["center"] > triangles["plain"]:
        findings.append("three pictures draw more triangles than two: a nearer plane would save geometry")
    if isinstance(source, nf.ReducedScene) and plane >= source.r2:
        place = f"the mono plane, {plane:g} m, lies beyond r2 = {source.r2:g} m"
        findings.append(f"{place}: only the map is shared, which saves nothing")
    return findings


def _rows(document: dict[str, Any], output: Path) -> list[tuple[str, str]]:
    eyes, seconds = document["eyes"], document["seconds"]
    pixels = document["pixels"]
    total = pixels.get("center", 0) + pixels.get("discarded", 0)
    return [
        ("headset", f"{document['hmd']}, {document['size'][0]} × {document['size'][1]} pixels an eye"),
        ("head", metres(document["head"])),
        ("mono plane", _plane_text(document)),
        ("greatest error", f"{document['error']['horizontal']:.3g} pixels to the side"),
        *((f"SSIM, {side} eye", f"{eyes[side]['ssim']:.5f}, PSNR {_decibels(eyes[side]['psnr'])}") for side in SIDES),
        *([("shared pixels drawn", f"{count(pixels['center'])} of {count(total)}")] if total else []),
        ("rendered in", f"{seconds['hybrid']:.2f} s; plain stereo {seconds['plain']:.2f} s"),
        *note_rows(document),
        ("written to", str(output)),
    ]


def _decibels(value: float | None) -> str:
    return "infinite" if value is None else f"{value:.2f} dB"


def _plane_text(document: dict[str, Any]) -> str:
    """Describe the position of the mono plane."""
    end = document["zone_end"]
    return f"{document['mono_plane']:g} m" + ("" if end is None else f", lines bend up to {end:g} m")


def _report(document: dict[str, Any], rig: nf.stereo.HybridRig) -> _page.Page:
    eyes, pixels, seconds = document["eyes"], document["pixels"], document["seconds"]
    tables = {
        "Against plain stereo": [
            ["measure", "left", "right"],
            ["SSIM", *(f"{eyes[side]['ssim']:.5f}" for side in eyes)],
            ["PSNR, dB", *("∞" if eyes[side]["psnr"] is None else f"{eyes[side]['psnr']:.2f}" for side in eyes)],
        ],
        "Greatest error by depth": [
            ["depth", "to the side, pixels", "upwards, pixels"],
            *(
                ["∞" if math.isinf(depth) else f"{depth:g} m", *(f"{rig.max_error(depth, axis):.2f}" for axis in AXES)]
                for depth in DEPTHS
            ),
        ],
        "Pixels": [
            ["picture", "pixels"],
            *([_PIXELS[name], count(pixels[name])] for name in _PIXELS if name in pixels),
        ],
        "Time": [
            ["stage", "seconds"],
            *([name, f"{value:.3f}"] for name, value in document["stages"].items()),
            ["hybrid, all", f"{seconds['hybrid']:.3f}"],
            ["plain stereo", f"{seconds['plain']:.3f}"],
        ],
    }
    if document["triangles"]:
        tables["Triangles"] = [
            ["drawn for", "triangles"],
            *([_TRIANGLES[name], count(document["triangles"][name])] for name in _TRIANGLES),
        ]
    tables |= _page.notes_table(document)
    width, height = document["size"]
    summary = [
        *(f"Note: {finding}." for finding in document["findings"]),
        *_page.paragraphs(
            "stereo.md",
            hmd=document["hmd"],
            width=width,
            height=height,
            head=metres(document["head"]),
            plane=_plane_text(document),
            assembly=document["assembly"],
        ),
    ]
    return _page.Page(document, f"Hybrid mono-stereo of {document['source']}", summary, CAPTIONS, tables)
