"""Tests of background reductions about another centre."""

from __future__ import annotations

import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from tests.support.reduce_cases import CENTER, R1, R2, box, camera, place, street

ELSEWHERE = np.add(CENTER, [6.0, 0.5, 4.0])


def same(one: nf.ReducedScene, other: nf.ReducedScene) -> None:
    """Assert the same map, counts and picture."""
    assert one.env is not None
    assert other.env is not None
    for name in one.env.channels:
        np.testing.assert_array_equal(getattr(one.env, name), getattr(other.env, name))
        assert getattr(one.env, name).dtype == getattr(other.env, name).dtype
    assert one.stats == other.stats
    view = camera(np.add(one.center, [2.0, 0.0, 1.0]), (1.0, -0.1, -0.5))
    np.testing.assert_array_equal(one.render(view).color, other.render(view).color)


@pytest.mark.parametrize(
    "how",
    [
        {"face_size": 32, "samples": 3},
        {"face_size": 16, "channels": ("color", "range", "object_id"), "range_dtype": np.float16, "morph": "cylinder"},
        {"face_size": 16, "samples": 1, "morph": "none", "boundary": "r1"},
        {"face_size": 16, "samples": 1, "backend": "cpu"},
    ],
)
def test_recentring_equals_a_reduction_with_the_same_settings(how: dict[str, Any]) -> None:
    scene = street()
    handle = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, **how).recentered(ELSEWHERE)
    assert handle.center == tuple(ELSEWHERE)
    again, afresh = handle.result(), nf.reduce(scene, center=ELSEWHERE, r1=R1, r2=R2, **how)
    assert handle.ready
    assert handle.result() is again
    assert (again.center, again.r1, again.r2, again.morph) == (tuple(ELSEWHERE), R1, R2, how.get("morph", "blend"))
    same(again, afresh)
    # A second step keeps the settings, too.
    same(again.recentered(CENTER).result(), nf.reduce(scene, center=CENTER, r1=R1, r2=R2, **how))


def test_a_changed_morph_and_poses_are_kept() -> None:
    scene = street(dynamic=True).at({"car": place(8.0, 0.75, -8.0)})
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=16, samples=1).with_morph("cylinder")
    pose = {"car": place(-8.0, 0.75, 3.0)}
    again = reduced.at(pose).recentered(ELSEWHERE).result()
    assert again.morph == "cylinder"
    afresh = nf.reduce(scene.at(pose), center=ELSEWHERE, r1=R1, r2=R2, face_size=16, samples=1, morph="cylinder")
    same(again, afresh)


def test_trees_and_textures_are_shared() -> None:
    build = SceneBuilder()
    texels = np.random.default_rng(0).integers(0, 256, (64, 64, 4), np.uint8)
    painted = build.material(texture=texels)
    vertices, faces = box((60.0, 0.0, -5.0), (70.0, 30.0, 5.0))
    uvs = np.random.default_rng(1).random((len(vertices), 2)).astype(np.float32)
    build.instance(build.mesh(vertices, faces, uvs=uvs, material=painted), name="painted")
    soup = np.random.default_rng(2).uniform(-100, 100, (600_000, 3)).astype(np.float32)
    build.instance(build.mesh(soup, np.arange(600_000, dtype=np.uint32).reshape(-1, 3)), name="soup")
    scene = build.build()
    begin = time.process_time()
    scene._core.build()
    building = time.process_time() - begin
    reduced = nf.reduce(scene, center=CENTER, r1=1.0, r2=2.0, face_size=1, samples=1)
    begin = time.process_time()
    again = reduced.recentered(ELSEWHERE).result()
    # Trees over 200,000 triangles take many times as long as a partition and a map of six texels.
    assert time.process_time() - begin < building / 2
    # Meshes own the trees and the compiled scene owns the textures: both are the same objects.
    assert again.scene is scene
    assert again.scene._core is scene._core


def test_the_caller_continues_during_the_reduction(monkeypatch: pytest.MonkeyPatch) -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=8, samples=1)
    may_go_on, threads = threading.Event(), []
    original = nf.ReducedScene._reduce_again

    def slow(self: nf.ReducedScene, *args: Any, **changed: Any) -> nf.ReducedScene:
        threads.append(threading.get_ident())
        may_go_on.wait()
        return original(self, *args, **changed)

    monkeypatch.setattr(nf.ReducedScene, "_reduce_again", slow)
    handle = reduced.recentered(ELSEWHERE)
    assert not handle.ready
    assert "in the making" in repr(handle)
    assert reduced.render(camera(CENTER, (1, 0, 0))).color is not None
    may_go_on.set()
    assert handle.result().center == tuple(ELSEWHERE)
    assert threads != [threading.get_ident()]
    assert "ready" in repr(handle)


def test_errors_are_raised_with_the_result() -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=8, samples=1)
    with pytest.raises(ValueError, match="center"):
        reduced.recentered((1e300, 0, 0)).result()


def test_a_loaded_scene_refuses_and_suggests_a_remedy(tmp_path: Path) -> None:
    nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=8, samples=1).save(tmp_path / "light")
    with pytest.raises(ValueError, match=r"center: expected the saved centre .* reduce the whole scene"):
        nf.ReducedScene.load(tmp_path / "light").recentered(ELSEWHERE)
