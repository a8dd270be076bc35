"""Decompression bombs and endless files: errors before memory or time is spent."""

from __future__ import annotations

import gzip
import io
import os
import tracemalloc
import zipfile
import zlib
from pathlib import Path

import pytest
import trimesh
from PIL import Image

import nearfar as nf
from nearfar._base.errors import UnusableError
from nearfar._scene import budget as budgets, load as loader
from nearfar._scene.budget import Budget
from tests.support import need
from tests.support.gltf_cases import gltf
from tests.support.refused import refusals

BALL = trimesh.creation.icosphere(2)


def bomb(size: int) -> bytes:
    """Zeros in gzip's format, piece by piece."""
    packer = zlib.compressobj(9, wbits=zlib.MAX_WBITS | 16)
    return b"".join(packer.compress(bytes(1 << 20)) for _ in range(size >> 20)) + packer.flush()


@pytest.mark.parametrize("size", [0, 1, 1 << 22, (1 << 22) + 1, 9_000_000])
def test_packed_bytes_are_unpacked(size: int) -> None:
    data = os.urandom(size)
    assert Budget().unpacked(gzip.compress(data, 0)) == data
    assert Budget().unpacked(gzip.compress(data, 0) + gzip.compress(b"more") + bytes(512)) == data + b"more"


@pytest.mark.parametrize("cut", [5, -1, -9])
def test_truncated_packed_bytes_are_damaged(cut: int, tmp_path: Path) -> None:
    path = tmp_path / "ball.ply.gz"
    path.write_bytes(gzip.compress(BALL.export(file_type="ply"))[:cut])
    with pytest.raises(nf.SceneError, match=r"ball\.ply\.gz: its compressed data is damaged"):
        nf.Scene.load(path)


def test_the_limit_follows_the_bytes_read() -> None:
    one = Budget()
    assert one.limit == budgets.FREE
    one.add_read(1 << 30)
    assert one.limit == budgets.MAX
    one = Budget(1000)
    one.count_unpacked(600)
    with pytest.raises(UnusableError, match="it unpacks to more than 1,000 bytes from 0"):
        one.count_unpacked(401)


def test_small_files_that_expand_to_gigabytes_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.ply.gz"
    path.write_bytes(64 * bomb(1 << 24))
    need("linux")
    (message,), more = refusals(path, None)
    assert "a.ply.gz: it unpacks to more than 268,435,456 bytes" in message
    assert more < 1 << 30


def test_archives_are_measured_before_they_are_unpacked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budgets, "FREE", 1 << 20)
    path = tmp_path / "a.3mf"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("3D/3dmodel.model", bytes(2 << 20))
    with pytest.raises(nf.SceneError, match=r"a\.3mf: it unpacks to more than 1,048,576 bytes"):
        nf.Scene.load(path)


def test_images_are_measured_before_they_are_decoded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budgets, "FREE", 1 << 20)
    file = io.BytesIO()
    Image.new("L", (900, 900)).save(file, "png")
    image = {"uri": "flat.png", "mimeType": "image/png"}
    (tmp_path / "flat.png").write_bytes(file.getvalue())
    material = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
    path = tmp_path / "a.glb"
    path.write_bytes(gltf([material], images=[image], textures=[{"source": 0}], samplers=[]))
    with pytest.raises(nf.SceneError, match=r"a\.glb: it unpacks to more than 1,048,576 bytes"):
        nf.Scene.load(path)
    assert nf.Scene.load(path, max_bytes=1 << 23).report.textures == 1


def test_pipes_and_devices_are_not_read(tmp_path: Path) -> None:
    need("fork")
    os.mkfifo(tmp_path / "pipe.obj")
    os.mkfifo(tmp_path / "data.bin")
    for path in (tmp_path / "pipe.obj", Path("/dev/zero")):
        with pytest.raises(nf.SceneError, match="is not a regular file, but a pipe, a socket or a device"):
            nf.Scene.load(path)
    document = BALL.scene().export(file_type="gltf")
    (tmp_path / "a.gltf").write_bytes(document["model.gltf"].replace(b"gltf_buffer_0.bin", b"data.bin"))
    with pytest.raises(nf.SceneError, match=r"a\.gltf: "):
        nf.Scene.load(tmp_path / "a.gltf")


MESH = (
    '<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices>'
    '<triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh>'
)


def threemf(path: Path, objects: dict[int, list[int]], items: int = 1) -> Path:
    """A 3MF whose object 0 is a triangle, and the others are components; `items` times the last one is built."""
    parts = [f'<object id="0" type="model">{MESH}</object>']
    for number, below in objects.items():
        components = "".join(f'<component objectid="{part}"/>' for part in below)
        parts.append(f'<object id="{number}" type="model"><components>{components}</components></object>')
    build = f'<item objectid="{max(objects, default=0)}"/>' * items
    space = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
    text = f'<model unit="meter" xmlns="{space}"><resources>{"".join(parts)}</resources><build>{build}</build></model>'
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("3D/3dmodel.model", text)
    return path


def test_components_of_components_are_counted(tmp_path: Path) -> None:
    assert nf.Scene.load(threemf(tmp_path / "a.3mf", {1: [0] * 3, 2: [1] * 2})).triangle_count == 6
    for objects, items in (({n: [n - 1] * 10 for n in range(1, 40)}, 1), ({}, 100_000)):
        with pytest.raises(nf.SceneError, match=r"b\.3mf: it unpacks to more than 268,435,456 bytes"):
            nf.Scene.load(threemf(tmp_path / "b.3mf", objects, items))
    with pytest.raises(nf.SceneError, match=r"c\.3mf: its object \d is a component of itself"):
        nf.Scene.load(threemf(tmp_path / "c.3mf", {1: [2], 2: [1, 0]}))


def test_counts_of_components_stay_small() -> None:
    # Counted exactly, each object of a chain would take a bit more than its predecessor: gigabytes for 10⁵ of them.
    chain = {str(n): [str(n - 1)] * 2 for n in range(1, 200)}
    assert loader._instances(chain, ["5", "199"]) == [63, 1 << 62]


def test_entities_are_not_expanded(tmp_path: Path) -> None:
    entities = "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10 if n else "x" * 1000}">' for n in range(12))
    path = threemf(tmp_path / "a.3mf", {})
    with zipfile.ZipFile(path) as archive:
        text = archive.read("3D/3dmodel.model").decode()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("3D/3dmodel.model", f"<!DOCTYPE model [{entities}]>" + text.replace("<build>", "&e11;<build>"))
    try:
        assert nf.Scene.load(path).triangle_count == 1
    except nf.SceneError as error:
        assert str(error).startswith(str(path))  # noqa: PT017


@pytest.mark.parametrize("count", [2_000_000_000, -1])
@pytest.mark.parametrize("kind", ["ascii", "binary_little_endian"])
def test_counts_in_headers_are_not_trusted(kind: str, count: int, tmp_path: Path) -> None:
    ply = f"ply\nformat {kind} 1.0\nelement vertex {count}\nproperty float x\nproperty float y\nproperty float z\n"
    ply += f"element face {count}\nproperty list uchar int vertex_indices\nend_header\n"
    contents = {
        "a.ply": ply.encode() + b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "a.off": f"OFF\n{count} {count} 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n".encode(),
        "a.stl": bytes(80) + (count % (1 << 32)).to_bytes(4, "little") + bytes(50),
    }
    for name, data in contents.items():
        (tmp_path / name).write_bytes(data)
        tracemalloc.start()
        with pytest.raises(nf.SceneError, match=name):
            nf.Scene.load(tmp_path / name)
        assert tracemalloc.get_traced_memory()[1] < 100e6
        tracemalloc.stop()


def test_files_are_read_once(tmp_path: Path) -> None:
    """A file named by many images does not raise the limit of the others."""
    (tmp_path / "a.bin").write_bytes(bytes(1000))
    budget = Budget()
    files = budgets.resolver(tmp_path / "a.obj", budget)
    for _ in range(1000):
        assert files.get("a.bin") is files.get("a.bin")
    budget.count_arrays(1000 + budgets.FREE)
    with pytest.raises(UnusableError):
        budget.count_arrays(1)
