"""Instances in 3MF files, which trimesh reads: nested components may stand for more of them than fit anywhere."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping, Sequence

from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget

_INSTANCE = 1 << 14
"""Bytes that an instance counts as: trimesh compares its name with those of all others."""


def check_instances(data: bytes, budget: Budget) -> None:
    """Count the instances of an archive's model before trimesh lists them; UnusableError for loops of components."""
    from lxml import etree
    from trimesh.exchange.common import XML_PARSER_OPTIONS

    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        names = [name for name in archive.namelist() if "3d/3dmodel.model" in name.lower()]
        if not names:
            return
        tags, parts = [f"{{*}}{name}" for name in ("object", "component", "item")], dict[str, list[str]]()
        items: list[str] = []
        inside = ""
        with archive.open(names[0]) as model:
            for event, element in etree.iterparse(model, events=("start", "end"), tag=tags, **XML_PARSER_OPTIONS):
                kind = etree.QName(element).localname
                if event == "end":
                    if kind == "object":
                        inside = ""
                        element.clear()
                elif kind == "object":
                    inside = element.get("id", "")
                    parts.setdefault(inside, [])
                elif kind == "component":
                    parts.setdefault(inside, []).append(element.get("objectid", ""))
                else:
                    items.append(element.get("objectid", ""))
    budget.take(_INSTANCE * sum(_instances(parts, items)))


def _instances(parts: Mapping[str, Sequence[str]], items: Sequence[str]) -> list[int]:
    """Objects that each item of the build stands for, itself and all below."""
    counts: dict[str, int] = {}
    open_ones: set[str] = set()
    for item in items:
        pending = [item]
        while pending:
            one = pending[-1]
            below = parts.get(one, ())
            missing = [part for part in below if part not in counts]
            if one in counts or not missing:
                counts.setdefault(one, 1 + sum(counts[part] for part in below))
                open_ones.discard(one)
                pending.pop()
            elif one in open_ones and not open_ones.isdisjoint(missing):
                raise UnusableError(f"its object {one} is a component of itself")
            else:
                open_ones.add(one)
                pending += dict.fromkeys(missing)
    return [counts[item] for item in items]
