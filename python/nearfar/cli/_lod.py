"""`nearfar lod`: levels of detail of one object, and the size up to which each is good enough."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import check, formats
from nearfar.cli import _options as options
from nearfar.cli._groups import Options, choice, flag, option
from nearfar.cli._options import read_numbers
from nearfar.cli._output import Clock, bytes_text, check_target, count, note_rows, show
from nearfar.cli._scenes import SceneOptions, open_scene
from nearfar.lod._measure.views import Directions, Spacing
from nearfar.lod._select.switches import read_floor
from nearfar.lod._select.threshold import Kind
from nearfar.lod._simplify.simplify import Method, read_ratios
from nearfar.lod._simplify.surface import Normals

VERSION = 1

MIN_SCENE_RADIUS = 20.0
"""Least radius in metres of a scene of several objects that counts as more than one thing to look at."""

DEFAULTS, THRESHOLD = nf.lod.MeasureSettings, nf.lod.LodThreshold
"""Classes whose defaults are the defaults of the options."""


@dataclass(frozen=True, kw_only=True)
class SimplifyOptions(Options):
    """How levels are simplified."""

    ratios: str | None = option(None, "R,R,…", "Shares of the triangles, as in 0.5,0.2,0.05.")
    method: Method = choice("fast", "The simplifier: see nf.lod.simplify.")
    normals: Normals = choice("keep", "How levels are shaded: see nf.lod.simplify.")

    @cached_property
    def keywords(self) -> dict[str, Any]:
        ratios = None if self.ratios is None else read_numbers("--ratios", self.ratios, "numbers such as 0.5,0.2,0.05")
        simplification = {"method": self.method, "normals": self.normals}
        return simplification if ratios is None else simplification | {"ratios": read_ratios(ratios)}


@dataclass(frozen=True, kw_only=True)
class MeasureOptions(Options):
    """How levels are compared."""

    hmd: str = option(options.HEADSET, "NAME", "Headset that levels are measured for: a name or a .json file.")
    views: int = option(DEFAULTS.views, "N", "Number of directions from which levels are compared.")
    directions: Directions = choice(DEFAULTS.directions, "Distribution of the views: see nf.lod.MeasureSettings.")
    spacing: Spacing = choice(DEFAULTS.spacing, "Sequence of the distances: see nf.lod.MeasureSettings.")
    distances: int = option(DEFAULTS.distances, "N", "Number of distances at which levels are compared.")
    standard_error: float = option(
        DEFAULTS.standard_error, "SSIM", "Compare no more views once the scores' standard error is this; 0: all."
    )
    percentile: str = option(
        f"{DEFAULTS.percentile:g}", "P", "Percentile of SSIM over the views that is a level's score; mean: their mean."
    )
    step: float = option(
        DEFAULTS.step,
        "SSIM",
        "Drop levels whose scores are within such a step of a coarser level's; see nf.lod.MeasureSettings.",
    )
    samples: int = option(DEFAULTS.samples, "N", "Samples of each pixel.")

    @cached_property
    def device(self) -> nf.Hmd:
        return options.headset(self.hmd)

    @cached_property
    def settings(self) -> nf.lod.MeasureSettings:
        score: Any = self.percentile
        if score != "mean":
            [score] = read_numbers("--percentile", score, "a number or mean", 1)
        return nf.lod.MeasureSettings(**asdict(self) | {"hmd": self.device, "percentile": score})


@dataclass(frozen=True, kw_only=True)
class SwitchOptions(Options):
    """Threshold at which levels switch, and the levels that are written."""

    k: float = option(THRESHOLD.k, "K", "Slope of the threshold.")
    d: float = option(
        THRESHOLD.d, "D", "The threshold of an object that covers 1/16 of the screen: see nf.lod.LodThreshold."
    )
    threshold: Kind = choice(THRESHOLD.kind, "Formula of the threshold.")
    quality: float | None = option(None, "SSIM", "Minimum score at all sizes, instead of the threshold.")
    floor: str | None = option(
        None, "H,H,…", "Shares of the picture's height up to which levels 1, 2, … are shown whatever their scores."
    )
    all_levels: bool = flag("--all-levels", "Also write levels that are never shown.")

    @cached_property
    def limit(self) -> nf.lod.LodThreshold:
        if self.quality is not None:
            for name in ("k", "d", "threshold"):
                if name in self.given_options():
                    raise ValueError(f"{name}: expected none with --quality, got {getattr(self, name)}")
            return nf.lod.LodThreshold(0.0, check.in_range("quality", self.quality, 0.0, 1.0), "constant")
        return nf.lod.LodThreshold(self.k, self.d, self.threshold)

    @cached_property
    def heights(self) -> tuple[float, ...]:
        shares = () if self.floor is None else read_numbers("--floor", self.floor, "numbers such as 0.5,0.25,0.1")
        return read_floor(shares)


def lod(
    *,
    scene: options.Input,
    output: Path = option(..., "FILE", "The model: .glb with its levels, or .json without.", "-o --output"),
    simplifier: SimplifyOptions,
    measurement: MeasureOptions,
    switching: SwitchOptions,
    backend: options.Backend = None,
    scene_options: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Simplify an object, measure the SSIM of each level over its size, and write the model with sizes to switch at."""
    check_target(output, ".glb", ".json")
    loaded, clock = open_scene(scene, scene_options.loading), Clock()
    device = measurement.device
    with clock.step("simplify"):
        levels = nf.lod.simplify(loaded, name=Path(scene.partition(":")[0]).stem, **simplifier.keywords)
    with clock.step("measure"):
        model = nf.lod.measure(levels, settings=measurement.settings, backend=backend)
    rules: dict[str, Any] = {"view": device, "threshold": switching.limit, "floor": switching.heights}
    model.export(output, **rules, all_levels=switching.all_levels)
    switches = nf.lod.switches(model, **rules)
    written = np.ones(len(model), bool) if switching.all_levels else switches.is_ever_shown
    document = describe(model, switches, written) | {
        "source": scene,
        "notes": list(loaded.report.notes),
        "file": str(output),
        "bytes": output.stat().st_size,
        "hmd": device.name,
        "seconds": clock.seconds,
    }
    rows = [
        *((f"level {n}", _text(level, model.triangles[0])) for n, level in enumerate(document["levels"])),
        *_hints(loaded, document),
        ("headset", device.name),
        ("file", f"{output}, {bytes_text(document['bytes'])}"),
        *((step, f"{value:.2f} s") for step, value in clock.seconds.items()),
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
                "quality": None if np.isnan(switches.score[number]) else float(switches.score[number]),
                "shown": bool(switches.is_ever_shown[number]),
                "reason": str(switches.reason[number]),
                "written": bool(written[number]),
                "limit_of_measurement": bool(switches.is_limit[number]),
                "distance": None if never[number] else float(switches.distance[number] * model.radius),
            }
            for number in range(len(model))
        ],
        "screen_coverage": switches.of_levels(np.flatnonzero(written)).coverages(),
    }


def _text(level: dict[str, Any], full: int) -> str:
    """Describe a level of an object of `full` triangles."""
    parts = [f"{count(level['triangles'])} triangles"]
    if level["curve"] is not None:
        parts[0] += f" ({100.0 * level['triangles'] / max(full, 1):.3g} %), off by up to {_length(level['error'])}"
    if level["quality"] is not None and level["curve"] is not None:
        # Rounded down: with a greater --quality the level would not be shown up to the greatest measured size.
        parts.append(f"SSIM at least {int(100 * level['quality']) / 100:.2f} at all sizes measured")
    if not level["shown"]:
        parts.append(f"never shown: {level['reason']}" + ("" if level["written"] else "; left out of the file"))
    elif level["distance"] is not None and level["curve"] is not None:
        where = f"shown where the object covers up to {_percent(level['screen_coverage'])} of the picture"
        largest = ", the largest size measured" if level["limit_of_measurement"] else ""
        parts.append(f"{where}{largest}: {_length(level['distance'])} away or more")
    return "; ".join([*parts, *filter(None, [level["note"]])])


def _length(metres: float) -> str:
    """Format a length with three digits, from a kilometre on in whole metres."""
    return f"{metres:,.0f} m" if metres >= 1000.0 else f"{metres:.3g} m"


def _percent(share: float) -> str:
    """Format a share with three digits."""
    return f"{100.0 * share:.3g} %"


def _hints(scene: nf.Scene, document: dict[str, Any]) -> list[tuple[str, str]]:
    """Return table rows that explain how levels are chosen, and that a whole scene is one object."""
    rows, coarser = [], [level for level in document["levels"][1:] if level["shown"]]
    if coarser:
        rows.append(("threshold", "a level is shown if its SSIM is above a threshold, lower for smaller objects; "
            "--quality SSIM demands one value at all sizes"))  # fmt: skip
    if len(scene.object_names) > 1 and document["radius"] >= MIN_SCENE_RADIUS:
        near = min((level["distance"] or math.inf for level in coarser), default=math.inf)
        where = f" less than {_length(near)} from its middle" if near < math.inf else ""
        rows.append(("note", f"all {count(len(scene.object_names))} objects of the scene became one object, which is "
            f"drawn in full{where}; for levels of single objects, give each its own file"))  # fmt: skip
    return rows
