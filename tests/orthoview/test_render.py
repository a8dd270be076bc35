"""Tests of pictures of trees: against the world itself, after updates, over the network, and of caching."""

from __future__ import annotations

import pickle
import shutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from http.server import ThreadingHTTPServer
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._camera.shot import Shot
from tests.support import need
from tests.support.flight_cases import camera_at, holes, images_of
from tests.support.orthoview_stores import SIZE, box_about, world_of
from tests.support.range_server import serve_folder

need("zarr")

CHANNELS = ("color", "range", "object_id", "albedo", "normal")
Tree = nf.orthoview.OrthoTree


def assert_same(one: nf.Frame, other: nf.Frame) -> None:
    assert one.channels == other.channels
    for name, image in images_of(one).items():
        assert image.tobytes() == other.require(name).tobytes(), name


def differ(one: nf.Frame, other: nf.Frame) -> bool:
    return any(image.tobytes() != other.require(name).tobytes() for name, image in images_of(one).items())


def truth_of(scene: nf.Scene, tree: Tree, camera: nf.Camera) -> nf.Frame:
    return nf.render(scene, camera, clip=nf.Clip(box=tree.bounds), channels=CHANNELS)


def psnr(frame: nf.Frame, truth: nf.Frame) -> float:
    error = frame.to_image().astype(float) - truth.to_image().astype(float)
    return float(10 * np.log10(255**2 / (error**2).mean()))


@pytest.mark.parametrize("angle", [0.3, 1.9, 4.0])
@pytest.mark.parametrize("distance", [120.0, 200.0])
def test_views_show_the_world(layered: Tree, thirty: nf.Scene, distance: float, angle: float) -> None:
    camera = camera_at(layered, distance, angle, size=(96, 96))
    truth = truth_of(thirty, layered, camera)
    frame = layered.render(camera, geometry=False, channels=CHANNELS)
    assert holes(frame, truth) <= 0.005
    assert psnr(frame, truth) > 21
    # A pixel of a view is at most as wide as a pixel of the picture, and ellipses extend by two of them.
    near, right = frame.require("range"), truth.require("range")
    both = np.isfinite(near) & np.isfinite(right)
    off = np.abs(near[both] - right[both]) / (right[both] * 2 * np.tan(np.radians(25)) / camera.width)
    assert (off < 4).mean() > 0.9
    assert (frame.require("object_id") == -1).all()
    assert frame.stats["leaves"] == 0 < frame.stats["splats_seen"] <= frame.stats["splats_in_picture"]


def test_pictures_use_the_views_of_their_cut(layered: Tree, thirty: nf.Scene) -> None:
    """With one view for each cell: that of its edge or, raised by 60 degrees, that from the top."""
    camera, found = camera_at(layered, 200), []
    for lift_deg in (0.0, 60.0):
        tree = nf.orthoview.open(layered.path)
        frame = tree.render(camera, views=1, lift_deg=lift_deg, geometry=False, channels=CHANNELS)
        keys = tree.cut(camera, views=1, lift_deg=lift_deg, geometry=False).keys()
        assert frame.stats["splats"] == sum(splats.count for splats in layered._viewer.views.get(keys))
        assert all(key in tree._viewer.views.cache for key in keys)
        found.append((set(keys), frame, tree._viewer.views.cache))
    (paper, one, _), (raised, other, views) = found
    assert len(paper) == len(raised)
    assert not any(key in views for key in paper)
    assert {direction for *_, direction in raised} == {layered.directions.index((0, 1, 0))}
    assert differ(one, other)


def test_a_near_viewer_sees_geometry(layered: Tree, thirty: nf.Scene) -> None:
    """All visible leaves are geometry: the world, except that positions are rounded to a millimetre."""
    camera = camera_at(layered, 140)
    frame = layered.render(camera, error_px=0.1, channels=CHANNELS)
    truth = truth_of(thirty, layered, camera)
    assert frame.stats["splats"] == 0 < frame.stats["leaves"]
    there = np.isfinite(frame.require("range"))
    assert (there != np.isfinite(truth.require("range"))).mean() < 0.001
    both = there & np.isfinite(truth.require("range"))
    assert (np.abs(frame.require("range")[both] - truth.require("range")[both]) < 0.01).mean() > 0.995
    assert (frame.to_image() == truth.to_image()).mean() > 0.99
    places = layered.cut(camera, error_px=0.1).leaf_places()
    leaves = layered._viewer.near.scene(layered._viewer.cutter.with_guests(places))
    assert leaves is not None
    right = nf.render(leaves, camera, channels=CHANNELS)
    for name, image in images_of(frame).items():
        if name == "color":  # The kernel sums the sky itself.
            np.testing.assert_allclose(image, right.require(name), atol=1e-6)
        else:
            np.testing.assert_array_equal(image, right.require(name))


def test_geometry_and_views_are_composited(layered: Tree) -> None:
    """Each pixel shows the nearer of the leaves' geometry and the views beyond them."""
    camera = camera_at(layered, 90)
    frame = layered.render(camera, channels=CHANNELS)
    leaves = layered._viewer.near.scene(layered._viewer.cutter.with_guests(layered.cut(camera).leaf_places()))
    assert leaves is not None
    geometry = nf.render(leaves, camera, channels=CHANNELS)
    is_geometry = frame.require("object_id") >= 0
    assert 0.02 < is_geometry.mean() < 0.9
    assert frame.stats["splats_seen"] > 0
    assert (frame.require("range") <= geometry.require("range")).all()
    for name, image in images_of(frame).items():
        np.testing.assert_array_equal(image[is_geometry], geometry.require(name)[is_geometry])
    is_splat = np.isfinite(frame.require("range")) & ~is_geometry
    assert (frame.require("range")[is_splat] <= geometry.require("range")[is_splat]).all()


@pytest.mark.parametrize("angle", [0.3, 3.5])
def test_there_are_no_holes_between_geometry_and_views(layered: Tree, thirty: nf.Scene, angle: float) -> None:
    camera = camera_at(layered, 90, angle)
    truth = truth_of(thirty, layered, camera)
    frame, views = layered.render(camera), layered.render(camera, geometry=False)
    cells = np.floor((truth_positions(truth) - layered.bounds[0]) / layered.cell)
    near = {tuple(place) for place in layered.cut(camera).leaves.tolist()}
    is_hit = np.isfinite(truth.require("range"))
    is_near = np.array(
        [
            [hit and tuple(cell) in near for hit, cell in zip(*row, strict=True)]
            for row in zip(is_hit, cells, strict=True)
        ]
    )
    through = is_near & (frame.require("range") > truth.require("range") + 1)
    assert through.sum() <= 0.005 * is_near.sum()
    assert holes(frame, truth) <= holes(views, truth) + 0.001


def truth_positions(truth: nf.Frame) -> NDArray[np.float64]:
    """World positions of pixels; infinite without a surface."""
    start, direction = truth.camera.rays()
    far = np.where(np.isfinite(truth.require("range")), truth.require("range"), 1e9)
    positions: NDArray[np.float64] = start + direction * far[..., None]
    return positions


def test_second_layers_fill_holes(thirty: nf.Scene, layered: Tree, tmp_path: Path) -> None:
    one = nf.orthoview.build(thirty, tmp_path / "one.zarr", cell=40, size=32, directions=5)
    two = nf.orthoview.build(thirty, tmp_path / "two.zarr", cell=40, size=32, directions=5, layers=2)
    total = [0.0, 0.0]
    for angle in (0.7, 2.4, 4.1):
        camera = camera_at(one, 130, angle)
        truth = truth_of(thirty, one, camera)
        first, second = (holes(tree.render(camera, geometry=False, views=1), truth) for tree in (one, two))
        assert second <= first
        total = [total[0] + first, total[1] + second]
    assert total[1] < 0.9 * total[0]


def test_samples_equal_means_of_a_finer_picture(layered: Tree) -> None:
    """With geometry and splats; a picture of twice the size has the same cut at twice the error."""
    camera = camera_at(layered, 90, size=(64, 48))
    finer = replace(camera, size=(128, 96))
    channels = ("color", "coverage", "range")
    frame = layered.render(camera, samples=4, channels=channels)
    fine = layered.render(finer, error_px=2.0, channels=("color", "coverage"))
    assert frame.stats["leaves"] == fine.stats["leaves"] > 0 < frame.stats["cells"] == fine.stats["cells"]
    for name in ("color", "coverage"):
        image = fine.require(name).astype(np.float64).reshape(48, 2, 64, 2, -1).mean(axis=(1, 3))
        np.testing.assert_allclose(frame.require(name), image.reshape(frame.require(name).shape), atol=1e-6)
    middle = layered.render(camera, channels=("range",))
    np.testing.assert_array_equal(frame.require("range"), middle.require("range"))
    odd = layered.render(camera, samples=9, channels=channels)
    np.testing.assert_array_equal(odd.require("range"), middle.require("range"))


def test_limits_apply_to_geometry_and_splats(layered: Tree) -> None:
    camera = camera_at(layered, 90)
    whole = layered.render(camera, channels=CHANNELS)
    ranges = whole.require("range")
    far = float(np.median(ranges[np.isfinite(ranges)]))
    cut = layered.render(camera, t_max=far, channels=CHANNELS)
    is_near = ranges <= far - 3
    np.testing.assert_array_equal(cut.require("color")[is_near], whole.require("color")[is_near])
    assert cut.require("range")[np.isfinite(cut.require("range"))].max() < far + 3
    low, high = layered.bounds
    clip = nf.Clip(box=[low, (high[0], low[1] + 40, high[2])])
    below = layered.render(camera, clip=clip, channels=("position",))
    heights = below.require("position")[..., 1] + below.origin[1]
    assert np.nanmax(heights) < low[1] + 43
    assert np.nanmax(heights) > low[1] + 30


def test_trees_are_drawn_with_masks_and_bare(layered: Tree) -> None:
    camera = camera_at(layered, 90)
    mask = np.random.default_rng(0).random((48, 64)) < 0.5
    shot = Shot(cameras=(camera,), channels=("color", "range"))
    (whole,), (masked,) = layered.trace(shot), layered.trace(replace(shot, mask=mask))
    for name in ("color", "range"):
        np.testing.assert_array_equal(masked[name][mask], whole[name][mask])
    assert (masked["color"][~mask] == 0).all()
    assert np.isinf(masked["range"][~mask]).all()
    (bare,) = layered.trace(replace(shot, bare=True))
    is_there = np.isfinite(whole["range"])[..., None]
    np.testing.assert_array_equal(bare["color"], np.where(is_there, whole["color"], 0))


def test_updated_and_compacted_trees_are_drawn(tmp_path: Path) -> None:
    boxes = range(8)
    before = nf.orthoview.build(world_of(boxes), tmp_path / "a.zarr", cell=20, size=SIZE, directions=5)
    after = world_of([*boxes, 101])
    camera = camera_at(before, 70, size=(48, 48))
    was = before.render(camera, channels=CHANNELS)
    fresh = nf.orthoview.open(before.path)
    updated = before.update(box_about([101]), after)
    compacted = updated.compact(tmp_path / "compact.zarr")
    now = updated.render(camera, channels=CHANNELS)
    assert_same(now, compacted.render(camera, channels=CHANNELS))
    assert differ(now, was)
    for opened in (before, fresh):
        assert_same(opened.render(camera, channels=CHANNELS), was)


def test_a_second_picture_reads_nothing(layered: Tree) -> None:
    tree = nf.orthoview.open(layered.path)
    camera = camera_at(tree, 90)
    first = tree.render(camera, channels=CHANNELS)
    views, near = tree._viewer.views.cache, tree._viewer.near.cache
    state = views.reads, views.read_bytes, near.read_bytes
    assert min(state) > 0
    assert views.reads == first.stats["views"]
    assert_same(tree.render(camera, channels=CHANNELS), first)
    assert (views.reads, views.read_bytes, near.read_bytes) == state
    assert_same(nf.render(tree, camera, channels=CHANNELS), first)
    assert (views.reads, views.read_bytes, near.read_bytes) == state
    # A rotated camera sees the same cells, and others.
    tree.render(camera_at(tree, 90, 0.35), channels=CHANNELS)
    assert views.reads < state[0] * 1.5


def test_without_a_cache_the_last_views_are_kept(layered: Tree) -> None:
    tree, cached = nf.orthoview.open(layered.path, cache_bytes=0), nf.orthoview.open(layered.path)
    for distance in (200.0, 100.0, 150.0):
        camera = camera_at(tree, distance)
        assert_same(tree.render(camera), cached.render(camera))
        views = tree._viewer.views.cache
        keys = tree.cut(camera).keys()
        assert all(key in views for key in keys)
        assert len(views.values) == len(keys)
        assert views.size == sum(layer.bytes for layers in views.values.values() for layer in layers)
    reads = tree._viewer.views.cache.reads
    tree.render(camera_at(tree, 200.0))
    assert tree._viewer.views.cache.reads > reads


def test_a_tree_behind_a_web_server_looks_the_same(few_tree: Tree, monkeypatch: pytest.MonkeyPatch) -> None:
    need("fsspec")
    need("aiohttp")
    # Parts are requested at once. With the default queue of five connections the others would wait for a second.
    monkeypatch.setattr(ThreadingHTTPServer, "request_queue_size", 1024)
    camera, folder = camera_at(few_tree, 40), Path(few_tree.path)
    local = few_tree.render(camera, channels=CHANNELS)
    assert local.stats["leaves"] > 0
    with serve_folder(folder.parent) as server:
        remote = nf.orthoview.open(server.url + folder.name)
        assert_same(remote.render(camera, channels=CHANNELS), local)
        asked = sum(server.answers.values())
        assert_same(remote.render(camera, channels=CHANNELS), local)
        assert sum(server.answers.values()) == asked > 0


def test_invalid_calls_of_render_are_named(layered: Tree) -> None:
    camera = camera_at(layered, 200, size=(16, 16))
    for samples in (8, 81, 2):
        with pytest.raises(ValueError, match=f"samples: expected 1, 4, 9 … 64 for orthoviews, got {samples}"):
            layered.render(camera, samples=samples)
    with pytest.raises((ValueError, TypeError), match="at"):
        nf.render(layered, camera, at={"car": np.eye(4)})


def test_damaged_stores_are_named(layered: Tree, tmp_path: Path) -> None:
    path = tmp_path / "copy.zarr"
    shutil.copytree(layered.path, path)
    near, far = camera_at(layered, 40), camera_at(layered, 200)
    nf.orthoview.open(path).render(near)
    for glb in (path / "geometry" / "content").rglob("*.glb"):
        glb.write_bytes(glb.read_bytes()[:-9])
    with pytest.raises(nf.FormatError, match=r"copy\.zarr.*\.glb"):
        nf.orthoview.open(path).render(near)
    tree = nf.orthoview.open(path)
    level = int(tree.cut(far).level[0])
    for shard in (path / str(level)).rglob("0"):
        if shard.is_file():
            content = bytearray(shard.read_bytes())
            content[: len(content) // 2] = bytes(len(content) // 2)
            shard.write_bytes(bytes(content))
    with pytest.raises(nf.FormatError, match=r"copy\.zarr"):
        tree.render(far)


def test_all_render_functions_accept_trees(layered: Tree) -> None:
    camera = camera_at(layered, 90, size=(48, 40))
    frame = layered.render(camera)
    assert frame.channels == ("color", "range") == layered.default_channels
    assert_same(nf.render(layered, camera), frame)
    other = camera_at(layered, 95, 0.4, size=(48, 40))
    frames = list(nf.render_path(layered, [camera, other]))
    assert_same(frames[0], frame)
    assert_same(frames[1], layered.render(other))
    hmd = nf.hmd.QUEST_2
    eyes = nf.render_eyes(layered, hmd, camera.position, orientation=camera.orientation, size=(48, 48))
    assert_same(eyes.left, nf.render(layered, eyes.left.camera))


def test_hybrid_stereo_accepts_trees(layered: Tree) -> None:
    """Parts in front of the plane are drawn per eye, others once; with a plane beyond the world all per eye."""
    camera, hmd = camera_at(layered, 90), nf.hmd.QUEST_2
    eyes = nf.render_eyes(layered, hmd, camera.position, orientation=camera.orientation, size=(48, 48))
    there = np.isfinite(eyes.left.require("range"))
    for plane in (60.0, 100.0, 1000.0):
        rig = nf.stereo.HybridRig.of(hmd, mono_plane=plane, size=(48, 48))
        hybrid = rig.render(layered, camera.position, camera.orientation)
        assert (there != np.isfinite(hybrid.left.require("range"))).mean() < 0.02
        assert psnr(hybrid.left, eyes.left) > 30


def test_trees_accept_no_poses(layered: Tree) -> None:
    camera, earlier = (camera_at(layered, 90, angle, size=(96, 96)) for angle in (0.3, 0.32))
    frame = nf.render(layered, camera, channels=("motion", "range", "position"), before=earlier)
    there = np.isfinite(frame.require("range"))
    places = frame.require("position")[there].astype(np.float64) + frame.origin
    rows, columns = np.nonzero(there)
    moved = np.column_stack([columns, rows]) + 0.5 - earlier.project(places)[:, :2]
    np.testing.assert_allclose(frame.require("motion")[there], moved, atol=1e-2)
    assert np.abs(moved).max() > 1


def test_trees_are_shared_by_threads_and_pickled_for_processes(layered: Tree) -> None:
    cameras = [camera_at(layered, 90 + 10 * n, n) for n in range(6)]
    right = [layered.render(camera).to_image() for camera in cameras]
    small = nf.orthoview.open(layered.path, cache_bytes=0)
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda camera: small.render(camera).to_image(), cameras * 2))
    for number, image in enumerate(found):
        np.testing.assert_array_equal(image, right[number % len(right)])
    again = pickle.loads(pickle.dumps(layered))
    np.testing.assert_array_equal(again.render(cameras[0]).to_image(), right[0])


def test_geometry_beyond_the_cache_is_dropped_with_the_picture_that_needed_it(layered: Tree) -> None:
    small, large = nf.orthoview.open(layered.path, cache_bytes=1), nf.orthoview.open(layered.path)
    drawn = set()
    for distance in (25, 90):
        frame = small.render(camera_at(layered, distance))
        large.render(camera_at(layered, distance))
        held = {place for place, scene in small._viewer.near.cache.values.items() if scene is not None}
        assert len(held) >= frame.stats["leaves"] > 0
        drawn |= held
    assert len(held) < len(drawn)
    assert drawn <= {*large._viewer.near.cache.values}


def test_a_missing_geometry_file_is_named(layered: Tree, tmp_path: Path) -> None:
    store = Path(shutil.copytree(layered.path, tmp_path / "copy.zarr"))
    for file in (store / "geometry" / "content").rglob("*.glb"):
        file.unlink()
    with pytest.raises(nf.FormatError, match=r"content/.*\.glb: the file is gone"):
        nf.orthoview.open(store).render(camera_at(layered, 90))
