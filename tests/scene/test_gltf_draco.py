"""glTF files compressed by Draco: the original arrays, or an error that names the file, in limited time."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.gltf import draco
from tests.support import data, need
from tests.support.draco_cases import EXTENSION, compress, document, glb
from tests.support.gltf_cases import encode, load
from tests.support.meshopt_cases import varint
from tests.support.refused import load_damaged, refusals

BOXES = "wild/glTF-Transform/packages"
TRUCK = "wild/cesium-native/CesiumGltfReader/test/data/DracoCompressed/CesiumMilkTruck.gltf"
DICE = np.random.default_rng(3)
POSITIONS = DICE.normal(size=(20, 3)).astype(np.float32)
FACES = np.array([[i, i + 1, i + 2] for i in range(18)], np.uint32)
PLACE = 4e-6
"""Half a step of the positions' 20 bits, whose range is below 8."""


@pytest.fixture(autouse=True)
def _needs_the_decoder() -> None:
    need("DracoPy")


def square(level: int = 7) -> tuple[bytes, dict[str, int]]:
    return compress(POSITIONS, FACES, {}, level)


def simple(stream: bytes, numbers: dict[str, int], **changes: Any) -> bytes:
    """A file whose mesh has only positions."""
    written, binary = document(stream, numbers, {"POSITION": POSITIONS}, FACES)
    return encode(written | changes, binary)


def by_position(scene: nf.Scene) -> dict[str, NDArray[Any]]:
    """The mesh's arrays, with vertices in the order of POSITIONS."""
    parts = nf._core.mesh_parts(scene._core.merged())
    rows = [int(np.argmin(np.abs(parts["positions"] - place).sum(axis=1))) for place in POSITIONS]
    return {
        name: np.asarray(parts[name])[rows]
        for name in ("positions", "normals", "uvs", "colors")
        if parts[name] is not None
    }


@pytest.mark.parametrize("level", [0, 1, 4, 7, 10])
def test_triangles_are_decoded(tmp_path: Path, level: int) -> None:
    scene = load(tmp_path, simple(*square(level)))
    found = np.sort(scene.triangles().reshape(len(FACES), -1).mean(axis=1))
    np.testing.assert_allclose(found, np.sort(POSITIONS[FACES].reshape(len(FACES), -1).mean(axis=1)), atol=PLACE)
    np.testing.assert_allclose(by_position(scene)["positions"], POSITIONS, atol=PLACE)


@pytest.mark.parametrize("number", [0, 1])
def test_attributes_are_found_by_their_numbers(tmp_path: Path, number: int) -> None:
    """Two sets of texture coordinates, one of which the material uses, normals and colours."""
    normals = DICE.normal(size=(20, 3)).astype(np.float32)
    arrays: dict[str, NDArray[Any]] = {
        "TEXCOORD_0": DICE.random((20, 2)).astype(np.float32),
        "TEXCOORD_1": DICE.random((20, 2)).astype(np.float32),
        "NORMAL": normals,
        "COLOR_0": np.column_stack([DICE.integers(0, 256, (20, 3)), np.full(20, 255)]).astype(np.uint8),
    }
    stream, numbers = compress(POSITIONS, FACES, arrays)
    written, binary = document(stream, numbers, {"POSITION": POSITIONS} | arrays, FACES, COLOR_0=True)
    written["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = number
    found = by_position(load(tmp_path, encode(written, binary)))
    np.testing.assert_allclose(found["uvs"] * [1, -1] + [0, 1], arrays[f"TEXCOORD_{number}"], atol=1e-6)
    np.testing.assert_allclose(found["normals"], normals / np.linalg.norm(normals, axis=1, keepdims=True), atol=1e-6)
    # Linear light in the file, sRGB in the scene.
    light = arrays["COLOR_0"][:, :3] / 255
    expected = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    np.testing.assert_allclose(found["colors"][:, :3], expected * 255, atol=0.51)


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
@pytest.mark.parametrize("normalized", [True, False])
def test_integers_may_represent_fractions(tmp_path: Path, kind: type[np.integer[Any]], normalized: bool) -> None:
    most = np.iinfo(kind).max
    uvs = DICE.integers(0, most, (20, 2), kind, endpoint=True)
    stream, numbers = compress(POSITIONS, FACES, {"TEXCOORD_0": uvs})
    arrays = {"POSITION": POSITIONS, "TEXCOORD_0": uvs}
    found = by_position(load(tmp_path, glb(stream, numbers, arrays, FACES, TEXCOORD_0=normalized)))
    expected = uvs / most if normalized else uvs.astype(np.float64)
    np.testing.assert_allclose(found["uvs"] * [1, -1] + [0, 1], expected, rtol=1e-6, atol=1e-6)


def test_sparse_rows_change_decoded_ones(tmp_path: Path) -> None:
    stream, numbers = square()
    written, binary = document(stream, numbers, {"POSITION": POSITIONS}, FACES)
    binary += bytes(-len(binary) % 4)
    start = len(binary)
    binary += np.array([0, 0], np.uint16).tobytes() + np.full(3, 50, np.float32).tobytes()
    written["bufferViews"] += [
        {"buffer": 0, "byteOffset": start, "byteLength": 4},
        {"buffer": 0, "byteOffset": start + 4, "byteLength": 12},
    ]
    written["buffers"][0]["byteLength"] = len(binary)
    plain = load(tmp_path, encode(written, binary))
    indices = {"bufferView": 1, "componentType": 5123}
    written["accessors"][1]["sparse"] = {"count": 1, "indices": indices, "values": {"bufferView": 2}}
    changed = load(tmp_path, encode(written, binary))
    assert (changed.triangles() == 50).all(axis=2).any()
    assert not (plain.triangles() == 50).any()
    assert (changed.triangles() != plain.triangles()).any(axis=2).sum() in (1, 2, 3)


@pytest.mark.parametrize("name", ["BoxDraco.gltf", "DracoSparseMesh.gltf", "CesiumMilkTruck.gltf"])
def test_real_files_have_the_triangles_that_trimesh_reads(name: str) -> None:
    import trimesh

    path = data(TRUCK) if "Truck" in name else data(f"{BOXES}/extensions/test/in/{name}")
    scene = nf.Scene.load(path)
    other = trimesh.load_scene(path, process=False).to_mesh()
    rows = [np.sort(np.asarray(part).mean(axis=1), axis=0) for part in (scene.triangles(), other.triangles)]
    np.testing.assert_allclose(rows[0], rows[1], atol=1e-5)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda d: d["meshes"][0]["primitives"][0]["extensions"][EXTENSION]["attributes"].clear(), "has no POSITION"),
        (
            lambda d: d["meshes"][0]["primitives"][0]["extensions"][EXTENSION]["attributes"].update(POSITION=99),
            "lacks the attribute 99, its POSITION",
        ),
        (lambda d: d["accessors"][0].update(count=51), "has 18 triangles instead of the stated 17"),
        (lambda d: d["accessors"][0].update(count=-3), "is used with -3 indices"),
        (lambda d: d["accessors"][0].update(count=53), "is used with 53 indices"),
        (lambda d: d["accessors"][1].update(type="VEC2"), "has 3 numbers in each row of POSITION instead of 2"),
        (lambda d: d["accessors"][1].update(type="VEC9"), "lacks an entry that it needs"),
        (lambda d: d["accessors"][1].update(componentType=5121), "has numbers of POSITION that do not fit into uint8"),
        (lambda d: d["accessors"][1].update(componentType=1), "its accessors have the unknown type 1"),
        (lambda d: d["bufferViews"][0].update(byteLength=9), "does not begin like one"),
        (lambda d: d["bufferViews"][0].update(byteLength=10**6), "refers to an item that it does not contain"),
        (
            lambda d: d["meshes"][0]["primitives"][0]["extensions"][EXTENSION].update(bufferView=7),
            "refers to an item that it does not contain",
        ),
        (
            lambda d: d["meshes"][0]["primitives"][0]["extensions"][EXTENSION].update(attributes=[1]),
            "wrong type|has no POSITION",
        ),
    ],
)
def test_descriptions_that_do_not_fit_are_errors(tmp_path: Path, change: Any, words: str) -> None:
    written, binary = document(*square(), {"POSITION": POSITIONS}, FACES)
    change(written)
    with pytest.raises(nf.SceneError, match=f"a\\.glb: .*({words})"):
        load(tmp_path, encode(written, binary))


def test_fewer_vertices_may_be_stated(tmp_path: Path) -> None:
    """The number is that of COLLADA2GLTF, which wrote Cesium's milk truck."""
    written, binary = document(*square(), {"POSITION": POSITIONS}, FACES)
    written["accessors"][1]["count"] = 7
    assert load(tmp_path, encode(written, binary)).triangle_count == len(FACES)


def test_point_clouds_are_refused(tmp_path: Path) -> None:
    stream, numbers = compress(POSITIONS, None, {})
    with pytest.raises(nf.SceneError, match=r"a\.glb: a Draco stream of its meshes holds no mesh"):
        load(tmp_path, simple(stream, numbers))


def test_truncated_draco_streams_are_errors(tmp_path: Path) -> None:
    stream, numbers = square()
    for length in range(0, len(stream), 3):
        with pytest.raises(nf.SceneError, match=r"a\.glb: a Draco stream of its meshes"):
            load(tmp_path, simple(stream[:length], numbers))


@pytest.mark.parametrize("level", [0, 7])
def test_damaged_streams_are_errors_or_other_triangles(tmp_path: Path, level: int) -> None:
    stream, numbers = square(level)
    scenes = load_damaged(tmp_path, stream, 60, lambda damaged: simple(damaged, numbers))
    assert 0 < len(scenes) < 60
    assert max(scene.triangle_count for scene in scenes) <= len(FACES)


def test_streams_that_exceed_the_time_limit_are_errors(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A limit of a microsecond of CPU time is exceeded, whether or not the clock ticks meanwhile."""
    rows = DICE.normal(size=(100_000, 3)).astype(np.float32)
    faces = np.arange(len(rows) - len(rows) % 3, dtype=np.uint32).reshape(-1, 3)
    stream, numbers = compress(rows, faces, {}, 10)
    written, binary = document(stream, numbers, {"POSITION": rows}, faces)
    with monkeypatch.context() as limits:
        limits.setattr(draco, "_SECONDS", 1e-6)
        limits.setattr(draco, "_SECONDS_PER_FACE", 0.0)
        limits.setattr(draco, "_WALL_CLOCK_FACTOR", 1e9)
        with pytest.raises(nf.SceneError, match=r"a\.glb: .*Draco stream .*takes too long"):
            load(tmp_path, encode(written, binary))
    assert load(tmp_path, encode(written, binary)).triangle_count == len(faces)


def test_a_stalled_decoder_is_killed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    need("linux")
    content = simple(*square())
    load(tmp_path, content)
    process = draco._process
    assert process is not None
    process._child.send_signal(signal.SIGSTOP)
    with monkeypatch.context() as limits:
        limits.setattr(draco, "_WALL_CLOCK_FACTOR", 0.1)
        with pytest.raises(nf.SceneError, match=r"a\.glb: .*Draco stream .*takes too long"):
            load(tmp_path, content)
    assert load(tmp_path, content).triangle_count == len(FACES)


def test_claimed_counts_of_draco_are_not_trusted(tmp_path: Path) -> None:
    """2³¹ triangles in stream and document: refused by the limit, and by the decoder if the limit is raised."""
    need("linux")
    stream, numbers = square(0)
    most = (1 << 31) // 3 * 3
    lying = stream[:11] + varint(most // 3) + varint(most) + stream[13:]
    written, binary = document(lying, numbers, {"POSITION": POSITIONS}, FACES)
    written["accessors"][0]["count"] = most
    written["accessors"][1]["count"] = most
    (tmp_path / "a.glb").write_bytes(encode(written, binary))
    (first, second), more = refusals(tmp_path / "a.glb", None, 1 << 50)
    assert "a.glb: it unpacks to more than 268,435,456 bytes" in first
    assert "a.glb: a Draco stream of its meshes is damaged" in second
    assert more < 200e6


def test_decoded_bytes_count_twice_towards_the_limit(tmp_path: Path) -> None:
    """Once more for the memory that Draco itself takes."""
    content = simple(*square())
    size = 2 * (len(FACES) * 12 + len(POSITIONS) * 12)
    # The texture's texels are added, and arrays that are free because the file has more bytes.
    assert load(tmp_path, content, max_bytes=size + 4 * 48).triangle_count == len(FACES)
    with pytest.raises(nf.SceneError, match=r"a\.glb: it unpacks to more than"):
        load(tmp_path, content, max_bytes=size - 1)


def test_the_decoder_is_started_again(tmp_path: Path) -> None:
    content = simple(*square())
    load(tmp_path, content)
    first = draco._process
    assert first is not None
    load(tmp_path, content)
    assert draco._process is first
    first._child.kill()
    first._child.wait()
    assert load(tmp_path, content).triangle_count == len(FACES)
    assert draco._process is not first


def test_threads_share_the_decoder(tmp_path: Path) -> None:
    content = simple(*square())
    counts: list[int] = []

    def work(number: int) -> None:
        folder = tmp_path / str(number)
        folder.mkdir()
        counts.extend(load(folder, content).triangle_count for _ in range(5))

    threads = [threading.Thread(target=work, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert counts == [len(FACES)] * 20


def test_a_fork_starts_its_own_decoder(tmp_path: Path) -> None:
    need("fork")
    (tmp_path / "a.glb").write_bytes(simple(*square()))
    code = (
        "import os, sys, nearfar as nf\n"
        "from nearfar._scene.gltf import draco\n"
        "assert nf.Scene.load(sys.argv[1]).triangle_count == 18\n"
        "before = draco._process._child.pid\n"
        "if child := os.fork():\n"
        "    sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))\n"
        "assert nf.Scene.load(sys.argv[1]).triangle_count == 18\n"
        "assert draco._process._child.pid != before\n"
    )
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-W", "ignore", "-c", code, str(tmp_path / "a.glb")]
    subprocess.run(command, timeout=120, check=True, env=environment)


def test_a_decoder_without_memory_is_no_fault_of_the_file(tmp_path: Path) -> None:
    """The system's limit, below which the decoder cannot set its own; another decoder has memory again."""
    resource = pytest.importorskip("resource")
    need("linux")
    side = 300
    columns, rows = np.meshgrid(np.arange(side, dtype=np.float32), np.arange(side, dtype=np.float32))
    positions = np.stack([columns.ravel(), rows.ravel(), DICE.normal(size=side * side).astype(np.float32)], axis=1)
    corner = (np.arange(side - 1) + side * np.arange(side - 1)[:, None]).ravel()
    faces = np.concatenate([corner[:, None] + [0, 1, side], corner[:, None] + [1, side + 1, side]]).astype(np.uint32)
    stream, numbers = compress(positions, faces, {})
    written, binary = document(stream, numbers, {"POSITION": positions}, faces)
    content = encode(written, binary)
    load(tmp_path, simple(*square()))
    decoder = draco._running_process()._child.pid
    pages = int(Path(f"/proc/{decoder}/statm").read_text(encoding="ascii").split()[0])
    resource.prlimit(decoder, resource.RLIMIT_AS, (pages * resource.getpagesize(),) * 2)
    size = len(stream) + faces.nbytes + positions.nbytes
    with pytest.raises(MemoryError, match=rf"a\.glb: decoding a Draco stream of its meshes needs {size} bytes"):
        load(tmp_path, content)
    assert load(tmp_path, content).triangle_count == len(faces)
