"""Operations of all stages on shared objects; their results are compared between threads and processes."""

from __future__ import annotations

import functools
import hashlib
import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from tests.support.lod_cases import SMALL, ball, levels
from tests.support.reduce_cases import CENTER, street

ZONES: dict[str, Any] = {"center": CENTER, "r1": 30.0, "r2": 50.0}
USER = np.add(CENTER, (1.0, 0.0, 1.0))
CHANNELS = ("color", "range", "object_id", "face_id", "position", "normal")


class Shared:
    """Objects that operations share, made once in a process, and files of them."""

    def __init__(self) -> None:
        draw = np.random.default_rng(5)
        self.folder = Path(tempfile.mkdtemp())
        self.scene = street(dynamic=True)
        eye = np.add(CENTER, (4.0, 0.0, 3.0))
        self.camera = nf.Camera.look_at(eye, np.add(eye, (1.0, -0.1, 0.4)), fov=nf.Fov.symmetric(90), size=(96, 64))
        self.reduced = nf.reduce(self.scene, **ZONES, face_size=32, samples=1, channels=CHANNELS[:3], backend="cpu")
        self.frame = nf.render(self.scene, self.camera, channels=CHANNELS, backend="cpu")
        self.points = draw.uniform(-60, 60, (20_000, 3))
        self.directions = np.ascontiguousarray(self.points[:2000] / np.linalg.norm(self.points[:2000], axis=1)[:, None])
        self.pictures = draw.random((2, 160, 200), np.float32)
        self.lens = nf.RadialLens((0.22, 0.24))
        self.model = nf.lod.measure(levels(6, 4), **SMALL)
        self.round = nf.Scene.from_arrays(*ball(24))
        self._save()

    def _save(self) -> None:
        import trimesh

        self.reduced.save(self.folder / "reduced")
        self.frame.save(self.folder / "frame.exr")
        self.model.save(self.folder / "model.json")
        nf.hmd.INDEX.save(self.folder / "hmd.json")
        mesh = trimesh.Trimesh(*ball(24), process=False)
        for suffix in ("obj", "glb", "ply", "stl"):
            mesh.export(self.folder / f"mesh.{suffix}")


@functools.cache
def shared() -> Shared:
    """Return the objects of this process."""
    return Shared()


def _loaded(suffix: str) -> Callable[[Shared], Any]:
    def load(it: Shared) -> Any:
        scene = nf.Scene.load(it.folder / f"mesh.{suffix}")
        return scene.bounds, nf.render(scene, it.camera, channels=("range",), backend="cpu").range

    return load


def _frame(frame: nf.Frame) -> list[Any]:
    return [frame.require(name) for name in frame.channels]


OPERATIONS: dict[str, Callable[[Shared], Any]] = {
    "load obj": _loaded("obj"),
    "load glb": _loaded("glb"),
    "load ply": _loaded("ply"),
    "load stl": _loaded("stl"),
    "load reduced": lambda it: _frame(nf.ReducedScene.load(it.folder / "reduced").render(it.camera, backend="cpu")),
    "load frame": lambda it: _frame(nf.Frame.load(it.folder / "frame.exr")),
    "load model": lambda it: nf.lod.LodModel.load(it.folder / "model.json").curves.a,
    "load hmd": lambda it: repr(nf.Hmd.load(it.folder / "hmd.json")),
    "render": lambda it: _frame(nf.render(it.scene, it.camera, channels=CHANNELS, backend="cpu")),
    "render samples": lambda it: _frame(nf.render(it.scene, it.camera, samples=4, backend="cpu")),
    "render reduced": lambda it: _frame(it.reduced.render(it.camera, method="exact", backend="cpu")),
    "render posed": lambda it: _frame(nf.render(it.scene, it.camera, at={"car": _moved()}, backend="cpu")),
    "reduce": lambda it: _baked(it),
    "partition": lambda it: nf.partition(it.scene, **ZONES).nsf,
    "load curve": lambda it: nf.load_curve(it.scene, center=CENTER).count(np.arange(100.0)),
    "cast rays": lambda it: nf.cast_rays(it.scene, CENTER, it.directions).t_hit,
    "nearest points": lambda it: nf.nearest_points(it.scene, it.points[:3000]).distance,
    "morph": lambda it: nf.morph(it.points, user=USER, **ZONES),
    "bend rays": lambda it: nf.bend_rays(it.directions[:300], user=USER, tolerance=1e-4, **ZONES),
    "bounding sphere": lambda it: nf.bounding_sphere(it.points),
    "ssim": lambda it: nf.ssim(*it.pictures, data_range=1.0, full=True),
    "ms_ssim": lambda it: repr(nf.ms_ssim(*(np.tile(p, (2, 2)) for p in it.pictures), data_range=1.0)),
    "discontinuity": lambda it: nf.discontinuity(it.frame),
    "warp": lambda it: it.lens.warp(np.dstack([it.pictures[0]] * 3), inverse=True, fov="symmetric"),
    "cube mips": lambda it: [np.asarray(level) for level in nf.cube_mips(_map(it).color)],
    "map conversion": lambda it: nf.convert_envmap(
        _map(it).color,
        source="cube",
        target="equirectangular",
        size=64,
    ),
    "simplify": lambda it: [
        len(level.scene.triangles()) for level in nf.lod.simplify(it.round, (1.0, 0.3), method="meshopt")
    ],
    "measure": lambda it: _scores(),
    "fit": lambda it: nf.lod.fit_4pl(np.arange(1.0, 30), 1 / (1 + np.arange(1.0, 30))).a,
    "select": lambda it: (
        nf.lod.select(
            [it.model], np.zeros(5000, int), it.points[:5000], np.ones(5000), camera=it.camera, k=0.9, d=1.0
        ).level
    ),
    "eyes": lambda it: nf.render_eyes(it.scene, nf.hmd.INDEX, CENTER, size=(40, 40), backend="cpu").side_by_side,
}
"""Operations that run at once or are interrupted; each gives the same at every call."""


def _map(it: Shared) -> nf.EnvMap:
    assert it.reduced.env is not None
    return it.reduced.env


def _baked(it: Shared) -> Any:
    env = nf.reduce(it.scene, **ZONES, face_size=16, samples=2, backend="cpu").env
    return None if env is None else env.color


def _scores() -> Any:
    samples = nf.lod.measure(levels(6, 4), **SMALL).samples
    return None if samples is None else samples.score


def _moved() -> Any:
    matrix = np.eye(4)
    matrix[:3, 3] = np.add(CENTER, (10.0, -1.0, 4.0))
    return matrix


def digest(value: Any) -> str:
    """Return a digest of arrays, bytes, texts and nested lists of them, bit for bit."""
    state = hashlib.sha256()
    _feed(state, value)
    return state.hexdigest()[:16]


def _feed(state: Any, value: Any) -> None:
    match value:
        case np.ndarray():
            state.update(f"{value.dtype}{value.shape}".encode() + np.ascontiguousarray(value).tobytes())
        case bytes():
            state.update(value)
        case list() | tuple():
            for item in value:
                _feed(state, item)
        case _:
            # Of numbers and texts; an interrupted `repr` of an array changes the next one.
            state.update(repr(value).encode())


def result(name: str) -> str:
    """Run an operation; returns the digest of its result."""
    return digest(OPERATIONS[name](shared()))


@functools.cache
def expected(name: str) -> str:
    """Return the digest of an operation's result, from its first call in this process."""
    return result(name)


def wrong(names: Iterable[str], digests: Iterable[str]) -> list[str]:
    """Return names of operations whose results differ from the expected ones."""
    return [name for name, got in zip(names, digests, strict=True) if got != expected(name)]
