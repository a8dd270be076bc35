"""Nodes of glTF files that do not form trees: errors, instead of meshes that are drawn twice or endlessly."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from tests.support.gltf_cases import gltf


def load(tmp_path: Path, nodes: list[dict[str, Any]], roots: list[int]) -> nf.Scene:
    path = tmp_path / "a.glb"
    path.write_bytes(gltf([{}], nodes=nodes, scenes=[{"nodes": roots}]))
    return nf.Scene.load(path)


@pytest.mark.parametrize(
    ("nodes", "roots", "words"),
    [
        ([{"mesh": 0, "children": [0]}], [0], "node 0 is a child of itself"),
        ([{"mesh": 0, "children": [1]}, {"mesh": 0, "children": [0]}], [0], "scene 0 lists node 0, .* child of node 1"),
        ([{"children": [1, 1]}, {"mesh": 0}], [0], "node 1 is a child of node 0 and again of node 0"),
        (
            [{"children": [2]}, {"children": [2]}, {"mesh": 0}],
            [0, 1],
            "node 2 is a child of node 0 and again of node",
        ),
        ([{"children": [1]}, {"mesh": 0}], [0, 1], "scene 0 lists node 1, which is a child of node 0"),
    ],
)
def test_nodes_that_are_no_trees_are_errors(
    nodes: list[dict[str, Any]], roots: list[int], words: str, tmp_path: Path
) -> None:
    with pytest.raises(nf.SceneError, match=rf"a\.glb: its {words}"):
        load(tmp_path, nodes, roots)


def test_loops_that_no_scene_reaches_are_not_drawn(tmp_path: Path) -> None:
    loop: list[dict[str, Any]] = [{"mesh": 0}, {"mesh": 0, "children": [2]}, {"mesh": 0, "children": [1]}]
    assert load(tmp_path, loop, [0]).triangle_count == 2
