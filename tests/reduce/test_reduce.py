"""Results of reduction: the map with its channels and types, statistics, other morphs, and refusals."""

from __future__ import annotations

import numpy as np
import pytest

import nearfar as nf
from tests.support.reduce_cases import ALL, CENTER, R1, R2, camera, place, street


def test_another_morph_shares_map_and_zones(scene: nf.Scene) -> None:
    blend = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=64, samples=1)
    plain = blend.with_morph("none")
    assert plain.env is blend.env
    assert plain.partition is blend.partition
    baked = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=64, samples=1, morph="none")
    view = camera(CENTER + np.array([4, 0, 3]), (1, 0, -0.3))
    np.testing.assert_array_equal(plain.render(view).require("color"), baked.render(view).require("color"))
    inner = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=64, samples=1, morph="none", boundary="r1")
    with pytest.raises(ValueError, match="boundary"):
        inner.with_morph("blend")


def test_maps_of_static_scenes_have_no_range_and_small_scenes_no_map(scene: nf.Scene) -> None:
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=8, samples=1)
    assert reduced.env is not None
    assert reduced.env.channels == ("color",)
    assert reduced.stats["ranges_computed"] == 0
    assert reduced.stats["rays"] == 6 * 8 * 8
    assert reduced.stats["map_bytes"] == 6 * 8 * 8 * 12
    whole = nf.reduce(scene, center=CENTER, r1=1e4, r2=2e4)
    assert whole.env is None
    assert whole.stats["rays"] == whole.stats["map_bytes"] == 0
    assert whole.stats["reduction"] == 1.0
    view = camera(CENTER + np.array([1, 0, 1]), (1, 0, -0.3))
    truth = nf.render(scene, view, channels=ALL)
    frame = whole.render(view, channels=ALL)
    for name in ALL:
        np.testing.assert_array_equal(frame.require(name), truth.require(name), err_msg=name)


def test_statistics_are_consistent(scene: nf.Scene, blend: nf.ReducedScene) -> None:
    stats = blend.stats
    zones = nf.partition(scene, center=CENTER, r1=R1, r2=R2).summary()
    assert {name: stats[name] for name in ("triangles", "near", "intermediate", "nsf", "sf")} == {
        name: zones[name] for name in ("triangles", "near", "intermediate", "nsf", "sf")
    }
    assert stats["drawn"] == zones["nsf"]
    assert stats["reduction"] == zones["triangles"] / zones["nsf"]
    still = blend.render(camera(CENTER, (1, 0, 0)), channels=("color",))
    assert still.stats["frame_triangles"] == 0
    moved = blend.render(camera(CENTER + 1.0, (1, 0, 0)), channels=("color",), tolerance_px=np.inf)
    assert moved.stats["frame_triangles"] == zones["nsf"]
    assert moved.stats["opposed_directions"] == 0
    assert blend.stats == stats
    assert "blend" in repr(blend)


def test_render_refuses(scene: nf.Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=8, samples=1)
    view = camera(CENTER, (1, 0, 0))
    for name, needed in (("range", "range"), ("object_id", "object_id"), ("position", "range")):
        for how in ({}, {"method": "exact"}):
            with pytest.raises(ValueError, match=rf'{needed}.*: reduce with channels=\("color", "{needed}"\)'):
                reduced.render(view, channels=("color", name), **how)  # type: ignore[arg-type]
        with pytest.raises(ValueError, match=rf'reduce with channels=\("color", "{needed}"\)'):
            list(nf.render_path(reduced, [view], channels=("color", name), backend="cpu"))
    # Without a map, every channel comes from a surface.
    assert "position" in reduced.render(view, channels=("position",), env=False).channels
    with pytest.raises(ValueError, match="got the static 'wall'"):
        reduced.render(view, at={"wall": np.eye(4)})
    monkeypatch.setenv("NEARFAR_ADAPTER", "none of this name")
    with pytest.raises(nf.DeviceError):
        nf.reduce(scene, center=CENTER, r1=R1, r2=R2, backend="gpu")


def test_every_frame_has_its_own_counts(scene: nf.Scene) -> None:
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=8, samples=1)
    assert "tolerance_held" not in reduced.stats
    before = reduced.stats
    views = [camera(CENTER + np.array(offset), (1, 0, 0)) for offset in ([4.0, 0, 0], [0, 0, 0], [18.5, 0, 0])]
    frames = list(nf.render_path(reduced, views, backend="cpu"))
    assert [frame.stats["tolerance_held"] for frame in frames] == [True, True, False]
    assert frames[1].stats["frame_triangles"] == 0 < frames[0].stats["frame_triangles"]
    assert reduced.stats == before
    assert nf.render(scene, views[0]).stats == {}


def test_empty_scenes_reduce_to_the_sky() -> None:
    scene = nf.Scene.from_arrays(np.zeros((0, 3)), np.zeros((0, 3), np.uint32))
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2)
    assert reduced.env is None
    for user in (CENTER, CENTER + 1.0):
        view = camera(user, (1, 0.3, 0))
        frame, truth = reduced.render(view), nf.render(scene, view)
        np.testing.assert_array_equal(frame.require("color"), truth.require("color"))
        assert np.isinf(frame.require("range")).all()


def test_half_float_ranges_occlude_the_same_pixels() -> None:
    """A car beyond the near part, half behind a tower: the bias is eight times the rounding of a half float."""
    scene = street(dynamic=True)
    kinds = (np.float32, np.float16)
    whole, half = (
        nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=256, samples=1, range_dtype=kind) for kind in kinds
    )
    assert half.env is not None
    assert half.env.range is not None
    assert half.env.range.dtype == np.float16
    assert half.stats["map_bytes"] < whole.stats["map_bytes"]
    view = nf.Camera.look_at(
        CENTER + np.array([4.0, 1.0, 2.0]), (121, 1, 97), fov=nf.Fov.symmetric(20, 16 / 9), size=(320, 180)
    )
    hidden = whole.render(view, at={"car": place(0, -500, 0)}, channels=["color"])
    shown = []
    # Across the line of sight from O past the tower's corner.
    for step in np.linspace(-2, 2, 9):
        poses = {"car": place(117.6 - 0.65 * step, 1, 94.8 + 0.76 * step)}
        exact, rounded = (reduced.render(view, at=poses, channels=["color"]) for reduced in (whole, half))
        np.testing.assert_array_equal(rounded.color, exact.color)
        shown.append(int(np.count_nonzero(exact.color != hidden.color)))
    assert 0 <= shown[0] < shown[4] < shown[-1]


def test_maps_with_objects_store_their_names() -> None:
    scene = street()
    named = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=8, channels=["color", "object_id"])
    assert named.env is not None
    assert named.env.object_names == scene.object_names
    plain = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=8)
    assert plain.env is not None
    assert plain.env.object_names == ()
