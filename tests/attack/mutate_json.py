"""Damage to JSON documents, which stay JSON."""

from __future__ import annotations

import copy
import json
import math
import random
from collections.abc import Iterator
from typing import Any

_VALUES: tuple[Any, ...] = (
    None, True, False, 0, -1, 1, 2, 255, 2**31 - 1, 2**31, 2**32, 2**53, 2**63, 2**64, -(2**63), 10**400, 0.5, -0.0,
    1e308, 1e-320, 3.5e38, 1e30, math.nan, math.inf, -math.inf, "", "x", "0", "nan", "\ud800", "a\0b", "../a",
    "/dev/zero",
    "a" * 300, "\u202e", [], {}, [[]], [None], [0], [0, 0, 0], [1e300] * 3, [0] * 16, {"a": 1}, [{}], "1", "data:,",
    "data:application/octet-stream;base64,AAAA",
)  # fmt: skip


def damaged(document: Any, dice: random.Random) -> Any:
    """Damage a document one or more times."""
    document = copy.deepcopy(document)
    for _ in range(dice.choice((1, 1, 1, 2, 3))):
        places = list(_places(document))
        if not places:
            return dice.choice(_VALUES)
        node, key = dice.choice(places)
        _change(node, key, places, dice)
    return document


def _places(node: Any) -> Iterator[tuple[Any, Any]]:
    """List places in a document as container and key; of long lists only some."""
    stack = [node]
    while stack:
        node = stack.pop()
        keys = list(node) if isinstance(node, dict) else list(range(min(len(node), 50)))
        for key in keys:
            yield node, key
            if isinstance(node[key], dict | list):
                stack.append(node[key])


def _change(node: Any, key: Any, places: list[tuple[Any, Any]], dice: random.Random) -> None:
    value = node[key]
    match dice.randrange(10):
        case 0 | 1 | 2:
            node[key] = copy.deepcopy(dice.choice(_VALUES))
        case 3:
            del node[key]
        case 4:
            other, place = dice.choice(places)
            # The other place may have been removed with its container; a copy keeps the document a tree.
            node[key] = copy.deepcopy(other[place]) if _has(other, place) else None
        case 5:
            if isinstance(node, list):
                node.insert(key, copy.deepcopy(value))
            else:
                node[dice.choice((f"{key}2", key.upper(), ""))] = copy.deepcopy(value)
        case 6:
            if isinstance(value, list) and value:
                node[key] = (value * dice.choice((0, 2, 100)))[:10_000]
            elif isinstance(value, str):
                node[key] = value + dice.choice(("x", "\0", "\n", "é"))
        case 7:
            if isinstance(value, int | float):
                # Integers of JSON may be beyond float64.
                near = min(max(value, -(10**300)), 10**300)
                node[key] = dice.choice((value + 1, value - 1, -value, value * 2, near + 0.5, float(near), str(value)))
        case 8:
            node[key] = dice.choice(([value], {"value": value}, {str(key): value}))
        case _:
            node[key] = nested(value, dice.choice((1, 3, 200)))


def _has(node: Any, key: Any) -> bool:
    return key in node if isinstance(node, dict) else 0 <= key < len(node)


def nested(value: Any, depth: int) -> Any:
    """Nest a value in a number of lists."""
    for _ in range(depth):
        value = [value]
    return value


def text(document: Any, dice: random.Random) -> bytes:
    """Encode a document, if possible, in one of the encodings of files; sometimes with a duplicate key."""
    written = json.dumps(document, ensure_ascii=dice.random() < 0.5)
    if dice.random() < 0.01:
        written = written.replace(":", ":" + "[" * 100_000, 1)
    if dice.random() < 0.05:
        written = written.replace("{", '{"version": 7, ', 1)
    if dice.random() < 0.05:
        written = written.replace("NaN", "1e999")
    return written.encode("utf-8", "surrogatepass")
