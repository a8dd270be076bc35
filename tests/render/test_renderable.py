"""Tests of a third kind of renderable besides scenes and reduced scenes, and of the shots passed to each kind."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from nearfar._render.renderer import Renderer
from tests.support.gpu_cases import ADAPTERS, adapter

SIZE = (40, 30)


@dataclass
class Pending:
    """A picture that is computed when it is read."""

    image: Callable[[], NDArray[np.float32]]

    def finish(self, report: Any = None) -> dict[str, NDArray[Any]]:
        return {"color": self.image()}


class Sky(nf.Renderable):
    """An environment map without any scene."""

    def __init__(self, env: nf.EnvMap) -> None:
        self.env = env
        self.shots: list[nf.Shot] = []

    def trace(self, shot: nf.Shot, report: Any = None) -> list[dict[str, NDArray[Any]]]:
        self.shots.append(shot)
        return [{"color": self.env.sample(camera.rays()[1], filter="nearest")} for camera in shot.cameras]

    def begin(self, device: Any, shot: nf.Shot, report: Any = None) -> list[Pending]:
        self.shots.append(shot)
        return [Pending(self.on_device(camera)) for camera in shot.cameras]

    def on_device(self, camera: nf.Camera) -> Callable[[], NDArray[np.float32]]:
        directions = camera.rays()[1].astype(np.float32)
        return lambda: nf.gpu.cube_lookup(np.asarray(self.env.color, np.float32), directions)


@pytest.fixture
def sky() -> Sky:
    color = np.random.default_rng(0).uniform(0, 1, (6, 16, 16, 3)).astype(np.float32)
    return Sky(nf.EnvMap((0, 0, 0), color))


def cameras(count: int) -> list[nf.Camera]:
    fov = nf.Fov.symmetric(90, SIZE[0] / SIZE[1])
    aims = [(np.cos(n), 0.1, np.sin(n)) for n in range(count)]
    return [nf.Camera.look_at((1, 2, 3), np.add((1, 2, 3), aim), fov=fov, size=SIZE) for aim in aims]


def test_a_sky_is_rendered_on_the_cpu(sky: Sky) -> None:
    (camera,) = cameras(1)
    frame = nf.render(sky, camera, backend="cpu")
    np.testing.assert_array_equal(frame.require("color"), sky.env.sample(camera.rays()[1], filter="nearest"))
    assert frame.channels == ("color",)
    paths = list(nf.render_path(sky, cameras(3), backend="cpu"))
    assert [frame.camera for frame in paths] == [shot.cameras[0] for shot in sky.shots[1:]]
    np.testing.assert_array_equal(paths[0].require("color"), frame.require("color"))


@pytest.mark.parametrize("name", ADAPTERS)
def test_a_sky_is_rendered_on_an_adapter(sky: Sky, name: str) -> None:
    with adapter(name):
        drawn = [nf.render(sky, camera, backend="gpu") for camera in cameras(3)]
        along = list(nf.render_path(sky, cameras(3), backend="gpu"))
    for camera, single, step in zip(cameras(3), drawn, along, strict=True):
        expected = sky.env.sample(camera.rays()[1], filter="nearest")
        # Directions within a float32 step of a texel's border may take the other texel: few do.
        assert (single.require("color") == expected).all(axis=-1).mean() > 0.99
        np.testing.assert_array_equal(single.require("color"), step.require("color"))


def test_a_shot_contains_cameras_user_and_ray_segment(sky: Sky) -> None:
    renderer = Renderer(sky, ("color",), 4)
    eyes = cameras(2)
    frames = renderer.frames(renderer.shot(eyes, (5, 6, 7), 0.5, 80.0), None, None)
    assert [frame.camera for frame in frames] == eyes
    expected = nf.Shot(cameras=tuple(eyes), channels=("color",), samples=4, user=(5, 6, 7), t_min=0.5, t_max=80.0)
    assert sky.shots == [expected]
    assert sky.shots[0].eye == (5, 6, 7)
    assert renderer.shot(eyes).eye == (1, 2, 3)
    nf.render(sky, eyes[0], user=(0, 1, 0), t_min=1.0, t_max=2.0, backend="cpu")
    assert (sky.shots[-1].user, sky.shots[-1].t_min, sky.shots[-1].t_max) == ((0, 1, 0), 1.0, 2.0)


def test_kinds_without_poses_or_levels_refuse_them(sky: Sky) -> None:
    (camera,) = cameras(1)
    with pytest.raises(ValueError, match="nothing moves"):
        nf.render(sky, camera, at={"car": np.eye(4)})
    with pytest.raises(ValueError, match="which no graphics adapter draws"):
        Still().begin(None, None)  # type: ignore[arg-type]  # Refused without being read.


class Still(nf.Renderable):
    """A renderable with only the defaults."""


class Moves(Still):
    """A renderable that refuses all poses."""

    def at(self, poses: Mapping[str, ArrayLike]) -> Moves:
        raise json.JSONDecodeError("no pose", "text", 3)


def test_errors_of_poses_of_any_type_name_the_argument() -> None:
    with pytest.raises(ValueError, match="at: no pose: line 1"):
        nf.render(Moves(), cameras(1)[0], at={"car": np.eye(4)})


def test_scenes_and_reduced_scenes_are_renderables() -> None:
    scene = nf.Scene.from_arrays(np.eye(3) - [0.3, 0.3, 2.0], [[0, 1, 2]])
    assert isinstance(scene, nf.Renderable)
    reduced = nf.reduce(scene, center=(0, 0, 0), r1=1, r2=30, face_size=8)
    assert isinstance(reduced, nf.Renderable)
    (camera,) = cameras(1)
    same = nf.render(reduced, camera, backend="cpu").require("color")
    np.testing.assert_array_equal(same, reduced.render(camera, backend="cpu").require("color"))
