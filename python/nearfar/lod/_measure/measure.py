"""Measuring how good levels look over their size."""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, overload

from nearfar._base import check
from nearfar._base.distribute import distribute
from nearfar._camera.camera import Fov
from nearfar._render import backend as backends
from nearfar._render.channels import MAX_SAMPLES
from nearfar.hmd._hmd import Hmd
from nearfar.lod._levels import Levels
from nearfar.lod._measure.one_object import Settings, measure_one
from nearfar.lod._measure.views import AXES, Screen
from nearfar.lod._model import LodModel


@overload
def measure(
    levels: Levels,
    *,
    hmd: Hmd | None = None,
    fov: Fov | None = None,
    size: tuple[int, int] | None = None,
    views: int = 144,
    distances: int = 16,
    percentile: float = 25.0,
    step: float | None = 0.05,
    saturated: float | None = 0.999,
    samples: int = 4,
    backend: str = "auto",
    cache: bool = True,
    workers: int | None = None,
    client: Any = None,
) -> LodModel: ...
@overload
def measure(
    levels: Mapping[str, Levels],
    *,
    hmd: Hmd | None = None,
    fov: Fov | None = None,
    size: tuple[int, int] | None = None,
    views: int = 144,
    distances: int = 16,
    percentile: float = 25.0,
    step: float | None = 0.05,
    saturated: float | None = 0.999,
    samples: int = 4,
    backend: str = "auto",
    cache: bool = True,
    workers: int | None = None,
    client: Any = None,
) -> dict[str, LodModel]: ...
@overload
def measure(
    levels: Sequence[Levels],
    *,
    hmd: Hmd | None = None,
    fov: Fov | None = None,
    size: tuple[int, int] | None = None,
    views: int = 144,
    distances: int = 16,
    percentile: float = 25.0,
    step: float | None = 0.05,
    saturated: float | None = 0.999,
    samples: int = 4,
    backend: str = "auto",
    cache: bool = True,
    workers: int | None = None,
    client: Any = None,
) -> list[LodModel]: ...
def measure(
    levels: Levels | Mapping[str, Levels] | Sequence[Levels],
    *,
    hmd: Hmd | None = None,
    fov: Fov | None = None,
    size: tuple[int, int] | None = None,
    views: int = 144,
    distances: int = 16,
    percentile: float = 25.0,
    step: float | None = 0.05,
    saturated: float | None = 0.999,
    samples: int = 4,
    backend: str = "auto",
    cache: bool = True,
    workers: int | None = None,
    client: Any = None,
) -> LodModel | dict[str, LodModel] | list[LodModel]:
    """Measure how good levels look beside their base over the size at which they are seen.

    Base and level are rendered from all sides at growing distances, alone and before the sky, and compared by SSIM
    (Gaussian, 11×11, σ 1.5, on the Rec. 709 luma of 8-bit sRGB) where either of them shows the object at a pixel's
    centre. A percentile over the views is what a level scores at that size, and a curve goes through these.

    Parameters
    ----------
    levels
        Of one object, the base first; or of many, by name or in a row. One level alone costs nothing.
    hmd
        The headset. Pictures have the pixels of its left eye's view, but lie symmetric about the axis, and only the
        object's box is rendered: it shows the same as the whole.
    fov, size
        A view and its width and height in pixels, in place of `hmd`.
    views
        From how many sides, a multiple of 4: the object turns in equal steps about x, y, z and the diagonal (1, 1, 1)
        of its own frame, before a camera on +z. Light and sky turn with the object.
    distances
        How many, 1 to 1000. At the first the bounding sphere's solid angle is σ₁/₁₆ = 2π(1−cos(asin(¼ tan ω))), where
        ω is half the horizontal field of view; to the sphere's nearest point the others are 2, 3, … times as far. Fewer
        than 4 leave curves "unfittable", and of fewer than 8 many look "flat": those stay at their least score.
    percentile
        Over the views, 0 to 100, as NumPy's "averaged_inverted_cdf".
    step
        Keep the coarsest of the levels that score at least 1 − step at the first distance, the coarsest of those that
        score at least 1 − 2 step, and so on; likewise at the next three, because SSIM of bumpy things may fall as they
        get smaller. Others look no better than a coarser one, and are measured no further. The base always stays. None
        keeps all.
    saturated
        A level that scores as much at two distances running is measured no further, and its curve stays where it was.
        None measures all.
    samples
        Of each pixel, as in `render`.
    backend
        As in `render`. Where a GPU multisamples, curves differ a little from the CPU's.
    cache
        Whether scores are kept, by content and settings: what was measured once, or before Ctrl-C, is not rendered
        again, and a level that is new is measured alone.
    workers
        Processes over which many objects are spread. The program's main module must be importable, as always with
        `multiprocessing`. None stays in this process.
    client
        A `distributed.Client`: objects are spread over a Dask cluster, whose workers have nearfar. Results are the same
        bytes in all three cases, where back ends are the same.

    Returns
    -------
    LodModel, or dict or list of them
        With `levels`, `samples`, and what was done in `measured`: "renders" and "scores" (pictures and comparisons
        made), "cached" (scores that were there) and "skipped" (scores that nobody needs, of levels × distances × views,
        those of a view that came before among them). `samples.score` is NaN where a level was measured no further.

    Raises
    ------
    ValueError, TypeError
        For arguments out of their domains, and for a base that is a single point.
    RuntimeError
        Where processes end at once, as in scripts without a guard for `__main__`.
    DeviceError
        As `render`.

    References
    ----------
    Liebisch (2021): views, distances, percentile and curve. Wang, Bovik, Sheikh, Simoncelli (2004): SSIM.
    """
    settings = Settings(
        screen=Screen.of(hmd, fov, size),
        views=check.integer("views", views, len(AXES), 1 << 20),
        distances=check.integer("distances", distances, 1, 1000),
        percentile=_within("percentile", percentile, 0.0, 100.0),
        step=None if step is None else check.positive("step", step),
        saturated=None if saturated is None else _within("saturated", saturated, -1.0, 1.0),
        samples=check.integer("samples", samples, 1, MAX_SAMPLES),
        backend=backends.check(backend),
        cache=_flag("cache", cache),
    )
    if settings.views % len(AXES):
        raise ValueError(f"views: expected a multiple of {len(AXES)}, got {settings.views}")
    names, objects = _objects(levels)
    measure_object = functools.partial(measure_one, settings=settings)
    measured = distribute(measure_object, objects, label="measuring", workers=workers, client=client)
    models = [
        replace(model, levels=Levels([own[number] for number in chosen], name=own.name, frame=own.frame))
        for own, (model, chosen) in zip(objects, measured, strict=True)
    ]
    if isinstance(levels, Levels):
        return models[0]
    return models if names is None else dict(zip(names, models, strict=True))


def _objects(levels: object) -> tuple[list[str] | None, list[Levels]]:
    """Names, where there are any, and levels of each object."""
    names: list[str] | None = None
    if isinstance(levels, Levels):
        return names, [levels]
    if isinstance(levels, Mapping):
        names, objects = list(levels), list(levels.values())
    elif isinstance(levels, Sequence) and not isinstance(levels, str | bytes):
        objects = list(levels)
    else:
        raise TypeError(f"levels: expected Levels, or a mapping or a sequence of them, got {type(levels).__name__}")
    for place, own in zip(range(len(objects)) if names is None else names, objects, strict=True):
        if not isinstance(own, Levels):
            raise TypeError(f"levels[{place!r}]: expected Levels, got {type(own).__name__}")
    return names, objects


def _within(name: str, value: float, low: float, high: float) -> float:
    given = check.number(name, value)
    if not low <= given <= high:
        raise ValueError(f"{name}: expected a number from {low:g} to {high:g}, got {given}")
    return given


def _flag(name: str, value: bool) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"{name}: expected True or False, got {value!r}")
    return value
