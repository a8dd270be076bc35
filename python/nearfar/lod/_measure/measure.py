"""Measures how similar levels look to their base over size."""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, Unpack, overload

from nearfar._base import cache, check
from nearfar._base.distribute import distribute
from nearfar._base.settings import gather
from nearfar.lod._levels import Levels, pick_levels
from nearfar.lod._measure.one_object import count_scores, measure_one
from nearfar.lod._measure.settings import MeasureKeywords, MeasureOptions, MeasureSettings
from nearfar.lod._model import LodModel


# One overload for each type of `levels`, so that callers need not narrow a union of return types.
@overload
def measure(levels: Levels, **options: Unpack[MeasureOptions]) -> LodModel: ...
@overload
def measure(levels: Mapping[str, Levels], **options: Unpack[MeasureOptions]) -> dict[str, LodModel]: ...
@overload
def measure(levels: Sequence[Levels], **options: Unpack[MeasureOptions]) -> list[LodModel]: ...
def measure(
    levels: Levels | Mapping[str, Levels] | Sequence[Levels],
    *,
    settings: MeasureSettings | None = None,
    workers: int | None = None,
    client: Any = None,
    **keywords: Unpack[MeasureKeywords],
) -> LodModel | dict[str, LodModel] | list[LodModel]:
    """Measure how similar levels look to their base, over the size at which they are seen.

    Base and level are rendered from all sides at growing distances, alone in front of the sky, and compared by SSIM
    (Gaussian, 11×11, σ 1.5, on the Rec. 709 luma of 8-bit sRGB) at pixels whose centre shows the object in either
    picture. The score of a level at a size is a percentile, or the mean, over the views. A falling curve is fitted to
    the least score at each size and all smaller ones, so that no object gets a finer level as it shrinks.

    ValueError and TypeError for arguments out of range, or a base that is a single point; DeviceError as in `render`;
    RuntimeError if processes end at once, as in scripts without a guard for `__main__`. On Ctrl-C, a note of the
    KeyboardInterrupt says how many of all scores are cached, and where. Sources: Liebisch (2021) for published
    views, distances, percentile and curve; Swinbank, Purser (2006) for even directions; Wang, Bovik, Sheikh, Simoncelli
    (2004) for SSIM.

    Parameters
    ----------
    levels
        Levels of one object, base first; or of many, by name or in a sequence. A single level needs no work.
    settings
        The screen, views, sizes and rules, as `MeasureSettings`.
    workers
        Number of processes over which many objects are distributed. The program's main module must be importable, as
        `multiprocessing` requires. None measures in this process.
    client
        A `distributed.Client`, to distribute objects over a Dask cluster whose workers have nearfar. Results have the
        same bytes however objects are distributed, if the backends are the same.
    keywords
        Fields of `settings`, which they replace: `hmd`, or `fov` and `size`; `views`, `directions`, `spacing`,
        `distances`, `standard_error`, `percentile`, `step`, `saturated`, `samples`, `backend`, `cache`.

    Returns
    -------
    LodModel, or dict or list of them
        A model for one object, a dict for a mapping, a list for a sequence. A model has `levels` and `samples`, and
        counts of the work in `measured`: "renders" and "scores" (pictures and comparisons made), "cached" (scores found
        in the cache) and "skipped" (the other ones of levels × distances × views, including duplicate views).
        `samples.score` is NaN at sizes where a level was no longer measured.
    """
    measure_settings = gather(MeasureSettings, settings, keywords)
    names, objects = _objects(levels)
    measure_object = functools.partial(measure_one, settings=measure_settings)
    try:
        measured = distribute(measure_object, objects, label="measuring", workers=workers, client=client)
    except KeyboardInterrupt as interrupt:
        interrupt.add_note(_describe_progress(objects, measure_settings, client))
        raise
    models = [
        replace(model, levels=pick_levels(every_level, kept))
        for every_level, (model, kept) in zip(objects, measured, strict=True)
    ]
    if isinstance(levels, Levels):
        return models[0]
    return models if names is None else dict(zip(names, models, strict=True))


def _describe_progress(objects: list[Levels], settings: MeasureSettings, client: Any) -> str:
    """Describe how many scores of an interrupted measurement are cached."""
    if not settings.cache:
        return "measure: no scores are kept without a cache"
    if client is not None:
        return "measure: scores are kept in the cache folders of the cluster's workers; the same call goes on from them"
    known_count, total_count = map(sum, zip(*(count_scores(levels, settings) for levels in objects), strict=True))
    kept = f"measure: {known_count:,} of at most {total_count:,} scores are kept in {cache.folder()}"
    return f"{kept}; the same call goes on from them"


def _objects(levels: object) -> tuple[list[str] | None, list[Levels]]:
    """Names, if given, and levels of each object."""
    if isinstance(levels, Levels):
        return None, [levels]
    if isinstance(levels, Mapping):
        by_key: dict[Any, object] = dict(check.mapping("levels", levels, "Levels by name"))
    elif isinstance(levels, Sequence) and not isinstance(levels, str | bytes):
        by_key = dict(enumerate(levels))
    else:
        raise TypeError(f"levels: expected Levels, or a mapping or a sequence of them, got {type(levels).__name__}")
    objects = [check.instance(f"levels[{key!r}]", item, Levels, "Levels") for key, item in by_key.items()]
    return list(by_key) if isinstance(levels, Mapping) else None, objects
