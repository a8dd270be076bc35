"""Summaries of a source's shapes for reports, and notes on materials that are drawn differently."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from nearfar._scene.materials import BaseColor
from nearfar._scene.report import count


@dataclass(frozen=True)
class Look:
    """Attributes and materials shared by some shapes."""

    shape_count: int
    """Number of these shapes."""
    materials: Sequence[BaseColor]
    """Materials; an empty list means the default material."""
    has_normals: bool
    has_uvs: bool
    has_colors: bool
    transparent_count: int
    """Number of these shapes with a vertex alpha below 1."""


def inventory(looks: Sequence[Look], vertices: int) -> list[str]:
    """Count shapes, vertices, and the shapes with each attribute, one phrase each."""
    shapes = sum(look.shape_count for look in looks)
    attributes = {
        "vertex normals": sum(look.shape_count for look in looks if look.has_normals),
        "texture coordinates": sum(look.shape_count for look in looks if look.has_uvs),
        "vertex colours": sum(look.shape_count for look in looks if look.has_colors),
    }
    all_shapes = "all of them" if shapes > 1 else "it"
    return [
        f"{count(shapes, 'mesh', 'meshes')} with {count(vertices, 'vertex', 'vertices')}",
        *(
            f"{name} of {all_shapes if number == shapes else f'{number:,} of them'}"
            for name, number in attributes.items()
            if number
        ),
    ]


def notes(looks: Sequence[Look]) -> list[str]:
    """Notes on differences between the drawn shapes and the source, one sentence each."""
    return [*_material_notes(looks), *_alpha_notes(looks), *_emission_notes(looks)]


def _material_notes(looks: Iterable[Look]) -> list[str]:
    materials = {id(material): material for look in looks for material in look.materials}
    counts = Counter(note for material in materials.values() for note in (*_blend_notes(material), *material.notes))
    return [f"{count(number, 'material')} {note}" for note, number in counts.items()]


def _blend_notes(material: BaseColor) -> list[str]:
    rendering = "opaque" if material.cutoff is None else "where alpha is at least 1/2"
    return [f"with {material.blend} drawn {rendering}"] if material.blend else []


def _alpha_notes(looks: Iterable[Look]) -> list[str]:
    opaque_looks = (look for look in looks if not look.materials or any(part.cutoff is None for part in look.materials))
    mesh_count = sum(look.transparent_count for look in opaque_looks)
    return [f"{count(mesh_count, 'mesh', 'meshes')} with vertex alpha below 1 drawn opaque"] if mesh_count else []


def _emission_notes(looks: Iterable[Look]) -> list[str]:
    mesh_count = sum(
        look.shape_count
        for look in looks
        if not look.has_uvs and any(material.emission_texture is not None for material in look.materials)
    )
    ending = "with a map of emission but no texture coordinates drawn and saved without it"
    return [f"{count(mesh_count, 'mesh', 'meshes')} {ending}"] if mesh_count else []
