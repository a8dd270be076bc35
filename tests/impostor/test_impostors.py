"""The result of a bake: budgets, scenes without a far part, arguments, threads."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from tests.support import printed_by_threads
from tests.support.card_cases import Card
from tests.support.impostor_cases import CENTER, SETTINGS, bake, view
from tests.support.reduce_cases import box

SMALL: dict[str, Any] = {**SETTINGS, "face_size": 128, "centers": 7}


def test_stats_count_what_is_drawn(scene: nf.Scene, impostors: nf.Impostors) -> None:
    stats = impostors.stats
    assert impostors.far is not None
    assert stats["triangles"] == impostors.far.triangle_count
    assert stats["near_triangles"] == impostors.near.triangle_count
    assert impostors.scene.triangle_count == impostors.triangle_count == stats["triangles"] + stats["near_triangles"]
    assert stats["scene_triangles"] == scene.triangle_count
    assert sum(count for _, count in impostors.layers) == stats["quads"]
    np.testing.assert_allclose(impostors.layers[0][0], CENTER, atol=1e-6)
    assert all(np.linalg.norm(np.subtract(at, CENTER)) <= SETTINGS["reach"] + 1e-6 for at, _ in impostors.layers)
    width, height = stats["atlas"]
    assert 0 < stats["texels"] < width * height
    assert stats["missing"] < 0.005
    assert impostors.object_names == scene.object_names
    assert f"{stats['quads']} quads" in repr(impostors)
    assert "texture of all quads" in Card(impostors._repr_html_()).text
    copy = pickle.loads(pickle.dumps(impostors))
    assert copy.stats == stats


def test_a_budget_increases_the_error_and_then_drops_the_least_visible_quads(scene: nf.Scene) -> None:
    free = nf.reduce(scene, far="impostors", **SMALL)
    coarsest = nf.reduce(scene, far="impostors", **SMALL, error_px=8.0)
    assert coarsest.triangle_count < free.triangle_count
    budget = free.triangle_count - 1
    chosen = nf.reduce(scene, far="impostors", **SMALL, triangles=budget)
    assert chosen.triangle_count <= budget
    assert free.settings.error_px < chosen.settings.error_px <= 8.0
    assert chosen.settings.error_px == chosen.stats["error_px"]
    assert 3 <= chosen.stats["bakes"] <= 5
    assert chosen.stats["dropped_quads"] == 0
    # Below what the greatest error allows.
    budget = coarsest.triangle_count // 2
    cut = nf.reduce(scene, far="impostors", **SMALL, triangles=budget)
    assert 0.9 * budget < cut.triangle_count <= budget
    assert cut.settings.error_px == 8.0
    all_quads, kept = coarsest._quads, cut._quads
    assert all_quads is not None
    assert kept is not None
    assert cut.stats["dropped_quads"] == len(all_quads) - len(kept) > 0
    assert cut.stats["dropped_texels"] == coarsest.stats["texels"] - cut.stats["texels"]
    np.testing.assert_array_equal(np.sort(all_quads.texels)[::-1][: len(kept)], np.sort(kept.texels)[::-1])
    drawn = {tuple(corner) for corner in np.asarray(kept.vertices).tolist()}
    assert drawn < {tuple(corner) for corner in np.asarray(all_quads.vertices).tolist()}


def test_few_large_far_triangles_that_users_see_stay_geometry() -> None:
    build = nf.SceneBuilder()
    for low, high in (((-8.0, 0.0, -5.0), (-7.0, 3.0, -4.0)), ((-40.0, 0.0, -31.0), (40.0, 30.0, -30.0))):
        corners, sides = box(low, high)
        build.instance(
            build.mesh(corners, sides, material=build.material((0.6, 0.3, 0.2, 1.0))), name=f"wall_{low[0]:g}"
        )
    # Only users beside the wall would see the ball behind it.
    ball = trimesh.creation.icosphere(subdivisions=4, radius=5.0)
    mesh = build.mesh(np.add(ball.vertices, (0.0, 8.0, -60.0)), ball.faces, material=build.material((1, 0, 0, 1)))
    build.instance(mesh, name="ball")
    scene, place = build.build(), (0.0, 1.7, 0.0)
    options: dict[str, Any] = {"far": "impostors", "center": place, "r2": 20.0, "reach": 4.0, "face_size": 128}
    kept = nf.reduce(scene, **options)
    assert kept.far is None
    assert kept.triangle_count <= 24
    assert "stay geometry" in kept.reason
    user = view(np.add(place, (3.0, 0.5, -2.0)))
    truth, shown = (nf.render(source, user, channels=("color", "range")) for source in (scene, kept))
    np.testing.assert_array_equal(truth.to_image(), shown.to_image())
    # Quads show the ball's side with fewer triangles than it has.
    aside = nf.reduce(scene, **{**options, "center": (0.0, 1.7, -46.0), "r2": 5.0})
    assert aside.far is not None
    assert nf.reduce(scene, **options, visible=False).far is not None


def test_chains_of_bakes_use_quads_again_once(scene: nf.Scene) -> None:
    options: dict[str, Any] = {**SMALL, "face_size": 64, "centers": 3}
    first = bake(scene, **options)
    chain = [first]
    for step in range(4):
        place = np.add(CENTER, (0.5 * (step + 1), 0.0, 0.0))
        chain.append(bake(scene, **{**options, "center": place}, earlier=chain[-1]))
    assert chain[1].stats["shared_quads"] > 0
    assert max(baked.far.triangle_count for baked in chain if baked.far) < 2 * first.stats["triangles"]
    assert max(len(baked.layers) for baked in chain) <= 2 * options["centers"]


def test_poses_reach_the_published_picture_the_next_centre_and_the_folder(scene: nf.Scene, tmp_path: Path) -> None:
    pose = scene.poses["car"].copy()
    pose[:3, 3] += (1.0, 0.0, 2.0)
    settings: dict[str, Any] = {**SMALL, "face_size": 64, "centers": 1}
    moved = nf.reduce(scene, far="impostors", **settings).at({"car": pose})
    again = moved.recentered(np.add(CENTER, (0.5, 0.0, 0.0))).result()
    moved.save(tmp_path / "light")
    loaded = nf.Impostors.load(tmp_path / "light" / "reduced.json")
    copy = pickle.loads(pickle.dumps(loaded))
    for shown in (moved.published, again, loaded, loaded.published, copy):
        np.testing.assert_allclose(shown.poses["car"], pose)
    assert {f"impostors_{sector}" for sector in range(6)} <= set(loaded.object_names)
    for fail in (lambda: loaded.recentered(CENTER), lambda: loaded.save(tmp_path / "again"), lambda: copy.published):
        with pytest.raises(ValueError, match="expected"):
            fail()


def test_folders_without_a_far_part_and_tiny_models_are_written(scene: nf.Scene, tmp_path: Path) -> None:
    nf.reduce(scene, far="impostors", **{**SMALL, "r2": 300.0}).save(tmp_path / "near")
    loaded = nf.Impostors.load(tmp_path / "near")
    assert (loaded.far, loaded.published.env) == (None, None)
    tiny = nf.Scene.from_arrays(np.array([[0.0, 0.0, 0.0], [1e-5, 0.0, 0.0], [0.0, 1e-5, 0.0]]), [[0, 1, 2]])
    lost = nf.reduce(tiny, far="impostors", center=(0, 0, 1e-4), r2=1e-3).save(tmp_path / "tiny")
    assert "smaller than its rounding" in lost[0]
    assert not (tmp_path / "tiny" / "light.glb").exists()


def test_a_budget_of_bytes_limits_the_file(scene: nf.Scene, tmp_path: Path) -> None:
    budget = 40_000
    kept = nf.reduce(scene, far="impostors", **SMALL, bytes=budget, triangles=1500)
    kept.save_glb(tmp_path / "light.glb")
    assert 0.5 * budget < (tmp_path / "light.glb").stat().st_size <= budget
    assert kept.triangle_count <= 1500
    with pytest.raises(ValueError, match=r"bytes: expected at least the .* of the near part within r2 = 12 m, got 500"):
        nf.reduce(scene, far="impostors", **SMALL, bytes=500)


def test_texels_are_counted_in_each_quads_rectangle(impostors: nf.Impostors) -> None:
    quads = impostors._quads
    assert quads is not None
    height, width = quads.atlas.shape[:2]
    for number in range(0, len(quads), 7):
        s, t = (quads.uvs[np.unique(quads.faces[quads.owners == number])] * (width, height)).T
        rows, columns = slice(round(height - t.max()), round(height - t.min())), slice(round(s.min()), round(s.max()))
        assert quads.texels[number] == (quads.atlas[rows, columns, 3] >= 128).sum() > 0


def test_a_scene_without_anything_beyond_r2_has_no_quads(scene: nf.Scene, tmp_path: Any) -> None:
    near = nf.reduce(scene, far="impostors", **{**SETTINGS, "r2": 300.0})
    assert (near.far, near.triangle_count, near.layers) == (None, scene.triangle_count, ())
    assert near.stats["quads"] == 0
    assert "no static triangle beyond 300 m is seen" in repr(near)
    assert "is seen" in Card(near._repr_html_()).text
    camera = view(np.array(CENTER))
    truth, frame = (nf.render(shown, camera, channels=("color",)) for shown in (scene, near))
    np.testing.assert_array_equal(truth.require("color"), frame.require("color"))
    with pytest.raises(ValueError, match="part: expected impostors with quads"):
        near.save_glb(tmp_path / "far.glb", part="far")
    empty = nf.reduce(scene.subset(triangles=[]), far="impostors", **SETTINGS)
    assert (empty.far, empty.triangle_count) == (None, 0)


def test_a_triangle_becomes_a_quad_if_it_is_divided_into_more() -> None:
    corners, faces = [[-6, -2, -30], [6, -2, -30], [0, 8, -30]], [[0, 1, 2]]
    fine = trimesh.Trimesh(corners, faces).subdivide().subdivide().subdivide()
    scene = nf.Scene.from_arrays(fine.vertices, fine.faces, object_names=["impostors"])
    settings: dict[str, Any] = {"center": (0, 0, 0), "reach": 2.0, "r2": 20.0, "face_size": 128}
    baked = nf.reduce(scene, far="impostors", **settings)
    assert baked.near.triangle_count == 0
    assert 2 <= baked.triangle_count <= 40
    assert baked.object_names == ("impostors",)
    for user in ((0.0, 0.0, 0.0), (1.2, 0.5, -1.0)):
        camera = view(np.array(user))
        truth, frame = (nf.render(shown, camera, samples=4, channels=("color",)) for shown in (scene, baked))
        assert nf.psnr(truth, frame) > 36
    kept = nf.reduce(nf.Scene.from_arrays(corners, faces), far="impostors", **settings)
    assert (kept.near.triangle_count, kept.far) == (1, None)
    assert "the 1 of the scene stay" in kept.reason
    none = nf.reduce(scene, far="impostors", **settings, triangles=1)
    assert (none.far, none.triangle_count) == (None, 0)
    assert none.stats["dropped_texels"] > 0
    assert "the budget leaves none" in repr(none)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"center": (0, 0)}, ValueError, "center: expected"),
        ({"center": (1e31, 0, 0)}, ValueError, r"center: expected coordinates within ±1e\+30 m"),
        ({"center": "here"}, TypeError, "center: expected"),
        ({"reach": 0}, ValueError, "reach: expected a number above 0"),
        ({"reach": 12.0}, ValueError, "reach: expected less than r2 = 12 m, got 12"),
        ({"r2": np.nan}, ValueError, "r2: expected a finite number"),
        ({"error_px": 0}, ValueError, "error_px: expected a number above 0"),
        ({"error_px": 101}, ValueError, "error_px: expected a number from 0 to 100"),
        ({"face_size": 63}, ValueError, "face_size: expected a whole number from 64"),
        ({"face_size": 64.5}, TypeError, "face_size: expected a whole number"),
        ({"centers": 0}, ValueError, "centers: expected a whole number from 1"),
        ({"missing": -0.1}, ValueError, "missing: expected a number from 0 to 1"),
        ({"triangles": 0}, ValueError, "triangles: expected a whole number from 1"),
        ({"triangles": "many"}, TypeError, "triangles: expected a whole number"),
        ({"scene": 3}, TypeError, "scene: expected a Scene"),
    ],
)
def test_bad_arguments_are_named(
    scene: nf.Scene, arguments: dict[str, Any], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        nf.reduce(**{"scene": scene, "far": "impostors", **SETTINGS, **arguments})


def test_results_do_not_depend_on_threads() -> None:
    code = """
import hashlib
import nearfar as nf
from tests.support.impostor_cases import SETTINGS, yard
baked = nf.reduce(yard(), far="impostors", **{**SETTINGS, "face_size": 64, "centers": 2})
quads = baked._quads
print([hashlib.sha256(getattr(quads, name).tobytes()).hexdigest() for name in ("vertices", "uvs", "faces", "atlas")])
"""
    assert len(printed_by_threads(code, "12")) == 1


def test_triangles_between_the_rays_of_the_probes_stay() -> None:
    ball = trimesh.creation.icosphere(5, 0.5)
    ball.apply_translation((0.0, 0.0, -3.0))
    wall = trimesh.creation.box((40.0, 40.0, 0.1)).apply_translation((0.0, 0.0, -30.0))
    scene = nf.Scene.from_trimesh(trimesh.util.concatenate([ball, wall]))
    found = nf.reduce(scene, center=(0, 0, 0), r2=10, far="impostors", reach=1, face_size=64)
    assert found.stats["changed"] == 0
    assert 0.5 < found.near.triangle_count / len(ball.faces) < 0.7  # half of the ball, and what users beside O see
