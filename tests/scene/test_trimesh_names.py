"""Private names of trimesh, without which files would be refused or read wrongly."""

from __future__ import annotations

import importlib

import pytest


@pytest.mark.parametrize(
    ("module", "names"),
    [
        ("trimesh.exchange.common", ["XML_PARSER_OPTIONS"]),
        ("trimesh.exchange.gltf", ["handle_extensions"]),
        ("trimesh.exchange.obj", ["parse_mtl"]),
        ("trimesh.geometry", ["weighted_vertex_normals"]),
        ("trimesh.visual.material", ["color_image"]),
        ("trimesh.resolvers", ["FilePathResolver.absolute"]),
    ],
)
def test_trimesh_has_the_private_names(module: str, names: list[str]) -> None:
    for name in names:
        found: object = importlib.import_module(module)
        for part in name.split("."):
            found = getattr(found, part)
