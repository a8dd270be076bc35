"""Texture coordinates of glTF materials: the set that a texture uses, and its KHR_texture_transform.

A mesh of a scene has one set of texture coordinates: that of the drawn texture, with its transform applied. The
transforms of a material's other textures are stated relative to it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

TRANSFORM = "KHR_texture_transform"

SPECULAR_GLOSSINESS = "KHR_materials_pbrSpecularGlossiness"
"""Extension whose diffuse colour and texture are drawn instead of the base colour's."""

_SURFACE = "pbrMetallicRoughness"

_EXACT = 1e-12
"""Rounding error of a float64 matrix product, relative to the matrix's largest entry."""


@dataclass(frozen=True, eq=False)
class Coordinates:
    """Texture coordinates of one texture."""

    number: int
    """Number of the set: n of TEXCOORD_n."""
    matrix: NDArray[np.float64]
    """Transform (2, 3) of columns (u, v, 1), v pointing down."""

    @property
    def is_plain(self) -> bool:
        """Whether the set is used without a transform."""
        return np.array_equal(self.matrix, _IDENTITY)

    def to_scene(self, rows: NDArray[Any]) -> NDArray[np.float32]:
        """Transform rows (N, 2) of the set in float64 and flip v, which points up in scenes."""
        if self.is_plain:
            return np.column_stack([rows[:, 0], 1 - rows[:, 1]])
        transformed = rows.astype(np.float64) @ self.matrix[:, :2].T + self.matrix[:, 2]
        with np.errstate(over="ignore"):  # too large for float32 becomes infinite, which texture coordinates may be
            return np.column_stack([transformed[:, 0], 1 - transformed[:, 1]]).astype(np.float32)


_IDENTITY = np.eye(2, 3)


def from_texture_info(info: dict[str, Any]) -> Coordinates:
    """Return the coordinates that a texture reference states; entries of wrong types count as absent.

    The rotation is counter-clockwise in an image whose v points down, as in the extension's example (lower left quarter
    turned by 90 degrees), three.js, Babylon.js and Khronos' viewer.
    """
    transform = object_of(object_of(info, "extensions"), TRANSFORM)
    number = transform.get("texCoord", info.get("texCoord", 0))
    number = number if type(number) is int and number >= 0 else 0
    (u, v), angle, (scale_u, scale_v) = (_DEFAULTS | _valid_parts(transform)).values()
    cosine, sine = math.cos(angle), math.sin(angle)
    rows = [[cosine * scale_u, sine * scale_v, u], [-sine * scale_u, cosine * scale_v, v]]
    return Coordinates(number, np.array(rows))


_DEFAULTS: dict[str, Any] = {"offset": [0.0, 0.0], "rotation": 0.0, "scale": [1.0, 1.0]}


def _valid_parts(transform: Mapping[str, Any]) -> dict[str, Any]:
    return numbers_of(transform, {"offset": 2, "rotation": 1, "scale": 2})


def numbers_of(source: Mapping[str, Any], sizes: Mapping[str, int]) -> dict[str, Any]:
    """Entries that have the stated sizes: a finite number for size 1, else a list of that many finite numbers."""

    def is_usable(value: object, size: int) -> bool:
        return is_number(value) if size == 1 else isinstance(value, list) and [*map(is_number, value)] == [True] * size

    return {name: source[name] for name, size in sizes.items() if is_usable(source.get(name), size)}


def is_number(value: object) -> TypeGuard[float]:
    """Whether a value of a document is a finite number."""
    try:
        return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
    except OverflowError:  # an integer beyond float64
        return False


def drawn_texture_coordinates(material: dict[str, Any]) -> Coordinates | None:
    """Return the coordinates of the base colour's texture, else of the emission's, with the transform.

    A material with neither uses the set of its first other texture, without a transform. None without textures.
    """
    surface = object_of(material, _SURFACE)
    extensions = object_of(material, "extensions")
    for info in (base_texture(material), material.get("emissiveTexture")):
        if isinstance(info, dict) and "index" in info:
            return from_texture_info(info)
    owners = [material, surface, *(item for item in extensions.values() if isinstance(item, dict))]
    first = next((value for owner in owners for key, value in owner.items() if is_texture(key, value)), None)
    return None if first is None else Coordinates(from_texture_info(first).number, _IDENTITY)


def base_texture(material: Mapping[str, Any]) -> Any:
    """Return the texture reference of the base colour, or of specular–glossiness' diffuse colour; may be None."""
    extensions = object_of(material, "extensions")
    if SPECULAR_GLOSSINESS in extensions:
        return object_of(extensions, SPECULAR_GLOSSINESS).get("diffuseTexture")
    return object_of(material, _SURFACE).get("baseColorTexture")


def base_factor(material: Mapping[str, Any]) -> Any:
    """Return the factor of the base colour, or of specular–glossiness' diffuse colour; may be None."""
    extensions = object_of(material, "extensions")
    if SPECULAR_GLOSSINESS in extensions:
        return numbers_of(object_of(extensions, SPECULAR_GLOSSINESS), {"diffuseFactor": 4}).get("diffuseFactor")
    return material.get(_SURFACE, {}).get("baseColorFactor")


def object_of(owner: Mapping[str, Any], key: str) -> dict[str, Any]:
    """Return an entry if it is a JSON object, else an empty one."""
    value = owner.get(key)
    return value if isinstance(value, dict) else {}


def is_texture(key: str, value: object) -> bool:
    """Whether an entry of a material is a reference to a texture."""
    return key.endswith("Texture") and isinstance(value, dict) and "index" in value


def relative(info: dict[str, Any], base: Coordinates) -> dict[str, Any] | None:
    """Return the KHR_texture_transform from the coordinates `base` to those of a texture; None if there is none.

    The extension scales, rotates, then translates. The product of such a transform and the inverse of another may lack
    this form.
    """
    target = from_texture_info(info)
    if target.number != base.number:
        return None
    if base.is_plain:
        return _valid_parts(object_of(object_of(info, "extensions"), TRANSFORM))
    if np.array_equal(target.matrix, base.matrix):
        return {}
    square_base = np.vstack([base.matrix, [0, 0, 1]])
    if abs(np.linalg.det(square_base)) <= _EXACT * np.abs(base.matrix[:, :2]).max() ** 2:
        return None
    product = target.matrix @ np.linalg.inv(square_base)
    size = np.abs(product[:, :2]).max()
    return _parts(np.where(np.abs(product) <= _EXACT * max(size, 1), 0.0, product))


def _parts(matrix: NDArray[np.float64]) -> dict[str, Any] | None:
    """Offset, rotation and scale of a transform (2, 3); None if its axes are not perpendicular."""
    u_axis, v_axis, offset = matrix.T
    scale_u, scale_v = float(np.hypot(*u_axis)), float(np.hypot(*v_axis))
    if not math.isfinite(scale_u * scale_v) or abs(u_axis @ v_axis) > 1e-9 * scale_u * scale_v:
        return None
    # The u axis is scale_u · (cos, −sin), the v axis scale_v · (sin, cos).
    angle = math.atan2(-u_axis[1], u_axis[0]) if scale_u else math.atan2(v_axis[0], v_axis[1])
    if np.linalg.det(matrix[:, :2]) < 0:
        scale_v = -scale_v
    parts: dict[str, Any] = {"offset": offset.tolist(), "rotation": angle, "scale": [scale_u, scale_v]}
    return {key: value for key, value in parts.items() if value != _DEFAULTS[key]}
