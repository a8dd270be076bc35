"""Run time against error of cube map look-ups and conversions, compared with NumPy, SciPy and OpenCV."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, Work, compare, comparisons, draw, greatest_error, print_limits
from benchmarks.harness.report import start, table
from nearfar._cubemap.lookup import Filter

Array = NDArray[Any]
SIZE = 512
DIRECTIONS = 1_000_000
FILTERS: tuple[Filter, ...] = ("linear", "cubic")
TIMED_FILTERS: tuple[Filter, ...] = ("linear", "nearest", "cubic")


def smooth(d: Array) -> Array:
    """Smooth function that fills the maps and that errors are measured against."""
    d = d / np.linalg.norm(d, axis=-1, keepdims=True)
    return np.asarray(np.sin(3 * d[..., 0] - d[..., 1]) + np.cos(2 * d[..., 2] + d[..., 1]))


def addresses(d: Array, size: int) -> tuple[Array, Array, Array]:
    """Face, column and row of directions, as NumPy users write it."""
    lengths = np.abs(d)
    axis = lengths.argmax(1)
    rows = np.arange(len(d))
    face = 2 * axis + (d[rows, axis] < 0)
    m = lengths[rows, axis]
    x, y, z = d.T
    u = np.choose(face, [-z, z, x, x, x, -x]) / m
    v = np.choose(face, [-y, -y, z, -z, -y, -y]) / m
    return face, (u + 1) * (size / 2) - 0.5, (v + 1) * (size / 2) - 0.5


def numpy_nearest(faces: Array, d: Array) -> Array:
    face, x, y = addresses(d, faces.shape[1])
    last = faces.shape[1] - 1
    i, j = (np.clip(np.rint(p), 0, last).astype(int) for p in (x, y))
    return np.asarray(faces[face, j, i])


def numpy_linear(faces: Array, d: Array) -> Array:
    face, x, y = addresses(d, faces.shape[1])
    last = faces.shape[1] - 1
    x, y = np.clip(x, 0, last), np.clip(y, 0, last)
    i, j = np.minimum(x.astype(int), last - 1), np.minimum(y.astype(int), last - 1)
    s, t = x - i, y - j
    if faces.ndim == 4:
        s, t = s[:, None], t[:, None]
    top = faces[face, j, i] * (1 - s) + faces[face, j, i + 1] * s
    return np.asarray(top * (1 - t) + (faces[face, j + 1, i] * (1 - s) + faces[face, j + 1, i + 1] * s) * t)


def scipy_spline(faces: Array, d: Array, order: int) -> Array:
    """Spline interpolation of stacked faces; positions within half a texel of an edge are clamped to their face."""
    size = faces.shape[1]
    face, x, y = addresses(d, size)
    positions = [face * size + np.clip(y, 0, size - 1), np.clip(x, 0, size - 1)]
    return np.asarray(map_coordinates(faces.reshape(6 * size, size), positions, order=order, mode="nearest"))


def cv2_remap(faces: Array, d: Array, interpolation: int, height: int = 1000) -> Array:
    size = faces.shape[1]
    face, x, y = addresses(d, size)
    rows = (face * size + np.clip(y, 0, size - 1)).astype(np.float32).reshape(height, -1)
    columns = np.clip(x, 0, size - 1).astype(np.float32).reshape(height, -1)
    image = faces.reshape(6 * size, size, *faces.shape[3:])
    result = cv2.remap(image, columns, rows, interpolation, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(result).reshape(len(d), *faces.shape[3:])


Lookup = Callable[[Array, Array], Array]


LOOKUPS: dict[str, Lookup] = {
    **{f"{OURS} {name}": partial(nf.cube_lookup, filter=name) for name in TIMED_FILTERS},
    "NumPy nearest": numpy_nearest,
    "NumPy linear": numpy_linear,
    "scipy order 1": partial(scipy_spline, order=1),
    "scipy order 3": partial(scipy_spline, order=3),
    "cv2.remap linear": partial(cv2_remap, interpolation=cv2.INTER_LINEAR),
    "cv2.remap cubic": partial(cv2_remap, interpolation=cv2.INTER_CUBIC),
}


def lookups(title: str, d: Array, *, channels: int = 1) -> str:
    """Table of look-ups in all directions; errors are root mean squares."""
    faces = smooth(nf.envmap_directions(SIZE)).astype(np.float32)
    truth = smooth(d.astype(np.float64))
    if channels > 1:
        faces = np.repeat(faces[..., None], channels, axis=3)
        truth = np.repeat(truth[:, None], channels, axis=1)

    def error(result: Array) -> float:
        return float(np.sqrt(np.mean((result - truth) ** 2)))

    jobs = {name: job for name, job in LOOKUPS.items() if channels == 1 or "scipy" not in name}
    cases = [Case(name, partial(job, faces, d), error) for name, job in jobs.items()]
    return compare(title, cases, work=Work(bytes=d.nbytes + truth.size * 4), unit="rms")


def seams() -> str:
    """Table of errors inside faces, and within half a texel of an edge or a corner."""
    rows = []
    for size in (64, SIZE):
        faces = smooth(nf.envmap_directions(size)).astype(np.float32)
        d = np.random.default_rng(1).uniform(-1, 1, (400_000, 3))
        near_corners = np.sign(d) + d / size
        d[::4], d[1::4, :2] = near_corners[::4], near_corners[1::4, :2]
        ordered = np.sort(np.abs(d), axis=1) / np.abs(d).max(1, keepdims=True)
        corner = ordered[:, 0] > 1 - 1 / size
        edge = (ordered[:, 1] > 1 - 1 / size) & ~corner
        truth = smooth(d)
        for name, job in LOOKUPS.items():
            error = job(faces, d) - truth
            inside, *seam = (float(np.sqrt(np.mean(error[mask] ** 2))) for mask in (~(edge | corner), edge, corner))
            rows.append([f"{size}²", name, inside, *seam, max(seam) / inside])
    header = "faces | lookup | inside {:.1e} | edges {:.1e} | corners {:.1e} | worst seam / inside {:.2f}"
    return table("Errors (rms) of lookups by where they are", header, rows)


def peer_mips(faces: Array, halve: Callable[[Array, int], Array]) -> list[Array]:
    """Mip levels, each computed from the previous one at half its size."""
    levels = [faces]
    while (size := levels[-1].shape[1] // 2) > 0:
        levels.append(halve(levels[-1], size))
    return levels


def numpy_halve(faces: Array, size: int) -> Array:
    """Unweighted means of 2 × 2 texels, which change the mean over the sphere."""
    return np.asarray(faces.reshape(6, size, 2, size, 2).mean((2, 4)))


def cv2_halve(faces: Array, size: int) -> Array:
    return np.stack([cv2.resize(face, (size, size), interpolation=cv2.INTER_AREA) for face in faces])


def mips() -> str:
    """Table of mip chains; the error is the difference of the last level's mean from the map's mean over the sphere."""
    faces = smooth(nf.envmap_directions(1024)).astype(np.float32)
    mean = float((faces * nf.cube_solid_angles(1024)).sum() / (4 * np.pi))

    def error(levels: list[Array]) -> float:
        return abs(float(levels[-1].mean()) - mean)

    cases = [
        Case(f"{OURS} cube_mips", lambda: nf.cube_mips(faces), error),
        Case("NumPy, 2 × 2", lambda: peer_mips(faces, numpy_halve), error),
        Case("cv2.resize", lambda: peer_mips(faces, cv2_halve), error),
    ]
    return compare("Mip chains of 6 × 1024²", cases, work=Work(bytes=faces.nbytes * 4 / 3))


def cones() -> str:
    """Table of cone look-ups (greatest texel within an angle); there is no peer, so only times are listed."""
    faces = smooth(nf.envmap_directions(SIZE)).astype(np.float32)
    lookup = partial(nf.cube_lookup, faces, np.random.default_rng(0).normal(size=(10_000, 3)), filter="max")
    cases = [Case(f"{OURS}, {texels} texels wide", partial(lookup, radius=texels / SIZE)) for texels in (2, 8, 32, 128)]
    return compare("Greatest texel within a cone around each of 10⁴ directions", cases)


def peer_convert(values: Array, width: int) -> Array:
    """Convert a cube to equirectangular: directions of all texels, then a look-up."""
    latitude = (0.5 - (np.arange(width // 2) + 0.5) / (width // 2)) * np.pi
    longitude = ((np.arange(width) + 0.5) / width - 0.5) * 2 * np.pi
    latitude, longitude = np.meshgrid(latitude, longitude, indexing="ij")
    cosine = np.cos(latitude)
    d = np.stack([cosine * np.sin(longitude), np.sin(latitude), -cosine * np.cos(longitude)], -1).reshape(-1, 3)
    return cv2_remap(values, d, cv2.INTER_LINEAR, width // 2).reshape(-1, width)


def peer_back(values: Array, size: int) -> Array:
    """Convert equirectangular to a cube, with an additional column on each side for the seam."""
    height, width = values.shape
    x, y, z = np.moveaxis(nf.envmap_directions(size), -1, 0)
    columns = (np.arctan2(x, -z) / (2 * np.pi) + 0.5) * width + 0.5
    rows = (0.5 - np.arctan2(y, np.hypot(x, z)) / np.pi) * height - 0.5
    padded = np.pad(values, ((0, 0), (1, 1)), mode="wrap")
    columns, rows = (p.reshape(6 * size, size).astype(np.float32) for p in (columns, rows))
    return np.asarray(cv2.remap(padded, columns, rows, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)).reshape(
        6, size, size
    )


def conversions() -> str:
    """Table of conversions with greatest errors; peers break at seams and poles."""
    cube = smooth(nf.envmap_directions(SIZE)).astype(np.float32)
    shape = (1024, 2048)
    flat = smooth(nf.envmap_directions(shape, layout="equirectangular")).astype(np.float32)

    def cases(values: Array, truth: Array, peer: Callable[[], Array], **how: Any) -> list[Case]:
        error = greatest_error(truth)
        ours = [Case(f"{OURS} {n}", partial(nf.convert_envmap, values, **how, filter=n), error) for n in FILTERS]
        return [*ours, Case("NumPy and cv2.remap", peer, error)]

    layouts: dict[str, Any] = {"source": "cube", "target": "equirectangular"}
    from_cube = cases(cube, flat, lambda: peer_convert(cube, 2048), **layouts, size=shape)
    layouts = {"source": "equirectangular", "target": "cube"}
    to_cube = cases(flat, cube, lambda: peer_back(flat, SIZE), **layouts, size=SIZE)
    first_table = compare("Cube of 6 × 512² to equirectangular of 2048 × 1024", from_cube, unit="greatest")
    return f"{first_table}\n{compare('Equirectangular of 2048 × 1024 to cube of 6 × 512²', to_cube, unit='greatest')}"


def main() -> None:
    start(__doc__)
    print_limits()
    random = np.random.default_rng(0).normal(size=(DIRECTIONS, 3)).astype(np.float32)
    print(lookups("10⁶ random directions in faces of 512², float32", random), flush=True)
    print(lookups("10⁶ random directions in faces of 512², float64", random.astype(np.float64)), flush=True)
    print(lookups("10⁶ random directions in RGB faces of 512²", random, channels=3), flush=True)
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(100, 1), size=(1000, 1000))
    coherent = camera.rays()[1].reshape(-1, 3).astype(np.float32)
    print(lookups("10⁶ directions of a picture in faces of 512²", coherent), flush=True)
    print(seams(), flush=True)
    print(mips(), flush=True)
    print(cones(), flush=True)
    print(conversions())
    titles = ("10⁶ random directions in faces of 512², float32", "Cube of 6 × 512² to equirectangular of 2048 × 1024")
    draw([comparisons[title] for title in titles], "cube maps")


if __name__ == "__main__":
    main()
