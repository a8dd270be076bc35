"""Materials besides nearfar's own diffuse ones: metallic, glossy and patterned surfaces in one colour.

Pictures are shaded from the hit of each ray, so that a scene is traced once for all materials. Patterns are
evaluated at the point itself, without texture coordinates that a simplifier could move.
"""

from __future__ import annotations

import functools
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._camera.rotation import rotation

Array = NDArray[np.float32]
Image = NDArray[np.uint8]
Light = tuple[Array, Array, Array]
"""Light at each hit, summed over lights: diffuse, mirrored, and mirrored at grazing angles."""

FINER = 2
"""Number of rays across a pixel."""

BASE = 0.5
"""Linear reflectance; patterns vary about it."""

AMBIENT = 0.15
"""Ambient light, linear."""
BACKGROUND = 0.2
"""Linear colour of the background, between the dark and the bright sides of objects, so that both stand out."""

LIGHTS = (((-0.5, 0.7, 0.6), 3.0), ((0.9, 0.1, 0.5), 1.0), ((0.1, 0.6, -0.8), 2.0))
"""Direction towards each light, by the camera's right, up and back, and its brightness. Lights move with the camera:
the object turns relative to both. Surfaces mirror only the lights."""

# A pattern's three directions, oblique to all axes about which objects turn, and perpendicular to each other.
_WAVES = np.linalg.qr(np.array([[0.9, 0.3, -0.2], [-0.3, 0.7, 0.6], [0.4, -0.5, 0.8]]))[0].astype(np.float32)
_MIRRORED = 0.04
"""Reflectance of dielectrics at normal incidence, linear."""
# Table from linear values in 16-bit steps to sRGB codes; its greatest error is a third of a code, for dark values.
_LINEAR = np.arange(1 << 16) / ((1 << 16) - 1)
_CODES = np.round(255 * np.where(_LINEAR <= 0.0031308, 12.92 * _LINEAR, 1.055 * _LINEAR ** (1 / 2.4) - 0.055))
_CODES = _CODES.astype(np.uint8)


@dataclass(frozen=True)
class Material:
    """Material of a surface; by default the neutral one, dull and in one colour."""

    metallic: float = 0.0
    """0 to 1, as in glTF 2.0."""
    roughness: float = 1.0
    """Perceptual roughness, 0 to 1, as in glTF 2.0."""
    frequency: float = 0.0
    """Frequency of the pattern, in cycles across the bounding sphere."""
    contrast: float = 0.0
    """Contrast of the pattern: reflectance varies from BASE (1 − contrast) to BASE (1 + contrast)."""
    mapped: bool = False
    """Whether the pattern lies on a sphere around the object with coordinates stored at vertices, so that it shifts on
    coarse triangles, as textures do. Otherwise it fills space, and depends on a point's position."""

    @property
    def dull(self) -> bool:
        """Whether the material is neither metallic nor glossy."""
        return (self.metallic, self.roughness) == (0.0, 1.0)

    @property
    def label(self) -> str:
        """Short label for tables."""
        parts = [f"metallic {self.metallic:g}, roughness {self.roughness:g}"]
        if self.contrast:
            parts.append(f"{self.frequency:g} cycles{', mapped' * self.mapped}, contrast {self.contrast:g}")
        return ", ".join(parts)


NEUTRAL = Material()


@dataclass(frozen=True, eq=False)
class Surface:
    """Hits of the rays of one picture, `FINER` by `FINER` to a pixel."""

    hit: NDArray[np.bool_]
    """(FINER H, FINER W), whether each ray hit."""
    position: Array
    """(N, 3) position of each hit, in the object's frame, where the bounding sphere has radius 1."""
    normal: Array
    """(N, 3) normal of a smooth surface through the vertices."""
    mapped: Array
    """(N, 3) direction from the middle of the object, stored at vertices and interpolated linearly."""
    view: Array
    """(N, 3) direction towards the eye."""
    axes: Array
    """Rows (3, 3) of the camera's right, up and back."""

    @property
    def silhouette(self) -> NDArray[np.bool_]:
        """(H, W), true where any part of the object is seen."""
        height, width = (side // FINER for side in self.hit.shape)
        return np.asarray(self.hit.reshape(height, FINER, width, FINER).any(axis=(1, 3)))


@dataclass(frozen=True, eq=False)
class Shape:
    """One mesh, with the smooth normals of its vertices."""

    vertices: Array
    faces: NDArray[np.int64]

    @functools.cached_property
    def scene(self) -> nf.Scene:
        return nf.Scene.from_arrays(self.vertices, self.faces, copy=True)

    @functools.cached_property
    def normals(self) -> Array:
        """Area-weighted mean of the normals of the faces around each vertex (V, 3)."""
        corners = self.vertices[self.faces]
        scaled = np.repeat(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), 3, axis=0)
        count = len(self.vertices)
        sums = np.stack([np.bincount(self.faces.ravel(), part, count) for part in scaled.T], axis=1)
        length = np.linalg.norm(sums, axis=1, keepdims=True)
        return (sums / np.where(length > 0, length, 1)).astype(np.float32)


def look(shape: Shape, camera: nf.Camera) -> Surface:
    """Trace a camera with FINER times the pixels of the picture, and return the hits on a shape at the origin."""
    frame = nf.render(shape.scene, camera, channels=("face_id", "position"), backend="cpu")
    numbers = frame.require("face_id")
    hit = numbers >= 0
    position = frame.require("position")[hit].astype(np.float32)
    faces = shape.faces[numbers[hit]]
    parts = shape.vertices[faces]
    # Barycentric coordinates by areas: computed from edges they would lose digits in slivers.
    to_corners = parts - position[:, None]
    areas = np.cross(np.roll(to_corners, -1, axis=1), np.roll(to_corners, -2, axis=1))
    weights = np.sqrt(np.einsum("nck,nck->nc", areas, areas))
    weights /= np.maximum(weights.sum(axis=1, keepdims=True), np.finfo(np.float32).tiny)
    normal = _unit(np.einsum("nc,nck->nk", weights, shape.normals[faces]))
    mapped = np.einsum("nc,nck->nk", weights, _unit(shape.vertices)[faces])
    eye = np.asarray(camera.position, np.float32)
    axes = rotation(camera.orientation).T.astype(np.float32)
    return Surface(hit, position, normal, mapped, _unit(eye - position), axes)


def shade(surface: Surface, materials: Sequence[Material]) -> Image:
    """Shade one picture for each material (M, H, W), sRGB codes."""
    light = _light(surface, {material.roughness for material in materials})
    patterns = {(material.frequency, material.mapped) for material in materials if material.contrast}
    waves = {(f, mapped): _pattern(surface.mapped if mapped else surface.position, f) for f, mapped in patterns}
    height, width = (side // FINER for side in surface.hit.shape)
    pictures = np.empty((len(materials), height, width), np.uint8)
    fine_picture = np.empty(surface.hit.shape, np.float32)
    for picture, material in zip(pictures, materials, strict=True):
        base: Array | np.float32 = np.float32(BASE)
        if material.contrast:
            base = base * (1 + np.float32(material.contrast) * waves[material.frequency, material.mapped])
        fine_picture.fill(BACKGROUND)
        fine_picture[surface.hit] = np.minimum(colors(light[material.roughness], base, material.metallic), 1.0)
        # Summing slices is many times as fast as summing axes of length two.
        rows = functools.reduce(np.add, (fine_picture[n::FINER] for n in range(FINER)))
        mean = functools.reduce(np.add, (rows[:, n::FINER] for n in range(FINER))) / FINER**2
        picture[:] = _CODES[np.round(mean * ((1 << 16) - 1)).astype(np.uint16)]
    return pictures


def colors(light: Light, base: Array | np.float32, metallic: float) -> Array:
    """Linear colour of each hit, from sums over lights that do not depend on the surface's colour."""
    diffuse, mirrored, grazing = light
    straight = (1 - metallic) * np.float32(_MIRRORED) + metallic * base
    dull = base * np.float32((1 - _MIRRORED) * (1 - metallic))
    return np.asarray((1 - straight) * (dull * diffuse + grazing) + straight * mirrored + base * np.float32(AMBIENT))


def _light(surface: Surface, roughness: Iterable[float]) -> dict[float, Light]:
    """Sums over lights for each roughness, by glTF's model as in pyrender.

    Fresnel's F = f₀ + (1 − f₀) s is linear in f₀, so the sums are independent of the surface's colour.
    """
    nv = np.clip(np.abs(_dot(surface.normal, surface.view)), 0.001, 1)
    diffuse = np.zeros(len(nv), np.float32)
    mirrors = {rough: (np.zeros(len(nv), np.float32), np.zeros(len(nv), np.float32)) for rough in roughness}
    for direction, bright in LIGHTS:
        towards = _unit(np.asarray(direction, np.float32) @ surface.axes)
        half_vector = _unit(surface.view + towards)
        nl = np.clip(surface.normal @ towards, 0.001, 1)
        nh = np.clip(_dot(surface.normal, half_vector), 0, 1)
        grazing_cosine = 1 - np.clip(_dot(surface.view, half_vector), 0, 1)
        s = grazing_cosine * grazing_cosine * grazing_cosine * grazing_cosine * grazing_cosine
        diffuse += nl * (1 - s) * np.float32(bright / np.pi)
        # The factor of nl D G / (4 nl nv) that all roughnesses share, with a small term against division by zero.
        shared = nl * nl * nv / (4 * nl * nv + 0.001) * np.float32(bright / np.pi)
        for rough, (straight, grazing) in mirrors.items():
            rough = max(rough, _MIRRORED)
            alpha2, small = np.float32(rough**4), np.float32((rough + 1) ** 2 / 8)
            narrow = nh * nh * (alpha2 - 1) + 1
            mirror = shared * alpha2 / (narrow * narrow * (nv * (1 - small) + small) * (nl * (1 - small) + small))
            straight += mirror
            grazing += mirror * s
    return {rough: (diffuse, *mirrored) for rough, mirrored in mirrors.items()}


def _pattern(points: Array, frequency: float) -> Array:
    """Waves along three directions in space (N,), −1 to 1."""
    waves = np.sin(np.float32(np.pi * frequency) * (_WAVES @ points.T))
    return np.asarray((waves[0] + waves[1] + waves[2]) / 3)


def _dot(one: Array, other: Array) -> Array:
    return np.asarray(np.einsum("nk,nk->n", one, other))


def _unit(vectors: Array) -> Array:
    length = np.sqrt(np.einsum("...k,...k->...", vectors, vectors))[..., None]
    return np.asarray(vectors / np.maximum(length, np.finfo(np.float32).tiny))
