"""The forest: hills with a trail, under spruces, oaks and birches."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets import _vegetation as vegetation
from nearfar.datasets._palette import material, materials
from nearfar.datasets._random import Floats, RandomStream, turn, xyz
from nearfar.datasets._shapes import Soup, halves, join, quads, sheet
from nearfar.datasets._stage import Stage, placements

_MAX_TREES = 2_000_000
_AREA = 34.0
"""Area of land for each tree, square metres."""
_HORIZON = 3000.0


@dataclass(frozen=True)
class Land:
    """The shape of the land; its height at the origin is 0."""

    side: float
    """Side length of the wooded square, metres."""
    phases: Floats

    @classmethod
    def generate(cls, trees: int, seed: int) -> Land:
        """Make the land for a number of trees."""
        return cls(float(np.sqrt(max(trees, 60) * _AREA)), RandomStream(seed, 50).uniform(12))

    def height(self, x: Floats | float, z: Floats | float) -> Floats:
        """Height of the land at positions, metres."""
        return self._raw(np.asarray(x, float), np.asarray(z, float)) - self._raw(np.zeros(()), np.zeros(()))

    def _raw(self, x: Floats, z: Floats) -> Floats:
        rise = np.zeros(np.broadcast(x, z).shape)
        for k, (length, high) in enumerate(((260.0, 9.0), (140.0, 4.5), (61.0, 1.5), (23.0, 0.35), (11.0, 0.12))):
            along = turn((x + 0.35 * z) / length + self.phases[2 * k])[1]
            across = turn((z - 0.3 * x) / (1.17 * length) + self.phases[2 * k + 1])[1]
            rise = rise + 0.5 * high * (along + across)
        far = np.clip((np.sqrt(x * x + z * z) - 0.5 * self.side) / _HORIZON, 0.0, 1.0)
        return rise + 160.0 * far * far

    def trail(self, z: Floats | float) -> Floats:
        """Position of the trail: its x at a given z, metres; 0 at the origin."""
        places = np.asarray(z, float)
        return 5.0 * (turn(places / 90.0 + self.phases[10])[1] - turn(self.phases[10])[1])

    def off_trail(self, x: Floats, z: Floats) -> Floats:
        """Distance from the trail, metres."""
        return np.asarray(np.abs(x - self.trail(z)))


def forest(trees: int = 6000, seed: int = 0, detail: int = 2) -> Scene:
    """Make a forest on rolling land, with a trail through it, rocks, bushes and grass.

    The origin lies on the trail, and the ground there is at y = 0; the trail runs along z. Objects are called "land",
    "spruce_17", "oak_4", "birch_9", "rock_2", "bush_5" and "grass_31"; trees are numbered through all kinds. The
    birches' leaves are cut out of cards by their texture's alpha. ValueError for numbers out of range.

    Parameters
    ----------
    trees
        Number of trees, 1 to 2,000,000; the wooded land grows with it.
    seed
        0 to 2⁶³ − 1.
    detail
        0: trees of some twenty triangles. 1: a hundred. 2: about a thousand, with grass along the trail. 3: several
        thousand: with the default number of trees, tens of millions of triangles, nearly all of them in instances.
    """
    trees = check.integer("trees", trees, 1, _MAX_TREES)
    seed = check.integer("seed", seed, 0, 2**63 - 1)
    detail = check.integer("detail", detail, 0, 3)
    stage, land = Stage(), Land.generate(trees, seed)
    stage.once(surface(land, detail), "land")
    _plant(stage, land, trees, seed, detail)
    _undergrowth(stage, land, trees, seed, detail)
    return stage.build()


def _lines(land: Land, detail: int) -> Floats:
    """Break lines of the land's grid along one axis: even among the trees, increasingly wide towards the horizon."""
    spacing = max((14.0, 6.0, 3.0, 1.5)[detail], land.side / 700.0)
    half = 0.5 * land.side
    inner = np.linspace(-half, half, 2 * int(np.ceil(half / spacing)) + 1)
    steps = np.arange(1.0, 25.0) / 24.0
    outer = half + spacing * 24.0 * steps + (_HORIZON - 24.0 * spacing) * steps * steps * steps
    return np.concatenate([-outer[::-1], inner, outer])


def surface(land: Land, detail: int) -> Soup:
    """Make the land as one sheet, with columns that follow the trail."""
    lines = _lines(land, detail)
    across, z = np.meshgrid(np.sort(np.concatenate([lines[np.abs(lines) > 2.2], [-1.4, -0.4, 0.4, 1.4]])), lines)
    half = 0.5 * land.side
    bend = land.trail(z) * np.clip(1.0 - np.abs(across) / half, 0.0, 1.0)
    x = across + bend * np.clip(2.0 - np.abs(z) / half, 0.0, 1.0)
    shade = 0.86 + 0.07 * (turn(x / 17.0 + 0.3 * turn(z / 11.0)[1])[1] + turn(z / 14.0 + 0.2 * turn(x / 31.0)[1])[0])
    cells = sheet(xyz(x, land.height(x, z), z)).reshape(-1, 4, 3)
    middle = 0.25 * (cells[:, 0] + cells[:, 1] + cells[:, 2] + cells[:, 3])
    patch = turn(middle[:, 0] / 47.0 + 0.2 * turn(middle[:, 2] / 29.0)[1])[1] + turn(middle[:, 2] / 53.0)[0]
    floor = np.array(materials("moss_dark", "moss", "moss", "litter"), np.int32)
    kinds = floor[np.clip((patch + 2.0).astype(np.int64), 0, 3)]
    wood = np.maximum(np.abs(middle[:, 0]), np.abs(middle[:, 2])) < half
    kinds = np.where(wood, kinds, material("meadow"))
    edges = 0.5 * (across[:-1, 1:] + across[:-1, :-1]).reshape(-1)
    kinds[(np.abs(edges) < 1.4) & wood] = material("gravel")
    return quads(cells, kinds).tinted(halves(sheet(shade).reshape(-1, 4)))


def scatter(land: Land, count: int, clear: float, random: RandomStream, reach: float = 1.0e9) -> tuple[Floats, Floats]:
    """Choose `count` positions, one in each cell of a grid, `clear` metres off the trail and within `reach` metres."""
    half = 0.5 * land.side
    across = 2.0 * min(half, reach)
    extra = 1.25
    while True:
        rows = max(2, int(np.ceil(np.sqrt(count * extra * land.side / across))))
        columns = max(2, int(np.ceil(count * extra / rows)))
        number = np.arange(rows * columns)
        z = land.side * ((number // columns + random.uniform(len(number), 0.05, 0.95)) / rows - 0.5)
        x = across * ((number % columns + random.uniform(len(number), 0.05, 0.95)) / columns - 0.5)
        x = x + (land.trail(z) if across < land.side else 0.0)
        free = np.flatnonzero((land.off_trail(x, z) > clear) & (x * x + z * z > 9.0) & (np.abs(x) < half))
        if len(free) >= count:
            selected = np.sort(free[np.argsort(random.uniform(len(free)), kind="stable")[:count]])
            return x[selected], z[selected]
        extra *= 1.5


def _plant(stage: Stage, land: Land, trees: int, seed: int, detail: int) -> None:
    random = RandomStream(seed, 52)
    x, z = scatter(land, trees, 2.6, random)
    y, turns, sizes = land.height(x, z), random.uniform(trees), random.uniform(trees, 0.7, 1.25)
    # Trees of a kind stand in groups: slow waves plus random noise choose the kind.
    wet = turn(x / 170.0 + land.phases[3])[1] + turn(z / 130.0 + land.phases[4])[1] + random.uniform(trees, -1.1, 1.1)
    kinds: NDArray[np.int64] = np.where(wet < 0.45, 0, np.where(wet < 1.2, 1, 2))
    card = stage.material((1.0, 1.0, 1.0, 1.0), vegetation.leaf_texture(), cutoff=0.5)
    transforms = placements(x, y, z, turns, sizes)
    makers: tuple[tuple[str, int, Callable[..., Soup]], ...] = (
        ("spruce", 6, vegetation.conifer),
        ("oak", 4, vegetation.broadleaf),
        ("birch", 3, functools.partial(vegetation.birch, card=card)),
    )
    for kind, (name, variants, make) in enumerate(makers):
        variant = np.where(kinds == kind, random.integers(trees, variants), -1)
        stage.mixed(functools.partial(make, seed, detail=detail), variant, transforms, name)


def _undergrowth(stage: Stage, land: Land, trees: int, seed: int, detail: int) -> None:
    """Add rocks and bushes everywhere, and grass along the trail."""
    table: tuple[tuple[str, Callable[..., Soup], int, float, float, float, tuple[float, float]], ...] = (
        ("rock", vegetation.rock, 4, 0.06, 1.9, 1.0e9, (0.3, 1.6)),
        ("bush", vegetation.shrub, 3, 0.12, 2.2, 1.0e9, (0.7, 1.5)),
        ("grass", _sward, 4, (0.0, 0.0, 1.0, 3.0)[detail], 1.55, 14.0, (0.7, 1.5)),
    )
    for kind, (name, make, variants, per_tree, clear, reach, sizes) in enumerate(table):
        count = round(trees * per_tree) if detail >= 1 else 0
        if count:
            random = RandomStream(seed, 53, kind)
            x, z = scatter(land, count, clear, random, reach)
            transforms = placements(x, land.height(x, z), z, random.uniform(count), random.uniform(count, *sizes))
            stage.mixed(
                functools.partial(make, seed, detail=detail), random.integers(count, variants), transforms, name
            )


def _sward(seed: int, variant: int, detail: int) -> Soup:
    """Several tufts of grass side by side."""
    random = RandomStream(seed, 54, variant)
    tufts = []
    for k in range(5):
        offset = [random.number(-0.7, 0.7), 0.0, random.number(-0.7, 0.7)]
        tufts.append(vegetation.tuft(seed, 7 * variant + k, detail).translate(offset))
    return join(tufts)
