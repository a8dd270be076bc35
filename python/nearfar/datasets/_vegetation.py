"""Prototypes of trees, shrubs, grass and rocks."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets._palette import Material, materials
from nearfar.datasets._random import Floats, RandomStream, cross, dot, turn, unit, xyz
from nearfar.datasets._shapes import Soup, join, lathe, loft, quads, ring, sphere, textured, triangles, tube
from nearfar.datasets._textures import grid

_LEAVES = materials("leaf", "leaf_deep", "leaf_light", "leaf_olive", "leaf", "leaf_deep", "leaf_autumn")
_BARKS = materials("bark", "bark_dark", "bark")


def blob(random: RandomStream, subdivisions: int, roughness: float) -> Floats:
    """Corners of a lumpy unit sphere: each lump pushes out the points that face it."""
    corners = sphere(subdivisions)
    swell = np.zeros(corners.shape[:2])
    for lump in _directions(random, 14):
        swell = np.maximum(swell, np.clip((dot(corners, lump) - 0.72) / 0.28, 0.0, 1.0))
    return corners * (1.0 - roughness + roughness * swell * (2.0 - swell))[..., None]


def _directions(random: RandomStream, count: int) -> Floats:
    """Unit vectors (count, 3), evenly spread over the sphere and then randomly displaced."""
    height = 1.0 - 2.0 * (np.arange(count) + random.uniform(count)) / count
    cosine, sine = turn(np.arange(count) * 0.6180339887498949 + random.uniform(count, 0.0, 0.25))
    flat = np.sqrt(np.clip(1.0 - height * height, 0.0, 1.0))
    return np.stack([flat * cosine, height, flat * sine], -1)


def _shaded(soup: Soup, low: float, high: float, *, darkest: float = 0.5) -> Soup:
    """Darken a soup towards the ground, like foliage."""
    fraction = np.clip((soup.corners[..., 1] - low) / (high - low), 0.0, 1.0)
    return soup.tinted(darkest + (1.0 - darkest) * fraction)


def broadleaf(seed: int, variant: int, detail: int) -> Soup:
    """A street tree about 8 m high around the y axis, its foot slightly below y = 0."""
    random = RandomStream(seed, 2, variant)
    high, crown = random.number(6.5, 9.5), random.number(1.9, 2.6)
    leaf, bark = _LEAVES[variant % len(_LEAVES)], random.pick(_BARKS)
    fork = 0.36 * high
    lean = random.uniform(2, -0.15, 0.15)
    trunk = [(0.0, -0.3, 0.0), (lean[0], 0.5 * fork, lean[1]), (0.0, fork, 0.0), (0.0, 0.8 * high, 0.0)]
    parts = [tube(trunk, [0.24, 0.17, 0.14, 0.05], (4, 5, 8, 8)[detail], bark)]
    count = 1 if detail <= 1 else int(random.integers(1, 2)[0]) + (3 if detail == 2 else 6)
    for center, radius in _clumps(random, count, high, crown):
        if detail >= 2:
            start = np.array([0.0, fork * 0.92, 0.0])
            bend = 0.5 * (start + center) - [0.0, 0.25, 0.0]
            parts.append(tube([start, bend, center], [0.09, 0.06, 0.03], 5, bark, bottom=False))
        parts.append(_foliage(random, center, radius, leaf, high, crown, detail))
    return join(parts)


def _clumps(random: RandomStream, count: int, high: float, crown: float) -> list[tuple[Floats, Floats]]:
    """Centres and half axes of the crown's clumps, one on top and the others around."""
    middle = high - 0.95 * crown
    if count == 1:
        return [(np.array([0.0, middle, 0.0]), np.array([crown, 1.15 * crown, crown]))]
    clumps = [(np.array([0.0, middle + 0.55 * crown, 0.0]), np.full(3, 0.72 * crown))]
    cosine, sine = turn((np.arange(count - 1) + random.uniform(count - 1, 0.0, 0.5)) / (count - 1))
    for c, s in zip(cosine, sine, strict=True):
        out, rise = random.number(0.5, 0.72) * crown, random.number(-0.55, 0.3) * crown
        size = random.number(0.5, 0.68) * crown
        clumps.append((np.array([c * out, middle + rise, s * out]), np.array([size, 0.85 * size, size])))
    return clumps


def _foliage(
    random: RandomStream, center: Floats, radius: Floats, leaf: int, high: float, crown: float, detail: int
) -> Soup:
    """One clump: a lumpy ball, or at the highest detail a cloud of leaves around a core."""
    core = triangles(blob(random, (0, 1, 2, 2)[detail], 0.28), leaf)
    low = high - 2.4 * crown
    if detail < 3:
        return _shaded(core.scaled(radius).translate(center), low, high)
    inside = _shaded(core.scaled(0.78 * radius).translate(center), low, high, darkest=0.35)
    return join([inside, _shaded(_leaf_cloud(random, 620, radius, center, leaf), low, high)])


def _leaf_cloud(random: RandomStream, count: int, radius: Floats, center: Floats, leaf: int) -> Soup:
    """Sprays of leaves over an ellipsoid's surface: rhombi of two triangles."""
    normals = _directions(random, count)
    middle = normals * random.uniform(count, 0.72, 1.08)[:, None] * radius + center
    tilt = _directions(random, count)[random.integers(count, count)]
    along = unit(tilt - normals * (0.6 * dot(tilt, normals))[:, None])
    length = random.uniform(count, 0.12, 0.24)[:, None]
    tip, side = along * length, cross(along, normals) * (0.5 * length)
    return quads(np.stack([middle - tip, middle + side, middle + tip, middle - side], 1), leaf)


def conifer(seed: int, variant: int, detail: int) -> Soup:
    """A spruce about 12 m high, around the y axis."""
    random = RandomStream(seed, 3, variant)
    high = random.number(9.0, 15.0)
    wide = random.number(0.17, 0.23) * high
    needle = "needle" if variant % 2 == 0 else "needle_blue"
    tiers, sides = ((1, 6), (3, 8), (9, 16), (16, 36))[detail]
    trunk = [(0, -0.4, 0), (0, 0.45 * high, 0), (0, 0.93 * high, 0)]
    parts = [tube(trunk, [0.24, 0.15, 0.03], (4, 5, 9, 12)[detail], "bark_dark")]
    for tier in range(tiers):
        fraction = tier / tiers
        low = high * (0.12 + 0.83 * fraction)
        top = min(high, low + high * (1.5 + 0.7 * (1.0 - fraction)) / (tiers + 1.0))
        radius = wide * (1.0 - fraction) * random.number(0.9, 1.08) + 0.12
        parts.append(_skirt(random, low, top, radius, sides, needle))
    return _shaded(join(parts), 0.0, high, darkest=0.55)


def _skirt(random: RandomStream, low: float, top: float, radius: float, sides: int, needle: Material) -> Soup:
    """A cone of branches: every second rib reaches out and droops."""
    ribs = np.where(np.arange(sides) % 2 == 0, 1.0, 0.66) * random.uniform(sides, 0.85, 1.1)
    x, z = ring(sides, phase=random.number()).T
    sections = []
    for row, (reach, rise) in enumerate(((0.25, 0.12), (1.0, 0.0), (0.55, 0.42), (0.0, 1.0))):
        out = radius * reach * (ribs if row in (1, 2) else 1.0)
        droop = 0.16 * radius * ribs if row == 1 else 0.0
        sections.append(xyz(x * out, low + (top - low) * rise - droop, z * out))
    return loft(sections, needle, top=False)


def birch(seed: int, variant: int, detail: int, card: int) -> Soup:
    """A slender white-barked tree; `card` is the material of its cut-out sprays of leaves."""
    random = RandomStream(seed, 4, variant)
    high = random.number(8.0, 11.0)
    sway = random.uniform(4, -0.3, 0.3)
    path = [(0, -0.3, 0), (sway[0], 0.35 * high, sway[1]), (sway[2], 0.7 * high, sway[3]), (0, high, 0)]
    parts = [tube(path, [0.16, 0.12, 0.07, 0.02], 4 if detail == 0 else 7, "bark_birch")]
    count = (6, 14, 90, 300)[detail]
    normals = _directions(random, count)
    rise = high * (0.66 + 0.31 * normals[:, 1])
    reach = high * 0.17 * np.sqrt(random.uniform(count, 0.1, 1.0))
    middle = xyz(normals[:, 0] * reach, rise, normals[:, 2] * reach)
    cosine, sine = turn(random.uniform(count))
    size = random.uniform(count, 0.5, 0.9) * (2.2, 1.6, 0.9, 0.6)[detail]
    tip, roll = random.uniform(2 * count, -0.4, 0.4).reshape(2, count), random.uniform(count, -0.25, 0.25)
    right, up = xyz(cosine, roll, sine) * size[:, None], xyz(tip[0], 1.0, tip[1]) * size[:, None]
    left_edge, right_edge = middle - right, middle + right
    return join(
        [*parts, textured(np.stack([left_edge - up, right_edge - up, right_edge + up, left_edge + up], 1), card)]
    )


def leaf_texture(size: int = 128) -> NDArray[np.uint8]:
    """A spray of leaves (size, size, 4): sRGB, transparent between the leaves."""
    random = RandomStream(0, 8)
    x, y = grid(size, size)
    image = np.zeros((size, size, 4))
    image[..., :3] = (96.0, 128.0, 58.0)
    stem = np.abs(x - 0.5 - 0.08 * (y - 0.5)) < 0.012
    image[stem & (y > 0.12)] = (110.0, 92.0, 64.0, 255.0)
    cosine, sine = turn(random.uniform(34))
    for c, s, u, v, length, light in zip(
        cosine, sine, random.uniform(34, 0.14, 0.86), random.uniform(34, 0.14, 0.86), random.uniform(34, 0.07, 0.12),
        random.uniform(34, 0.75, 1.15), strict=True,
    ):  # fmt: skip
        a, b = (c * (x - u) + s * (y - v)) / length, (c * (y - v) - s * (x - u)) / length
        # Two parabolas that meet at the tips bound the leaf; its midrib is lighter.
        inside = np.abs(b) < 0.5 * (1.0 - a * a)
        shade = light * np.where(np.abs(b) < 0.06, 1.15, 1.0)
        rgb = np.minimum(255.0, np.array([104.0, 140.0, 62.0]) * shade[inside, None])
        image[inside] = np.insert(rgb, 3, 255.0, axis=1)
    return np.floor(image).astype(np.uint8)


def shrub(seed: int, variant: int, detail: int) -> Soup:
    """A low bush of two or three clumps."""
    random = RandomStream(seed, 5, variant)
    parts = []
    for _ in range(1 if detail <= 1 else 3):
        size = random.number(0.45, 0.75)
        offset = [random.number(-0.5, 0.5), 0.5 * size, random.number(-0.5, 0.5)]
        soup = triangles(blob(random, 1 if detail <= 2 else 2, 0.3), "leaf_deep")
        parts.append(soup.scaled([size, 0.8 * size, size]).translate(offset))
    return _shaded(join(parts), -0.3, 1.2, darkest=0.45)


def tuft(seed: int, variant: int, detail: int) -> Soup:
    """A tuft of grass: blades of one triangle, or two at the highest detail."""
    random = RandomStream(seed, 6, variant)
    count = 12 if detail <= 1 else 26 if detail == 2 else 60
    cosine, sine = turn(random.uniform(count))
    radius = random.uniform(count, 0.0, 0.22)
    foot = xyz(cosine * radius, -0.04, sine * radius)
    high, lean = random.uniform(count, 0.18, 0.45), random.uniform(count, 0.3, 0.9)
    side = xyz(-sine, 0.0, cosine) * 0.016
    tip = foot + xyz(cosine * high * lean, high, sine * high * lean)
    soup = triangles(np.stack([foot - side, tip, foot + side], 1), "grass" if variant % 2 else "fern")
    return _shaded(soup, -0.05, 0.3, darkest=0.5)


def rock(seed: int, variant: int, detail: int) -> Soup:
    """A boulder about a metre across, half in the ground."""
    random = RandomStream(seed, 7, variant)
    corners = sphere(1 if detail <= 1 else 2 if detail == 2 else 3)
    # Cuts by random planes give faces like those of broken stone.
    for normal, reach in zip(_directions(random, 16), random.uniform(16, 0.6, 0.9), strict=True):
        excess = np.clip(dot(corners, normal) - reach, 0.0, None)
        corners = corners - excess[..., None] * normal * 0.92
    kind = "rock_moss" if variant % 3 == 2 else "rock"
    size = random.uniform(3, 0.5, 0.9) * [1.0, 0.7, 1.0]
    return _shaded(triangles(corners, kind).scaled(size).translate([0.0, 0.12, 0.0]), -0.5, 0.6, darkest=0.6)


def planter(detail: int) -> Soup:
    """A round tub with a bush."""
    profile = [(0.5, 0.0), (0.62, 0.55), (0.54, 0.55), (0.5, 0.42)]
    tub = lathe(profile, 10 if detail < 2 else 18, "terracotta", bottom=False)
    return join([tub, shrub(11, 0, detail).scaled([0.8, 0.9, 0.8]).translate([0.0, 0.35, 0.0])])
