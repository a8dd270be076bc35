"""`nearfar info`: what a scene holds."""

from __future__ import annotations

import dataclasses
import time
from typing import Any

import nearfar as nf
from nearfar import _formats
from nearfar.cli._options import Input, Invalid, Json, Up, open_scene
from nearfar.cli._output import count, metres, show

VERSION = 1


def info(scene: Input, up: Up = "y", on_invalid: Invalid = "raise", as_json: Json = False) -> None:
    """Say what a scene holds: triangles, objects, extent, and what its file had that is not used."""
    started = time.perf_counter()
    loaded = open_scene(scene, up=up, on_invalid=on_invalid)
    document = describe(loaded, scene, time.perf_counter() - started)
    rows = [
        *((key.replace("_", " "), _text(value)) for key, value in document["report"].items() if value),
        ("from", metres(document["bounds"][0])),
        ("to", metres(document["bounds"][1])),
        ("origin", metres(document["origin"])),
        ("loaded in", f"{document['seconds']:.2f} s"),
    ]
    show(document, rows, title=scene, as_json=as_json)


def describe(scene: nf.Scene, source: str, seconds: float) -> dict[str, Any]:
    """Document of a scene; schema "info"."""
    return _formats.header("info", VERSION, origin=[float(value) for value in scene.origin]) | {
        "source": source,
        "triangles": int(scene.triangle_count),
        "objects": len(scene.object_names),
        "bounds": [[float(value) for value in corner] for corner in scene.bounds],
        "report": _plain(dataclasses.asdict(scene.report)),
        "seconds": round(seconds, 3),
    }


def _plain(value: Any) -> Any:
    """Of types that JSON has."""
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple | set | frozenset):
        return [_plain(item) for item in value]
    return value if isinstance(value, str | int | float | bool | None) else str(value)


def _text(value: Any) -> str:
    if isinstance(value, int) and not isinstance(value, bool):
        return count(value)
    if isinstance(value, dict):
        return "; ".join(f"{key}: {_text(item)}" for key, item in value.items())
    return "; ".join(map(str, value)) if isinstance(value, list) else str(value)
