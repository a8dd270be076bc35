"""Damaged files of formats that trimesh reads: each message is about the file, not about the code that reads it."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
import trimesh

import nearfar as nf
from tests.support.verdict import FOREIGN

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

READERS = ("UnboundLocalError", "AttributeError", "charset_normalizer", "chardet", "cannot access", "cannot reshape")


def sentence(path: Path) -> str:
    """Message of loading a file; "" for a loadable file."""
    try:
        nf.Scene.load(path)
    except nf.SceneError as error:
        return str(error).removeprefix(f"{path}: ")
    return ""


@pytest.mark.parametrize(("name", "expected"), [(name, words) for name, (_, words) in DAMAGED.items()])
def test_messages_are_about_the_file(tmp_path: Path, name: str, expected: str) -> None:
    (tmp_path / name).write_bytes(DAMAGED[name][0])
    with pytest.raises(nf.SceneError, match=expected):
        nf.Scene.load(tmp_path / name)


def files() -> dict[str, bytes]:
    ball = trimesh.creation.icosphere(1)
    exported = {
        "stl": ball.export(file_type="stl"),
        "text.stl": ball.export(file_type="stl_ascii"),
        "off": ball.export(file_type="off"),
        "ply": ball.export(file_type="ply"),
        "text.ply": ball.export(file_type="ply", encoding="ascii"),
        "obj": ball.export(file_type="obj"),
        "xyz": trimesh.PointCloud(ball.vertices).export(file_type="xyz"),
    }
    return {name: data.encode() if isinstance(data, str) else data for name, data in exported.items()}


def damage(data: bytes, chance: random.Random) -> bytes:
    """A copy with changed, added or lost bytes or lines."""
    place, lines = chance.randrange(len(data)), data.split(b"\n")
    match chance.randrange(6):
        case 0:
            return data[:place] + bytes([chance.randrange(256)]) + data[place + 1 :]
        case 1:
            return data[:place]
        case 2:
            return data[:place] + chance.randbytes(chance.choice((1, 8, 64))) + data[place:]
        case 3:
            return data[:place] + data[place + chance.choice((1, 4, 50)) :]
        case 4:
            odd = (b"nan", b"-1", b"1e999", b"\xff\xfe", b"99999999999999999999", b"\n\n", b'"', b"\0", b"0x1")
            return data[:place] + chance.choice(odd) + data[place:]
        case _:
            chance.shuffle(lines) if chance.random() < 0.3 else lines.pop(chance.randrange(len(lines)))
            return b"\n".join(lines)


@pytest.mark.parametrize("name", files())
def test_no_message_is_about_the_reader(tmp_path: Path, name: str) -> None:
    chance, data = random.Random(name), files()[name]
    path = tmp_path / f"ball.{name}"
    for _ in range(60):
        path.write_bytes(damage(data, chance))
        said = sentence(path)
        assert not FOREIGN.search(said), said
        assert not any(word in said for word in READERS), said
