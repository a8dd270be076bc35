"""Wavefront OBJ against a reader of a few lines: index rules, unusual lines, wrong indices."""

from __future__ import annotations

import itertools
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf

CORNERS = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n"


def load(tmp_path: Path, text: str | bytes) -> nf.Scene:
    path = tmp_path / "a.obj"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return nf.Scene.load(path)


def triangles_of(text: str) -> NDArray[np.float64]:
    """Triangles (N, 3, 3) of a text by the format's description."""
    corners: list[list[float]] = []
    triangles = []
    for line in text.replace("\\\n", " ").splitlines():
        keyword, *words = line.split() or [""]
        if keyword == "v":
            corners.append([float(word) for word in words])
        if keyword == "f":
            indices = [int(word.split("/")[0]) for word in words]
            around = [corners[index - 1 if index > 0 else index] for index in indices]
            fans = [fan_of(around[first:] + around[:first]) for first in range(len(around))]
            triangles += next((fan for fan in fans if covers(fan)), fans[0])
    return np.array(triangles)


def fan_of(corners: list[list[float]]) -> list[list[list[float]]]:
    return [[corners[0], b, c] for b, c in itertools.pairwise(corners[1:])]


def covers(fan: list[list[list[float]]]) -> bool:
    """Whether no triangle of a fan is turned against the others."""
    a, b, c = np.array(fan).swapaxes(0, 1)
    areas = np.cross(b - a, c - a)
    return bool((areas @ areas.sum(axis=0) >= 0).all())


def random_text(random: np.random.Generator) -> str:
    """A random text that uses every notation of the format."""
    lines, count, normals = [], 0, 0

    def blank() -> str:
        return str(random.choice([" ", "  ", "\t", " \\\n "]))

    def indent() -> str:
        return str(random.choice(["", "", " ", "\t"]))

    for part in range(int(random.integers(1, 4))):
        if random.random() < 0.5:
            lines.append(f"{indent()}o{blank()}part{part}")
        for _ in range(int(random.integers(3, 6))):
            numbers = [f"{value:.3f}" for value in random.uniform(-1, 1, 3)]
            lines.append(f"{indent()}v{blank()}{blank().join(numbers)}")
            count += 1
        if random.random() < 0.5:
            lines.append(f"{indent()}vn{blank()}0 0 1")
            normals += 1
        for _ in range(int(random.integers(1, 4))):
            chosen = random.choice(count, 3 if random.random() < 0.7 else min(4, count), replace=False)
            words = []
            for index in chosen:
                word = str(index + 1 if random.random() < 0.5 else index - count)
                words.append(word + (f"//{random.choice([-1, normals])}" if normals else ""))
            lines.append(f"{indent()}f{blank()}{blank().join(words)}")
    return "\n".join(lines) + str(random.choice(["", "\n"]))


def in_any_order(triangles: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rows of nine numbers, independent of the order of triangles and of their first corners."""
    corners = np.round(triangles, 5).tolist()
    turned = [min(t[k:] + t[:k] for k in range(3)) for t in corners]
    return np.array(sorted(turned)).reshape(len(triangles), 9)


def test_every_notation_gives_the_same_triangles(tmp_path: Path) -> None:
    random = np.random.default_rng(0)
    for _ in range(150):
        text = random_text(random)
        expected = in_any_order(triangles_of(text))
        found = in_any_order(load(tmp_path, text).triangles().astype(np.float64))
        np.testing.assert_allclose(found, expected, rtol=0, atol=2e-5)


@pytest.mark.parametrize(
    ("faces", "words"),
    [
        ("f 0 1 2", "line 5: a face names vertex 0, but the first is 1"),
        ("f 1 2 4", "line 5: a face names vertex 4, but there are 3"),
        ("f -4 2 3", "line 5: a face names vertex -4, but there are 3"),
        ("f 1//9 2//1 3//1", "line 5: a face names normal 9, but there are 1"),
        ("f 1/1 2/1 3/1", "line 5: a face names texture coordinate 1, but there are 0"),
        ("f 1.0 2 3", "line 5: a face has '1.0' where an index belongs"),
    ],
)
def test_out_of_range_obj_indices_are_errors(faces: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(nf.SceneError, match=f"a.obj: {words}"):
        load(tmp_path, f"{CORNERS}{faces}\n")


def test_texts_of_any_encoding_are_read(tmp_path: Path) -> None:
    text = f"o Häuser\n{CORNERS}f 1 2 3\n"
    for encoding in ("utf-8", "utf-8-sig", "utf-16", "latin-1"):
        assert load(tmp_path, text.encode(encoding)).triangle_count == 1


def test_long_blank_lines_are_fast(tmp_path: Path) -> None:
    for keyword in ("mtllib", "usemtl", "f", "v"):
        text = f"{CORNERS}f 1 2 3\n{keyword} {' ' * 400_000}\n"
        try:
            load(tmp_path, text)
        except nf.SceneError:
            assert keyword in ("f", "v")


def test_many_objects_keep_their_own_vertices(tmp_path: Path) -> None:
    lines = [f"o part{n}\nv {n} 0 0\nv {n + 1} 0 0\nv {n} 1 0\nvn 0 0 1\nf -3//-1 -2 -1//-1" for n in range(3_000)]
    scene = load(tmp_path, "\n".join(lines))
    assert scene.object_names == tuple(f"part{n}" for n in range(3_000))
    np.testing.assert_array_equal(scene.triangles()[1234, :, 0], [1234, 1235, 1234])


def test_faces_of_an_object_need_not_be_consecutive(tmp_path: Path) -> None:
    scene = load(tmp_path, f"{CORNERS}o b\nf 1 2 3\no a\nf 2 3 1\no b\nf 3 1 2\nf 1 2\n")
    assert scene.object_names == ("b", "a")
    np.testing.assert_array_equal(np.bincount(scene.subset(objects=["b"]).triangles()[:, 0, 1].astype(int)), [1, 1])
    assert "1 face with fewer than three corners ignored" in scene.report.notes


def test_long_names_of_many_parts_count_towards_the_limit(tmp_path: Path) -> None:
    (tmp_path / "a.mtl").write_text("newmtl m0\nnewmtl m1\n" + "".join(f"newmtl m{n}\n" for n in range(2, 400)))
    uses = "".join(f"usemtl m{n}\nf 1 2 3\n" for n in range(400))
    with pytest.raises(nf.SceneError, match=r"a\.obj: it unpacks to more than 268,435,456 bytes"):
        load(tmp_path, f"mtllib a.mtl\n{CORNERS}o {'x' * 1_000_000}\n{uses}")


def test_materials_come_from_all_libraries(tmp_path: Path) -> None:
    (tmp_path / "a.mtl").write_text("newmtl red\nKd 1 0 0\n")
    (tmp_path / "b c.mtl").write_text("newmtl green\nKd 0 1 0\n")
    text = f"mtllib a.mtl\nmtllib b c.mtl\nmtllib gone.mtl\n{CORNERS}usemtl red\nf 1 2 3\nusemtl green\nf 3 2 1\n"
    scene = load(tmp_path, text)
    assert scene.report.materials == 2
    assert "material file 'gone.mtl' cannot be read, drawn without it" in scene.report.notes


def test_skipped_elements_and_missing_materials_are_noted(tmp_path: Path) -> None:
    (tmp_path / "a.mtl").write_text("newmtl red\nKd 1 0 0\n")
    text = (
        f"mtllib a.mtl\n{CORNERS}usemtl blue\nf 1 2 3\nusemtl red\nf 1 2 3\nusemtl unused\nf 1 2\nl 1 2 3\np 1\np 2 3\n"
    )
    assert load(tmp_path, text).report.notes == (
        "2 materials defined nowhere, drawn without: 'blue', 'unused'",
        "1 face with fewer than three corners ignored",
        "1 line element ignored",
        "2 point elements ignored",
    )


@pytest.mark.parametrize(
    ("statement", "left", "note"),
    [
        ("t.png", 0.25, ""),
        ("-blendu on -clamp off -mm 0 1 my dir/t.png", 0.25, ""),
        ("my dir\\t.png", 0.25, ""),
        ("C:\\models\\my dir\\t.png", 0.25, ""),
        ('"t.png"', 0.25, ""),
        ("-s 2 1 1 t.png", 0.125, ""),
        ("-o 0.5 -s -1 t.png", 0.25, ""),
        ("-s 2 2 -o -0.5 0 0 my dir\\t.png", 0.375, ""),
        ("-clamp on -s 2 1 t.png", 0.125, ""),
        ("-mm 0.2 0.5 -bm 3 t.png", 0.25, "options -mm -bm of texture 't.png' ignored"),
    ],
)
def test_options_and_paths_of_textures(tmp_path: Path, statement: str, left: float, note: str) -> None:
    """The middle of the texture's red half is seen at `left`."""
    (tmp_path / "my dir").mkdir()
    for folder in (tmp_path, tmp_path / "my dir"):
        Image.fromarray(np.array([[[255, 0, 0]] * 8 + [[0, 0, 255]] * 8] * 4, np.uint8)).save(folder / "t.png")
    (tmp_path / "a.mtl").write_text(f"newmtl m\nmap_Kd {statement}\n")
    square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"
    scene = load(tmp_path, f"mtllib a.mtl\nusemtl m\n{square}")
    assert scene.report.textures == 1
    assert scene.report.notes == ((note,) if note else ())
    camera = nf.Camera.look_at((left, 0.5, 1), (left, 0.5, 0), fov=nf.Fov.symmetric(0.1), size=(2, 2))
    red, _, blue = nf.render(scene, camera, backend="cpu").require("color")[0, 0, :3]
    assert red > 10 * blue


def test_corners_without_normals_are_flat_among_others(tmp_path: Path) -> None:
    scene = load(tmp_path, f"{CORNERS}vn 1 0 1\nf 1//2 2//2 3//2\nf 1 3 2\n")
    frame = nf.render(
        scene, nf.Camera.look_at((0.2, 0.2, 2), (0.2, 0.2, 0), fov=nf.Fov.symmetric(10), size=(4, 4)), backend="cpu"
    )
    assert np.isfinite(frame.require("color")).all()
