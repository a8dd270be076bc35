"""Levels by simplification: counts, closed surfaces, seams, textures, errors, and meshes that are odd."""

from __future__ import annotations

import sys
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar import _core
from nearfar._scene.builder import SceneBuilder
from nearfar.lod._simplify import carry, deviation
from nearfar.lod._simplify import normals as smooth_normals
from nearfar.lod._simplify.surface import Base
from tests.support import data, printed_by_threads

Array = NDArray[Any]
METHODS = ("fast", "meshopt")


@pytest.fixture(params=METHODS)
def method(request: pytest.FixtureRequest) -> str:
    pytest.importorskip("fast_simplification")
    return str(request.param)


def parts(scene: nf.Scene) -> dict[str, Any]:
    return _core.mesh_parts(scene._core.merged())


def open_edges(scene: nf.Scene) -> int:
    """Edges with an odd number of faces, places of vertices taken together."""
    corners = scene.triangles().reshape(-1, 3)
    _, number = np.unique(corners, axis=0, return_inverse=True)
    faces = number.reshape(-1, 3)
    edges = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    edges = edges[edges[:, 0] != edges[:, 1]]
    return int((np.unique(edges, axis=0, return_counts=True)[1] % 2).sum())


def globe(rings: int = 40, *, texture: Array | None = None, radius: float = 1.0) -> nf.Scene:
    """A sphere whose texture coordinates have a seam and are torn at the poles."""
    u, v = np.meshgrid(np.linspace(0, 1, 2 * rings + 1), np.linspace(0, 1, rings + 1))
    around, down = 2 * np.pi * np.where(u == 1, 0, u), np.pi * v
    points = np.stack([np.sin(down) * np.cos(around), np.cos(down), -np.sin(down) * np.sin(around)], axis=2)
    points[0], points[-1] = (0, 1, 0), (0, -1, 0)
    row, column = np.meshgrid(np.arange(rings), np.arange(2 * rings), indexing="ij")
    a = (row * (2 * rings + 1) + column).ravel()
    b, c, d = a + 2 * rings + 1, a + 1, a + 2 * rings + 2
    upper, lower = np.column_stack([a, b, d]), np.column_stack([a, d, c])
    builder = SceneBuilder()
    picture = np.zeros((8, 8, 4), np.uint8) if texture is None else texture
    material = builder.material((1, 1, 1, 1), picture)
    uvs = np.stack([u, 1 - v], axis=2).reshape(-1, 2)
    # The poles' faces would be degenerate otherwise.
    faces = np.concatenate([upper, lower[row.ravel() > 0]])
    faces = faces[~((faces >= rings * (2 * rings + 1)).sum(axis=1) == 2)]
    mesh = builder.mesh(points.reshape(-1, 3) * radius, faces, uvs=uvs, material=material)
    builder.instance(mesh, name="globe")
    return builder.build()


def checkers(size: int = 256) -> Array:
    """Squares whose colour says where they are."""
    x, y = np.meshgrid(np.arange(size), np.arange(size))
    dark = ((x // 32 + y // 32) % 2) * 120
    return np.stack([x * 255 // size, y * 255 // size, 255 - dark, np.full_like(x, 255)], axis=2).astype(np.uint8)


def view(scene: nf.Scene, direction: tuple[float, float, float], size: int = 160) -> Array:
    low, high = scene.bounds
    middle, reach = (low + high) / 2, float(np.linalg.norm(high - low))
    eye = middle + reach * 1.1 * np.array(direction) / np.linalg.norm(direction)
    camera = nf.Camera.look_at(eye, middle, fov=nf.Fov.symmetric(55.0), size=(size, size))
    color = nf.render(scene, camera, channels=["color"], samples=4).color
    assert color is not None
    return color


VIEWS = [(1, 0.4, 0.2), (-0.5, 0.3, 1), (0.1, -0.2, -1)]


def likeness(base: nf.Scene, level: nf.Scene) -> float:
    """Least similarity over views, of 8-bit pictures."""
    return min(float(nf.ssim(view(base, way).clip(0, 1), view(level, way).clip(0, 1), data_range=1.0)) for way in VIEWS)


def test_counts_are_reached_and_errors_grow(method: str) -> None:
    levels = nf.lod.simplify(globe(), [0.5, 0.25, 0.1], method=method)
    base = levels[0].triangle_count
    assert [level.ratio for level in levels] == [1, 0.5, 0.25, 0.1]
    for level in levels[1:]:
        assert abs(level.triangle_count / (base * level.ratio) - 1) < 0.02
        assert level.note == ""
    errors = [level.error for level in levels]
    assert errors == sorted(errors)
    assert levels[0].error == levels[0].mean_error == 0
    # A chord of a sphere whose faces are 1 / ratio times as large lies that much below it.
    assert 0 < levels[1].mean_error < levels[1].error < 0.01
    assert levels[3].error < 0.05
    assert levels.name == "globe"
    assert levels[2].scene.object_names == ("globe",)


def test_closed_surfaces_stay_closed(method: str) -> None:
    for scene in (globe(), nf.Scene.from_trimesh(trimesh.creation.torus(1.0, 0.3))):
        assert open_edges(scene) == 0
        for level in nf.lod.simplify(scene, [0.5, 0.1, 0.05], method=method)[1:]:
            assert open_edges(level.scene) == 0


def test_textures_stay_where_they_are(method: str) -> None:
    scene = globe(texture=checkers())
    levels = nf.lod.simplify(scene, [0.5, 0.2], method=method)
    for level, least in zip(levels[1:], (0.97, 0.9), strict=True):
        assert likeness(scene, level.scene) > least
        arrays = parts(level.scene)
        uvs, points = arrays["uvs"], arrays["positions"].astype(float)
        assert uvs.min() >= 0
        assert uvs.max() <= 1
        # Texture coordinates say where a vertex lies on the sphere.
        around, down = 2 * np.pi * uvs[:, 0], np.pi * (1 - uvs[:, 1])
        aim = np.stack([np.sin(down) * np.cos(around), np.cos(down), -np.sin(down) * np.sin(around)], axis=1)
        assert np.linalg.norm(aim - points, axis=1).max() < 0.1
        # And no face spans the texture from one side of the seam to the other.
        spans = np.ptp(uvs[arrays["faces"]][:, :, 0], axis=1)
        away = np.abs(points[arrays["faces"]][:, :, 1]).max(axis=1) < 0.9
        assert spans[away].max() < 0.4


def test_materials_stay_apart(method: str) -> None:
    """A sphere in two colours, whose border lies on an edge loop."""
    ball = trimesh.creation.icosphere(4)
    builder = SceneBuilder()
    red, blue = builder.material((1, 0, 0, 1)), builder.material((0, 0, 1, 1))
    faces = ball.faces
    upper = ball.triangles_center[:, 1] > 0
    builder.instance(builder.mesh(ball.vertices, faces, material=np.where(upper, red, blue)), name="ball")
    scene = builder.build()
    for level in nf.lod.simplify(scene, [0.3, 0.1], method=method)[1:]:
        arrays = parts(level.scene)
        middle = arrays["positions"][arrays["faces"]].mean(axis=1)[:, 1]
        assert set(arrays["materials"].tolist()) == {red, blue}
        assert middle[arrays["materials"] == red].min() > -0.1
        assert middle[arrays["materials"] == blue].max() < 0.1
        assert open_edges(level.scene) == 0


def test_open_borders_keep_their_outline(method: str) -> None:
    """A square of many squares: without care for borders its corners are cut off."""
    x, z = np.meshgrid(np.linspace(0, 1, 33), np.linspace(0, 1, 33))
    points = np.stack([x, np.zeros_like(x), z], axis=2).reshape(-1, 3)
    a = (np.arange(32)[:, None] * 33 + np.arange(32)).ravel()
    faces = np.concatenate([np.column_stack([a, a + 33, a + 1]), np.column_stack([a + 1, a + 33, a + 34])])
    levels = nf.lod.simplify(nf.Scene.from_arrays(points, faces), [0.1, 0.01], method=method)
    for level in levels[1:]:
        assert level.error < 1e-5
        corners = level.scene.triangles().astype(float)
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
        assert area == pytest.approx(1, abs=1e-5)


def test_vertex_colors_are_carried(method: str) -> None:
    ball = trimesh.creation.icosphere(4)
    colors = np.column_stack([np.rint((ball.vertices + 1) * 127), np.full(len(ball.vertices), 255)]).astype(np.uint8)
    builder = SceneBuilder()
    builder.instance(builder.mesh(ball.vertices, ball.faces, colors=colors), name="ball")
    for level in nf.lod.simplify(builder.build(), [0.3, 0.1], method=method)[1:]:
        arrays = parts(level.scene)
        expected = (arrays["positions"] + 1) * 127
        assert np.abs(arrays["colors"][:, :3] - expected).max() < 8


def test_normals_are_carried_made_or_left_out(method: str) -> None:
    """Those of a sphere are its places; a box's smooth ones are its faces'."""
    ball = trimesh.creation.icosphere(4)
    builder = SceneBuilder()
    builder.instance(builder.mesh(ball.vertices, ball.faces, normals=ball.vertices), name="ball")
    scene = builder.build()
    for kind in ("keep", "smooth"):
        for level in nf.lod.simplify(scene, [0.3, 0.1], method=method, normals=kind):
            arrays = parts(level.scene)
            assert np.linalg.norm(arrays["normals"], axis=1) == pytest.approx(1, abs=1e-5)
            assert np.abs(arrays["normals"] - arrays["positions"]).max() < 0.08
    assert all(parts(level.scene)["normals"] is None for level in nf.lod.simplify(scene, [0.1], normals="flat"))
    box = trimesh.creation.box().subdivide().subdivide().subdivide()
    assert parts(nf.lod.simplify(box, [0.2], method=method)[1].scene)["normals"] is None
    for level in nf.lod.simplify(box, [0.2, 0.05], method=method, normals="smooth"):
        arrays = parts(level.scene)
        corners = level.scene.triangles().astype(float)
        flat = smooth_normals.unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
        assert np.abs(arrays["normals"][arrays["faces"]] - flat[:, None]).max() < 1e-3
        assert level.error < 1e-5


def test_errors_are_distances_between_surfaces() -> None:
    """Two spheres of one middle, and a plate that is half as wide as the other."""
    inner, outer = (Base(trimesh.creation.icosphere(4, radius=radius)) for radius in (1.0, 1.1))
    found = deviation.deviation((inner.scene, inner.surface), (outer.scene, outer.surface))
    assert found[0] == pytest.approx(0.1, abs=0.003)
    assert found[1] == pytest.approx(0.1, abs=0.003)
    square = np.array([[0, 0, 0], [0, 0, 1], [1, 0, 0], [1, 0, 1]])
    one, two = (Base(trimesh.Trimesh(square * (x, 1, 1), [[0, 1, 2], [2, 1, 3]])) for x in (1, 2))
    greatest, mean = deviation.deviation((one.scene, one.surface), (two.scene, two.surface))
    # Of the wide one half is off by 0 to 1.
    assert greatest == 1
    assert mean == pytest.approx(0.125, abs=0.002)


def test_spread_points_are_even() -> None:
    surface = Base(trimesh.creation.box((1, 2, 3))).surface
    points = deviation.spread_points(surface, 20_000)
    on = np.abs(np.abs(points) - (0.5, 1, 1.5)) < 1e-6
    assert on.any(axis=1).all()
    shares = np.array([6, 3, 2]) / 11
    # Three standard errors of a share.
    assert np.abs(on.mean(axis=0) - shares).max() < 3 * 0.5 / np.sqrt(20_000)


def test_smooth_normals_keep_hard_edges() -> None:
    for shape, hard in ((trimesh.creation.box(), True), (trimesh.creation.icosphere(3), False)):
        positions = np.asarray(shape.vertices, np.float32)
        faces = np.asarray(shape.faces, np.uint32)
        corners, normals = smooth_normals.smoothed(positions, faces, np.arange(len(positions), dtype=np.uint32))
        found = normals[corners]
        assert np.allclose(np.linalg.norm(found, axis=2), 1, atol=1e-6)
        if hard:
            assert np.allclose(found, shape.face_normals[:, None], atol=1e-6)
        else:
            assert np.abs(found - positions[faces]).max() < 0.02
            assert len(np.unique(corners)) == len(positions)


def test_corners_share_a_vertex_where_they_agree() -> None:
    corners = np.array([0, 0, 0, 0, 1, 1], np.uint32)
    values = np.array([[0.0], [5.0], [0.9], [5.5], [np.nan], [1.0]])
    assert carry.together(corners, values).tolist() == [0, 1, 0, 1, 4, 5]


def test_ratios_that_cannot_be_reached_are_said(method: str) -> None:
    levels = nf.lod.simplify(trimesh.creation.box(), [0.9, 0.5, 0.1], method=method)
    assert levels[0].triangle_count == 12
    assert all(level.triangle_count >= 4 for level in levels)
    assert "0.1" in levels[-1].note
    single = nf.lod.simplify(nf.Scene.from_arrays(np.eye(3), [[0, 1, 2]]), [0.5], method=method)
    assert len(single) == 1
    assert "ratio 0.5 can't be reached" in single[0].note
    assert "can't be reached" in str(single)


def test_meshopt_gives_up_small_parts_where_it_must() -> None:
    """A ball among 300 boxes whose faces are charts of their own: seams keep their corners, so that no edge can go."""
    ball, box = trimesh.creation.icosphere(4), trimesh.creation.box((0.02, 0.02, 0.02))
    corners, uvs = box.vertices[box.faces].reshape(-1, 3), np.random.default_rng(1).uniform(size=(36, 2))
    places = np.random.default_rng(3).uniform(-1, 1, (300, 3)) * (3, 0.2, 0.2) + (0, 2, 0)
    vertices = np.concatenate([ball.vertices, *(corners + place for place in places)])
    faces = np.concatenate([ball.faces, len(ball.vertices) + np.arange(300 * 36).reshape(-1, 3)])
    visual = trimesh.visual.TextureVisuals(
        uv=np.concatenate([np.zeros((len(ball.vertices), 2)), *[uvs] * 300]), image=Image.new("RGB", (4, 4))
    )
    whole = trimesh.Trimesh(vertices, faces, process=False, visual=visual)
    levels = nf.lod.simplify(whole, [0.8, 0.3, 0.02], method="meshopt")
    assert [level.triangle_count for level in levels[:2]] == [8720, 6976]
    assert levels[2].triangle_count <= 2616
    assert levels[3].triangle_count == pytest.approx(174, abs=2)
    assert levels[2].note == f"{levels[2].triangle_count:,} triangles instead of 2,616"
    assert not levels[3].note
    # The ball is below 1, all boxes above 1.7. Without any of them to give up, the ball would be nothing.
    above = [level.scene.triangles()[:, :, 1].min(axis=1) > 1.5 for level in levels]
    assert [int(boxes.sum()) for boxes in above[:2]] == [3600, 3600]
    assert all((~boxes).sum() > 150 for boxes in above)


def odd_meshes() -> dict[str, tuple[Array, Array]]:
    ball = trimesh.creation.icosphere(3)
    v, f = np.asarray(ball.vertices), np.asarray(ball.faces)
    aside, loose = np.array([2, 0, 0]), np.repeat(np.arange(len(f)), 3)[:, None] * 1e-3
    fan = np.concatenate([f, [[0, 1, 200], [0, 1, 300], [0, 1, 400]]])
    return {
        "copies of faces": (v, np.concatenate([f, f[:200], f[:200, ::-1]])),
        "faces without an area": (v, np.concatenate([f, np.repeat(f[:50, :1], 3, axis=1), f[:50][:, [0, 1, 1]]])),
        "vertices of no face": (np.concatenate([v, v * 100]), f),
        "two pieces": (np.concatenate([v, v + 5]), np.concatenate([f, f + len(v)])),
        "pieces that touch": (np.concatenate([v, v + aside]), np.concatenate([f, f + len(v)])),
        "edges of many faces": (v, fan),
        "an open border": (v, f[ball.triangles_center[:, 1] > 0]),
        "a soup": (v[f].reshape(-1, 3) + loose, np.arange(3 * len(f)).reshape(-1, 3)),
        "all in one place": (np.zeros((30, 3)), np.arange(30).reshape(-1, 3)),
        "all on a line": (np.arange(30)[:, None] * np.ones(3), np.arange(30).reshape(-1, 3)),
        "tiny": (v * 1e-20, f),
        "huge": (v * 1e20, f),
        "far away": (v + aside * 1e7, f),
    }


@pytest.mark.parametrize("name", odd_meshes())
def test_odd_meshes_are_simplified_or_left_alone(method: str, name: str) -> None:
    vertices, faces = odd_meshes()[name]
    levels = nf.lod.simplify(nf.Scene.from_arrays(vertices, faces), [0.5, 0.1], method=method)
    counts = [level.triangle_count for level in levels]
    assert counts[0] == len(faces)
    assert counts == sorted(counts, reverse=True)
    size = np.abs(levels[0].scene.bounds[1] - levels[0].scene.bounds[0]).max()
    for level in levels:
        assert np.isfinite([level.error, level.mean_error]).all()
        assert name.startswith("all") or level.error <= 0.5 * size
    if name in ("tiny", "huge", "far away", "two pieces", "pieces that touch", "vertices of no face", "an open border"):
        assert abs(counts[1] / counts[0] - 0.5) < 0.02


def test_levels_do_not_depend_on_threads_or_on_what_came_before() -> None:
    pytest.importorskip("fast_simplification")
    code = (
        "import nearfar as nf, trimesh, hashlib\n"
        "for method in ('fast', 'meshopt', 'fast'):\n"
        "    s = nf.lod.simplify(trimesh.creation.icosphere(4), [.5, .1], method=method)\n"
        "    print([hashlib.sha256(l.scene.triangles().tobytes()).hexdigest() for l in s], [l.error for l in s])"
    )
    printed = printed_by_threads(code)
    assert len(printed) == 1
    lines = printed.pop().splitlines()
    assert lines[0] == lines[2] != lines[1]


def test_bad_arguments_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    ball = trimesh.creation.icosphere(1)
    for ratios, message in (([0.5, 0], "ratios.1.: expected"), ([1.5], "ratios.0."), ([np.nan], "ratios.0.")):
        with pytest.raises(ValueError, match=message):
            nf.lod.simplify(ball, ratios)
    with pytest.raises(TypeError, match="ratios"):
        nf.lod.simplify(ball, 0.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="method: expected one of 'fast', 'meshopt'"):
        nf.lod.simplify(ball, method="slow")
    with pytest.raises(ValueError, match="normals: expected one of"):
        nf.lod.simplify(ball, normals="hard")
    with pytest.raises(TypeError, match="mesh: expected a Scene"):
        nf.lod.simplify(ball.vertices)
    with pytest.raises(TypeError, match="name: expected a string"):
        nf.lod.simplify(ball, name=3)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="mesh: expected triangles, got none"):
        nf.lod.simplify(SceneBuilder().build())
    with pytest.raises(nf.SceneError, match="finite"):
        nf.lod.simplify(trimesh.Trimesh([[0, 0, 0], [0, np.nan, 1], [1, 0, 0]], [[0, 1, 2]], process=False))
    monkeypatch.setitem(sys.modules, "fast_simplification", None)
    with pytest.raises(ModuleNotFoundError, match=r"pip install nearfar\[lod\]"):
        nf.lod.simplify(ball, method="fast")


def test_instances_are_placed_and_named(method: str, tmp_path: Path) -> None:
    builder = SceneBuilder()
    ball = trimesh.creation.icosphere(3)
    mesh = builder.mesh(ball.vertices, ball.faces)
    for x in (0.0, 5.0):
        builder.instance(mesh, trimesh.transformations.translation_matrix([x, 0, 0]), name=f"ball {x:g}")
    scene = builder.build()
    levels = nf.lod.simplify(scene, [0.2], method=method)
    assert levels.name == "object"
    assert levels[0].triangle_count == 2 * len(ball.faces)
    assert np.abs(levels[1].scene.bounds - scene.bounds).max() < 0.1
    assert nf.lod.simplify(scene, [0.2], method=method, name="two balls").name == "two balls"
    path = tmp_path / "sphere.ply"
    ball.export(path)
    assert nf.lod.simplify(path, [0.2], method=method).name == "sphere"


def spot(folder: Path) -> nf.Scene:
    with zipfile.ZipFile(data("objects/spot/spot.zip")) as packed:
        packed.extractall(folder)
    mesh = trimesh.load(folder / "spot/spot_triangulated.obj", process=False)
    picture = Image.open(folder / "spot/spot_texture.png")
    mesh.visual = trimesh.visual.TextureVisuals(mesh.visual.uv, image=picture)
    return nf.Scene.from_trimesh(mesh)


def test_spot_keeps_her_spots(method: str, tmp_path: Path) -> None:
    scene = spot(tmp_path)
    levels = nf.lod.simplify(scene, [0.5, 0.1], method=method)
    for level, least in zip(levels[1:], (0.95, 0.8), strict=True):
        assert abs(level.triangle_count / (levels[0].triangle_count * level.ratio) - 1) < 0.02
        assert open_edges(level.scene) == open_edges(scene)
        assert likeness(scene, level.scene) > least


def test_the_helmet_keeps_its_materials(method: str) -> None:
    scene = nf.Scene.load(data("objects/gltf/FlightHelmet/FlightHelmet.gltf"))
    levels = nf.lod.simplify(scene, [0.25, 0.05], method=method)
    assert levels[1].scene.report.textures == scene.report.textures
    used = set(parts(scene)["materials"].tolist())
    for level in levels[1:]:
        assert set(parts(level.scene)["materials"].tolist()) == used
    assert abs(levels[1].triangle_count / levels[0].triangle_count - 0.25) < 0.005 or levels[1].note
    assert levels[1].error < 0.01 * levels.radius * 2


def test_copies_of_faces_may_be_all_that_goes(method: str) -> None:
    ball = trimesh.creation.icosphere(3)
    doubled = nf.Scene.from_arrays(ball.vertices, np.concatenate([ball.faces, ball.faces]))
    levels = nf.lod.simplify(doubled, (0.5, 0.2), method=method)
    assert levels[0].triangle_count == 2560
    assert levels[1].triangle_count <= 1280
    if method == "fast":
        assert levels[1].triangle_count == 1280
        assert levels[1].error < 1e-6
    assert "can't be reached" not in levels[0].note
