"""A valid call of every public callable, with small scenes and pictures."""

from __future__ import annotations

import functools
from collections.abc import Callable
from inspect import Parameter
from typing import Any

from tests.support.public_callables import PublicCallable, public_callables
from tests.support.valid_calls.objects import Valid
from tests.support.valid_calls.pictures import PICTURES
from tests.support.valid_calls.scenes import SCENES
from tests.support.valid_calls.streams import STREAMS
from tests.support.valid_calls.values import INSTANCES, SMALL, required_argument

OWN = {**SCENES, **PICTURES, **STREAMS}
"""Arguments by the callable's name, or by a prefix of names that ends in a full stop.

A name followed by " @" and a word is another call of the same callable, which reaches other checks.
"""

CALLABLES = public_callables()
NAMES = sorted({*CALLABLES, *(name for name in OWN if not name.endswith("."))})
"""Names of all calls."""

PASSED_ON = {
    "Scene.load": "LoadOptions",
    "Walk.render": "ReducedScene.render",
    "lod.MeasureSettings.full": "lod.MeasureSettings",
    "lod.MeasureSettings.published": "lod.MeasureSettings",
    "lod.Selector": "lod.LodRules",
    "lod.measure": "lod.MeasureSettings",
    "lod.select": "lod.LodRules",
    "metrics.ms_ssim": "SsimSettings",
    "metrics.ssim_pairs": "SsimSettings",
    "open_source": "LoadOptions",
    "orthoview.build": "orthoview.ViewSettings",
    "orthoview.simulate": "orthoview.FlightSettings",
    "ssim": "SsimSettings",
    "stream.export": "stream.ExportSettings",
    "stream.simulate": "stream.ClientSettings",
}
"""Callables to which others pass all keywords that they do not name."""

SETTINGS = {
    "render": "RenderSettings", "render_path": "RenderSettings", "render_eyes": "RenderSettings",
    "ReducedScene.render": "RenderSettings MorphSettings", "gpu.measure": "RenderSettings",
    "gpu.render": "RenderSettings", "orthoview.Flight.render": "RenderSettings",
    "orthoview.OrthoTree.far_map": "MapSettings", "orthoview.OrthoTree.render": "RenderSettings",
    "stereo.HybridRig.render": "RenderSettings stereo.HybridSettings",
    "stereo.TemporalAntialiasing.render": "RenderSettings stereo.HybridSettings", "choose_radii": "RadiusSettings",
    "reduce": "MapSettings", "Impostors.render": "RenderSettings",
    "regions": "RadiusSettings MapSettings",
}  # fmt: skip
"""Groups of settings whose fields callables also take as keywords."""

NEEDS = {
    "FlightLog.plot": "matplotlib", "LoadCurve.plot": "matplotlib", "LodModel.plot": "matplotlib",
    "Timeline.plot": "matplotlib", "explore": "ipywidgets", ".show ": "anywidget",
    "lod.simplify": "fast_simplification", "orthoview.": "zarr", "stream.client.": "aiohttp", "collect.play": "aiohttp",
    "gpu.": "adapter", ".begin": "adapter", "metrics.jod": "pycvvdp",
}  # fmt: skip
"""Parts of `tests.support.PARTS` that calls need, by parts of their names; a space is the end of a name."""


def callable_of(name: str) -> PublicCallable:
    """Return the callable of a call."""
    return CALLABLES[name.partition(" @")[0]]


@functools.cache
def parameters_of(name: str) -> dict[str, tuple[str, Parameter]]:
    """Return the parameters of a call, each with its full name, such as "Scene.load.path".

    Keywords that the callable passes on are those of the other callable.
    """
    entry = callable_of(name)
    found = {key: (f"{entry.name}.{key}", value) for key, value in _own_parameters(entry).items()}
    passed_on = PASSED_ON.get(entry.name)
    return found if passed_on is None else {**parameters_of(passed_on), **found}


def receivers(name: str) -> list[str]:
    """Return the callables to which a callable forwards keywords, directly or through another one."""
    direct = [*SETTINGS.get(name, "").split(), *([PASSED_ON[name]] if name in PASSED_ON else [])]
    return [receiver for one in direct for receiver in (one, *receivers(one))]


def _own_parameters(entry: PublicCallable) -> dict[str, Parameter]:
    """Return the parameters of a callable, and the fields of its groups of settings."""
    groups = [CALLABLES[group].parameters for group in SETTINGS.get(entry.name, "").split()]
    return {name: parameter for one in (*groups, entry.parameters) for name, parameter in one.items()}


def needs(name: str) -> list[str]:
    """Return the parts of the system that a call needs."""
    return [part for key, part in NEEDS.items() if key in f"{name} "]


def arguments(name: str, valid: Valid) -> dict[str, Any]:
    """Return the keywords of a call."""
    found = dict(OWN[name](valid)) if name in OWN else {}
    shared = {
        key: value
        for part in OWN
        if part.endswith(".") and name.startswith(part)
        for key, value in OWN[part](valid).items()
    }
    for parameter in _own_parameters(callable_of(name)).values():
        if parameter.name in found:
            continue
        if parameter.name in SMALL:
            found[parameter.name] = SMALL[parameter.name]
        elif parameter.default is Parameter.empty:
            own = parameter.name in shared
            found[parameter.name] = shared[parameter.name] if own else required_argument(parameter.name, valid)
    return found


def target(name: str, valid: Valid) -> Callable[..., Any]:
    """Return the callable; methods of objects that calls change get a new one each time."""
    entry = callable_of(name)
    if entry.owner is None:
        return entry.on(None)
    return entry.on(INSTANCES.get(name, INSTANCES[entry.owner])(valid))
