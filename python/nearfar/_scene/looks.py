"""Summaries of a source's shapes, and notes on materials drawn differently, for reports."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from nearfar._scene.materials import BaseColor
from nearfar._scene.report import count


@dataclass(frozen=True)
class Look:
    """Attributes and materials shared by some shapes."""

    number: int
    """Number of these shapes."""
    materials: Sequence[BaseColor]
    """Materials; an empty list means the plain one."""
    has_normals: bool
    has_uvs: bool
    has_colors: bool
    see_through: int
    """Number of these shapes with a vertex alpha below 1."""


def inventory(looks: Sequence[Look], vertices: int) -> list[str]:
    """Count shapes, their vertices, and those that have an attribute, one phrase each."""
    shapes = sum(look.number for look in looks)
    attributes = {
        "vertex normals": sum(look.number for look in looks if look.has_normals),
        "texture coordinates": sum(look.number for look in looks if look.has_uvs),
        "vertex colours": sum(look.number for look in looks if look.has_colors),
    }
    whole = "all of them" if shapes > 1 else "it"
    return [
        f"{count(shapes, 'mesh', 'meshes')} with {count(vertices, 'vertex', 'vertices')}",
        *(
            f"{name} of {whole if number == shapes else f'{number:,} of them'}"
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
    drawn = "opaque" if material.cutoff is None else "where alpha is at least 1/2"
    return [f"with {material.blend} drawn {drawn}"] if material.blend else []


def _alpha_notes(looks: Iterable[Look]) -> list[str]:
    ignoring = (look for look in looks if not look.materials or any(part.cutoff is None for part in look.materials))
    transparent = sum(look.see_through for look in ignoring)
    return [f"{count(transparent, 'mesh', 'meshes')} with vertex alpha below 1 drawn opaque"] if transparent else []


def _emission_notes(looks: Iterable[Look]) -> list[str]:
    lost = sum(
        look.number
        for look in looks
        if not look.has_uvs and any(material.emission_texture is not None for material in look.materials)
    )
    ending = "with a map of emission but no texture coordinates drawn and saved without it"
    return [f"{count(lost, 'mesh', 'meshes')} {ending}"] if lost else []
