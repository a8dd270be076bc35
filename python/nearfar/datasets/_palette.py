"""The table of materials that all procedural scenes share."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

# sRGB as 0xRRGGBB. A material's number is its position in this table.
_COLORS = {
    # ground
    "asphalt": 0x5D6064, "asphalt_worn": 0x6A6C6E, "paint_white": 0xE4E4DE, "kerb": 0xB9B6AE, "paving": 0x9D9A93,
    "paving_warm": 0xA99F90, "plaza": 0xC0B5A2, "yard": 0x8B8C86, "lawn": 0x7F9A5C, "meadow": 0x8FA266,
    "meadow_dry": 0xA5A673, "field": 0xB4AA7C, "hill": 0x75905F, "gravel": 0xCBBB9B, "soil": 0x5E4A3A,
    "water": 0x5E8CA0,
    # walls
    "brick_red": 0x9C5443, "brick_brown": 0x7D5644, "brick_orange": 0xB87151, "brick_yellow": 0xC9A877,
    "brick_grey": 0x8D857E, "stone_sand": 0xD3BF98, "stone_pale": 0xD9D0BD, "stone_grey": 0xB0ACA3,
    "stone_pink": 0xC7A28E, "paint_cream": 0xE9DFC4, "paint_rose": 0xDDB3A2, "paint_mint": 0xB5CBB8,
    "paint_sky": 0xA9BFCE, "paint_ochre": 0xD9B36C, "paint_snow": 0xE8E7E1, "concrete": 0xB4B2AC,
    "concrete_dark": 0x8F8F8D, "concrete_warm": 0xC2B8A9, "panel_white": 0xDCDEDD, "panel_slate": 0x5C6670,
    "panel_bronze": 0x6E5A48, "panel_navy": 0x44536A, "spandrel_blue": 0x5A7488, "spandrel_green": 0x5E7A74,
    # trims
    "trim_stone": 0xDDD5C4, "trim_white": 0xEFEDE8, "trim_dark": 0x4B4A49, "metal": 0x9AA0A4, "metal_light": 0xC3C7C8,
    "metal_dark": 0x3C4145, "iron": 0x2E3338,
    # glass and doors
    "glass_dark": 0x2F3B45, "glass_blue": 0x3F5567, "glass_sky": 0x6D8799, "glass_green": 0x44544F,
    "glass_steel": 0x5F788A, "glass_pale": 0x86A0B0, "curtain": 0xA7A291, "lamp_lit": 0xC4AE84, "shop_glass": 0x4A5A60,
    "shop_warm": 0xA98F68, "door_green": 0x35523F, "door_red": 0x7C2F2B, "door_blue": 0x2F4766, "door_wood": 0x6B4A30,
    # signs, awnings, shutters
    "sign_red": 0xB5392F, "sign_teal": 0x2E7F80, "sign_mustard": 0xD29A2C, "sign_navy": 0x2A3F66,
    "sign_green": 0x3C7148, "awning_cream": 0xE6D9B8, "shutter_green": 0x4F7058, "shutter_blue": 0x587592,
    # roofs
    "roof_gravel": 0xA09C95, "roof_felt": 0x6F7173, "roof_tile": 0xA95F43, "roof_tile_dark": 0x83503F,
    "roof_slate": 0x596068, "roof_copper": 0x7FA392,
    # plants
    "bark": 0x6F5A46, "bark_dark": 0x54473B, "bark_birch": 0xD8D3C8, "leaf": 0x6B9142, "leaf_deep": 0x4F7A3A,
    "leaf_light": 0x8FAE4E, "leaf_olive": 0x83893F, "leaf_autumn": 0xC08A3A, "needle": 0x44693F,
    "needle_blue": 0x557565, "grass": 0x7F9E48, "fern": 0x5E8C3E, "flower": 0xD9667A, "moss": 0x76854F,
    "moss_dark": 0x6B7A4C, "litter": 0x7F7C52, "rock": 0x8E8C86, "rock_moss": 0x757F63,
    # vehicles
    "car_white": 0xE9EAEA, "car_silver": 0xB3B8BC, "car_black": 0x2B2D31, "car_red": 0xB02A2A, "car_blue": 0x2F5D97,
    "car_green": 0x3F6A55, "car_yellow": 0xE0B032, "car_beige": 0xBDAE93, "tyre": 0x26272A, "tail_light": 0xC32B22,
    # rooms
    "wall_paint": 0xE6E0D4, "wall_accent": 0x7E958B, "ceiling": 0xF1EFEA, "skirting": 0xEDEAE3, "wood": 0xA8794F,
    "wood_dark": 0x6B4730, "wood_pale": 0xCFAE82, "fabric_teal": 0x3F7478, "fabric_sand": 0xC9B596,
    "fabric_rust": 0xB5613C, "paper": 0xEDE6D6, "terracotta": 0xB86F4D, "shade": 0xF0E2BF,
    # factories
    "daylight": 0xF4F8FA, "machine_grey": 0xC6CBC9, "machine_green": 0x6E9A84, "machine_blue": 0x4F7FA6,
    "machine_cream": 0xDED6BE, "robot_orange": 0xE8822B, "safety_yellow": 0xF2C12E, "safety_red": 0xC8352B,
    "steel_blue": 0x6C8CA6, "steel_grey": 0xA3A9AC, "rack_orange": 0xD9702E, "rack_blue": 0x335E96,
    "cardboard": 0xC29A66, "cardboard_pale": 0xD6B98A, "barrel_blue": 0x2E68AC, "pipe_green": 0x5E9C6B,
    "rubber": 0x4A4D50,
}  # fmt: skip

Material = int | str
"""A material's number or name."""

_NUMBERS = {name: number for number, name in enumerate(_COLORS)}


def material(name: str) -> int:
    """Return the number of a material."""
    return _NUMBERS[name]


def numbers_of(materials: ArrayLike, count: int) -> NDArray[np.int32]:
    """Return the material numbers (count,) of elements; `materials` has numbers or names, one or `count` of them."""
    if isinstance(materials, str):
        materials = _NUMBERS[materials]
    elif isinstance(materials, list | tuple):
        materials = [_NUMBERS[entry] if isinstance(entry, str) else entry for entry in materials]
    return np.broadcast_to(np.asarray(materials, np.int32), count)


def materials(*names: str) -> tuple[int, ...]:
    """Return the numbers of several materials."""
    return tuple(_NUMBERS[name] for name in names)


def linear_colors() -> list[tuple[float, float, float, float]]:
    """Return linear RGBA of every material, in the order of their numbers."""
    return [
        (_decode_srgb(rgb >> 16), _decode_srgb(rgb >> 8 & 0xFF), _decode_srgb(rgb & 0xFF), 1.0)
        for rgb in _COLORS.values()
    ]


def _decode_srgb(byte: int) -> float:
    """Decode an sRGB byte to linear light by a cubic, because powers are not rounded alike on every platform."""
    c = byte / 255.0
    return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878)
