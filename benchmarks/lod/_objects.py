"""Objects with levels for scenes as in Liebisch (2021): files if the data exist, else procedural ones."""

from __future__ import annotations

import functools
import io
import zipfile
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import trimesh
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.lod._dense import densify
from benchmarks.lod._printed_turns import RIFT_S as PRINTED_RIFT_S, VIVE_PRO as PRINTED_VIVE_PRO, PrintedTurn
from nearfar._base import data
from nearfar.lod._select.kernel_inputs import on_panel

RATIOS = (1, 0.5, 0.25, 0.12, 0.06, 0.03, 0.015, 0.007, 0.003, 0.0015, 0.0007, 0.0003)

FILES = {
    "bunny": scenes.FILES["bunny"],
    "dragon": "objects/dragon/dragon_vrip_res2.ply.gz",
    "armadillo": scenes.FILES["armadillo"],
    "duck": scenes.FILES["Duck"],
    "FlightHelmet": scenes.FILES["FlightHelmet"],
}


@dataclass(frozen=True)
class Headset:
    """A headset as described by the thesis' performance tables."""

    name: str
    degrees: tuple[float, float]
    """Horizontal and vertical field of view."""
    lens: nf.RadialLens
    size: tuple[int, int]
    """Pixels rendered per eye."""
    panel_size: tuple[int, int]
    """Pixels of an eye's panel."""
    printed: dict[int, PrintedTurn]
    """Published measurements with it, by the scene's radius in metres."""

    @property
    def fov(self) -> nf.Fov:
        """Symmetric tangents."""
        x, y = (float(np.tan(np.radians(angle) / 2)) for angle in self.degrees)
        return nf.Fov(-x, x, -y, y)

    @property
    def panel_fov(self) -> nf.Fov:
        """Tangents of the part of the panel that the lens magnifies to the view."""
        return nf.Fov(*on_panel(self.fov, self.lens, self.fov.right))

    def camera(self, yaw: float = 0.0, *, position: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> nf.Camera:
        """Return a camera turned to the left by an angle in radians."""
        turned = (0.0, float(np.sin(yaw / 2)), 0.0, float(np.cos(yaw / 2)))
        return nf.Camera(position, turned, fov=self.fov, size=self.size)


def _panel(hmd: nf.Hmd) -> tuple[int, int]:
    """Panel size in pixels stated by a profile."""
    if hmd.panel_size is None:
        raise RuntimeError(f"expected a profile with the pixels of the panel: {hmd.name}")
    return hmd.panel_size


RIFT_S = Headset(
    "Rift S", (87, 90), nf.RadialLens((0.22, 0.24)), nf.hmd.RIFT_S.render_size, _panel(nf.hmd.RIFT_S), PRINTED_RIFT_S
)
VIVE_PRO = Headset(
    "Vive Pro",
    (95, 95),
    nf.RadialLens((0.2063, 0.0576)),
    nf.hmd.VIVE_PRO.render_size,
    _panel(nf.hmd.VIVE_PRO),
    PRINTED_VIVE_PRO,
)


def sources() -> dict[str, Callable[[], nf.Scene]]:
    """Loader of each available object."""
    loaders: dict[str, Callable[[], nf.Scene]] = {}
    if packed := data.find("objects/spot/spot.zip"):
        loaders["spot"] = functools.partial(_spot, packed)
    for name, file in FILES.items():
        if path := data.find(file):
            loaders[name] = functools.partial(nf.Scene.load, path)
    return loaders | {"knot": _knot, "pebble": _pebble}


BY_MESHOPT = ("bunny", "dragon", "FlightHelmet")
"""Objects of many parts and holes, where the other simplifier stops earlier."""

VIEWS = 36
"""Number of sides from which objects are measured: a quarter of the default of `measure`, and of its time."""


@functools.cache
def simplified(name: str, *, dense: bool) -> nf.lod.Levels:
    """Simplify an object, which may be `densify` before."""
    scene, method = sources()[name](), "meshopt" if name in BY_MESHOPT else "fast"
    return nf.lod.simplify(densify(scene) if dense else scene, RATIOS, method=method, normals="smooth", name=name)


def measured(
    headset: Headset,
    names: Iterable[str] = (),
    *,
    percentile: float = 25.0,
    step: float | None = 0.05,
    wider: int = 1,
    views: int = VIEWS,
    directions: str = "even",
    dense: bool = False,
) -> list[nf.lod.LodModel]:
    """Measure the levels of the objects for a headset, or read them from nearfar's cache.

    `dense` objects have half a million triangles and more. A screen `wider` by a factor, with pixels of the same size,
    makes curves begin at larger sizes.
    """
    levels = [simplified(name, dense=dense) for name in names or sources()]
    fov = nf.Fov(*(wider * side for side in (headset.fov.left, headset.fov.right, headset.fov.down, headset.fov.up)))
    size = wider * headset.size[0], wider * headset.size[1]
    how = functools.partial(nf.lod.measure, fov=fov, size=size, distances=16 * wider)
    return [how(each, views=views, directions=directions, percentile=percentile, step=step) for each in levels]


@dataclass(frozen=True)
class Crowd:
    """Objects at random places in a ball about the origin, with random orientations."""

    model_index: NDArray[np.int64]
    transforms: NDArray[np.float64]
    """Transforms from object to world (N, 4, 4)."""
    centers: NDArray[np.float64]
    radii: NDArray[np.float64]


def crowd(
    models: Sequence[nf.lod.LodModel], *, size: float, count: int, radius: float = 0.5, seed: int | Sequence[int] = 0
) -> Crowd:
    """Scatter `count` objects of one radius, all within `size` metres."""
    random = np.random.default_rng(seed)
    index = random.integers(len(models), size=count)
    ways = random.normal(size=(count, 3))
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    centers = ways * (size * random.random((count, 1)) ** (1 / 3))
    transforms = np.tile(np.eye(4), (count, 1, 1))
    for n, turn in enumerate(random.normal(size=(count, 4))):
        model = models[index[n]]
        transforms[n] = trimesh.transformations.quaternion_matrix(turn)
        transforms[n, :3, :3] *= radius / model.radius
        transforms[n, :3, 3] = centers[n] - transforms[n, :3, :3] @ model.center
    return Crowd(index, transforms, centers, np.full(count, radius))


def _spot(packed: Path) -> nf.Scene:
    """Load Spot and assign its texture, since the file names no material."""
    with zipfile.ZipFile(packed) as archive:
        mesh = trimesh.load(io.BytesIO(archive.read("spot/spot_triangulated.obj")), file_type="obj", process=False)
        image = Image.open(io.BytesIO(archive.read("spot/spot_texture.png"))).convert("RGB")
    mesh.visual = trimesh.visual.TextureVisuals(uv=mesh.visual.uv, image=image)
    return nf.Scene.from_trimesh(mesh)


def _knot() -> nf.Scene:
    """Make a trefoil tube of 96,000 triangles."""
    around, along = np.meshgrid(np.arange(80), np.arange(600))
    t, angle = 2 * np.pi * along.ravel() / 600, 2 * np.pi * around.ravel() / 80
    at = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], 1)
    way = np.stack([np.cos(t) + 4 * np.cos(2 * t), -np.sin(t) + 4 * np.sin(2 * t), -3 * np.cos(3 * t)], 1)
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    side = np.cross(way, [0.0, 0.0, 1.0])
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    thick = 0.45 * (1 + 0.08 * np.cos(12 * t) * np.cos(3 * angle))
    points = at + thick[:, None] * (np.cos(angle)[:, None] * side + np.sin(angle)[:, None] * np.cross(way, side))
    number = np.arange(600 * 80).reshape(600, 80)
    right, down = np.roll(number, -1, 1), np.roll(number, -1, 0)
    both = np.roll(right, -1, 0)
    faces = np.concatenate([np.stack([number, down, right], -1), np.stack([right, down, both], -1)]).reshape(-1, 3)
    mesh = trimesh.Trimesh(points, faces, process=False)
    if mesh.volume < 0:
        mesh.invert()
    return nf.Scene.from_trimesh(mesh)


def _pebble() -> nf.Scene:
    """Make a smooth stone of 81,920 triangles with dents of all sizes."""
    mesh = trimesh.creation.icosphere(subdivisions=6)
    points = mesh.vertices.view(np.ndarray)
    random = np.random.default_rng(7)
    height = np.zeros(len(points))
    for octave in range(1, 6):
        for wave in random.normal(size=(6, 3)) * 1.7**octave:
            height += 0.35 * 0.5**octave * np.sin(points @ wave + random.uniform(0, 6))
    stone = points * (1 + 0.25 * height[:, None]) * (1.0, 0.7, 0.85)
    return nf.Scene.from_trimesh(trimesh.Trimesh(stone, mesh.faces, process=False))
