"""Buildings: tiers of four façades and a roof, as prototypes that a city places many times."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nearfar.datasets import _roofs as roofs
from nearfar.datasets._palette import materials
from nearfar.datasets._random import Floats, RandomStream
from nearfar.datasets._shapes import Soup, boxes, join
from nearfar.datasets._styles import HIGH_STYLES, ROW_STYLES, TOWER_STYLES, Style
from nearfar.datasets._walls import Paint, walls

# Depth of walls below the ground in metres, so that no wall ends at ground level.
_FOOT = 0.4
_DECKS = materials("roof_gravel", "roof_felt", "concrete", "roof_gravel")
_TILES = materials("roof_tile", "roof_tile_dark", "roof_slate", "roof_tile")


@dataclass(frozen=True, order=True)
class Kind:
    """Parameters of a prototype; equal kinds are the same building.

    Width and depth are in decimetres; `form` is 0 low, 1 middle, 2 high, 3 tower; `place` is 0 between neighbours,
    1 with a street on its right, 2 on its left, 3 free on all sides; `variant` numbers buildings of the same kind.
    """

    width: int
    depth: int
    form: int
    place: int
    variant: int


# Faces of each place, from the front counter-clockwise, and the sides against neighbours.
_FACES = (
    ("street", "party", "yard", "party"), ("street", "street", "yard", "party"), ("street", "party", "yard", "street"),
    ("street", "street", "street", "street"),
)  # fmt: skip
_PARTY = ("+x -x", "-x", "+x", "")
_STOREYS = ((2, 4), (5, 7), (8, 13), (17, 38))


@dataclass(frozen=True)
class Design:
    """Random choices made once for a building."""

    kind: Kind
    style: Style
    paint: Paint
    shops: bool
    storeys: int
    detail: int


@dataclass(frozen=True)
class Tier:
    """A part of a building between two heights, set back from the part below."""

    width: float
    depth: float
    rows: Floats
    """Heights of the storeys' edges, metres; the last one is the top of a blank band."""
    faces: tuple[str, ...]
    first: bool
    last: bool


def building(kind: Kind, seed: int, detail: int) -> Soup:
    """Build a building on the ground y = 0 around the y axis, its front towards +z."""
    random = RandomStream(seed, 1, kind.width, kind.depth, kind.form, kind.place, kind.variant)
    style = random.pick((ROW_STYLES, ROW_STYLES, HIGH_STYLES, TOWER_STYLES)[kind.form])
    low, high = _STOREYS[kind.form]
    storeys = low + int(random.integers(1, high - low + 1)[0])
    shops = kind.form >= 1 or random.chance(0.3)
    design = Design(kind, style, Paint.pick(style, random), shops, storeys, detail)
    return join(
        soup for tier in _tiers(design, random) for part in (_walls, _roof) for soup in part(tier, design, random)
    )


def _tiers(design: Design, random: RandomStream) -> list[Tier]:
    sizes = _sizes(0.1 * design.kind.width, 0.1 * design.kind.depth, design.storeys, design.kind.form, random)
    tiers: list[Tier] = []
    floor = 0.0
    for number, (width, depth, count) in enumerate(sizes):
        first = number == 0
        ground = design.style.storey + (1.0 if first else 0.0)
        heights = floor + ground + design.style.storey * np.arange(count)
        # Walls start inside the part below, so that they never end on its surface.
        rows = np.concatenate([[-_FOOT if first else floor - 0.3], heights, [heights[-1] + 0.6]])
        faces = _FACES[design.kind.place if first else 3]
        tiers.append(Tier(width, depth, rows, faces, first, number == len(sizes) - 1))
        floor = float(rows[-1]) - 0.15
    return tiers


def _sizes(width: float, depth: float, storeys: int, form: int, random: RandomStream) -> list[tuple[float, float, int]]:
    """Width, depth and storeys of each tier, from below."""
    if form < 2 or storeys < 8 or (form == 2 and random.chance(0.6)):
        return [(width, depth, storeys)]
    if form == 2:
        return [(width, depth, storeys - 2), (width - 4.4, depth - 4.4, 2)]
    base, shrink = int(random.integers(1, 4)[0]) + 2, random.number(3.0, 6.0)
    middle = (width - shrink, depth - shrink)
    if random.chance(0.45):
        return [(width, depth, base), (*middle, storeys - base)]
    upper = int((storeys - base) * random.number(0.25, 0.45))
    return [(width, depth, base), (*middle, storeys - base - upper), (middle[0] - 5.0, middle[1] - 5.0, upper)]


def _walls(tier: Tier, design: Design, random: RandomStream) -> list[Soup]:
    size, faces = (tier.width, tier.depth), (tier.faces, design.shops, tier.first)
    return walls(size, tier.rows, faces, design.style, design.paint, random, design.detail)


def _roof(tier: Tier, design: Design, random: RandomStream) -> list[Soup]:
    top = float(tier.rows[-1])
    if tier.last and design.style.pitched and design.storeys <= 5:
        return _pitched(tier, top, design, random)
    if design.detail == 0:
        return [roofs.deck(tier.width + 0.2, tier.depth + 0.2, top, random.pick(_DECKS))]
    paint, cornice = design.paint, design.style.cornice
    edge = paint.trim if cornice == "moulded" else paint.wall
    party = _PARTY[design.kind.place] if tier.first else ""
    soups = [
        roofs.parapet(tier.width, tier.depth, top, cornice, edge, party),
        roofs.deck(tier.width, tier.depth, top - 0.05, random.pick(_DECKS)),
    ]
    if not tier.last:
        return soups
    tower = design.kind.form == 3
    if tower:
        x, z = 0.25 * tier.width, 0.25 * tier.depth
        soups.append(boxes([-x, top - 0.2, -z], [x, top + 3.6, z], "metal", without="-y"))
    plant = roofs.furnish(tier.width, tier.depth, paint.wall, random, tower=tower, detail=design.detail)
    return [*soups, plant.translate([0.0, top - 0.05, 0.0])]


def _pitched(tier: Tier, top: float, design: Design, random: RandomStream) -> list[Soup]:
    """A tiled roof with a chimney; between neighbours it has gables."""
    tiles, pitch, paint = random.pick(_TILES), random.number(0.55, 0.85), design.paint
    x = random.number(-0.3, 0.3) * tier.width
    shape = (tier.width, tier.depth, top, pitch, tiles, paint.trim)
    soups = [roofs.hipped(*shape) if design.kind.place == 3 else roofs.gabled(*shape, paint.wall)]
    if design.detail >= 1:
        ridge = 0.5 * (tier.depth + 0.9) * pitch
        soups.append(roofs.chimney(x, -0.18 * tier.depth, top, top + ridge + 0.5))
    return soups
