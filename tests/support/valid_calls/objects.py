"""Small objects of every public kind, for valid calls of every public callable."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

import nearfar as nf
from nearfar._render import backend as backends
from tests.support import leveled_cases


@dataclass(frozen=True)
class Scale:
    """Sizes of valid arguments."""

    size: tuple[int, int]
    """Width and height of pictures."""
    rows: int
    """Number of points and of directions, even."""
    side: int
    """Width of a map's faces, texels."""
    cuts: int
    """Number of parts of each edge of the scene's two triangles."""


SMALL = Scale((24, 16), rows=2, side=4, cuts=1)
BUSY = Scale((96, 64), rows=2000, side=32, cuts=50)
"""Calls take milliseconds, so that calls in threads overlap."""
LARGE = Scale((2000, 2000), rows=2_000_000, side=768, cuts=500)
"""Most arrays take tens of megabytes."""

SIZE = SMALL.size
ZONES: dict[str, Any] = {"center": (0.0, 1.0, 0.0), "r1": 2.0, "r2": 4.0}
EYE = (0.0, 1.0, 3.0)
FAR: dict[str, Any] = {"reach": 1.0, "r2": 2.0, "face_size": 64, "centers": 1}
"""Settings of impostors at `EYE` for which the scene has a far part."""
MATRIX = np.array([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, -1.0, -0.1], [0.0, 0.0, -1.0, 0.0]])
"""A projection with depth 0..1."""


class Valid:
    """Valid arguments for tests: objects of every public kind, made once, and files in a folder."""

    def __init__(self, folder: Path, *, scale: Scale = SMALL) -> None:
        self.folder, self.scale = folder, scale
        draw = np.random.default_rng(3)
        corners = np.array([[-1, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 6], [1, 0, 6], [0, 1, 6]], np.float32)
        parts = [_divided(triangle, scale.cuts) for triangle in corners.reshape(2, 3, 3)]
        self.vertices = np.concatenate([vertices for vertices, _ in parts])
        self.faces = np.concatenate([faces + len(parts[0][0]) * number for number, (_, faces) in enumerate(parts)])
        self.points = np.tile(corners.astype(np.float64), (scale.rows // 2, 1))
        self.directions = np.tile([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0]], (scale.rows // 2, 1))
        self.single = np.asarray(self.directions, np.float32)
        self.picture = draw.integers(0, 256, scale.size[::-1], np.uint8)
        self.cube = draw.random((6, scale.side, scale.side, 3), np.float32)
        for value in vars(self).values():
            if isinstance(value, np.ndarray):
                value.setflags(write=False)  # No call may change its arguments.

    @functools.cached_property
    def scene(self) -> nf.Scene:
        """Two objects, of which "far" can be posed."""
        builder = nf.SceneBuilder()
        for rows, name in zip(np.split(self.faces, 2), ("near", "far"), strict=True):
            builder.instance(builder.mesh(self.vertices, rows, copy=True), name=name)
        return builder.build(dynamic=["far"])

    @functools.cached_property
    def model(self) -> nf.lod.LodModel:
        """Two levels with geometry."""
        return leveled_cases.model_of((1, 0))

    @functools.cached_property
    def measured(self) -> nf.lod.LodModel:
        """The model with scores of single views."""
        views = np.full((2, 8, 4), 0.9, np.float32)
        return replace(self.model, samples=nf.lod.Samples(np.geomspace(1e-4, 0.3, 8), np.full((2, 8), 0.9), views))

    @functools.cached_property
    def leveled(self) -> nf.Scene:
        """A scene with levels."""
        return nf.lod.place([self.model], [0, 0], self.transforms, names=["one", "two"])

    @property
    def transforms(self) -> np.ndarray:
        """Two places."""
        places = np.tile(np.eye(4), (2, 1, 1))
        places[1, :3, 3] = (3.0, 0.0, 0.0)
        return places

    @functools.cached_property
    def camera(self) -> nf.Camera:
        """A view of the scene."""
        return nf.Camera.look_at(EYE, (0.0, 1.0, 0.0), fov=nf.Fov.symmetric(90.0), size=self.scale.size)

    @functools.cached_property
    def frame(self) -> nf.Frame:
        """A picture with all channels."""
        names = ("color", "range", "object_id", "face_id", "position", "normal")
        return nf.render(self.scene, self.camera, channels=names, backend="cpu")

    @functools.cached_property
    def reduced(self) -> nf.ReducedScene:
        """The scene, reduced."""
        return nf.reduce(
            self.scene, **ZONES, face_size=len(self.cube[0]), samples=1, channels=("color", "range"), backend="cpu"
        )

    @functools.cached_property
    def reduced_leveled(self) -> nf.ReducedScene:
        """The scene with levels, reduced."""
        return nf.reduce(self.leveled, **ZONES, face_size=4, samples=1, backend="cpu")

    @functools.cached_property
    def impostors(self) -> nf.Impostors:
        """The scene, with its far part as quads."""
        return nf.reduce(self.scene, far="impostors", center=EYE, **FAR)

    @functools.cached_property
    def regions(self) -> nf.Regions:
        """Two regions of a walk."""
        small: dict[str, Any] = {"reach": 0.5, "hysteresis": 0.1, "r2": 4.0, "face_size": 4, "samples": 1}
        return nf.regions(self.scene, [(0.0, 1.0, 1.0), (0.0, 1.0, 2.0)], **small, backend="cpu")

    @functools.cached_property
    def ring_maps(self) -> nf.stream.RingMaps:
        """Maps of two rings."""
        rings = nf.stream.assign(self.scene, center=ZONES["center"], radii=[2.0, 4.0])
        return nf.stream.bake_maps(rings, face_size=64)

    @functools.cached_property
    def bundle(self) -> nf.stream.Bundle:
        """Files of two rings."""
        given: dict[str, Any] = {"center": ZONES["center"], "radii": [2.0, 4.0], "face_size": 64, "samples": 1}
        return nf.stream.export(self.scene, self.folder / "bundle", **given)

    @functools.cached_property
    def timeline(self) -> nf.stream.Timeline:
        """A client that loads these files."""
        return nf.stream.simulate(self.bundle, link=nf.stream.Link(50.0), strategy="clovrd")

    @functools.cached_property
    def store(self) -> Path:
        """A store of orthoviews."""
        path = self.folder / "valid.zarr"
        nf.orthoview.build(self.scene, path, cell=8.0, size=8, directions=5)
        return path

    @functools.cached_property
    def orthotree(self) -> nf.orthoview.OrthoTree:
        """The tree of this store."""
        return nf.orthoview.open(self.store)

    @functools.cached_property
    def moving_orthotree(self) -> nf.orthoview.OrthoTree:
        """The tree with a moving object."""
        return self.orthotree.with_dynamic(self.scene)

    @functools.cached_property
    def sphere_task(self) -> nf.datasets.SphereTask:
        """A task of pointing at spheres."""
        return nf.datasets.sphere_task()[1]

    @functools.cached_property
    def flown(self) -> nf.orthoview.FlightLog:
        """Two frames of a simulated flight."""
        return nf.orthoview.simulate(self.orthotree, [self.camera] * 2, link=nf.stream.Link(50.0))

    @functools.cached_property
    def env(self) -> nf.EnvMap:
        """A map with all channels."""
        shape = self.cube.shape[:3]
        return nf.EnvMap((0.0, 1.0, 0.0), self.cube, np.full(shape, 9.0, np.float32), np.zeros(shape, np.int32), ("a",))

    @functools.cached_property
    def lens(self) -> nf.RadialLens:
        """A lens without tangential terms."""
        return nf.RadialLens([0.1, 0.02])

    @functools.cached_property
    def chromatic(self) -> nf.ChromaticLens:
        """A lens for each colour."""
        return nf.ChromaticLens(self.lens, self.lens, self.lens)

    @functools.cached_property
    def hmd(self) -> nf.Hmd:
        """A headset with a lens."""
        return nf.hmd.get("QUEST_2").with_lens(self.lens)

    @functools.cached_property
    def stereo(self) -> nf.StereoFrame:
        """A small picture of both eyes."""
        return nf.render_eyes(self.scene, self.hmd, EYE, size=SIZE, backend="cpu")

    @functools.cached_property
    def levels(self) -> nf.lod.Levels:
        """The geometry of the model."""
        levels = self.model.levels
        assert levels is not None
        return levels

    @functools.cached_property
    def shot(self) -> nf.Shot:
        """A request for a picture."""
        return nf.Shot(cameras=(self.camera,), channels=("color",))

    @functools.cached_property
    def mesh(self) -> trimesh.Trimesh:
        """A box of trimesh, or for large arguments a tenth of the scene."""
        if self.scale.cuts == 1:
            return trimesh.creation.box()
        return trimesh.Trimesh(*_divided(self.vertices[self.faces[0]], self.scale.cuts // 3), process=False)

    @functools.cached_property
    def device_frame(self) -> Any:
        """A frame on the adapter that is selected."""
        return nf.gpu.render(self.scene, self.camera, channels=("color", "range", "position"))

    @property
    def device(self) -> Any:
        """The adapter that is selected."""
        return backends.open_device()

    @functools.cached_property
    def selection(self) -> nf.lod.Selection:
        """The levels of two objects."""
        return nf.lod.select([self.model], [0, 0], np.zeros((2, 3)), [1.0, 2.0], camera=self.camera, full=True)

    @functools.cached_property
    def rig(self) -> nf.stereo.HybridRig:
        """Cameras of a headset with one picture far away."""
        return nf.stereo.HybridRig.of(self.hmd, mono_plane=8.0, size=SIZE)

    def builder(self) -> nf.SceneBuilder:
        """A builder with one mesh and one object, new each time, because calls change it."""
        builder = nf.SceneBuilder()
        builder.instance(builder.mesh(self.vertices, self.faces, copy=True), name="first")
        return builder

    def file(self, name: str) -> Path:
        """A file that `load` reads, of the class of that name."""
        savers: dict[str, tuple[str, Callable[[Path], object]]] = {
            "EnvMap": ("map.exr", self.env.save),
            "Frame": ("frame.exr", self.frame.save),
            "Hmd": ("hmd.json", self.hmd.save),
            "Impostors": ("impostors", self.impostors.save),
            "LodModel": ("model.json", self.model.save),
            "ReducedScene": ("reduced", self.reduced.save),
            "Scene": ("scene.obj", lambda path: path.write_text(trimesh.exchange.obj.export_obj(self.mesh))),
        }
        file, save = savers[name]
        path = self.folder / "valid" / file
        if not path.exists():
            path.parent.mkdir(exist_ok=True)
            save(path)
        return path


def _divided(triangle: np.ndarray, cuts: int) -> tuple[np.ndarray, np.ndarray]:
    """Return vertices and faces of a triangle that is divided into `cuts`² equal ones."""
    lines = np.arange(cuts + 1)
    row, column = np.nonzero(lines[:, None] + lines <= cuts)
    weights = np.stack([cuts - row - column, column, row], -1)
    number = np.zeros((cuts + 1, cuts + 1), np.uint32)
    number[row, column] = np.arange(len(row))
    x, y = column[row + column < cuts], row[row + column < cuts]
    upright = np.stack([number[y, x], number[y, x + 1], number[y + 1, x]], -1)
    x, y = column[row + column < cuts - 1], row[row + column < cuts - 1]
    inverted = np.stack([number[y, x + 1], number[y + 1, x + 1], number[y + 1, x]], -1)
    return (weights @ triangle / cuts).astype(np.float32), np.concatenate([upright, inverted])
