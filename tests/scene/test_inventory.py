"""Tests of the inventory of a scene's source: used and unused parts."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar._scene.report import Report
from tests.support.cli_cases import command
from tests.support.gltf_cases import gltf


def report(path: Path) -> Report:
    return nf.Scene.load(path).report


def test_glb_inventories_list_generator_and_parts(tmp_path: Path) -> None:
    (tmp_path / "a.glb").write_bytes(trimesh.Scene({"one": trimesh.creation.box()}).export(file_type="glb"))
    used = report(tmp_path / "a.glb").used
    assert used[0].startswith("glTF 2.0, made by 'https://github.com/mikedh/trimesh")
    assert {"1 node with meshes", "1 primitive of triangles"} <= set(used)
    assert used[-1] == "1 mesh with 8 vertices"


def test_attributes_are_counted_by_the_meshes_that_have_them(tmp_path: Path) -> None:
    (tmp_path / "squares.glb").write_bytes(gltf())
    scene = nf.Scene.load(tmp_path / "squares.glb")
    attributes = [phrase for phrase in scene.report.used if phrase.startswith("texture coordinates")]
    assert len(attributes) == 1
    assert scene.subset(objects=scene.object_names).report.used == scene.report.used


def test_properties_of_ply_files_that_are_ignored_are_named(tmp_path: Path) -> None:
    rows = "0 0 0 0.5 7\n1 0 0 0.5 7\n0 1 0 0.5 7\n"
    header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    header += "property float confidence\nproperty uchar red\nelement face 1\n"
    header += "property list uchar int vertex_indices\nend_header\n"
    (tmp_path / "a.ply").write_text(header + rows + "3 0 1 2\n")
    found = report(tmp_path / "a.ply")
    assert found.notes == ("vertex property confidence ignored",)
    assert found.used == ("PLY", "1 mesh with 3 vertices")


@pytest.mark.parametrize(("suffix", "name"), [("obj", "Wavefront OBJ"), ("stl", "STL"), ("off", "OFF")])
def test_other_formats_are_named(suffix: str, name: str, tmp_path: Path) -> None:
    trimesh.creation.box().export(tmp_path / f"box.{suffix}")
    assert report(tmp_path / f"box.{suffix}").used[0] == name


def test_scenes_without_a_source_have_no_inventory() -> None:
    scene = nf.Scene.from_arrays(np.eye(3, dtype=np.float32), np.array([[0, 1, 2]], np.uint32))
    assert scene.report.used == ()


def test_info_prints_both(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "squares.glb").write_bytes(gltf())
    status, out, _ = command(capsys, "info", "-i", tmp_path / "squares.glb")
    assert status == 0
    assert out.index("parts of the file used") < out.index("glTF 2.0") < out.index("drawn differently")
