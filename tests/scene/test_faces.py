"""Polygons of OBJ, PLY and OFF files: concave, mixed, coloured, with attributes of corners; PLY data of any layout."""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Literal

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from tests.support.solids import area_vectors

DART = [(0.0, 0.0), (2.0, 1.0), (0.0, 2.0), (1.0, 1.0)]
"""An arrowhead of area 1."""
# An L of area 3 and a comb of area 7.
L = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]
COMB = [(0, 0), (5, 0), (5, 2), (4, 2), (4, 1), (3, 1), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)]
Format = Literal["obj", "off", "ascii", "binary_little_endian", "binary_big_endian"]
FORMATS: tuple[Format, ...] = ("obj", "off", "ascii", "binary_little_endian", "binary_big_endian")
TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "float": "f", "double": "d"}

Row = tuple[float | tuple[float, ...], ...]


def ply(kind: Format, elements: Mapping[str, tuple[dict[str, str], Sequence[Row]]], comment: str = "") -> bytes:
    """A PLY file; elements have types by property, such as "float" or "uchar int" for lists, and rows."""
    header, body = f"ply\nformat {kind} 1.0\n{comment}", b""
    for name, (properties, rows) in elements.items():
        header += f"element {name} {len(rows)}\n"
        for prop, types in properties.items():
            header += f"property {'list ' if ' ' in types else ''}{types} {prop}\n"
        for row in rows:
            words: list[str] = []
            for types, value in zip(properties.values(), row, strict=True):
                cells = [(types, value)]
                if isinstance(value, tuple):
                    count_type, item_type = types.split()
                    cells = [(count_type, len(value)), *((item_type, item) for item in value)]
                for cell_type, item in cells:
                    words.append(str(item))
                    if kind != "ascii":
                        order = "<" if kind == "binary_little_endian" else ">"
                        body += struct.pack(order + TYPES[cell_type], item)
            body += (" ".join(words) + "\n").encode() if kind == "ascii" else b""
    return header.encode() + b"end_header\n" + body


POSITION = dict.fromkeys("xyz", "float")
INDICES = {"vertex_indices": "uchar int"}


def load(tmp_path: Path, data: bytes | str, suffix: str = "ply") -> nf.Scene:
    path = tmp_path / f"a.{suffix}"
    path.write_bytes(data.encode() if isinstance(data, str) else data)
    return nf.Scene.load(path)


def write(kind: Format, points: Sequence[tuple[float, ...]], faces: Sequence[tuple[int, ...]]) -> tuple[bytes, str]:
    """A file of polygons, and its suffix."""
    if kind == "obj":
        lines = [f"v {x} {y} {z}" for x, y, z in points]
        return "\n".join(lines + [f"f {' '.join(str(n + 1) for n in face)}" for face in faces]).encode(), "obj"
    if kind == "off":
        lines = ["OFF", f"{len(points)} {len(faces)} 0", *(f"{x} {y} {z}" for x, y, z in points)]
        return "\n".join(lines + [f"{len(face)} {' '.join(map(str, face))}" for face in faces]).encode(), "off"
    indices = {"vertex_indices": "ushort int"}
    return ply(kind, {"vertex": (POSITION, list(points)), "face": (indices, [(face,) for face in faces])}), "ply"


@pytest.mark.parametrize(
    ("kind", "outline", "area"),
    [("obj", DART, 1), ("obj", COMB, 8), ("obj", DART[:3], 2), ("obj", L[:3], 1), *((kind, L, 3) for kind in FORMATS)],
)
def test_polygons_have_their_area_from_every_first_corner(
    tmp_path: Path, kind: Format, outline: list[tuple[float, float]], area: float
) -> None:
    random = np.random.default_rng(1)
    for bend in (0.0, 0.01):
        points = [(x, y, float(bend * random.uniform(-1, 1))) for x, y in outline]
        for first in range(len(points)):
            around = tuple((first + n) % len(points) for n in range(len(points)))
            found = area_vectors(load(tmp_path, *write(kind, points, [around, around[::-1]])))
            assert len(found) == 2 * (len(points) - 2)
            np.testing.assert_allclose(np.abs(found[:, 2]).sum(), 2 * area, rtol=1e-5)
            half = len(found) // 2
            assert (found[:half, 2] > -1e-6).all()
            assert (found[half:, 2] < 1e-6).all()


@pytest.mark.parametrize("kind", FORMATS)
def test_triangles_quads_and_larger_faces_mix(tmp_path: Path, kind: Format) -> None:
    points = [(*point, 0.0) for point in [*COMB, *DART]]
    faces: list[tuple[int, ...]] = [(12, 13, 15), tuple(range(12)), (12, 13), (15, 12, 13, 14), (0, 1, 2, 11)]
    scene = load(tmp_path, *write(kind, points, faces))
    assert scene.triangle_count == 1 + 10 + 2 + 2
    np.testing.assert_allclose(area_vectors(scene)[:, 2].sum(), 0.5 + 8 + 1 + 10)
    assert "1 face with fewer than three corners ignored" in scene.report.notes


def corner_colors(scene: nf.Scene, points: list[tuple[float, float]]) -> NDArray[np.float64]:
    """Colours (N, 3) of points of the plane z = 0 seen from the front, relative to white."""
    corners = np.array([[-9.0, -9, 0], [9, -9, 0], [0, 9, 0]])
    grey = nf.Scene.from_arrays(corners, [[0, 1, 2]])
    cameras = [nf.Camera.look_at((x, y, 1), (x, y, 0), fov=nf.Fov.symmetric(0.1), size=(2, 2)) for x, y in points]
    found, full = (
        np.array([nf.render(each, camera, backend="cpu").require("color")[..., :3].mean((0, 1)) for camera in cameras])
        for each in (scene, grey)
    )
    return np.asarray(0.8 * found / full)


@pytest.mark.parametrize("kind", ["obj", "ascii", "binary_big_endian"])
def test_texture_coordinates_stay_with_their_corners(tmp_path: Path, kind: Format) -> None:
    """The texture is red where x < 1 and blue beyond, as long as each corner has its own coordinates."""
    Image.fromarray(np.array([[[255, 0, 0]] * 8 + [[0, 0, 255]] * 8] * 16, np.uint8)).save(tmp_path / "t.png")
    inside = [(0.25, 1.82), (0.85, 1.2), (1.3, 0.8), (1.9, 0.97)]
    for first in range(4):
        around = [(first + n) % 4 for n in range(4)]
        uvs = [(DART[n][0] / 2, DART[n][1] / 2) for n in around]
        if kind == "obj":
            (tmp_path / "a.mtl").write_text("newmtl m\nmap_Kd t.png\n")
            lines = ["mtllib a.mtl", "usemtl m", *(f"v {x} {y} 0" for x, y in DART), *(f"vt {u} {v}" for u, v in uvs)]
            face = " ".join(f"{n + 1}/{row + 1}" for row, n in enumerate(around))
            scene = load(tmp_path, "\n".join([*lines, f"f {face}"]), "obj")
        else:
            faces: list[Row] = [(tuple(around), tuple(value for uv in uvs for value in uv))]
            elements: dict[str, tuple[dict[str, str], Sequence[Row]]] = {
                "face": ({**INDICES, "texcoord": "uchar float"}, faces),
                "vertex": (POSITION, [(*point, 0.0) for point in DART]),
            }
            scene = load(tmp_path, ply(kind, elements, "comment TextureFile t.png\n"))
        assert scene.report.textures == 1
        colors = corner_colors(scene, inside)
        assert (colors[:2, 0] > 10 * colors[:2, 2]).all()
        assert (colors[2:, 2] > 10 * colors[2:, 0]).all()


@pytest.mark.parametrize("kind", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_lists_of_any_length_stand_between_other_properties(tmp_path: Path, kind: Format) -> None:
    """Each face has a list before and after its indices, and faces stand before vertices."""
    types = {"a": "uchar", "before": "ushort double", "b": "double", **INDICES, "c": "ushort", "after": "int uchar"}
    faces: list[Row] = [
        (1, (1.5, 2.5), 3.0, (0, 1, 2, 3), 9, ()),
        (1, (), 3.0, (0, 1, 3), 9, (1, 2, 3)),
        (1, (7.0,), 3.0, (3, 0, 1, 2), 9, (4,)),
    ]
    points: list[Row] = [(*point, 0.0) for point in DART]
    edges: list[Row] = [(0, 1)]
    elements = {
        "face": (types, faces),
        "edge": ({"vertex1": "int", "vertex2": "int"}, edges),
        "vertex": (POSITION, points),
    }
    scene = load(tmp_path, ply(kind, elements))
    assert scene.triangle_count == 2 + 1 + 2
    np.testing.assert_allclose(area_vectors(scene)[:, 2].sum(), 2.5)
    assert "1 row of element 'edge' ignored" in scene.report.notes
    assert {f"face property {name} ignored" for name in ("a", "before", "b", "c", "after")} <= set(scene.report.notes)
    if kind != "ascii":
        with pytest.raises(nf.SceneError, match="it is cut off"):
            load(tmp_path, ply(kind, elements)[:-1])


@pytest.mark.parametrize("kind", FORMATS)
def test_neighbours_of_straight_sides_fit(tmp_path: Path, kind: Format) -> None:
    """Below a rectangle, whose upper side has two more corners, stand three squares: no corner lies on an edge."""
    upper, lower = [(float(x), 1.0, 0.0) for x in range(4)], [(float(x), 0.0, 0.0) for x in range(4)]
    points = [*upper, *lower, (3.0, 2.0, 0.0), (0.0, 2.0, 0.0)]
    for first in range(6):
        rectangle = [0, 1, 2, 3, 8, 9]
        rectangle = rectangle[first:] + rectangle[:first]
        faces = [tuple(rectangle), *((4 + n, 5 + n, 1 + n, n) for n in range(3))]
        scene = load(tmp_path, *write(kind, points, faces))
        assert scene.triangle_count == 4 + 6
        assert scene.report.degenerate_faces == 0
        edges = [
            (tuple(face[n]), tuple(face[(n + 1) % 3]))
            for face in scene.triangles()[:, :, :2].tolist()
            for n in range(3)
        ]
        # Every edge has its reverse in a neighbour, apart from the outline's eight.
        assert len(set(edges)) == len(edges)
        assert sum((end, start) not in edges for start, end in edges) == 8


@pytest.mark.parametrize("kind", ["obj", "off", "ascii"])
def test_fans_that_do_not_cover_their_face_are_noted(tmp_path: Path, kind: Format) -> None:
    bow = [(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 3.0)]
    comb = [(float(n), 1.0 + n % 2) for n in range(9000)]
    points = [(*point, 0.0) for point in [*bow, *comb, (9000.0, 0.0), (0.0, 0.0)]]
    large = tuple(range(4, len(points)))
    notes = load(tmp_path, *write(kind, points, [(0, 1, 2, 3), large[::-1], (0, 1, 2)])).report.notes
    note = "drawn as a fan from the first corner"
    assert f"1 face with an outline that crosses itself {note}" in notes
    assert f"1 face with more than 8,192 corners {note}, which may leave the outline" in notes


@pytest.mark.parametrize("kind", ["ascii", "binary_little_endian", "binary_big_endian"])
@pytest.mark.parametrize(("types", "full"), [("uchar", 255), ("ushort", 65535), ("float", 1.0), ("int", 255)])
def test_colours_range_over_their_type(tmp_path: Path, kind: Format, types: str, full: float) -> None:
    half = full / 2 if types == "float" else (int(full) + 1) // 2
    one = full if types == "float" else int(full)
    properties = {**POSITION, "red": types, "green": types, "blue": types}
    points: list[Row] = [(*point, 0.0, half, one, 0) for point in DART[:3]]
    triangle: list[Row] = [((0, 1, 2),)]
    scene = load(tmp_path, ply(kind, {"vertex": (properties, points), "face": (INDICES, triangle)}))
    colored: list[Row] = [((0, 1, 2), half, one, 0)]
    face_properties = {**INDICES, "red": types, "green": types, "blue": types}
    by_face = load(
        tmp_path, ply(kind, {"vertex": (POSITION, [p[:3] for p in points]), "face": (face_properties, colored)})
    )
    for found in (scene, by_face):
        red, green, blue = corner_colors(found, [(0.5, 1.0)])[0]
        # sRGB 128 of 255 is 0.216 in linear light.
        assert abs(red / green - 0.216) < 0.005
        assert blue == 0


@pytest.mark.parametrize("kind", ["ascii", "binary_little_endian"])
@pytest.mark.parametrize(
    ("types", "color", "expected"),
    [
        (("uchar", "ushort", "float", "uchar"), (255, 65535, 1.0, 255), (255, 255, 255, 255)),
        (("float", "uchar", "uchar", "ushort"), (0.5, 51, 0, 65535), (128, 51, 0, 255)),
        (("ushort", "ushort", "ushort", "uchar"), (255, 0, 128, 255), (1, 0, 0, 255)),
        (("int", "int", "uchar", "float"), (255, 51, 102, 1.0), (255, 51, 102, 255)),
        (("short", "char", "int", "short"), (255, 127, 255, 2**15 - 1), (2, 255, 255, 255)),
        (("int", "int", "int", "uchar"), (2**31 - 1, 0, 255, 51), (255, 0, 0, 51)),
    ],
)
def test_each_channel_ranges_over_its_own_type(
    tmp_path: Path, kind: Format, types: tuple[str, ...], color: tuple[float, ...], expected: tuple[int, ...]
) -> None:
    names = ("red", "green", "blue", "alpha")
    points: list[Row] = [(*point, 0.0, *color) for point in DART[:3]]
    triangle: list[Row] = [((0, 1, 2),)]
    properties = {**POSITION, **dict(zip(names, types, strict=True))}
    scene = load(tmp_path, ply(kind, {"vertex": (properties, points), "face": (INDICES, triangle)}))
    colors = nf._core.mesh_parts(scene._core.merged())["colors"]
    np.testing.assert_array_equal(colors, [expected] * 3)


def test_off_rows_may_differ_in_length(tmp_path: Path) -> None:
    """Vertices and faces without a colour among others are light grey; texture coordinates are ignored."""
    scene = load(tmp_path, "STCNOFF\n3 1 0\n0 0 0 0 0 1 128 0 255 0.5 0.5\n1 0 0 0 0 1\n0 1 0\n3 0 1 2\n", "off")
    parts = nf._core.mesh_parts(scene._core.merged())
    np.testing.assert_array_equal(parts["colors"], [(128, 0, 255, 255), (231,) * 3 + (255,), (231,) * 3 + (255,)])
    np.testing.assert_array_equal(parts["normals"], [(0, 0, 1), (0, 0, 1), (0, 0, 0)])
    assert scene.report.notes == (
        "texture coordinates ignored: not all vertices have equally many numbers",
        "2 vertices without red, green and blue drawn light grey",
    )
    rows = "".join(f"{x} {y} 0\n" for x, y in DART)
    by_face = load(tmp_path, f"OFF\n4 3 0\n{rows}3 0 1 3 255 0 0\n3 1 2 3\n3 0 2 3 7\n", "off")
    assert by_face.report.notes == ("2 faces without red, green and blue drawn light grey",)
    grey, red = nf._core.scene_parts(by_face._core)["material_colors"]
    # The byte nearest to the sRGB of 0.8.
    np.testing.assert_allclose([*red[:3], *grey[:3]], [1, 0, 0, 0.8, 0.8, 0.8], atol=2e-3)


def test_off_colours_are_read(tmp_path: Path) -> None:
    scene = load(
        tmp_path, "COFF\n3 1 0\n" + "".join(f"{x} {y} 0 128 255 0 255\n" for x, y in DART[:3]) + "3 0 1 2\n", "off"
    )
    rows = "".join(f"{x} {y} 0\n" for x, y in DART[:3])
    by_face = load(tmp_path, f"OFF # a comment\n3 1 0\n{rows}3 0 1 2 128 255 0\n", "off")
    for found in (scene, by_face):
        red, green, blue = corner_colors(found, [(0.5, 1.0)])[0]
        assert abs(red / green - 0.216) < 0.005
        assert blue == 0
