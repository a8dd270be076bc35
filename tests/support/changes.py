"""Finds the stages that a change touches, and dependent stages."""

from __future__ import annotations

import re
from collections.abc import Iterable

from tests.support.graphs import reachable
from tests.support.stages import CORE, PACKAGE

ROOMS = {name.strip("_") for name in PACKAGE if name != "__init__"}
"""Names of the stages that have a folder of tests."""

RUST_ROOMS = {"bvh": "scene", "export": "stream", "exr": "base"}
"""Stages of the core whose folder of tests has another name."""

ALL = "everything"
"""Represents the folders of all stages."""

FIXED: dict[str, set[str]] = {
    r"(docs|notebooks|LICENSE|CHANGELOG|README|ARCHITECTURE|references)": {"project"},
    r"scripts/(bench|first_hour|notebooks|\w+_picture|pictures|tokyo_geoparquet|view_load)\.py": {"project"},
    r"(benchmarks|fuzz|tests/mutations)/": set(),
    r"scripts/mutations\.py|\.ci/landed": set(),
    r"tests/exporters/": {"scene"},
    r"tests/readers/": {"impostor", "lod", "orthoview", "stream"},
    r"rust/gpu/": {"gpu", "orthoview", "reduce", "stereo"},
    r"rust/serve/": {"serve", "view"},
    r"(web|python/nearfar/view)/.*orthoview": {"orthoview"},
    r"(web|python/nearfar/view/dist)/": {"orthoview", "view"},
}
"""Files by path prefix, and the folders of tests that cover them; no other stage uses these."""


def stages_of(path: str) -> set[str]:
    """Folders of tests for a file that changed; `ALL` for a file of base, of the build or of the tests' support."""
    for beginning, folders in FIXED.items():
        if re.match(beginning, path):
            return folders
    if found := re.match(r"tests/(\w+)/", path):
        return {found[1]} if found[1] in ROOMS | {"attack", "project"} else {ALL}
    if found := re.match(r"rust/core/src/(\w+)", path):
        using = {stage for stage in CORE if found[1] in reachable(CORE, stage) | {stage}}
        rooms = {RUST_ROOMS.get(stage, stage) for stage in using}
        return {ALL} if not using or "base" in rooms else set().union(*(users_of(room) for room in rooms))
    if found := re.match(r"(?:rust/py/src|python/nearfar)/_?(\w+)", path):
        return users_of(found[1])
    return {ALL}


def users_of(room: str) -> set[str]:
    """A stage and all stages that use it, directly or not; `ALL` for base and for unknown parts."""
    names = {name.strip("_"): name for name in PACKAGE if name != "__init__"}
    if room not in names or room == "base":
        return {ALL}
    return {other for other, name in names.items() if names[room] in reachable(PACKAGE, name) | {name}}


def choose(paths: Iterable[str]) -> dict[str, str]:
    """Folders of tests to run for changed files, each with the first file that requires it; `ALL` means all."""
    reasons: dict[str, str] = {}
    for path in sorted(paths):
        for folder in sorted(stages_of(path)):
            reasons.setdefault(folder, path)
    return reasons
