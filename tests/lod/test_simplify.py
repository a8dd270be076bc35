"""Levels by simplification: counts, closed surfaces, borders, errors, degenerate meshes, and refusals."""

from __future__ import annotations

import functools
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from nearfar.lod._simplify import deviation
from nearfar.lod._simplify.surface import Base
from tests.support import need, printed_by_threads
from tests.support.simplify_cases import globe, open_edges

Array = NDArray[Any]


def test_counts_are_reached_and_errors_grow(method: Any) -> None:
    levels = nf.lod.simplify(globe(), [0.5, 0.25, 0.1], method=method)
    base = levels[0].triangle_count
    assert [level.ratio for level in levels] == [1, 0.5, 0.25, 0.1]
    for level in levels[1:]:
        assert abs(level.triangle_count / (base * level.ratio) - 1) < 0.02
        assert level.note == ""
    errors = [level.error for level in levels]
    assert errors == sorted(errors)
    assert levels[0].error == levels[0].mean_error == 0
    # Faces 1 / ratio times as large have chords that much farther below the sphere.
    assert 0 < levels[1].mean_error < levels[1].error < 0.01
    assert levels[3].error < 0.05
    assert levels.name == "globe"
    assert levels[2].scene.object_names == ("globe",)


def test_closed_surfaces_stay_closed(method: Any) -> None:
    for scene in (globe(), nf.Scene.from_trimesh(trimesh.creation.torus(1.0, 0.3))):
        assert open_edges(scene) == 0
        for level in nf.lod.simplify(scene, [0.5, 0.1, 0.05], method=method)[1:]:
            assert open_edges(level.scene) == 0


def test_open_borders_keep_their_outline(method: Any) -> None:
    """Simplifies a square of many squares: without preservation of borders its corners are cut off."""
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


def test_errors_are_distances_between_surfaces() -> None:
    """Covers two concentric spheres, and a plate half as wide as the other."""
    inner, outer = (Base(trimesh.creation.icosphere(4, radius=radius)) for radius in (1.0, 1.1))
    found = deviation.deviation((inner.scene, inner.surface), (outer.scene, outer.surface))
    assert found[0] == pytest.approx(0.1, abs=0.003)
    assert found[1] == pytest.approx(0.1, abs=0.003)
    square = np.array([[0, 0, 0], [0, 0, 1], [1, 0, 0], [1, 0, 1]])
    one, two = (Base(trimesh.Trimesh(square * (x, 1, 1), [[0, 1, 2], [2, 1, 3]])) for x in (1, 2))
    greatest, mean = deviation.deviation((one.scene, one.surface), (two.scene, two.surface))
    # Points on half of the wide plate are off by 0 to 1.
    assert greatest == 1
    assert mean == pytest.approx(0.125, abs=0.002)


def test_sampled_points_are_evenly_distributed() -> None:
    surface = Base(trimesh.creation.box((1, 2, 3))).surface
    points = deviation.spread_points(surface, 20_000)
    on = np.abs(np.abs(points) - (0.5, 1, 1.5)) < 1e-6
    assert on.any(axis=1).all()
    shares = np.array([6, 3, 2]) / 11
    # Three standard errors of a share.
    assert np.abs(on.mean(axis=0) - shares).max() < 3 * 0.5 / np.sqrt(20_000)


def test_unreachable_ratios_are_noted(method: Any) -> None:
    levels = nf.lod.simplify(trimesh.creation.box(), [0.9, 0.5, 0.1], method=method)
    assert levels[0].triangle_count == 12
    assert all(level.triangle_count >= 4 for level in levels)
    assert "no level with 10 %" in levels[-1].note
    single = nf.lod.simplify(nf.Scene.from_arrays(np.eye(3), [[0, 1, 2]]), [0.5], method=method)
    assert len(single) == 1
    assert "found no level with 50 % of the triangles" in single[0].note
    assert "no level with" in str(single)


def test_meshopt_removes_small_parts_if_necessary() -> None:
    """A ball among 300 boxes whose faces are separate charts: seams keep their corners, so no edge can collapse."""
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
    # The ball is below 1, all boxes above 1.7. If no box were removed, nothing would be left of the ball.
    above = [level.scene.triangles()[:, :, 1].min(axis=1) > 1.5 for level in levels]
    assert [int(boxes.sum()) for boxes in above[:2]] == [3600, 3600]
    assert all((~boxes).sum() > 150 for boxes in above)


@functools.cache
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
def test_degenerate_meshes_are_simplified_or_unchanged(method: Any, name: str) -> None:
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


@pytest.mark.slow
def test_levels_do_not_depend_on_threads_or_earlier_calls() -> None:
    need("fast_simplification")
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
    with pytest.raises(ValueError, match="mesh: expected triangles, got none"):
        nf.lod.simplify(SceneBuilder().build())
    with pytest.raises(nf.SceneError, match="finite"):
        nf.lod.simplify(trimesh.Trimesh([[0, 0, 0], [0, np.nan, 1], [1, 0, 0]], [[0, 1, 2]], process=False))
    monkeypatch.setitem(sys.modules, "fast_simplification", None)
    with pytest.raises(ModuleNotFoundError, match="pip install fast-simplification"):
        nf.lod.simplify(ball, method="fast")


def test_instances_are_placed_and_named(method: Any, tmp_path: Path) -> None:
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


def test_duplicate_faces_alone_may_be_removed(method: Any) -> None:
    ball = trimesh.creation.icosphere(3)
    doubled = nf.Scene.from_arrays(ball.vertices, np.concatenate([ball.faces, ball.faces]))
    levels = nf.lod.simplify(doubled, (0.5, 0.2), method=method)
    assert levels[0].triangle_count == 2560
    assert levels[1].triangle_count <= 1280
    if method == "fast":
        assert levels[1].triangle_count == 1280
        assert levels[1].error < 1e-6
    assert "no level with" not in levels[0].note
