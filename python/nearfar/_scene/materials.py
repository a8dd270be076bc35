"""Base colours and emission, the properties of materials that nearfar draws, and their conversion from trimesh."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene import undrawn as undrawn_parts, wavefront_materials
from nearfar._scene.arrays import MAX_CUTOFF
from nearfar._scene.budget import Budget
from nearfar._scene.coordinates import base_factor, base_texture
from nearfar._scene.emission import DARK, MAP, Light, emission_of, is_unlit
from nearfar._scene.samplers import REPEATED, Sampler, to_gltf
from nearfar._scene.srgb import to_linear
from nearfar._scene.undrawn import EncodedImage, GltfMaterial, TextureSource
from nearfar._scene.wavefront_maps import sampler_of

MAX_TEXELS = 1 << 27
"""Greatest number of texels of a texture (half a gigabyte); a damaged header can claim billions."""

_TRIMESH_DEFAULT = (102, 102, 102, 255)
"""sRGB colour and alpha that trimesh assigns to a material without a colour."""


@dataclass(frozen=True, eq=False)
class BaseColor:
    """Base colour and emission of a surface."""

    factor: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)
    """Linear RGB and alpha, 0..1."""
    texture: NDArray[np.uint8] | None = None
    """(H, W, 4), sRGB with linear alpha, row 0 on top."""
    cutoff: float | None = None
    """Alpha below which nothing is drawn; None draws everything opaque."""
    emission: Light = DARK
    """Linear RGB of the emitted light, at least 0."""
    emission_texture: NDArray[np.uint8] | None = None
    """Image that multiplies the emission; format and coordinates as for `texture`."""
    unlit: bool = False
    """Whether the base colour is shown unshaded."""
    sampler: Sampler = REPEATED
    """Sampler of `texture`."""
    emission_sampler: Sampler = REPEATED
    """Sampler of `emission_texture`."""
    notes: tuple[str, ...] = ()
    """Differences from the source's material, phrased to follow "2 materials"."""
    undrawn: GltfMaterial | None = None
    """The source's material with its undrawn properties; None if it has none."""
    blend: str = ""
    """Kind of transparency, "blending" or "transparency"; empty for opaque materials."""

    @property
    def is_textured(self) -> bool:
        """Whether the material has textures, drawn or not."""
        drawn = self.texture is not None or self.emission_texture is not None
        return drawn or (self.undrawn is not None and self.undrawn.has_maps)

    def without_textures(self) -> BaseColor:
        """Copy for meshes without texture coordinates; it has no textures and no emission that a texture multiplies."""
        undrawn = None if self.undrawn is None else self.undrawn.without_textures()
        emission = self.emission if self.emission_texture is None else DARK
        return replace(self, texture=None, emission=emission, emission_texture=None, undrawn=undrawn)


PLAIN = BaseColor(factor=(0.8, 0.8, 0.8, 1.0))
"""Light grey, for sources without a colour."""

UNCOLORED = BaseColor()
"""White, for meshes with vertex colours."""


def colors_of(values: NDArray[Any], count: int, *, linear: bool) -> NDArray[np.uint8] | None:
    """Convert vertex colours (V, 3 or 4) to sRGB uint8 RGBA; None unless there is one for each of `count` vertices.

    Floats range over 0..1, integers up to the greatest value of their type. `linear` means linear light.
    """
    if values.ndim != 2 or len(values) != count or values.shape[1] not in (3, 4):
        return None
    full = 1.0 if values.dtype.kind == "f" else float(np.iinfo(values.dtype).max)
    rgba = np.full((count, 4), 255, np.uint8)
    if linear:
        rgba[:, :3] = _core.encode_srgb((values[:, :3] / full).astype(np.float32).ravel()).reshape(-1, 3)
    elif values.dtype == np.uint8:
        rgba[:, :3] = values[:, :3]
    else:
        rgba[:, :3] = _to_bytes(values[:, :3] / full)
    if values.shape[1] == 4:
        rgba[:, 3] = values[:, 3] if values.dtype == np.uint8 else _to_bytes(values[:, 3] / full)
    return rgba


def _to_bytes(values: NDArray[Any]) -> NDArray[np.uint8]:
    # NaN becomes 0.
    return np.rint(np.clip(np.nan_to_num(values), 0, 1) * 255).astype(np.uint8)  # type: ignore[no-any-return]


@dataclass(frozen=True, eq=False)
class MaterialEntry:
    """A material's entry in a glTF document."""

    material: dict[str, Any]
    texture: Callable[[int], TextureSource | None]
    """Returns a texture by index; None if it cannot be read."""

    @property
    def factor(self) -> tuple[float, float, float, float] | None:
        """Base colour factor in full precision; None if the entry has none."""
        factor = base_factor(self.material)
        if factor is None:
            return None
        red, green, blue, alpha = np.clip(np.nan_to_num(np.array(factor, np.float64)), 0, 1).tolist()
        return red, green, blue, alpha

    @property
    def is_textured(self) -> bool:
        """Whether the entry refers to a base colour texture."""
        return base_texture(self.material) is not None


_COMPARED_ROWS = 4
"""Least number of sampled rows that textures must share before all of their texels are compared."""

_UNREADABLE = "with an unreadable texture drawn without it"
_UNREADABLE_EMISSION = "with an unreadable map of emission drawn without it"


def _is_placeholder(image: Any) -> bool:
    """Whether an image is the tiny grey one that trimesh uses for texture coordinates without a material."""
    from trimesh.visual.material import color_image

    grey = color_image()
    is_alike = image is not None and (image.size, image.mode) == (grey.size, grey.mode)
    return is_alike and bool(image.tobytes() == grey.tobytes())


def _gltf_entry(material: Any) -> MaterialEntry:
    """Make a glTF entry for a trimesh material that is not from a glTF file; textures are encoded as PNG on demand."""
    images: list[Any] = []

    def value(key: str, item: Any) -> Any:
        if key.endswith("Texture"):
            images.append(item)
            return {"index": len(images) - 1}
        return item.tolist() if hasattr(item, "tolist") else item

    entry = {key: value(key, item) for key, item in material._data.items() if not key.startswith("baseColorF")}
    surface = {key: entry.pop(key) for key in _SURFACE_KEYS if key in entry}
    return MaterialEntry(entry | {"pbrMetallicRoughness": surface}, lambda number: _encode_png(images[number]))


_SURFACE_KEYS = ("metallicFactor", "roughnessFactor", "baseColorTexture", "metallicRoughnessTexture")


def _encode_png(image: Any, sampler: str = "") -> TextureSource | None:
    if image is None or image.size[0] * image.size[1] > MAX_TEXELS:
        return None
    file = io.BytesIO()
    try:
        image.save(file, "png", compress_level=1)
    except MemoryError:
        raise
    except Exception:  # Pillow's decoders raise errors of any type
        return None
    return TextureSource(EncodedImage(file.getvalue(), "image/png"), sampler)


class Materials:
    """Converts trimesh's materials to base colours; each image is decoded once, however many materials use it.

    `budget` counts the texels of images from files; None for images that the caller made.
    """

    def __init__(self, budget: Budget | None = None) -> None:
        self._budget = budget
        self._colors: dict[int, tuple[Any, BaseColor]] = {}
        self._textures: dict[tuple[int, int, bytes], list[NDArray[np.uint8]]] = {}
        """Textures by size and a sample of their rows."""
        self._images: dict[int, tuple[Any, NDArray[np.uint8] | None]] = {}

    def base_colors(self, material: Any, *, entry: MaterialEntry | None = None) -> list[BaseColor]:
        """Convert a material of trimesh: one base colour, several for a MultiMaterial, none for None.

        `entry` is the material's entry in the source file, if any.
        """
        if material is None:
            return []
        if hasattr(material, "materials"):
            return [color for part in material.materials for color in self.base_colors(part) or [PLAIN]]
        if id(material) not in self._colors:
            is_physical = hasattr(material, "baseColorFactor")
            colors = self._physical(material, entry) if is_physical else self._simple(material)
            # The reference keeps the material alive, so that its id is not reused.
            self._colors[id(material)] = (material, colors)
        return [self._colors[id(material)][1]]

    def _physical(self, material: Any, entry: MaterialEntry | None) -> BaseColor:
        factor = None if entry is None else entry.factor
        if factor is None:
            color = material.baseColorFactor
            red, green, blue, alpha = (255, 255, 255, 255) if color is None else color
            factor = (float(red) / 255, float(green) / 255, float(blue) / 255, float(alpha) / 255)
        texture, notes = self._texture(material.baseColorTexture)
        if entry is not None and entry.is_textured and material.baseColorTexture is None:
            notes = (_UNREADABLE,)
        mode = str(material.alphaMode or "OPAQUE").upper()
        cutoff = None
        if mode == "MASK":
            least_alpha = material.alphaCutoff
            cutoff = 0.5 if least_alpha is None or not np.isfinite(least_alpha) else float(least_alpha)
            cutoff = min(max(cutoff, -MAX_CUTOFF), MAX_CUTOFF)
        entry = entry or _gltf_entry(material)
        undrawn, differences = undrawn_parts.of_gltf(entry.material, entry.texture)
        notes += differences
        unlit = undrawn is not None and is_unlit(undrawn.material)
        sampler = REPEATED if undrawn is None else undrawn.sampler(base_texture(undrawn.material))
        blend = "blending" if mode == "BLEND" else ""
        color = BaseColor(factor, texture, cutoff, unlit=unlit, sampler=sampler, notes=notes, blend=blend)
        return self._with_undrawn(color, undrawn, material.emissiveTexture)

    def _with_undrawn(self, color: BaseColor, undrawn: GltfMaterial | None, image: Any) -> BaseColor:
        """Add undrawn properties and emission; `image` is the emission's texture."""
        light = DARK if undrawn is None else emission_of(undrawn.material)
        color = replace(color, undrawn=undrawn, emission=light)
        if undrawn is None or light == DARK or MAP not in undrawn.material:
            return color
        texels = None if image is None else self._texture(image)[0]
        if texels is None:
            return replace(color, emission=DARK, notes=(*color.notes, _UNREADABLE_EMISSION))
        return replace(color, emission_texture=texels, emission_sampler=undrawn.sampler(undrawn.material[MAP]))

    def _simple(self, material: Any) -> BaseColor:
        """Convert a Wavefront material, with its diffuse colour as sRGB, as in three.js."""
        diffuse, entries = tuple(int(c) for c in material.diffuse), material.kwargs
        image = getattr(material, "image", None)
        texture, notes = self._texture(None if _is_placeholder(image) else image)
        emission_image = entries.get(wavefront_materials.EMISSION_IMAGE)
        gltf = wavefront_materials.as_gltf(entries)
        emission_sampler = json.dumps(to_gltf(sampler_of(emission_image)))
        undrawn, differences = undrawn_parts.of_gltf(gltf, lambda _: _encode_png(emission_image, emission_sampler))
        notes += (*differences, *wavefront_materials.losses(entries))
        alpha = min(diffuse[3] / 255, wavefront_materials.opacity(entries))
        blend = "transparency" if alpha < 1.0 else ""
        if diffuse == _TRIMESH_DEFAULT:
            red, green, blue, _ = UNCOLORED.factor if texture is not None else PLAIN.factor
        else:
            red, green, blue = (float(c) for c in to_linear(np.array(diffuse[:3]) / 255))
        sampler = sampler_of(image)
        color = BaseColor((red, green, blue, alpha), texture, sampler=sampler, notes=notes, blend=blend)
        return self._with_undrawn(color, undrawn, emission_image)

    def _texture(self, image: Any) -> tuple[NDArray[np.uint8] | None, tuple[str, ...]]:
        if image is None:
            return None, ()
        self.decode([image])
        texels = self._images[id(image)][1]
        return texels, () if texels is not None else (_UNREADABLE,)

    def decode(self, images: Iterable[Any]) -> None:
        """Decode Pillow images in parallel; skip those decoded before."""
        new = [image for key, image in {id(image): image for image in images}.items() if key not in self._images]
        for image in new:
            if self._budget is not None and image.size[0] * image.size[1] <= MAX_TEXELS:
                self._budget.count_unpacked(4 * image.size[0] * image.size[1])
        decoded: Iterable[NDArray[np.uint8] | None] = map(_decode, new)
        if len(new) > 1:
            from nearfar._base import side_by_side  # imported here: its threads import `logging`

            decoded = side_by_side.results([partial(_decode, image) for image in new])
        for image, texels in zip(new, decoded, strict=True):
            self._images[id(image)] = (image, None if texels is None else self._deduplicate(texels))

    def _deduplicate(self, texels: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Return the first texture with the same texels."""
        rows = texels[:: max(1, len(texels) // _COMPARED_ROWS)].tobytes()
        alike = self._textures.setdefault((*texels.shape[:2], rows), [])
        for other in alike:
            if np.array_equal(other, texels):
                return other
        alike.append(texels)
        return texels


def texels_of(data: bytes) -> NDArray[np.uint8] | None:
    """Decode an image file to texels (H, W, 4); None if it cannot be read."""
    from PIL import Image  # not needed by scenes without files

    try:
        with Image.open(io.BytesIO(data)) as image:
            return _decode(image)
    except MemoryError:
        raise
    except Exception:  # Pillow's decoders raise errors of any type
        return None


def _decode(image: Any) -> NDArray[np.uint8] | None:
    from PIL import Image

    if image.size[0] * image.size[1] > MAX_TEXELS:
        return None
    try:
        if image.mode.startswith("I;16"):  # Pillow would clip 16-bit values instead of scaling them
            image = Image.fromarray((np.asarray(image) >> 8).astype(np.uint8))
        # Pillow's decoders raise OSError, SyntaxError, ValueError, struct.error, zlib.error and others.
        return np.asarray(image.convert("RGBA"))
    except MemoryError:
        width, height = image.size
        raise MemoryError(f"its image of {width} × {height} pixels needs {4 * width * height} bytes") from None
    except Exception:
        return None
