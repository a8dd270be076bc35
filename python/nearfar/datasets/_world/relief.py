"""Natural relief: height of the land without towns and roads, as a function of seed and position."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._random import Floats, step
from nearfar.datasets._world.noise import noise, noise_with_slopes

SEA_BED, SUMMIT = -180.0, 2600.0
"""Bounds of all heights, metres; the water's surface is at 0."""
_HOME, _DRY = 3000.0, 620.0
"""Distances from the world's centre within which the land is low, and without rivers, metres."""


def natural(seed: int, x: Floats, z: Floats) -> Floats:
    """Heights in metres at positions (N,): continents, mountains eroded into ridges, hills, valleys with rivers."""
    home, dry = _near(x, z, _HOME), _near(x, z, _DRY)
    shift = 420.0 * noise(seed, 1, x, z, 2700.0)
    px, pz = x + shift, z + 420.0 * noise(seed, 2, x, z, 2700.0)
    coast = 0.9 * noise(seed, 3, x, z, 41_000.0) + 0.4 * noise(seed, 4, x, z, 15_000.0)
    coast = coast + 0.17 * noise(seed, 5, px, pz, 5_600.0) + 0.05 * noise(seed, 6, px, pz, 1_700.0) + 0.1
    coast = coast + home * (0.16 - coast)
    range_ = noise(seed, 7, x, z, 21_000.0) + 0.4 * noise(seed, 8, px, pz, 7_000.0)
    mountain = step(-0.05, 0.5, range_) * step(0.04, 0.4, coast) * (1.0 - home)
    height = np.where(coast < 0.0, 210.0, 120.0) * coast
    river = np.abs(noise(seed, 9, px, pz, 8_300.0) + 0.12 * noise(seed, 10, px, pz, 1_300.0)) + 0.3 * dry
    bank = step(0.012, 0.30, river)
    height = height + bank * _hills(seed, px, pz, coast)
    high = np.flatnonzero(mountain > 0.0)
    if len(high):
        rise = mountain[high] * (0.06 + 0.94 * bank[high])
        height[high] = height[high] + rise * _ridges(seed, px[high], pz[high])
    land = step(0.0, 0.05, coast)
    height = height * (1.0 - 0.75 * land * (1.0 - step(0.01, 0.16, river)))
    bed = 1.0 - step(0.010, 0.022, river)
    height = height - land * bed * (np.maximum(height, 0.0) + 3.5)
    return np.clip(height, SEA_BED + 1.0, SUMMIT - 1.0)


def _near(x: Floats, z: Floats, reach: float) -> Floats:
    """Nearness of the world's centre: 1 there, a quarter at a distance `reach`."""
    falloff = 1.0 + (x * x + z * z) / (reach * reach)
    return 1.0 / (falloff * falloff)


def _hills(seed: int, x: Floats, z: Floats, coast: Floats) -> Floats:
    """Rolling hills, low on plains, smoother where they are steep."""
    rough = 0.4 + 0.8 * step(-0.2, 0.5, noise(seed, 20, x, z, 9_000.0))
    total, amplitude, length = np.zeros_like(x), 58.0, 1_900.0
    slope_x, slope_z = np.zeros_like(x), np.zeros_like(x)
    for octave in range(7):
        value, dx, dz = noise_with_slopes(seed, 21 + octave, x, z, length)
        steepness = amplitude / length
        slope_x, slope_z = slope_x + steepness * dx, slope_z + steepness * dz
        total = total + amplitude * value / (1.0 + 24.0 * (slope_x * slope_x + slope_z * slope_z))
        amplitude, length = 0.44 * amplitude, 0.47 * length
    return rough * (total + 14.0) * step(-0.1, 0.12, coast)


def _ridges(seed: int, x: Floats, z: Floats) -> Floats:
    """Mountains: ridges along zero lines of noise; octaves fade where the ground is steep, like eroded rock."""
    total, amplitude, length = np.zeros_like(x), 820.0, 6_200.0
    weight, slope = np.ones_like(x), np.zeros_like(x)
    for octave in range(9):
        value, dx, dz = noise_with_slopes(seed, 40 + octave, x, z, length)
        sign = np.where(value < 0.0, 1.0, -1.0)
        ridge = 1.0 + sign * value
        ridge = ridge * ridge
        slope = slope + (amplitude / length) * (amplitude / length) * (dx * dx + dz * dz)
        total = total + amplitude * weight * ridge / (1.0 + 1.1 * slope)
        weight = np.clip(1.25 * ridge - 0.1, 0.0, 1.0)
        amplitude, length = 0.46 * amplitude, 0.48 * length
    return total
