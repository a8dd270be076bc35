"""Architectural styles: shapes and materials of a building's façades."""

from __future__ import annotations

from dataclasses import dataclass

from nearfar.datasets._facade import Window


@dataclass(frozen=True)
class Style:
    """One style; colours are names of `_palette`."""

    walls: tuple[str, ...]
    trims: tuple[str, ...]
    bay: float
    """Width of a window axis, metres."""
    window: Window
    storey: float = 3.2
    pier: float = 0.7
    """Width of the blank wall at the corners, metres."""
    frames: tuple[str, ...] = ("trim_white",)
    sill: bool = True
    lintel: bool = False
    shutters: bool = False
    course_every: int = 0
    """Number of storeys between bands; 0 for none."""
    pilasters: bool = False
    balcony: str = ""
    """Kind of balcony: "rail", "solid" or "" for none."""
    cornice: str = "plain"
    """Kind of cornice: "plain", "moulded" or "slim"."""
    pitched: bool = False
    """Whether low buildings have a tiled roof."""


BRICK = Style(
    walls=("brick_red", "brick_brown", "brick_orange", "brick_grey", "brick_red"),
    trims=("trim_stone", "stone_grey"),
    bay=2.5,
    window=Window(0.5, 0.85, 0.84, 0.22),
    lintel=True,
    cornice="moulded",
    pitched=True,
)
STONE = Style(
    walls=("stone_sand", "stone_pale", "stone_grey", "stone_pink"),
    trims=("trim_stone", "stone_pale"),
    bay=2.9,
    window=Window(0.46, 0.5, 0.86, 0.3),
    storey=3.5,
    course_every=1,
    balcony="rail",
    cornice="moulded",
)
STUCCO = Style(
    walls=("paint_cream", "paint_rose", "paint_mint", "paint_sky", "paint_ochre", "paint_snow"),
    trims=("trim_white", "trim_stone"),
    bay=2.8,
    window=Window(0.42, 0.7, 0.86, 0.2),
    shutters=True,
    course_every=3,
    balcony="rail",
    pitched=True,
)
CONCRETE = Style(
    walls=("concrete", "concrete_warm", "concrete_dark", "panel_white"),
    trims=("concrete_dark", "concrete"),
    bay=3.4,
    window=Window(0.78, 0.8, 0.9, 0.26, "|"),
    storey=3.1,
    pier=0.5,
    frames=("trim_dark", "metal"),
    balcony="solid",
    cornice="slim",
)
LOFT = Style(
    walls=("brick_yellow", "brick_brown", "panel_slate", "brick_grey"),
    trims=("concrete_dark", "trim_dark"),
    bay=3.6,
    window=Window(0.8, 0.7, 0.92, 0.3, "+"),
    storey=3.8,
    frames=("iron",),
    pilasters=True,
)
CURTAIN = Style(
    walls=("spandrel_blue", "metal", "spandrel_green", "panel_slate", "metal_light", "panel_bronze"),
    trims=("metal_light", "panel_white", "metal_light", "metal_dark"),
    bay=1.75,
    window=Window(0.92, 0.7, 0.985, 0.1, ""),
    storey=3.6,
    pier=0.3,
    sill=False,
    pilasters=True,
    cornice="slim",
)
SLAB_TOWER = Style(
    walls=("panel_white", "concrete_warm", "stone_pale", "panel_bronze"),
    trims=("panel_white", "concrete"),
    bay=2.2,
    window=Window(0.72, 0.75, 0.93, 0.35, ""),
    storey=3.4,
    pier=0.9,
    sill=False,
    course_every=1,
    cornice="slim",
)

ROW_STYLES = (BRICK, STONE, STUCCO, CONCRETE, BRICK, STUCCO, LOFT, STONE)
HIGH_STYLES = (CONCRETE, LOFT, STONE, SLAB_TOWER, BRICK)
TOWER_STYLES = (CURTAIN, SLAB_TOWER, CURTAIN)
