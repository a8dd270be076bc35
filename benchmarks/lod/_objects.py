"""Objects with levels for scenes as in Liebisch (2021): files if the data exist, else procedural ones."""

from __future__ import annotations

import functools
import io
import zipfile
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Self, Unpack

import numpy as np
import trimesh
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.lod._printed_turns import RIFT_S as PRINTED_RIFT_S, VIVE_PRO as PRINTED_VIVE_PRO, PrintedTurn
from nearfar._base import data
from nearfar.lod._measure.settings import MeasureKeywords
from nearfar.lod._select.kernel_inputs import on_panel
from nearfar.lod._simplify.simplify import Method
from nearfar.lod._simplify.surface import Base, Surface

RATIOS = (1, 0.5, 0.25, 0.12, 0.06, 0.03, 0.015, 0.007, 0.003, 0.0015, 0.0007, 0.0003)

FILES = {
    "bunny": scenes.FILES["bunny"],
    "dragon": "objects/dragon/dragon_vrip_res2.ply.gz",
    "armadillo": scenes.FILES["armadillo"],
    "duck": scenes.FILES["Duck"],
    "FlightHelmet": scenes.FILES["FlightHelmet"],
}


MIN_TRIANGLES = 500_000
"""Least number of triangles after `densify`, each round of which quadruples them: most get 0.5 to 1.6 million."""
ROUGHNESS = 0.05
"""Maximum displacement of a midpoint along each axis, as a share of its edge's length."""
_MIX = np.array([0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D], np.uint32)
"""Odd multipliers, so that no bit of a coordinate is lost."""


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
        x, y = (float(np.tan(np.radians(angle) / 2)) for angle in self.degrees)
        return nf.Fov(-x, x, -y, y)

    @property
    def panel_fov(self) -> nf.Fov:
        """Tangents of the part of the panel that the lens magnifies to the view."""
        return nf.Fov(*on_panel(self.fov, self.lens, self.fov.right))

    def camera(self, yaw: float) -> nf.Camera:
        """Return a camera at the origin, turned to the left by an angle in radians."""
        orientation = (0.0, float(np.sin(yaw / 2)), 0.0, float(np.cos(yaw / 2)))
        return nf.Camera((0.0, 0.0, 0.0), orientation, fov=self.fov, size=self.size)

    @classmethod
    def from_profile(
        cls, hmd: nf.Hmd, name: str, degrees: tuple[int, int], *lens: float, printed: dict[int, PrintedTurn]
    ) -> Self:
        """Make a headset with the pixel counts of a profile."""
        assert hmd.panel_size is not None
        return cls(name, degrees, nf.RadialLens(lens), hmd.render_size, hmd.panel_size, printed)


RIFT_S = Headset.from_profile(nf.hmd.RIFT_S, "Rift S", (87, 90), 0.22, 0.24, printed=PRINTED_RIFT_S)
VIVE_PRO = Headset.from_profile(nf.hmd.VIVE_PRO, "Vive Pro", (95, 95), 0.2063, 0.0576, printed=PRINTED_VIVE_PRO)


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
"""Number of views of each object: a quarter of the default of `measure`, which takes a quarter of the time."""


@functools.cache
def simplify_object(name: str, *, dense: bool) -> nf.lod.Levels:
    """Simplify an object, after `densify` if `dense`."""
    scene = sources()[name]()
    method: Method = "meshopt" if name in BY_MESHOPT else "fast"
    return nf.lod.simplify(densify(scene) if dense else scene, RATIOS, method=method, normals="smooth", name=name)


def measure_objects(
    headset: Headset, names: Iterable[str] = (), *, dense: bool = False, **changes: Unpack[MeasureKeywords]
) -> list[nf.lod.LodModel]:
    """Measure the levels of the objects for a headset, or read them from nearfar's cache.

    `dense` objects have half a million triangles and more. Without `changes` of the settings, all `VIEWS` are compared
    at the distances of the thesis.
    """
    levels = [simplify_object(name, dense=dense) for name in names or sources()]
    settings: MeasureKeywords = {"spacing": "published", "standard_error": 0.0, "views": VIEWS}
    settings |= {"fov": headset.fov, "size": headset.size}
    return nf.lod.measure(levels, settings=nf.lod.MeasureSettings(**(settings | changes)))


@dataclass(frozen=True)
class Crowd:
    """Objects at random places in a sphere about the origin, with random orientations."""

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
    directions = random.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    centers = directions * (size * random.random((count, 1)) ** (1 / 3))
    transforms = np.tile(np.eye(4), (count, 1, 1))
    for n, turn in enumerate(random.normal(size=(count, 4))):
        model = models[index[n]]
        transforms[n] = trimesh.transformations.quaternion_matrix(turn)
        transforms[n, :3, :3] *= radius / model.radius
        transforms[n, :3, 3] = centers[n] - transforms[n, :3, :3] @ model.center
    return Crowd(index, transforms, centers, np.full(count, radius))


def _spot(packed: Path) -> nf.Scene:
    mesh = spot_mesh(packed)
    with zipfile.ZipFile(packed) as archive:
        image = Image.open(io.BytesIO(archive.read("spot/spot_texture.png"))).convert("RGB")
    mesh.visual = trimesh.visual.TextureVisuals(uv=mesh.visual.uv, image=image)
    return nf.Scene.from_trimesh(mesh)


def spot_mesh(packed: Path) -> trimesh.Trimesh:
    with zipfile.ZipFile(packed) as archive:
        return trimesh.load(io.BytesIO(archive.read("spot/spot_triangulated.obj")), file_type="obj", process=False)


def _knot() -> nf.Scene:
    """Make a trefoil tube of 96,000 triangles."""
    around, along = np.meshgrid(np.arange(80), np.arange(600))
    t, angle = 2 * np.pi * along.ravel() / 600, 2 * np.pi * around.ravel() / 80
    centers = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], 1)
    tangent = np.stack([np.cos(t) + 4 * np.cos(2 * t), -np.sin(t) + 4 * np.sin(2 * t), -3 * np.cos(3 * t)], 1)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    side = np.cross(tangent, [0.0, 0.0, 1.0])
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    radius = 0.45 * (1 + 0.08 * np.cos(12 * t) * np.cos(3 * angle))
    up = np.cross(tangent, side)
    points = centers + radius[:, None] * (np.cos(angle)[:, None] * side + np.sin(angle)[:, None] * up)
    number = np.arange(600 * 80).reshape(600, 80)
    right, down = np.roll(number, -1, 1), np.roll(number, -1, 0)
    down_right = np.roll(right, -1, 0)
    corners = np.stack([number, down, right], -1), np.stack([right, down, down_right], -1)
    mesh = trimesh.Trimesh(points, np.concatenate(corners).reshape(-1, 3), process=False)
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


def densify(scene: nf.Scene) -> nf.Scene:
    """Split every triangle into four at the displaced midpoints of its edges, until there are enough; flat normals."""
    base = Base(scene)
    base.with_normals("flat")
    surface = base.surface
    while len(surface.faces) < MIN_TRIANGLES:
        surface = _split(surface)
    return base.scene_of(surface)


def _split(surface: Surface) -> Surface:
    """Split every triangle once. Midpoints at the same place move alike, so that seams of the texture stay closed."""
    old = surface.positions.astype(np.float64)
    squares = (old * old).sum(axis=1, keepdims=True)
    attributes = {key: values.astype(np.float64) for key, values in surface.attributes.items()}
    positions, faces, means = trimesh.remesh.subdivide(old, surface.faces, vertex_attributes=attributes | {"": squares})
    new = positions[len(old) :]
    # |a − b|² = 4 ((|a|² + |b|²)/2 − |(a + b)/2|²)
    lengths = 2 * np.sqrt(np.maximum(means.pop("")[len(old) :] - (new * new).sum(axis=1, keepdims=True), 0))
    new += ROUGHNESS * lengths * _noise(new)
    return Surface(
        np.ascontiguousarray(positions, np.float32),
        np.ascontiguousarray(faces, np.uint32),
        np.repeat(surface.materials, 4),
        {key: np.ascontiguousarray(values, surface.attributes[key].dtype) for key, values in means.items()},
    )


def _noise(places: NDArray[np.float64]) -> NDArray[np.float64]:
    """Numbers from −1 to 1 for each axis (N, 3) that depend on the position only."""
    bits = np.ascontiguousarray(places + 0.0, np.float32).view(np.uint32)
    mixed = (bits * _MIX).sum(axis=1, dtype=np.uint32)[:, None] * _MIX
    mixed ^= mixed >> np.uint32(15)
    mixed *= _MIX[::-1]
    mixed ^= mixed >> np.uint32(13)
    return np.asarray(mixed / np.float64(2**31) - 1)
