"""Joins several scenes, such as the tiles of a world, into one."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._scene.names import Names
from nearfar._scene.poses import frame_of
from nearfar._scene.scene import Scene
from nearfar._scene.serialize import core_of_parts, parts_of


def join_scenes(scenes: Sequence[Scene]) -> Scene:
    """Join one or several scenes in the frame of the first; objects with the same name become one object.

    Scenes with levels contribute the levels that they show.
    """
    names, numbers = _union([scene._names for scene in scenes])
    load_placements = [scene._load_placements.copy() for scene in scenes]
    for scene, rows in zip(scenes, load_placements, strict=True):
        rows[:, :, 3] += scene.origin - scenes[0].origin
    return Scene(
        _core.Scene.join([scene._core for scene in scenes], numbers),
        names,
        frames=_frames(scenes, names, numbers),
        load_placements=np.concatenate(load_placements),
        dropped=sum(scene._dropped for scene in scenes),
        notes=tuple(dict.fromkeys(note for scene in scenes for note in scene._notes)),
        used=tuple(dict.fromkeys(extension for scene in scenes for extension in scene._used)),
        undrawn={tag: material for scene in scenes for tag, material in scene._undrawn.items()},
    )


def move_origin(scene: Scene, origin: ArrayLike) -> Scene:
    """Move a scene without dynamic objects so that its origin lies at another position (3,), metres."""
    core = core_of_parts(parts_of(scene._core) | {"origin": tuple(np.asarray(origin, np.float64).tolist())})
    return scene._derived(core, scene._load_placements)


def _union(name_lists: Sequence[Names]) -> tuple[Names, list[NDArray[np.int32]]]:
    """Unique names, and for each list the new numbers of its names, or an empty array if they do not change."""
    first = name_lists[0]
    if all(names is first for names in name_lists):
        return first, [np.zeros(0, np.int32) for _ in name_lists]
    number_by_name: dict[str, int] = {}
    numbers = [
        np.array([number_by_name.setdefault(name, len(number_by_name)) for name in names.as_tuple], np.int32)
        for names in name_lists
    ]
    return Names(tuple(number_by_name)), numbers


def _frames(scenes: Sequence[Scene], names: Names, numbers: Sequence[NDArray[np.int32]]) -> NDArray[np.float64] | None:
    """Load transforms of the objects, by number; an object of several scenes has that of the first scene."""
    if all(scene._frames is None for scene in scenes):
        return None
    if names is scenes[0]._names:
        return scenes[0]._frames
    frames = np.tile(np.eye(4), (len(names), 1, 1))
    for scene, new_numbers in zip(reversed(scenes), reversed(numbers), strict=True):
        for number, new_number in enumerate(new_numbers.tolist()):
            frames[new_number] = frame_of(scene._frames, number)
    return frames
