"""Counts of a scene's contents, and notes on the parts of its source that are used, dropped or drawn differently."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from nearfar import _core
from nearfar._scene.materials import PLAIN, UNCOLORED, BaseColor
from nearfar._scene.units import extent_note


class Unread(str):
    """Note on parts of a source that could not be read; the scene lacks triangles or has coarser ones."""

    __slots__ = ()


@dataclass(frozen=True)
class Report:
    """Contents of a scene; `str` formats them as text."""

    triangles: int
    """Number of triangles of all instances."""
    meshes: int
    """Number of distinct meshes; static meshes placed once are merged and count as one."""
    instances: int
    """Number of placed meshes, static and dynamic."""
    objects: int
    """Number of objects, with or without triangles."""
    dynamic: int
    """Number of instances that `Scene.at` can pose."""
    materials: int
    """Number of distinct materials, including those that look alike."""
    textures: int
    """Number of distinct images."""
    degenerate_faces: int
    """Number of faces with zero area, which are kept but never visible."""
    dropped_faces: int
    """Number of faces dropped because of non-finite or missing vertices (``on_invalid="drop"``)."""
    used: tuple[str, ...] = ()
    """Format of the source and the features that the scene uses, one phrase each; empty without a source."""
    notes: tuple[str, ...] = ()
    """Parts of the source that are ignored or drawn differently, and its unit if not the metre, one sentence each."""
    unit_note: str = ""
    """Sentence about an extent that suggests another unit than the metre; else empty.

    It is set if the scene is higher than 9,000 m (no ground is); or higher than 830 m (no building is) and a fifth
    of its width (steeper than landscapes); or smaller than 0.06 m, the distance between the eyes. Nothing is
    rescaled: a room in centimetres has the extent of a building in metres.
    """

    @classmethod
    def count(
        cls, core: _core.Scene, objects: int, dynamic: int, dropped: int, notes: tuple[str, ...], used: tuple[str, ...]
    ) -> Report:
        """Count the parts of a scene."""
        return cls(
            triangles=core.triangle_count,
            meshes=len(np.unique(core.mesh_ids())),
            instances=core.instance_count,
            objects=objects,
            dynamic=dynamic,
            materials=core.material_count,
            textures=core.texture_count,
            degenerate_faces=core.degenerate_count(),
            dropped_faces=dropped,
            notes=notes,
            used=used,
            unit_note=extent_note(core.bounds()),
        )

    def __str__(self) -> str:
        counts = [
            f"{count(self.triangles, 'triangle')} in {count(self.instances, 'instance')}"
            f" of {count(self.meshes, 'mesh', 'meshes')}",
            f"{count(self.objects, 'object')}, {count(self.dynamic, 'dynamic instance')}",
            f"{count(self.materials, 'material')}, {count(self.textures, 'drawn texture')}",
        ]
        if self.degenerate_faces:
            counts.append(f"{count(self.degenerate_faces, 'face')} without an area")
        if self.dropped_faces:
            counts.append(f"{count(self.dropped_faces, 'unusable face')} dropped")
        return "\n".join([*counts, *self.notes, *filter(None, [self.unit_note])])


def count(number: int, noun: str, plural: str = "") -> str:
    """Format a number with its noun, in the plural unless the number is 1."""
    return f"{number:,} {noun if number == 1 else plural or noun + 's'}"


def listing(items: Sequence[str], most: int = 3) -> str:
    """List the first items, and the number of the others."""
    others = f" and {len(items) - most:,} more" if len(items) > most else ""
    return ", ".join(items[:most]) + others


@dataclass(frozen=True)
class Surface:
    """Materials of faces, and their vertex attributes."""

    materials: Sequence[BaseColor]
    """Materials; empty means the plain one."""
    has_normals: bool
    has_uvs: bool
    has_colors: bool

    @property
    def is_textured(self) -> bool:
        """Whether the texture coordinates are used."""
        return self.has_uvs and any(material.is_textured for material in self.materials)

    @property
    def drawn_materials(self) -> list[BaseColor]:
        """Materials that the faces are drawn with, at least one."""
        materials = self.materials or [UNCOLORED if self.has_colors else PLAIN]
        return [material if self.is_textured else material.without_textures() for material in materials]


@dataclass(frozen=True)
class SurfaceUse:
    """A surface, and the numbers of shapes that have it."""

    surface: Surface
    shape_count: int
    transparent_count: int
    """Number of the shapes with a vertex alpha below 1."""


def inventory(uses: Sequence[SurfaceUse], vertices: int) -> list[str]:
    """Count shapes, vertices, and the shapes with each attribute, one phrase each."""
    shapes = sum(use.shape_count for use in uses)
    all_shapes = "all of them" if shapes > 1 else "it"
    phrases = [f"{count(shapes, 'mesh', 'meshes')} with {count(vertices, 'vertex', 'vertices')}"]
    attributes = {"has_normals": "vertex normals", "has_uvs": "texture coordinates", "has_colors": "vertex colours"}
    for field, name in attributes.items():
        if number := sum(use.shape_count for use in uses if getattr(use.surface, field)):
            phrases.append(f"{name} of {all_shapes if number == shapes else f'{number:,} of them'}")
    return phrases


def notes(uses: Sequence[SurfaceUse]) -> list[str]:
    """Notes on what is drawn differently from the source, one sentence each."""
    materials = {id(material): material for use in uses for material in use.surface.materials}
    counts = Counter(note for material in materials.values() for note in (*_blend_notes(material), *material.notes))
    opaque_count = dark_count = 0
    for use in uses:
        if any(material.cutoff is None for material in use.surface.drawn_materials):
            opaque_count += use.transparent_count
        has_map = any(material.emission_texture is not None for material in use.surface.materials)
        dark_count += use.shape_count * (has_map and not use.surface.has_uvs)
    dark = "with a map of emission but no texture coordinates drawn and saved without it"
    return [
        *(f"{count(number, 'material')} {note}" for note, number in counts.items()),
        *([f"{count(opaque_count, 'mesh', 'meshes')} with vertex alpha below 1 drawn opaque"] if opaque_count else []),
        *([f"{count(dark_count, 'mesh', 'meshes')} {dark}"] if dark_count else []),
    ]


def _blend_notes(material: BaseColor) -> list[str]:
    rendering = "opaque" if material.cutoff is None else "where alpha is at least 1/2"
    return [f"with {material.blend} drawn {rendering}"] if material.blend else []
