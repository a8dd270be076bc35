"""Reads a tileset, or a single tile, for a scene."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

from nearfar._base import check, glb
from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget
from nearfar._scene.city.read import KINDS as CITIES
from nearfar._scene.content import Content
from nearfar._scene.tileset.frames import checked_origin
from nearfar._scene.tileset.tileset import KINDS, Tileset, suffix


@dataclass(frozen=True)
class Detail:
    """Selection of a tileset's tiles, and the scene's origin; `nearfar.Scene.load` documents the fields."""

    error: float | None = None
    triangles: int | None = None
    origin: tuple[float, float, float] | None = None

    @classmethod
    def from_arguments(cls, error: Any, triangles: Any, origin: Any) -> Detail:
        """Check arguments; ValueError or TypeError if they are invalid."""
        if error is not None and triangles is not None:
            raise ValueError("triangles: expected none beside an error, got both")
        return cls(
            None if error is None else check.at_least_zero("error", error),
            None if triangles is None else check.integer("triangles", triangles, 1, 1 << 40),
            checked_origin(origin),
        )

    def check_kind(self, path: str | os.PathLike[str]) -> None:
        """Reject fields for files that are not tilesets; footprints may have an origin, too."""
        if suffix(path) not in (*KINDS, "json"):
            for name in ("error", "triangles", *(() if suffix(path) in CITIES else ("origin",))):
                if getattr(self, name) is not None:
                    raise ValueError(f"{name}: expected none with {os.fspath(path)}, which is no tileset")

    def check_unused(self) -> None:
        """Reject fields for JSON that is not a tileset; UnusableError."""
        for name in ("error", "triangles"):
            if getattr(self, name) is not None:
                raise UnusableError(f"it is no tileset: {name} does not apply to it")


def is_tileset(data: bytes) -> bool:
    """Whether a JSON file holds a tileset."""
    document = glb.json_object(data)
    return "root" in document and "asset" in document


def read(path: str | os.PathLike[str], detail: Detail, budget: Budget) -> Content:
    """Read a tileset, or a single b3dm, i3dm or cmpt; errors are those of `Tileset.open` and `Tileset.read`."""
    if "://" in os.fspath(path) and suffix(path) not in (*KINDS, "json"):
        raise UnusableError("of files at URLs only those of 3D Tiles are read: download it")
    tileset = Tileset.open(path, origin=detail.origin, budget=budget)
    error = 0.0 if detail.error is None else detail.error
    return tileset.read(error=error, triangles=detail.triangles, budget=budget)
