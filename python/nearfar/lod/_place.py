"""Makes scenes from models that are placed many times."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._scene.arrays import origin_for, transforms_of
from nearfar._scene.levels import check_levels, notes_of, with_levels
from nearfar._scene.names import Names, names_of
from nearfar._scene.scene import Scene
from nearfar._scene.serialize import empty_core
from nearfar.lod._measured_levels import MeasuredLevels
from nearfar.lod._select.kernel_inputs import models_of


def place(
    models: Sequence[MeasuredLevels] | Mapping[str, MeasuredLevels],
    model_index: ArrayLike,
    transforms: ArrayLike,
    *,
    names: Sequence[str] | None = None,
    dynamic: Iterable[str] = (),
) -> Scene:
    """Make a scene in which each model is placed any number of times.

    `lod` of `nearfar.render` selects the levels; by default level 0 is drawn. Placements share the meshes of their
    model's levels, so the scene takes little more memory than the models. Object n is model `model_index[n]` at
    `transforms[n]`. ValueError for indices out of range, unusable matrices, lengths that do
    not match, repeated or unknown names, or models without geometry; TypeError for values that are not models, numbers
    or names.

    Parameters
    ----------
    models
        Models with geometry (`LodModel`), in a sequence or by name, as returned by `measure`.
    model_index
        Model of each of the N objects (N,): indices or, if `models` is a mapping, also names.
    transforms
        Invertible matrices (N, 4, 4) for column vectors, from the frame of the models' levels and spheres to world;
        reflections and scales are allowed.
    names
        Names of the objects; by default ``object_0``, ``object_1``, …
    dynamic
        Names of objects that `Scene.at` can pose.
    """
    if not isinstance(models, Mapping):
        models = check.items("models", models, MeasuredLevels, "a sequence of LodModels or a mapping to them")
    listed, numbers = models_of(models, model_index)
    frames = transforms_of("transforms", transforms)
    if frames.ndim != 3:
        raise ValueError(f"transforms: expected shape (N, 4, 4), got {frames.shape}")
    count = len(frames)
    index = check.array("model_index", numbers, columns=None, dtype=np.int64)
    if index.shape != (count,):
        raise ValueError(f"model_index: expected one for each of {count} transforms, got shape {index.shape}")
    if count and not 0 <= index.min() <= index.max() < len(listed):
        raise ValueError(f"model_index: expected 0 to {len(listed) - 1}, got {index.min()} to {index.max()}")
    given_names = None if names is None else names_of("names", names)
    if given_names is not None and len(given_names) != count:
        raise ValueError(f"names: expected {count}, one for each transform, got {len(given_names)}")
    object_names = Names(count if given_names is None else given_names)
    movers = [dynamic] if isinstance(dynamic, str) else check.items("dynamic", dynamic, str, "names of objects")
    object_names.flags("dynamic", movers)  # rejects unknown names
    checked = check_levels(
        object_names, range(count), [listed[number] for number in index.tolist()], frames, in_place=False
    )
    positions = frames[:, :3, 3]
    bounds = np.array([positions.min(axis=0), positions.max(axis=0)]) if count else np.zeros((2, 3))
    empty = empty_core(check.vector("origin", origin_for(bounds)))
    core, placements, table = with_levels(empty, np.zeros((0, 3, 4)), None, count, checked)
    scene = Scene(
        core, object_names, frames=frames, load_placements=placements, table=table, **notes_of(checked.models)
    )
    return scene.with_dynamic(movers)
