"""Limits instances in 3MF files, which trimesh reads: nested components may multiply them without bound."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping, Sequence

from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget

_INSTANCE = 1 << 14
"""Bytes counted per instance: trimesh compares its name with those of all others."""

_MAX = 1 << 62
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
        parts: dict[str, list[str]] = {}
        items: list[str] = []
        owner = ""
        with archive.open(names[0]) as model:
            for event, element in etree.iterparse(model, events=("start", "end"), tag=tags, **XML_PARSER_OPTIONS):
                kind = etree.QName(element).localname
                if event == "end":
                    if kind == "object":
                        owner = ""
                        element.clear()
                elif kind == "object":
                    owner = element.get("id", "")
                    parts.setdefault(owner, [])
                elif kind == "component":
                    parts.setdefault(owner, []).append(element.get("objectid", ""))
                else:
                    items.append(element.get("objectid", ""))
    budget.take(_INSTANCE * sum(_instances(parts, items)))


def _instances(parts: Mapping[str, Sequence[str]], items: Sequence[str]) -> list[int]:
    """Number of objects in each build item: itself and all descendants."""
    counts: dict[str, int] = {}
    unfinished: set[str] = set()
    for item in items:
        pending = [item]
        while pending:
            owner = pending[-1]
            below = parts.get(owner, ())
            missing = [part for part in below if part not in counts]
            if owner in counts or not missing:
                counts.setdefault(owner, min(_MAX, 1 + sum(counts[part] for part in below)))
                unfinished.discard(owner)
                pending.pop()
            elif owner in unfinished and not unfinished.isdisjoint(missing):
                raise UnusableError(f"its object {owner} is a component of itself")
            else:
                unfinished.add(owner)
                pending += dict.fromkeys(missing)
    return [counts[item] for item in items]
