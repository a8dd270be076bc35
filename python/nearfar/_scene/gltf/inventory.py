"""Summary of the features of a glTF document that a scene uses."""

from __future__ import annotations

from typing import Any

from nearfar._base import check
from nearfar._scene.gltf import extensions
from nearfar._scene.gltf.corners import MODES, mode
from nearfar._scene.report import count


def used(header: dict[str, Any]) -> list[str]:
    """The format, counts of supported parts, and the extensions, one phrase each."""
    made_by = header.get("asset", {}).get("generator")
    placing = sum("mesh" in node for node in header.get("nodes", []))
    primitives = sum(mode(primitive) in MODES for mesh in header.get("meshes", []) for primitive in mesh["primitives"])
    return [
        "glTF 2.0" + (f", made by {check.shortened(str(made_by))}" if made_by else ""),
        f"{count(placing, 'node')} with meshes",
        f"{count(primitives, 'primitive')} of triangles",
        *(count(len(header[f"{part}s"]), part) for part in ("material", "texture", "image") if header.get(f"{part}s")),
        *extensions.used(header),
    ]
