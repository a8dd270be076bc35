"""Users around a centre, and how far the pictures of several methods are from the truth for them."""

from __future__ import annotations

import importlib.util
import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from nearfar.cli import _page
from nearfar.cli._options import Point
from nearfar.cli._output import rounded

COUNT = 10
"""Number of users."""
WIDTH = 480
"""Greatest width in pixels of the pictures that are measured."""
MIN_SIDE = 11
"""Least width and height in pixels of these pictures: the window of SSIM."""

_TRIES = 60
_GOLDEN = math.pi * (3.0 - math.sqrt(5.0))
"""Golden angle: its multiples are spread evenly in all directions."""
_LEAST_SHOWN, _COARSE = 0.05, 32
"""Least share of a picture that shows surfaces, and the width in pixels of the picture that tells."""
_CLEARANCE = 0.5
"""Least distance of a user from a surface that the centre sees behind the user, metres."""


def choose_users(
    scene: nf.Scene, center: Point, reach: float, pixels: tuple[int, int]
) -> list[tuple[float, nf.Camera]]:
    """Choose users all around a centre at equal steps of distance up to `reach`, each with the distance.

    They look at right angles to the line from the centre or, where little is in view there, towards the middle of the
    scene, in pictures of `pixels`, but at most `WIDTH` wide. Directions in which a surface is in the way are skipped,
    so there may be fewer than `COUNT`.
    """
    turns = _GOLDEN * np.arange(_TRIES)
    outwards = np.column_stack([np.cos(turns), np.zeros(_TRIES), np.sin(turns)])
    free = nf.cast_rays(scene, np.tile(center, (_TRIES, 1)), outwards).t_hit
    users: list[tuple[float, nf.Camera]] = []
    scale = max(min(WIDTH / pixels[0], 1.0), MIN_SIDE / min(pixels))
    size, fov = (round(pixels[0] * scale), round(pixels[1] * scale)), nf.Fov.symmetric(90, pixels[0] / pixels[1])
    for turn, outward, distance_free in zip(turns, outwards, free, strict=True):
        distance = reach * (len(users) + 1) / COUNT
        if len(users) < COUNT and distance_free > distance + min(_CLEARANCE, distance):
            eye = np.add(center, distance * outward)
            side = -1.0 if len(users) % 2 else 1.0
            sideways = np.array([-math.sin(turn) * side, -0.02, math.cos(turn) * side])
            camera = nf.Camera.look_at(eye, eye + sideways, fov=fov, size=size)
            middle = scene.bounds.mean(axis=0)
            if _shown_share(scene, camera) < _LEAST_SHOWN and (middle != eye).any():
                camera = nf.Camera.look_at(eye, middle, fov=fov, size=size)
            users.append((distance, camera))
    return users


def _shown_share(scene: nf.Scene, camera: nf.Camera) -> float:
    """Return the share of a picture that shows surfaces."""
    width, height = camera.size
    coarse = replace(camera, size=(_COARSE, max(round(_COARSE * height / width), 1)))
    return float(np.isfinite(nf.render(scene, coarse, channels=("range",)).require("range")).mean())


def measure(
    scene: nf.Scene, methods: Mapping[str, nf.Renderable], users: list[tuple[float, nf.Camera]], samples: int
) -> dict[str, Any]:
    """Return distances of users, and PSNR, SSIM and share of missing pixels of each method for them.

    A pixel is missing if it shows nothing where the truth shows a surface; methods with a map miss none.
    """
    measures: dict[str, Any] = {name: {"psnr": [], "ssim": [], "missing": []} for name in methods}
    for _, camera in users:
        truth = nf.render(scene, camera, samples=samples, channels=("color", "range"))
        for name, source in methods.items():
            has_range = isinstance(source, nf.Impostors)
            frame = nf.render(source, camera, samples=samples, channels=("color", "range")[: 1 + has_range])
            missing = np.isfinite(truth.require("range")) & ~np.isfinite(frame.require("range")) if has_range else 0.0
            measures[name]["psnr"].append(rounded(nf.psnr(truth, frame), 4))
            measures[name]["ssim"].append(rounded(float(nf.ssim(truth, frame))))
            measures[name]["missing"].append(rounded(float(np.mean(missing)), 8))
    return {"distances": [round(distance, 4) for distance, _ in users], "methods": measures}


def rows(document: dict[str, Any]) -> list[list[str]]:
    """Return a table of the means and worst values, header first; means leave out the `equal_views`."""
    users = document["users"]
    if not users["distances"]:
        return []
    header = ["method", "PSNR, dB", "worst", "SSIM", "worst", "missing pixels", "triangles", "bytes"]
    lines = [header]
    is_equal = equal_views(document)
    for name, values in users["methods"].items():
        psnr, ssim = (
            [value for value, equal in zip(values[measure], is_equal, strict=True) if not equal]
            for measure in ("psnr", "ssim")
        )
        size = document["sizes"][name]
        lines.append(
            [
                name,
                f"{np.mean(psnr):.1f}" if psnr else "all equal",
                f"{min(psnr):.1f}" if psnr else "all equal",
                f"{np.mean(ssim):.3f}" if ssim else "all equal",
                f"{min(ssim):.3f}" if ssim else "all equal",
                f"{100.0 * np.mean(values['missing']):.3f} %" if name == "impostors" else "0 %",
                f"{size['triangles']:,}",
                f"{size['bytes']:,}",
            ]
        )
    return lines


def equal_views(document: dict[str, Any]) -> list[bool]:
    """Return for each user whether a method's picture equals the truth: mostly views of the background alone."""
    return [
        None in psnr for psnr in zip(*(each["psnr"] for each in document["users"]["methods"].values()), strict=True)
    ]


def plot(path: Path, users: dict[str, Any]) -> bool:
    """Plot PSNR of each method against the user's distance from O; return False without users or matplotlib."""
    if not users["distances"] or not importlib.util.find_spec("matplotlib"):
        return False
    figure, axes = _page.make_plot(4.5)
    for name, values in users["methods"].items():
        psnr = [math.nan if value is None else value for value in values["psnr"]]
        axes.plot(users["distances"], psnr, marker="o", linestyle="", label=name)
    axes.set(xlabel="distance of the user from O in metres", ylabel="PSNR against the truth, dB", xlim=(0.0, None))
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(path, dpi=130)
    return True
