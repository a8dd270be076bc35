"""Files that unpack to far more than they are, and files that never end: errors, before memory or time are taken."""

from __future__ import annotations

import gzip
import io
import os
import subprocess
import sys
import zipfile
import zlib
from pathlib import Path

import pytest
import trimesh
from PIL import Image

import nearfar as nf
from nearfar._base.errors import UnusableError
from nearfar._scene import budget as budgets
from nearfar._scene.budget import Budget
from tests.support import PEAK, need
from tests.support.gltf_cases import gltf

BALL = trimesh.creation.icosphere(2)


def bomb(size: int) -> bytes:
    """Zeros in gzip's format, piece by piece."""
    packer = zlib.compressobj(9, wbits=zlib.MAX_WBITS | 16)
    return b"".join(packer.compress(bytes(1 << 20)) for _ in range(size >> 20)) + packer.flush()


@pytest.mark.parametrize("size", [0, 1, 1 << 22, (1 << 22) + 1, 9_000_000])
def test_packed_bytes_come_back(size: int) -> None:
    data = os.urandom(size)
    assert Budget().unpacked(gzip.compress(data, 1)) == data
    assert Budget().unpacked(gzip.compress(data, 1) + gzip.compress(b"more") + bytes(512)) == data + b"more"


@pytest.mark.parametrize("cut", [5, -1, -9])
def test_packed_bytes_that_end_too_early_are_damaged(cut: int, tmp_path: Path) -> None:
    path = tmp_path / "ball.ply.gz"
    path.write_bytes(gzip.compress(BALL.export(file_type="ply"))[:cut])
    with pytest.raises(nf.SceneError, match=r"ball\.ply\.gz: its compressed data is damaged"):
        nf.Scene.load(path)


def test_the_limit_follows_the_bytes_read() -> None:
    one = Budget()
    assert one.limit == budgets.FREE
    one.add_read(1 << 30)
    assert one.limit == budgets.MOST
    one = Budget(1000)
    one.take(600)
    with pytest.raises(UnusableError, match="it unpacks to more than 1,000 bytes from 0; max_bytes allows more"):
        one.take(401)


def test_small_files_that_unpack_to_gigabytes_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.ply.gz"
    path.write_bytes(bomb(1 << 30))
    need("linux")
    code = f"{PEAK}\nimport sys, nearfar as nf\nstart = peak()\ntry: nf.Scene.load(sys.argv[1])\n"
    code += "except nf.SceneError as error: print(error)\nprint(peak() - start)"
    done = subprocess.run([sys.executable, "-c", code, path], capture_output=True, text=True, timeout=600, check=True)
    message, more = done.stdout.splitlines()
    assert "a.ply.gz: it unpacks to more than 268,435,456 bytes" in message
    assert int(more) < 1 << 30


def test_archives_are_measured_before_they_are_unpacked(tmp_path: Path) -> None:
    path = tmp_path / "a.3mf"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("3D/3dmodel.model", bytes(300 << 20))
    with pytest.raises(nf.SceneError, match=r"a\.3mf: it unpacks to more than 268,435,456 bytes"):
        nf.Scene.load(path)


def test_images_are_measured_before_they_are_decoded(tmp_path: Path) -> None:
    file = io.BytesIO()
    Image.new("L", (9000, 9000)).save(file, "png")
    image = {"uri": "flat.png", "mimeType": "image/png"}
    (tmp_path / "flat.png").write_bytes(file.getvalue())
    material = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
    path = tmp_path / "a.glb"
    path.write_bytes(gltf([material], images=[image], textures=[{"source": 0}], samplers=[]))
    with pytest.raises(nf.SceneError, match=r"a\.glb: it unpacks to more than 268,435,456 bytes"):
        nf.Scene.load(path)
    assert nf.Scene.load(path, max_bytes=1 << 30).report.textures == 1
    with pytest.raises(ValueError, match="max_bytes: expected a whole number"):
        nf.Scene.load(path, max_bytes=0)


def test_pipes_and_devices_are_not_read(tmp_path: Path) -> None:
    need("fork")
    os.mkfifo(tmp_path / "pipe.obj")
    os.mkfifo(tmp_path / "data.bin")
    for path in (tmp_path / "pipe.obj", Path("/dev/zero")):
        with pytest.raises(nf.SceneError, match="is no ordinary file, but a pipe, a socket or a device"):
            nf.Scene.load(path)
    document = BALL.scene().export(file_type="gltf")
    (tmp_path / "a.gltf").write_bytes(document["model.gltf"].replace(b"gltf_buffer_0.bin", b"data.bin"))
    with pytest.raises(nf.SceneError, match=r"a\.gltf: "):
        nf.Scene.load(tmp_path / "a.gltf")
