"""Limits instances in 3MF files, which trimesh reads: nested components may multiply them without bound."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping, Sequence

from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget

_INSTANCE_BYTES = 1 << 14
"""Bytes taken from the budget per instance; the time grows, too: trimesh compares each name with all others."""

_MAX_INSTANCES = 1 << 62
"""Cap of instance counts, far above any budget. Each level of components may double the number."""


def check_instances(data: bytes, budget: Budget) -> None:
    """Count the instances of an archive's model before trimesh expands them; UnusableError for cyclic components."""
    from lxml import etree
    from trimesh.exchange.common import XML_PARSER_OPTIONS

    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        names = [name for name in archive.namelist() if "3d/3dmodel.model" in name.lower()]
        if not names:
            return
        tags = [f"{{*}}{name}" for name in ("object", "component", "item")]
        components: dict[str, list[str]] = {}
        items: list[str] = []
        object_id = ""
        with archive.open(names[0]) as model:
            for event, element in etree.iterparse(model, events=("start", "end"), tag=tags, **XML_PARSER_OPTIONS):
                kind = etree.QName(element).localname
                if event == "end":
                    if kind == "object":
                        object_id = ""
                        element.clear()
                elif kind == "object":
                    object_id = element.get("id", "")
                    components.setdefault(object_id, [])
                elif kind == "component":
                    components.setdefault(object_id, []).append(element.get("objectid", ""))
                else:
                    items.append(element.get("objectid", ""))
    budget.take(_INSTANCE_BYTES * sum(_instances(components, items)))


def _instances(components: Mapping[str, Sequence[str]], items: Sequence[str]) -> list[int]:
    """Number of objects in each build item: itself and all descendants."""
    counts: dict[str, int] = {}
    open_objects = set[str]()
    for item in items:
        pending = [item]
        while pending:
            object_id = pending[-1]
            children = components.get(object_id, ())
            uncounted = [part for part in children if part not in counts]
            if object_id in counts or not uncounted:
                counts.setdefault(object_id, min(_MAX_INSTANCES, 1 + sum(counts[part] for part in children)))
                open_objects.discard(object_id)
                pending.pop()
            elif object_id in open_objects and not open_objects.isdisjoint(uncounted):
                raise UnusableError(f"its object {object_id} is a component of itself")
            else:
                open_objects.add(object_id)
                pending += dict.fromkeys(uncounted)
    return [counts[item] for item in items]
