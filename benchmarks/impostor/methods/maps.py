"""One cube map: the published methods, and a map with range that is reprojected for each user."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.impostor.methods import place as places
from benchmarks.impostor.methods.place import Floats, Place, fill, fine
from nearfar.stream import _map_files as codec

QUALITY = 80
"""Quality of WebP, as for the textures of impostors."""

BAKE_SAMPLES = 4

Kind = Literal["conventional", "continuous", "chosen radii"]
KINDS: tuple[Kind, ...] = get_args(Kind)

SMALLEST, LARGEST = 16, 1280
"""Least and greatest width of a face, texels. 1280 are 11 a degree in the middle, as many as pixels."""


@dataclass(frozen=True, eq=False)
class CubeMap:
    """Method of Popescu et al. (2022), whose map has gone through WebP."""

    reduced: nf.ReducedScene
    bytes: int
    setting: str
    triangles: int = 0

    def picture(self, place: Place, user: nf.Camera) -> tuple[nf.Frame, NDArray[np.bool_]]:
        """Draw near and far part; see `Method`."""
        frame = self.reduced.render(fine(user), user=user.position, channels=("color", "position"))
        away = frame.require("position") + np.subtract(frame.origin, place.center)
        return frame, ~(np.hypot(away[..., 0], away[..., 2]) <= place.r2)


def compress(color: Floats) -> tuple[Floats, int]:
    """Encode faces (6, S, S, 3) as WebP; return what a reader decodes, and the bytes."""
    size = color.shape[1]
    files = [codec.encode_color(face, QUALITY) for face in color]
    return np.stack([codec.decode_color(data, (size, size)) for data in files]), sum(map(len, files))


def cube_maps(place: Place, budget: int) -> dict[Kind, CubeMap]:
    """Make all three methods with one map, whose faces are as great as a budget of bytes allows."""
    settings: dict[str, Any] = {"samples": BAKE_SAMPLES, "channels": ("color", "range")}

    def make(size: float) -> tuple[nf.ReducedScene, int]:
        reduced = nf.reduce(
            place.scene, center=place.center, r1=0.6 * place.r2, r2=place.r2, face_size=round(size), **settings
        )
        assert reduced.env is not None
        color, count = compress(reduced.env.color)
        env = nf.EnvMap(reduced.env.center, color, reduced.env.range)
        zones, counts = reduced.partition, reduced._counts
        return nf.ReducedScene(reduced.scene, zones, env, morph="blend", boundary="r2", counts=counts), count

    reduced, count = fill(make, lambda made: float(made[1]), budget, SMALLEST, LARGEST)
    assert reduced.env is not None
    # Farther from the centre the morph would fold the picture.
    reach = min(place.reach, 0.47 * place.r2)
    chosen = nf.choose_radii(place.scene, place.center, r2=place.r2, reach=reach).r1
    kinds: dict[Kind, nf.ReducedScene] = {
        "conventional": reduced.with_morph("none"),
        "continuous": reduced,
        "chosen radii": reduced.with_r1(chosen),
    }
    size = f"6 × {reduced.env.face_size}² texels"
    return {
        kind: CubeMap(shown, count, size + ("" if shown.morph == "none" else f", r1 = {shown.r1:.3g} m"))
        for kind, shown in kinds.items()
    }


def direction(face: NDArray[np.int64], u: NDArray[Any], v: NDArray[Any]) -> NDArray[np.float64]:
    """Directions (N, 3), one unit along the face's axis, to coordinates from −1 to 1 to the right and down."""
    one = np.ones_like(u, np.float64)
    ways = [(one, -v, -u), (-one, -v, u), (u, one, v), (u, -one, -v), (u, -v, one), (-u, -v, -one)]
    return np.asarray(np.select([(face == number)[..., None] for number in range(6)], [np.stack(w, -1) for w in ways]))


def corner_directions(size: int) -> NDArray[np.float64]:
    """Directions (6, S + 1, S + 1, 3) to the corners of the texels, one unit along the face's axis."""
    face, row, column = np.indices((6, size + 1, size + 1))
    return direction(face, 2.0 * column / size - 1.0, 2.0 * row / size - 1.0)


@dataclass(frozen=True, eq=False)
class Relief:
    """Corners of a map's texels at their ranges, and which texels lie across an edge of depth."""

    directions: NDArray[np.float64]
    depth: NDArray[np.float64]
    """(6, S + 1, S + 1) inverse of the distance along the face's axis, 1/m; 0 for the sky."""
    is_cut: NDArray[np.bool_]
    """(6, S, S)."""
    bytes: int

    @property
    def quads(self) -> NDArray[np.float64]:
        """Inverse distances of the corners of each texel (6, S, S, 4), around it."""
        w = self.depth
        return np.stack([w[:, :-1, :-1], w[:, 1:, :-1], w[:, 1:, 1:], w[:, :-1, 1:]], axis=-1)


def relief(place: Place, size: int, *, pixels: float = 2.0, rounding: float = 0.5) -> Relief:
    """Measure and encode the ranges of the texels' corners.

    A step is an edge of depth if users see it as more than `pixels` and no plane on either side continues across it.
    Ranges are rounded by at most `rounding` pixels of the farthest user.
    """
    directions = corner_directions(size)
    lengths = np.linalg.norm(directions, axis=-1)
    rays = (directions / lengths[..., None]).reshape(-1, 3)
    ranges = nf.cast_rays(place.far, place.center, rays).t_hit.reshape(lengths.shape)
    least = float(ranges.min(initial=np.inf, where=np.isfinite(ranges)))
    scale = codec.RangeScale.fit(ranges, place.tolerance(rounding) * min(least, 1e6))
    codes = scale.codes(ranges)
    count = len(codec.encode_ranges(codes, None, np.ones(codes.shape, np.bool_), _all_tiles(), size + 1, scale.step))
    depth = lengths / scale.ranges(codes)
    tolerance = place.tolerance(pixels)
    jumps_down, jumps_right = _jumps(depth, tolerance), _jumps(depth.transpose(0, 2, 1), tolerance).transpose(0, 2, 1)
    is_cut = jumps_down[:, :, 1:] | jumps_down[:, :, :-1] | jumps_right[:, 1:] | jumps_right[:, :-1]
    return Relief(directions, depth, is_cut, count)


def _all_tiles() -> NDArray[np.int64]:
    return np.arange(6)


def _jumps(depth: NDArray[np.float64], tolerance: float) -> NDArray[np.bool_]:
    """Whether depth jumps between each corner and the next one below (6, S, S + 1)."""
    steps = np.diff(depth, axis=1)
    before, after = np.roll(steps, 1, axis=1), np.roll(steps, -1, axis=1)
    before[:, 0], after[:, -1] = after[:, 0], before[:, -1]
    touches_sky = (depth[:, 1:] == 0) != (depth[:, :-1] == 0)
    jumps = np.minimum(np.abs(steps - before), np.abs(steps - after)) > tolerance
    return np.asarray(jumps | touches_sky, np.bool_)


@dataclass(frozen=True, eq=False)
class Reprojected:
    """Map whose colours are projected from the centre onto a mesh."""

    mesh: nf.Scene
    color: Floats
    """(6, S, S, 3)."""
    constant: Floats
    """Colours (K, 3) of the last K triangles, which fill holes."""
    bytes: int
    setting: str

    @property
    def triangles(self) -> int:
        """Number of triangles that are drawn for the far part."""
        return self.mesh.triangle_count

    def picture(self, place: Place, user: nf.Camera) -> tuple[nf.Frame, NDArray[np.bool_]]:
        """Draw near and far part; see `Method`."""
        frame = nf.render(self.mesh, fine(user), channels=("range", "face_id"))
        points = places.points_of(frame)
        is_hit = np.isfinite(points[..., 0])
        color = np.zeros((*is_hit.shape, 3), np.float32)
        color[is_hit] = nf.cube_lookup(self.color, points[is_hit] - place.center, filter="linear")
        number = frame.require("face_id") - (self.triangles - len(self.constant))
        color[number >= 0] = self.constant[number[number >= 0]]
        shown = places.baked_at(place.far, points, place.center)
        return place.compose(user, places.Far(color, frame.require("range"), shown))


def bake_color(place: Place, size: int) -> Floats:
    """Bake the colours of the far part as the centre sees them."""
    faces = []
    for face in range(6):
        camera = nf.Camera(place.center, fov=nf.CubeFace(face), size=(size, size))
        faces.append(nf.render(place.far, camera, samples=BAKE_SAMPLES, channels=("color",)).require("color"))
    return np.stack(faces)


def reprojected(place: Place, budget: int) -> Reprojected:
    """Make a mesh of two triangles for each texel, torn at edges of depth, with the largest faces for a budget.

    Holes beside a torn edge are filled from the farthest neighbour: a sheet from the edge to the surface behind it has
    that surface's colour. A texel across an edge that is nearer with half of its corners or more is drawn there, too.
    """

    def make(size: float) -> Reprojected:
        edge = round(size)
        shape = relief(place, edge)
        color, count = compress(bake_color(place, edge))
        mesh, constant = _texel_mesh(place, shape, color)
        return Reprojected(mesh, color, constant, count + shape.bytes, f"6 × {edge}² texels with range")

    return fill(make, lambda made: made.bytes, budget, SMALLEST, LARGEST, first=1024.0)  # type: ignore[no-any-return]


def _texel_mesh(place: Place, shape: Relief, color: Floats) -> tuple[nf.Scene, Floats]:
    w = shape.quads
    is_sky = (w == 0).all(axis=-1)
    directions = np.stack(
        [shape.directions[:, a : a + w.shape[1], b : b + w.shape[1]] for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))],
        axis=3,
    )
    whole = ~shape.is_cut & ~is_sky
    grid = np.arange(shape.depth.size).reshape(shape.depth.shape)
    corners = np.stack([grid[:, :-1, :-1], grid[:, 1:, :-1], grid[:, 1:, 1:], grid[:, :-1, 1:]], axis=-1)
    depth = np.maximum(shape.depth, 1e-9)
    vertices = [(shape.directions / depth[..., None]).reshape(-1, 3)]
    quads = [corners[whole]]
    # Torn texels: corners in front of the greatest gap are near.
    torn = shape.is_cut & ~is_sky
    depths, rays = w[torn], directions[torn]
    order = np.sort(depths, axis=1)
    gap = np.argmax(np.diff(order, axis=1), axis=1)
    rows = np.arange(len(gap))
    is_near = depths > 0.5 * (order[rows, gap] + order[rows, gap + 1])[:, None]
    mean = (depths * is_near).sum(axis=1) / is_near.sum(axis=1)
    front = np.where(is_near, depths, mean[:, None])[is_near.sum(axis=1) >= 2]
    front_rays = rays[is_near.sum(axis=1) >= 2]
    has_back = depths.min(axis=1) > 0
    back, back_rays = depths[has_back], rays[has_back]
    start = len(vertices[0])
    for part_depths, part_rays in ((front, front_rays), (back, back_rays)):
        vertices.append((part_rays / part_depths[..., None]).reshape(-1, 3))
        quads.append(start + np.arange(part_depths.size).reshape(-1, 4))
        start += part_depths.size
    faces = np.concatenate(quads)[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)
    constant = np.repeat(_colors_behind(w, torn, color)[torn][has_back], 2, axis=0)
    used, numbers = np.unique(faces, return_inverse=True)
    world = np.concatenate(vertices)[used] + place.center
    return nf.Scene.from_arrays(world.astype(np.float32), numbers.reshape(-1, 3).astype(np.uint32)), constant


def _colors_behind(quads: NDArray[np.float64], torn: NDArray[np.bool_], color: Floats) -> Floats:
    """Return for each texel the colour of the farthest whole texel among its 24 neighbours, else its own."""
    result, least = color.copy(), np.full(torn.shape, np.inf)
    mean = np.where(torn | (quads.min(axis=-1) == 0), np.inf, quads.mean(axis=-1))
    for down in range(-2, 3):
        for right in range(-2, 3):
            other = np.roll(mean, (down, right), axis=(1, 2))
            is_farther = torn & (other < least)
            least[is_farther] = other[is_farther]
            result[is_farther] = np.roll(color, (down, right), axis=(1, 2))[is_farther]
    return result
