"""Reduced scenes and their maps on graphics adapters, against the tracer."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar._reduce.drawing import MorphKind
from tests.support import data
from tests.support.gpu_cases import check_color, check_ids, check_range, edges
from tests.support.normal_cases import scene_around
from tests.support.reduce_cases import street

pytestmark = pytest.mark.usefixtures("backend")

CENTER = (0.0, 1.7, 0.0)
CHANNELS = ("color", "range", "object_id")
ALL = (*CHANNELS, "face_id")
USERS = {"centre": CENTER, "near": (2.0, 1.9, -1.0), "far": (9.0, 2.5, 6.0)}


@pytest.fixture(scope="module", params=[("blend", "r2"), ("cylinder", "r2"), ("none", "r2"), ("none", "r1")])
def reduced(city: nf.Scene, request: pytest.FixtureRequest) -> nf.ReducedScene:
    """The city, bent in two ways, and cut at each radius by the conventional method."""
    morph, boundary = request.param
    settings: dict[str, Any] = {"morph": morph, "boundary": boundary, "channels": CHANNELS, "samples": 1}
    return nf.reduce(city, center=CENTER, r1=30, r2=50, face_size=64, **settings)


@pytest.fixture(scope="module")
def small(city: nf.Scene) -> nf.ReducedScene:
    """The city with small radii and a small map."""
    return nf.reduce(city, center=CENTER, r1=15, r2=30, face_size=64, channels=CHANNELS, samples=1)


@pytest.fixture(scope="module")
def poses() -> dict[str, NDArray[np.float64]]:
    """Return poses of cars within r1, across both radii, between them and beyond, some behind houses."""
    places = [(-3, -8, 0.3), (2, -29, 1.0), (-4, -49.5, 0.2), (3, -70, 2.0), (-40, -60, 0.1)]
    return {f"car_{i}": pose_at(x, 0.15, z, turn) for i, (x, z, turn) in enumerate(places)}


def pose_at(x: float, y: float, z: float, turn: float = 0.0) -> NDArray[np.float64]:
    matrix = trimesh.transformations.rotation_matrix(turn, (0, 1, 0))
    matrix[:3, 3] = x, y, z
    return np.asarray(matrix)


def view(user: tuple[float, float, float], size: int = 96) -> nf.Camera:
    target = (user[0] - 1.5, 3.0, user[2] - 40.0)
    return nf.Camera.look_at(user, target, fov=nf.Fov.symmetric(70), size=(size, size))


def both(reduced: nf.ReducedScene, camera: nf.Camera, **settings: object) -> tuple[nf.Frame, nf.Frame]:
    frames = [reduced.render(camera, backend=backend, **settings) for backend in ("cpu", "gpu")]  # type: ignore[arg-type]
    return frames[0], frames[1]


def test_frames_equal_the_tracer(reduced: nf.ReducedScene, poses: dict[str, NDArray[np.float64]]) -> None:
    for user, env in (("centre", True), ("near", True), ("near", False), ("far", False)):
        # Both morph the same vertices and differ by rounding only. Without a map all pixels have faces.
        cpu, gpu = both(reduced, view(USERS[user]), at=poses, channels=ALL, tolerance_px=np.inf, env=env)
        check_ids(cpu.require("object_id"), gpu.require("object_id"))
        check_ids(cpu.require("face_id"), gpu.require("face_id"), 0.998)
        check_color(cpu, gpu)
        check_range(cpu, gpu, worst=1e-3)
        assert np.array_equal(np.isfinite(cpu.require("range")), np.isfinite(gpu.require("range"))) or user != "centre"
    if reduced.morph != "none":
        cpu, gpu = both(reduced, view(USERS["near"]), at=poses, channels=ALL)
        # The CPU splits for this user, the device for several users; edges may differ by a part of half a pixel.
        check_ids(cpu.require("object_id"), gpu.require("object_id"))
        check_color(cpu, gpu)
        assert gpu.stats["tolerance_held"]
        assert cpu.stats["tolerance_held"]


def test_normals_of_vertices_are_the_same() -> None:
    center = np.array([3.0, 1.7, -2.0])
    reduced = nf.reduce(scene_around(center), center=center, r1=15, r2=25, face_size=64, samples=1, channels=CHANNELS)
    eye = center + np.array([2.0, 0.3, -1.0])
    camera = nf.Camera.look_at(eye, eye + np.array([1, 0.02, 0.4]), fov=nf.Fov.symmetric(60), size=(96, 96))
    for tolerance_px in (np.inf, 0.5):
        cpu, gpu = both(reduced, camera, channels=("color", "object_id", "face_id"), tolerance_px=tolerance_px)
        check_ids(cpu.require("object_id"), gpu.require("object_id"))
        check_color(cpu, gpu)


def test_a_large_moving_object_is_split_at_its_pose() -> None:
    """Morphing only its corners would displace parts of a train of 60 m by many pixels."""
    ground = trimesh.creation.box((400, 0.2, 400))
    train = trimesh.creation.box((60, 3, 2))
    train.visual.face_colors = np.tile([[200, 60, 40, 255], [40, 90, 200, 255]], (6, 1))
    assembled = trimesh.Scene()
    assembled.add_geometry(ground, node_name="ground", geom_name="ground")
    assembled.add_geometry(train, node_name="train", geom_name="train")
    scene = nf.Scene.from_trimesh(assembled).with_dynamic(["train"])
    reduced = nf.reduce(scene, center=CENTER, r1=10, r2=25, face_size=64, channels=CHANNELS)
    pose = {"train": pose_at(5, 1.7, -12, 0.2)}
    cpu, gpu = both(reduced, view((1.5, 2.4, 1.0)), at=pose, channels=ALL)
    check_ids(cpu.require("face_id"), gpu.require("face_id"), 0.995)
    bent = reduced.render(view((1.5, 2.4, 1.0)), at=pose, channels=ALL, tolerance_px=np.inf, backend="gpu")
    assert (bent.require("object_id") != cpu.require("object_id")).mean() > 0.003


def test_maps_equal_the_tracer_face_by_face(city: nf.Scene) -> None:
    for r2 in (1.0, 50.0):
        cpu, gpu = (
            nf.reduce(city, center=CENTER, r1=0.5, r2=r2, face_size=128, channels=CHANNELS, samples=1, backend=backend)
            for backend in ("cpu", "gpu")
        )
        assert cpu.env is not None
        assert gpu.env is not None
        for face in range(6):
            check_ids(cpu.env.object_id[face], gpu.env.object_id[face])  # type: ignore[index]
            camera = nf.Camera(CENTER, fov=nf.CubeFace(face), size=(128, 128))
            colors = [np.asarray(env.color[face], np.float32) for env in (cpu.env, gpu.env)]
            # The share of texels at edges, where rounding decides between two faces, is greater in a small map.
            check_color(nf.Frame(camera, color=colors[0]), nf.Frame(camera, color=colors[1]), percentile=99.5)
            inside = ~edges(cpu.env.object_id[face])  # type: ignore[index]
            expected, got = cpu.env.range[face][inside], gpu.env.range[face][inside]  # type: ignore[index]
            finite = np.isfinite(expected) & np.isfinite(got)
            # Edges inside an object are not edges of objects: all but a few of a thousand texels agree.
            apart = np.abs(got[finite] - expected[finite]) / expected[finite]
            assert apart.size == 0 or np.percentile(apart, 99) <= 1e-5
        assert gpu.stats["rays"] == 0 < cpu.stats["rays"]


def test_without_far_geometry_the_sky_is_visible() -> None:
    scene = nf.Scene.from_trimesh(trimesh.creation.box((2, 2, 2)))
    reduced = nf.reduce(scene, center=(0, 0, 5), r1=30, r2=50)
    assert reduced.env is None
    cpu, gpu = both(reduced, nf.Camera((0.5, 0.2, 5), fov=nf.Fov.symmetric(90), size=(64, 64)), channels=ALL)
    check_ids(cpu.require("face_id"), gpu.require("face_id"))
    assert np.array_equal(np.isinf(cpu.require("range")), gpu.require("face_id") < 0)
    check_color(cpu, gpu)


def test_a_loaded_scene_is_drawn_as_before_saving(small: nf.ReducedScene, tmp_path: Path) -> None:
    small.save(tmp_path / "light")
    loaded = nf.ReducedScene.load(tmp_path / "light")
    before, after = (one.render(view(USERS["near"], 64), backend="gpu", channels=ALL) for one in (small, loaded))
    check_ids(before.require("object_id"), after.require("object_id"))
    check_color(before, after)


def test_only_near_geometry_is_drawn_and_little_is_uploaded(
    small: nf.ReducedScene, poses: dict[str, NDArray[np.float64]]
) -> None:
    cameras = [view((0.8 + 0.02 * i, 1.7, 0.0), 64) for i in range(6)]
    for frame in nf.render_path(small, cameras, at=poses, backend="gpu"):
        assert frame.camera.size == (64, 64)
    before = nf.gpu.stats()
    frame = small.render(cameras[0], at=poses, backend="gpu")
    still = nf.gpu.stats()
    # Split triangles near the user, and cars twice: within the near part and beyond it.
    assert 0 < still["triangles"] - before["triangles"] <= frame.stats["frame_triangles"] + 20_000
    small.render(cameras[3], at=poses, backend="gpu")
    small.render(cameras[3], at=poses | {"car_0": pose_at(-2.5, 0.15, -9, 0.4)}, backend="gpu")
    after = nf.gpu.stats()
    assert after["allocations"] == still["allocations"] == before["allocations"]
    # A pass, and one car's transform in two passes.
    assert after["uploaded_bytes"] - still["uploaded_bytes"] < 1500


def test_adapters_refuse_positions_of_maps_without_range() -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=15, r2=30, face_size=32)
    camera = view(USERS["near"], 32)
    calls: list[Callable[[], object]] = [
        lambda: reduced.render(camera, channels=("color", "position"), backend="gpu"),
        lambda: list(nf.render_path(reduced, [camera], channels=("position",), backend="gpu")),
        lambda: nf.gpu.render(reduced, camera, channels=("position",)),
    ]
    for call in calls:
        with pytest.raises(ValueError, match=r'position.*: reduce with channels=\("color", "range"\)'):
            call()


def test_each_frame_reports_its_own_counts(
    city: nf.Scene, small: nf.ReducedScene, poses: dict[str, NDArray[np.float64]]
) -> None:
    cameras = [view(user, 32) for user in (USERS["near"], (16.0, 1.7, 0.0))]
    frames = list(nf.render_path(small, cameras, at=poses, backend="gpu"))
    assert [frame.stats["tolerance_held"] for frame in frames] == [True, False]
    assert all(frame.stats["dynamic_triangles"] > 0 for frame in frames)
    kept = nf.gpu.render(small, cameras[0], at=poses).read()
    assert kept.stats == frames[0].stats
    assert nf.gpu.render(city, cameras[0]).read().stats == {}


def test_bent_rays_require_the_cpu(city: nf.Scene) -> None:
    reduced = nf.reduce(city, center=CENTER, r1=15, r2=30, face_size=32, samples=1)
    camera = view(USERS["near"], 32)
    with pytest.raises(ValueError, match=r"method: expected 'vertex' with backend='gpu', got 'exact'"):
        reduced.render(camera, method="exact", backend="gpu")
    reduced.render(camera, method="exact")
    with pytest.raises(ValueError, match="channels: expected an environment map with object_id"):
        reduced.render(camera, channels=("object_id",), backend="gpu")


@pytest.mark.slow
def test_tokyo_looks_the_same_on_both(tmp_path: Path) -> None:
    scene = nf.Scene.load(data("city/tokyo23/tokyo_core_lod1.glb"))
    reduced = nf.reduce(scene, center=CENTER, r1=60, r2=120, face_size=256, channels=CHANNELS, backend="gpu")
    cpu, gpu = both(reduced, view((3.0, 2.0, 1.0), 512), channels=ALL, tolerance_px=np.inf)
    check_ids(cpu.require("object_id"), gpu.require("object_id"))
    check_color(cpu, gpu)
    # For a bent long thin triangle, float64 finds errors of 3e-4 on the CPU and of 2e-4 on the adapter.
    check_range(cpu, gpu, worst=1e-3)


def street_with_a_drone() -> tuple[nf.Scene, dict[str, NDArray[np.float64]]]:
    """Return a ground across both radii, a façade within r2, and behind it an object that moves beyond r2."""
    ground = trimesh.creation.box((600, 0.2, 600))
    facade = trimesh.creation.box((0.5, 60, 80))
    facade.apply_translation((40, 30, 0))
    parts = {"ground": ground, "facade": facade, "drone": trimesh.creation.box((4, 4, 4))}
    assembled = trimesh.Scene()
    for name, mesh in parts.items():
        assembled.add_geometry(mesh, node_name=name, geom_name=name)
    scene = nf.Scene.from_trimesh(assembled).with_dynamic(["drone"])
    return scene, {"drone": pose_at(60, 25, 0)}


@pytest.mark.parametrize(
    ("morph", "user"),
    [*zip(["blend", "cylinder", "none", "blend"], [(-16.0, 1.7, 0.0), (-25.0, 1.7, 3.0)] * 2, strict=True)],
)
def test_moving_objects_beyond_are_hidden_by_near_geometry(morph: MorphKind, user: tuple[float, float, float]) -> None:
    """Covers a user nearer to the wall than the centre, and scenes without triangles wholly within r1."""
    scene, pose = street_with_a_drone()
    reduced = nf.reduce(scene, center=CENTER, r1=30, r2=50, face_size=32, morph=morph, channels=CHANNELS, samples=1)
    drone = scene.object_names.index("drone")
    for settings in ({"tolerance_px": 9.0}, {"tolerance_px": np.inf}, {"env": False, "tolerance_px": 9.0}):
        camera = nf.Camera.look_at(user, (60, 25, 0), fov=nf.Fov.symmetric(60), size=(96, 96))
        cpu, gpu = both(reduced, camera, at=pose, channels=ALL, **settings)
        for frame in (cpu, gpu):
            assert not (frame.require("object_id") == drone).any()
        check_ids(cpu.require("object_id"), gpu.require("object_id"), 0.995)
    assert not (reduced.render(camera, at=pose, method="exact").require("object_id") == drone).any()


@pytest.mark.parametrize("morph", ["blend", "cylinder"])
def test_a_moving_object_across_both_radii_has_no_hole(morph: MorphKind) -> None:
    """Its vertices are morphed on both sides of r2, so that the separately drawn parts meet."""
    scene, _ = street_with_a_drone()
    reduced = nf.reduce(scene, center=CENTER, r1=10, r2=25, face_size=64, morph=morph, channels=CHANNELS, samples=1)
    wall = np.diag([8.0, 3.0, 1.0, 1.0]) @ np.eye(4)
    wall[:3, 3] = 18.0, 3.0, -9.0
    # Split edges may be apart by a part of a pixel.
    for user, tolerance, share in (
        ((1.5, 2.4, 1.0), 0.5, 0.99),
        ((1.5, 2.4, 1.0), np.inf, 0.998),
        ((30.0, 2.0, 12.0), np.inf, 0.998),
    ):
        camera = nf.Camera.look_at(user, (18, 3, -9), fov=nf.Fov.symmetric(60), size=(96, 96))
        cpu, gpu = both(reduced, camera, at={"drone": wall}, channels=ALL, tolerance_px=tolerance, method="vertex")
        check_ids(cpu.require("object_id"), gpu.require("object_id"), share)
