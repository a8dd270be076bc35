"""Octahedral impostors: clusters of far triangles as pictures from the directions of an octahedral grid."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

import nearfar as nf
from benchmarks.harness.pictures import blocks
from benchmarks.impostor.methods import place as places
from benchmarks.impostor.methods.meshes import Visible, simplified
from benchmarks.impostor.methods.place import Place, fill
from nearfar import _core
from nearfar._base import webp
from nearfar._scene.joined import join_scenes

SPREAD = 0.25
"""Greatest side of a cluster's cell as a share of its distance from the centre."""

LONGEST = 2.0
"""Triangles longer than so many sides of their cell, such as ground and long walls, stay geometry."""

QUALITY = 80

GRID = 32
"""Squares along each side of the octahedral map: neighbouring directions are 3 to 6 degrees apart. With 24, 48 and 96
squares two pictures of the city differed by less than 0.5 dB at equal bytes."""

CUTOFF = 0.5

LARGEST = 1024
"""Greatest side of a card, texels."""


@dataclass(frozen=True, eq=False)
class Cluster:
    """Triangles of one cell, and the directions of the grid from which users of the region see it."""

    scene: nf.Scene
    points: NDArray[np.float64]
    """Corners of its triangles (N, 3)."""
    middle: NDArray[np.float64]
    radius: float
    distance: float
    """Distance of the middle from the centre of the region, metres."""
    frames: list[int]


@dataclass(frozen=True, eq=False)
class Card:
    """Picture of a cluster from one direction, and where it hangs."""

    texels: NDArray[np.uint8]
    """(h, w, 4) sRGB and alpha."""
    corners: NDArray[np.float64]
    """World positions (4, 3) of its corners: upper left, lower left, lower right, upper right."""
    direction: NDArray[np.float64]
    """Unit vector towards the viewer."""


def grid(count: int) -> NDArray[np.float64]:
    """Unit directions (N², 3) of the octahedral map of the sphere, at the middles of N × N squares."""
    edge = (np.arange(count) + 0.5) / count * 2.0 - 1.0
    u, v = (part.ravel() for part in np.meshgrid(edge, edge))
    y = 1.0 - np.abs(u) - np.abs(v)
    fold = np.maximum(-y, 0.0)
    ways = np.column_stack([u - np.copysign(fold, u), y, v - np.copysign(fold, v)])
    return np.asarray(ways / np.linalg.norm(ways, axis=1, keepdims=True))


def clusters(place: Place, ways: NDArray[np.float64]) -> tuple[list[Cluster], NDArray[np.bool_]]:
    """Divide the far triangles that probes see into cells; return them and a mask (T,) of those that stay geometry.

    Cells of an octree are as large as `SPREAD` allows. A frame belongs to a cluster if it is the nearest one for a user
    of the region; the others, which engines store for all directions, are left out.
    """
    seen = np.flatnonzero(place.sample_counts > 0)
    corners = place.scene.triangles()[seen].astype(np.float64) + place.scene.origin
    middles = corners.mean(axis=1)
    distance = np.linalg.norm(middles - place.center, axis=1)
    side = 2.0 ** np.floor(np.log2(SPREAD * np.maximum(distance, place.r2)))
    is_long = (corners.max(axis=1) - corners.min(axis=1)).max(axis=1) > LONGEST * side
    keys = np.column_stack([np.floor(middles / side[:, None]), side])
    cells, cell_of = np.unique(keys[~is_long], axis=0, return_inverse=True)
    users = np.array(place.probes())
    number_of = np.cumsum(place.sample_counts > 0) - 1
    order = np.argsort(cell_of, kind="stable")
    parts = np.split(seen[~is_long][order], np.flatnonzero(np.diff(cell_of[order])) + 1)
    found = []
    for part in parts if len(cells) else []:
        scene = place.visible.subset(triangles=number_of[part])
        points = scene.triangles().reshape(-1, 3).astype(np.float64) + scene.origin
        low, high = points.min(axis=0), points.max(axis=0)
        middle = 0.5 * (low + high)
        views = users - middle
        views /= np.linalg.norm(views, axis=1, keepdims=True)
        frames = np.unique(np.argmax(views @ ways.T, axis=1)).tolist()
        distance_of = float(np.linalg.norm(middle - place.center))
        found.append(Cluster(scene, points, middle, float(np.linalg.norm(high - middle)), distance_of, frames))
    kept = np.zeros(place.scene.triangle_count, np.bool_)
    kept[seen[is_long]] = True
    return found, kept


def card(cluster: Cluster, way: NDArray[np.float64], density: float) -> Card | None:
    """Draw a cluster by parallel rays from a direction; `density` is in texels per radian for the region's centre.

    The card hangs at the mean depth of what it shows, which halves its parallax beside one through the middle.
    """
    up = (0.0, 1.0, 0.0) if abs(way[1]) < 0.99 else (1.0, 0.0, 0.0)
    right_way = np.cross(np.array(up), way)
    right_way /= np.linalg.norm(right_way)
    up_way = np.cross(way, right_way)
    place = (cluster.points - cluster.middle) @ np.column_stack([right_way, up_way])
    texel = cluster.distance / density
    low, high = np.floor(place.min(axis=0) / texel).astype(int), np.ceil(place.max(axis=0) / texel).astype(int) + 1
    width, height = np.minimum(high - low, LARGEST).tolist()
    left, bottom = (low * texel).tolist()
    fov = nf.Orthographic(left, left + width * texel, bottom, bottom + height * texel)
    eye = cluster.middle + way * (cluster.radius + 1.0)
    camera = nf.Camera.look_at(eye, cluster.middle, fov=fov, size=(2 * width, 2 * height), up=up)
    frame = nf.render(cluster.scene, camera, channels=("color", "range"))
    distance = blocks(frame.require("range"), 2).swapaxes(1, 2).reshape(height, width, 4)
    color = blocks(frame.require("color"), 2).swapaxes(1, 2).reshape(height, width, 4, 3)
    is_hit = np.isfinite(distance)
    shown = is_hit.sum(axis=2)
    if not shown.any():
        return None
    mean = (color * is_hit[..., None]).sum(axis=2) / np.maximum(shown, 1)[..., None]
    # Filters mix shown texels with others, which have the colour of the nearest one shown.
    nearest = distance_transform_edt(shown == 0, return_distances=False, return_indices=True)
    mean = mean[tuple(nearest)]
    codes = _core.encode_srgb(np.ascontiguousarray(mean, np.float32)).reshape(height, width, 3)
    alpha = np.where(shown >= 2, 255, 0).astype(np.uint8)
    origin = eye - way * float(distance[is_hit].mean())
    x, y = left + texel * width * np.array([0, 0, 1, 1]), bottom + texel * height * np.array([1, 0, 0, 1])
    return Card(np.dstack([codes, alpha]), origin + x[:, None] * right_way + y[:, None] * up_way, way)


def pack(cards: list[Card], width: int) -> tuple[NDArray[np.uint8], list[tuple[int, int]]]:
    """Put the cards into rows of one picture, each with a ring that repeats its border; return it and their places."""
    order = sorted(range(len(cards)), key=lambda number: -cards[number].texels.shape[0])
    spots, x, y, row = [(0, 0)] * len(cards), 0, 0, 0
    for number in order:
        height, length = cards[number].texels.shape[:2]
        if x + length + 2 > width:
            x, y, row = 0, y + row, 0
        row = max(row, height + 2)
        spots[number] = (y + 1, x + 1)
        x += length + 2
    picture = np.zeros((y + row, width, 4), np.uint8)
    for part, (top, left) in zip(cards, spots, strict=True):
        height, length = part.texels.shape[:2]
        ring = np.pad(part.texels, ((1, 1), (1, 1), (0, 0)), mode="edge")
        picture[top - 1 : top + height + 1, left - 1 : left + length + 1] = ring
    return picture, spots


@dataclass(frozen=True, eq=False)
class Octahedral:
    """Cards of all clusters, of which each user sees those from the nearest directions."""

    cards: dict[int, dict[int, int]]
    """Number of the card of each cluster and frame."""
    clusters: list[Cluster]
    all_cards: list[Card]
    atlas: NDArray[np.uint8]
    spots: list[tuple[int, int]]
    ways: NDArray[np.float64]
    kept: nf.Scene | None
    bytes: int
    setting: str
    _scenes: dict[Any, nf.Scene] = field(default_factory=dict)

    @property
    def triangles(self) -> int:
        """Number of triangles that are drawn for the far part."""
        return 2 * len(self.cards) + (0 if self.kept is None else self.kept.triangle_count)

    def choose(self, user: nf.Camera) -> list[int]:
        """Numbers of the cards that a user sees."""
        numbers = []
        for cluster, by_frame in self.cards.items():
            view = np.subtract(user.position, self.clusters[cluster].middle)
            frames = list(by_frame)
            numbers.append(by_frame[frames[int(np.argmax(self.ways[frames] @ view))]])
        return numbers

    def scene(self, numbers: list[int]) -> nf.Scene:
        """Make a scene of some cards, by number."""
        height, width = self.atlas.shape[:2]
        build = nf.SceneBuilder()
        material = build.material((1, 1, 1, 1), self.atlas, CUTOFF, unlit=True)
        corners, uvs = [], []
        for number in numbers:
            (top, left), (rows, columns) = self.spots[number], self.all_cards[number].texels.shape[:2]
            corners.append(self.all_cards[number].corners)
            x, y = np.array([left, left, left + columns, left + columns]), np.array([top, top + rows, top + rows, top])
            uvs.append(np.column_stack([x / width, 1.0 - y / height]))
        faces = (4 * np.arange(len(numbers))[:, None, None] + [[0, 1, 2], [0, 2, 3]]).reshape(-1, 3)
        mesh = build.mesh(np.concatenate(corners), faces.astype(np.uint32), material=material, uvs=np.concatenate(uvs))
        build.instance(mesh, name="cards")
        return build.build()

    def picture(self, place: Place, user: nf.Camera) -> tuple[nf.Frame, NDArray[np.bool_]]:
        """Draw near and far part; see `Method`."""
        numbers = self.choose(user)
        cards = self.scene(numbers)
        scene = cards if self.kept is None else join_scenes([cards, self.kept])
        frame = places.draw_scene(scene, user, "face_id")
        points = places.points_of(frame)
        owner = frame.require("face_id") // 2
        is_card = (owner >= 0) & (owner < len(numbers))
        ways = np.array([self.all_cards[number].direction for number in numbers])[owner[is_card]]
        points[is_card] = places.move_along(place.far, points[is_card], ways)
        return place.compose(user, places.Far(frame.require("color"), frame.require("range"), points))


def octahedral(place: Place, *, triangles: int, budget: int, count: int = GRID) -> Octahedral:
    """Make the cards with the finest texels that keep a budget of bytes; long triangles stay geometry, simplified."""
    ways = grid(count)
    groups, is_kept = clusters(place, ways)
    kept, kept_bytes = None, 0
    if is_kept.any():
        rest = Visible(place, is_kept)
        made = simplified(place, rest, "meshoptimizer", triangles=max(triangles - 2 * len(groups), 100))
        kept, kept_bytes = made.mesh, made.bytes

    def make(density: float) -> Octahedral:
        all_cards: list[Card] = []
        numbers: dict[int, dict[int, int]] = defaultdict(dict)
        for number, group in enumerate(groups):
            for frame in group.frames:
                made = card(group, ways[frame], density)
                if made is not None:
                    numbers[number][frame] = len(all_cards)
                    all_cards.append(made)
        area = sum((part.texels.shape[0] + 2) * (part.texels.shape[1] + 2) for part in all_cards)
        atlas, spots = pack(all_cards, max(1024, int(np.sqrt(area))))
        data = webp_of(atlas)
        text = (
            f"{len(numbers):,} clusters, {len(all_cards):,} cards of a grid of {count}², "
            f"{np.radians(density):.1f} texels a degree, {0 if kept is None else kept.triangle_count:,} triangles kept"
        )
        size = len(data) + kept_bytes + 12 * len(all_cards)
        return Octahedral(dict(numbers), groups, all_cards, atlas, spots, ways, kept, size, text)

    return fill(make, lambda made: made.bytes, budget, 30.0, 900.0, first=450.0)  # type: ignore[no-any-return]


def webp_of(atlas: NDArray[np.uint8]) -> bytes:
    return webp.encode(atlas, QUALITY)
