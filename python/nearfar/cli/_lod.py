"""`nearfar lod`: levels of detail of one object, and the size from which on each is good enough."""

from __future__ import annotations

import functools
import time
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import formats
from nearfar.cli import _options as options
from nearfar.cli._groups import Options
from nearfar.cli._options import option, read_numbers
from nearfar.cli._output import bytes_text, check_target, count, note_rows, show
from nearfar.cli._scenes import SceneOptions, open_scene

VERSION = 1

# Defaults of their fields are the defaults of the options.
Settings, Threshold = nf.lod.MeasureSettings, nf.lod.LodThreshold


@dataclass(frozen=True, kw_only=True)
class SimplifyOptions(Options):
    """How levels are simplified."""

    ratios: Annotated[str | None, option("--ratios", "R,R,…", "Shares of the triangles, as in 0.5,0.2,0.05.")] = None
    method: Annotated[str, option("--method", "fast|meshopt", "The simplifier: see nf.lod.simplify.")] = "fast"
    normals: Annotated[str, option("--normals", "keep|smooth|flat", "How levels are shaded: see nf.lod.simplify.")] = (
        "keep"
    )

    @cached_property
    def shares(self) -> list[float] | None:
        """Shares of the triangles; None for the default."""
        if self.ratios is None:
            return None
        return read_numbers("--ratios", self.ratios, "numbers such as 0.5,0.2,0.05")

    def simplify(self, scene: nf.Scene, name: str) -> nf.lod.Levels:
        """Return the levels of a scene."""
        simplify = functools.partial(nf.lod.simplify, scene, method=self.method, normals=self.normals, name=name)
        return simplify() if self.shares is None else simplify(self.shares)


@dataclass(frozen=True, kw_only=True)
class MeasureOptions(Options):
    """How levels are compared."""

    hmd: Annotated[str, option("--hmd", "NAME", "Headset that levels are measured for: a name or a .json file.")] = (
        "quest_2"
    )
    views: Annotated[int, option("--views", "N", "Number of directions from which levels are compared.")] = (
        Settings.views
    )
    directions: Annotated[
        str, option("--directions", "even|published", "Distribution of the views: see nf.lod.MeasureSettings.")
    ] = Settings.directions
    distances: Annotated[int, option("--distances", "N", "Number of distances at which levels are compared.")] = (
        Settings.distances
    )


@dataclass(frozen=True, kw_only=True)
class SwitchOptions(Options):
    """Threshold at which levels switch, and the levels that are written."""

    k: Annotated[float, option("--k", "K", "Slope of the threshold.")] = Threshold.k
    d: Annotated[float, option("--d", "D", "The threshold at 1/16 of the screen.")] = Threshold.d
    threshold: Annotated[
        str, option("--threshold", "KIND", "Formula of the threshold: anchored, literal or normalized.")
    ] = Threshold.kind
    all_levels: Annotated[bool, typer.Option("--all-levels", help="Also write levels that are never shown.")] = False


def lod(
    *,
    scene: options.Input,
    output: Annotated[Path, option("-o --output", "FILE", "The model: .glb with its levels, or .json without.")],
    simplifier: SimplifyOptions,
    pictures: MeasureOptions,
    switching: SwitchOptions,
    backend: options.Backend = None,
    file: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Simplify an object, measure the SSIM of each level over its size, and write the model with sizes to switch at."""
    options.check_backend(backend)
    check_target(output, ".glb", ".json")
    device = options.headset(pictures.hmd)
    loaded = open_scene(scene, file.loading)
    started = time.perf_counter()
    levels = simplifier.simplify(loaded, Path(scene.partition(":")[0]).stem)
    simplified = time.perf_counter()
    asked = asdict(pictures) | {"hmd": device}
    model = nf.lod.measure(levels, backend=backend, **asked)
    seconds = {"simplify": simplified - started, "measure": time.perf_counter() - simplified}
    threshold: dict[str, Any] = {"k": switching.k, "d": switching.d, "threshold": switching.threshold}
    model.export(output, view=device, all_levels=switching.all_levels, **threshold)
    switches = nf.lod.switches(model, view=device, **threshold)
    written = np.ones(len(model), bool) if switching.all_levels else switches.is_ever_shown
    document = describe(model, switches, written) | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "file": str(output),
        "bytes": output.stat().st_size,
        "hmd": device.name,
        "seconds": {step: round(value, 3) for step, value in seconds.items()},
    }
    rows = [
        *((f"level {number}", _text(level)) for number, level in enumerate(document["levels"])),
        ("headset", device.name),
        ("file", f"{output}, {bytes_text(document['bytes'])}"),
        *((step, f"{value:.2f} s") for step, value in seconds.items()),
        *note_rows(document),
    ]
    show(document, rows, title=scene, as_json=as_json)


def describe(model: nf.lod.LodModel, switches: nf.lod.Switches, written: NDArray[np.bool_]) -> dict[str, Any]:
    """Return the document of a model's levels; `written` (K,) marks those in the file; schema "levels"."""
    statuses = [None, *model.curves.status.tolist()]
    never = switches.solid_angle == 0
    geometry = model.levels or ()
    return formats.header("levels", VERSION) | {
        "name": model.name,
        "radius": float(model.radius),
        "levels": [
            {
                "triangles": int(model.triangles[number]),
                "error": float(model.errors[number]),
                "note": geometry[number].note if geometry else "",
                "curve": statuses[number],
                "solid_angle": float(switches.solid_angle[number]),
                "screen_coverage": float(switches.screen_coverage[number]),
                "shown": bool(switches.is_ever_shown[number]),
                "written": bool(written[number]),
                "limit_of_measurement": bool(switches.is_limit[number]),
                "distance": None if never[number] else float(switches.distance[number] * model.radius),
            }
            for number in range(len(model))
        ],
        "screen_coverage": switches.of_levels(np.flatnonzero(written)).coverages(),
    }


def _text(level: dict[str, Any]) -> str:
    parts = [f"{count(level['triangles'])} triangles", f"error {level['error']:.3g} m"]
    if level["curve"] is not None:
        where = "never" if level["distance"] is None else f"from {level['distance']:.3g} m on"
        share = f"{level['screen_coverage']:.2%} of the picture"
        if level["limit_of_measurement"]:
            where, share = f"at all sizes measured, {where}", f"{share}; larger is beyond what was measured"
        parts.append(f"good enough {where} ({share})")
    if not level["shown"]:
        parts.append("never shown" + ("" if level["written"] else ", left out of the file"))
    return ", ".join(parts) + (f"; {level['note']}" if level["note"] else "")
