"""Tests of damaged, empty, missing and foreign files: a scene with a report, or an error message, in short time."""

from __future__ import annotations

import re
import struct
import time
import tracemalloc
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import nearfar as nf
from nearfar._base import data as data_files
from nearfar._scene.options import OnInvalid
from tests.support import need
from tests.support.gltf_cases import encode, triangle
from tests.support.verdict import FOREIGN

LONGEST = 2.0
"""CPU seconds allowed for any malformed file."""


@pytest.fixture(autouse=True)
def nothing_leaks(capfd: pytest.CaptureFixture[str]) -> Iterator[None]:
    """Assert that nothing is printed; warnings are errors in all tests."""
    yield
    captured = capfd.readouterr()
    assert captured.out + captured.err == ""


def outcome(path: Path, on_invalid: OnInvalid = "raise") -> nf.Scene | nf.SceneError:
    """Load a file like a user; accepts only a working scene or a SceneError that names the file."""
    start = time.process_time()
    result: nf.Scene | nf.SceneError
    try:
        result = nf.Scene.load(path, on_invalid=on_invalid)
        assert result.triangle_count > 0
        assert str(result.report)
        assert np.isfinite(result.bounds).all()
    except nf.SceneError as error:
        result = error
    assert time.process_time() - start < LONGEST
    if isinstance(result, nf.SceneError):
        sentence = str(result)
        assert sentence.startswith(f"{path}: ")
        assert 5 < len(sentence) - len(str(path)) < 600
        assert "\n" not in sentence
        assert not FOREIGN.search(sentence)
    return result


def test_every_malformed_file_gives_a_scene_or_a_message() -> None:
    need("data")
    files = [path for path in sorted(data_files.require("malformed").rglob("*")) if path.is_file()]
    outcome(files[0])  # Imports the reader.
    tracemalloc.start()
    results = {path.name: (outcome(path), outcome(path, "drop")) for path in files}
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert len(results) > 40
    # The largest of the files is 200 kB.
    assert peak < 50e6
    scenes = {name for name, (strict, _) in results.items() if isinstance(strict, nf.Scene)}
    assert {"box_UTF16BE.obj", "negative_indices.obj", "busted.STL", "no_indices_3storybuilding.glb"} <= scenes
    assert not scenes & {"empty.obj", "empty.stl", "point_cloud.obj", "Cube.gltf", "BoxTextured.gltf", "NoScene.gltf"}


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("assimp/glTF2/MissingBin/BoxTextured.gltf", "a file that it refers to cannot be read: BoxTextured0.bin"),
        ("assimp/glTF2/IndexOutOfRange/IndexOutOfRange.gltf", "1 face with vertices that do not exist in mesh 'Mesh'"),
        ("assimp/glTF2/IncorrectVertexArrays/Cube.gltf", "expected three corners for each triangle, got 35"),
        ("assimp/glTF2/wrongTypes/badArray.gltf", "one of its entries has the wrong type"),
        ("trimesh/points_emptyface.ply", "no triangles; 1,024 points without faces ignored"),
        ("trimesh/empty.stl", "no triangles"),
    ],
)
def test_messages_explain_the_defect(name: str, words: str) -> None:
    need("data")
    result = outcome(data_files.require(f"malformed/{name}"))
    assert isinstance(result, nf.SceneError)
    assert words in str(result)


# trimesh guesses an encoding if charset_normalizer is installed; then the byte is a letter in place of a number.
UNKNOWN = "its text is in an unknown encoding|one of its rows has too few or too many numbers|no triangles"

DAMAGED = {
    "byte.off": (b"OFF\n3 1 0\n0 0 0\n1 0 \xff\n0 1 0\n3 0 1 2\n", "instead of a number"),
    "byte.xyz": (b"0 0 0\n1 0 \xff\n0 1 0\n", UNKNOWN),
    "byte.stl": (b"solid a\nfacet normal 0 0 1\nvertex 0 0 \xff\n" * 9, UNKNOWN),
    "word.off": (b"OFF\n3 1 0\n0 0 0\n1 0 abc\n0 1 0\n3 0 1 2\n", "'abc' instead of a number"),
    "count.off": (b"OFF\n3 x 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "'x' instead of a number"),
    "short.off": (b"OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "one of its rows has too few or too many numbers"),
    "short.xyz": (b"0 0 0\n1 0\n0 1 0\n", "one of its rows has too few or too many numbers"),
    "type.ply": (
        b"ply\nformat ascii 1.0\nelement vertex 1\nproperty foat x\nend_header\n0\n",
        "its header has the unknown type 'foat'",
    ),
    "rows.ply": (
        b"ply\nformat ascii 1.0\nelement vertex 18446744073709551616\nproperty list char int x\nend_header\n1 0\n0\n",
        "its header has the line 'element vertex 18446744073709551616'",
    ),
    "packed.3mf": (b"PK\3\4" + b"\0" * 60, "its archive is damaged"),
}


@pytest.mark.parametrize("name", DAMAGED)
def test_messages_are_about_the_file(tmp_path: Path, name: str) -> None:
    data, words = DAMAGED[name]
    (tmp_path / name).write_bytes(data)
    assert re.search(words, str(outcome(tmp_path / name)))


def test_skins_and_animations_are_reported() -> None:
    need("data")
    result = outcome(data_files.require("malformed/assimp/glTF2/simple_skin/simple_skin.gltf"))
    assert isinstance(result, nf.Scene)
    assert {"1 animation ignored", "1 skin shown at rest"} <= set(result.report.notes)


def test_missing_materials_and_textures_are_reported(tmp_path: Path) -> None:
    triangle = "usemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n"
    (tmp_path / "a.obj").write_text(f"mtllib my red.mtl\n{triangle}")
    result = outcome(tmp_path / "a.obj")
    assert isinstance(result, nf.Scene)
    assert result.report.notes == ("material file 'my red.mtl' cannot be read, drawn without it",)
    (tmp_path / "my red.mtl").write_text("newmtl red\nKd 1 0 0\nmap_Kd missing.png\nmap_Kd text.png\n")
    (tmp_path / "text.png").write_text("no picture")
    result = outcome(tmp_path / "a.obj")
    assert isinstance(result, nf.Scene)
    words = "texture '{}' cannot be read, drawn without it"
    assert result.report.notes == (words.format("missing.png"), words.format("text.png"))
    Image.new("RGB", (2, 2)).save(tmp_path / "text.png")
    (tmp_path / "my red.mtl").write_text("newmtl red\nKd 1 0 0\nmap_Kd text.png\n")
    result = outcome(tmp_path / "a.obj")
    assert isinstance(result, nf.Scene)
    assert result.report.notes == ()


def test_operating_system_errors_pass_through(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"nowhere\.glb"):
        nf.Scene.load(tmp_path / "nowhere.glb")
    with pytest.raises(IsADirectoryError, match="expected a file, got a folder: "):
        nf.Scene.load(tmp_path)
    (tmp_path / "house.obj").touch()
    with pytest.raises(IsADirectoryError, match=r"expected a file, got a folder, which holds house\.obj: "):
        nf.Scene.load(tmp_path)
    (tmp_path / "reduced.json").touch()
    with pytest.raises(IsADirectoryError, match="the folder of a reduced scene"):
        nf.Scene.load(tmp_path)


@pytest.mark.parametrize("suffix", ["glb", "gltf", "obj", "ply", "stl", "off", "3mf", "ply.gz"])
@pytest.mark.parametrize("content", [b"", b"\0" * 100, b"\xff\xfe\xfd" * 50, b"solid\nfacet", b"{}", b"[1]", b"null"])
def test_nonsense_of_every_kind_is_refused(tmp_path: Path, suffix: str, content: bytes) -> None:
    path = tmp_path / f"file.{suffix}"
    path.write_bytes(content)
    assert isinstance(outcome(path), nf.SceneError)


@pytest.mark.parametrize("name", ["a.txt", "a", "a.bin", "a.dxf", "a.json", ".glb.exe", "a.xyz.gz"])
def test_unknown_kinds_are_refused(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_bytes(b"0 0 0\n")
    kinds = r"the kind of file .* is not known; nearfar reads .*\bglb\b.*\bobj\b"
    assert re.search(f"{kinds}|damaged|no triangles|it is not valid JSON", str(outcome(tmp_path / name)))


def test_archives_must_be_unpacked(tmp_path: Path) -> None:
    for name in ("a.zip", "a.tar.gz", "a.tar"):
        (tmp_path / name).write_bytes(b"PK")
        assert re.search("is an archive|damaged", str(outcome(tmp_path / name)))


POSITIONS: dict[str, Any] = {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}


def primitive(**changes: Any) -> bytes:
    return triangle(meshes=[{"primitives": [{"attributes": {"POSITION": 0}} | changes]}])


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (triangle(accessors=[POSITIONS | {"count": 10**12}]), "does not contain"),
        (triangle(accessors=[{"componentType": 5126, "count": 10**12, "type": "VEC3"}]), "unpacks to more than"),
        (triangle(accessors=[POSITIONS | {"count": -3}]), "does not contain"),
        # A negative index counts from the end in Python.
        (
            triangle(
                bufferViews=[{"buffer": 0, "byteOffset": -24, "byteLength": 12}], accessors=[POSITIONS | {"count": 1}]
            ),
            "does not contain",
        ),
        (triangle(extensionsRequired=["ACME_gizmo"]), "needs the extension ACME_gizmo, which is not read"),
        (triangle(nodes=[{"mesh": 0, "name": "thing", "scale": [1e300, 1, 1]}]), r"numbers up to 1e\+30"),
        (triangle(nodes=[{"mesh": 0, "name": "thing", "translation": [float("nan"), 0, 0]}]), "at node 'thing'"),
        (triangle(nodes=[{"mesh": 0, "name": "thing", "matrix": [1.0] * 16}]), "at node 'thing'"),
        (triangle(nodes=[{"mesh": -1}]), "does not contain"),
        (triangle(nodes=[{"mesh": 7}]), "no triangles|not contain|entry"),
        (triangle(nodes=[{"mesh": 0, "children": [-1]}]), "does not contain"),
        (triangle(scenes=[{"nodes": [-1]}]), "does not contain"),
        (triangle(scenes=[{"nodes": [9]}]), "not contain|entry"),
        (triangle(scene=1), "does not contain"),
        (primitive(material=-1), "does not contain"),
        (primitive(indices=-1), "does not contain"),
        (primitive(attributes={"POSITION": -1}), "does not contain"),
        (primitive(attributes={"POSITION": 0, "NORMAL": -1}), "does not contain"),
        (primitive(attributes={}), "no triangles; 1 primitive without POSITION ignored"),
        (triangle(nodes=[{"mesh": 0, "translation": [0, 1]}]), "3 numbers as translation"),
        (triangle(nodes=[{"mesh": 0, "scale": ["a", 1, 1]}]), "3 numbers as scale"),
        (triangle(nodes=[{"mesh": 0, "rotation": 10**400}]), "4 numbers as rotation"),
        # Nodes that are no trees, whose meshes would be drawn twice or endlessly.
        (triangle(nodes=[{"mesh": 0, "children": [0]}]), "node 0 is a child of itself"),
        (
            triangle(nodes=[{"mesh": 0, "children": [1]}, {"mesh": 0, "children": [0]}]),
            "scene 0 lists node 0, .* child of node 1",
        ),
        (triangle(nodes=[{"children": [1, 1]}, {"mesh": 0}]), "node 1 is a child of node 0 and again of node 0"),
        (
            triangle(nodes=[{"children": [2]}, {"children": [2]}, {"mesh": 0}], scenes=[{"nodes": [0, 1]}]),
            "node 2 is a child of node 0 and again of node",
        ),
        (
            triangle(nodes=[{"children": [1]}, {"mesh": 0}], scenes=[{"nodes": [0, 1]}]),
            "scene 0 lists node 1, which is a child of node 0",
        ),
        (triangle(nodes=[{"mesh": False}]), "not contain|entry|wrong type"),
        (triangle(accessors=[POSITIONS | {"componentType": 5555}]), "accessors have the unknown type 5555"),
        (triangle(accessors=[POSITIONS | {"type": "X\nY" * 300}]), "lacks an entry that it needs"),
        (triangle(asset={"version": "1.0"}), "only glTF 2 is read"),
        (triangle(asset={"version": "3\n4" * 300}), "only glTF 2 is read|glTF 3"),
        (triangle(extensionsRequired=["A\nB" * 300]), "needs the extension A B"),
        (triangle(nodes=[{"mesh": 0, "name": "a\nb" * 300, "scale": [float("nan"), 1, 1]}]), r"at node 'a\\nb"),
        (triangle(nodes=[{"mesh": 0, "name": "\ud800"}]), "a string in it contains a lone surrogate"),
        (primitive(mode=3), "; 1 line primitive ignored"),
        (triangle(buffers=[{"byteLength": 36, "uri": "gone.bin"}]), "refers to cannot be read"),
        (triangle()[:-4], "cannot be read"),
        (encode([], b""), "its JSON is not an object"),
        (b"glTF" + struct.pack("<II", 1, 99) + bytes(40), "does not begin like a GLB of version 2"),
    ],
)
def test_broken_gltf_is_explained(tmp_path: Path, data: bytes, words: str) -> None:
    (tmp_path / "a.glb").write_bytes(data)
    result = outcome(tmp_path / "a.glb")
    assert isinstance(result, nf.SceneError)
    assert re.search(words, str(result)), str(result)
    assert "\n" not in str(result)
    assert len(str(result).encode()) < 400 + len(str(tmp_path))


def test_loops_that_no_scene_reaches_are_not_drawn(tmp_path: Path) -> None:
    nodes = [{"mesh": 0}, {"mesh": 0, "children": [2]}, {"mesh": 0, "children": [1]}]
    (tmp_path / "a.glb").write_bytes(triangle(nodes=nodes))
    result = outcome(tmp_path / "a.glb")
    assert isinstance(result, nf.Scene)
    assert result.triangle_count == 1


def test_cameras_and_skipped_meshes_do_not_misplace_their_children(tmp_path: Path) -> None:
    nodes = [
        {"name": "eye", "camera": 0, "mesh": 0, "translation": [0, 5, 0], "children": [1]},
        {"name": "line", "mesh": 1, "translation": [7, 0, 0], "children": [2]},
        {"name": "leaf", "mesh": 0},
    ]
    cameras = [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}]
    corners = {"attributes": {"POSITION": 0}}
    meshes = [{"primitives": [corners]}, {"primitives": [corners | {"mode": 3}]}]
    (tmp_path / "a.glb").write_bytes(triangle(nodes=nodes, cameras=cameras, meshes=meshes))
    result = outcome(tmp_path / "a.glb")
    assert isinstance(result, nf.Scene)
    assert set(result.object_names) == {"eye", "leaf"}
    np.testing.assert_array_equal(result.subset(objects=["eye"]).bounds[0], [0, 5, 0])
    np.testing.assert_array_equal(result.subset(objects=["leaf"]).bounds[0], [7, 5, 0])
    assert result.report.notes == ("1 camera ignored", "1 line primitive ignored")


def test_valid_triangles_can_be_kept_despite_invalid_placements(tmp_path: Path) -> None:
    nodes = [{"mesh": 0, "name": "good"}, {"mesh": 0, "name": "bad", "translation": [float("inf"), 0, 0]}]
    (tmp_path / "a.glb").write_bytes(triangle(nodes=nodes, scenes=[{"nodes": [0, 1]}]))
    assert "at node 'bad'" in str(outcome(tmp_path / "a.glb"))
    kept = outcome(tmp_path / "a.glb", "drop")
    assert isinstance(kept, nf.Scene)
    assert kept.object_names == ("good",)
