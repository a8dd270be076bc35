"""Writes and reads the materials and textures of a scene's GLB, with the properties that nearfar does not draw."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import glb
from nearfar._scene import samplers, undrawn as undrawn_parts
from nearfar._scene.arrays import MAX_CUTOFF
from nearfar._scene.budget import MAX, Budget
from nearfar._scene.coordinates import TRANSFORM, is_texture
from nearfar._scene.emission import DARK, MAP, Light, emission_of, entries, is_unlit
from nearfar._scene.gltf import ktx2
from nearfar._scene.material_list import NO_TEXTURE, Material, surface_arguments
from nearfar._scene.materials import MAX_TEXELS, texels_of
from nearfar._scene.samplers import Sampler
from nearfar._scene.srgb import encode_image
from nearfar._scene.undrawn import EncodedImage, GltfMaterial, TextureSource

_SURFACE, _BASE = "pbrMetallicRoughness", "baseColorTexture"
_PLAIN_KINDS = ("image/png", "image/jpeg")
_KIND_EXTENSIONS = {
    "image/webp": "EXT_texture_webp",
    "image/avif": "EXT_texture_avif",
    "image/ktx2": "KHR_texture_basisu",
}
_PLAIN = GltfMaterial(undrawn_parts.PLAIN)


ImageEncoder = Callable[[NDArray[np.uint8]], EncodedImage]
"""Encodes the texels (H, W, 4) of a scene's texture as an image file."""

_WEBP_SIDE = 16383
"""Greatest side of a WebP image, pixels."""


def png(texels: NDArray[np.uint8], level: int = 3) -> EncodedImage:
    """Encode texels without loss, at a level of compression from 0 to 9."""
    return EncodedImage(encode_image(texels, "png", compress_level=level), "image/png")


def webp(quality: int) -> ImageEncoder:
    """Return an encoder of WebP with loss of colour but not of alpha; ValueError for texels that WebP cannot hold.

    Method 5 takes 2 % fewer bytes than 4 in the same time; method 6 takes another 1 % in twelve times the time.
    """

    def encode(texels: NDArray[np.uint8]) -> EncodedImage:
        if max(texels.shape[:2]) > _WEBP_SIDE:
            size = f"{texels.shape[1]} x {texels.shape[0]}"
            raise ValueError(f"textures: expected 'png' for a texture beyond {_WEBP_SIDE} texels a side, {size}")
        return EncodedImage(encode_image(texels, "webp", quality=quality, method=5), "image/webp")

    return encode


class SurfaceWriter:
    """Writes a scene's materials, from the result of `_core.scene_parts`, with the textures that they use."""

    def __init__(
        self, writer: glb.Writer, parts: dict[str, Any], undrawn: Mapping[int, GltfMaterial], encode: ImageEncoder
    ) -> None:
        self._writer, self._parts, self._undrawn, self._encode = writer, parts, undrawn, encode
        self._numbers: dict[int, int] = {}
        self._base_images: dict[int, EncodedImage] = {}
        self._samplers: list[dict[str, Any]] = []
        self._images: list[dict[str, Any]] = []
        self._image_numbers: dict[bytes, int] = {}
        self._textures: list[dict[str, Any]] = []
        self._required_extensions: set[str] = set()
        self._used_extensions: set[str] = set()

    def number(self, material: int) -> int:
        """Return the index in the file of a scene's material."""
        return self._numbers.setdefault(material, len(self._numbers))

    def fields(self) -> dict[str, Any]:
        """Return the document's entries; lists may be empty."""
        return {
            "materials": [self._material(number) for number in self._numbers],
            "textures": self._textures,
            "samplers": self._samplers,
            "images": self._images,
            "extensionsUsed": sorted(self._used_extensions),
            "extensionsRequired": sorted(self._required_extensions),
        }

    def _material(self, number: int) -> dict[str, Any]:
        parts = self._parts
        undrawn = self._undrawn.get(int(parts["material_tags"][number]), _PLAIN)
        material = _sorted(dict(undrawn.material))
        if undrawn is _PLAIN:
            red, green, blue = parts["material_emissions"][number].tolist()
            material |= entries((red, green, blue), unlit=bool(parts["material_unlit"][number]))
        surface = material.setdefault(_SURFACE, {})
        color = parts["material_colors"][number]
        # Keep the file's own digits if they round to the same float32; they may exceed its range.
        with np.errstate(over="ignore"):
            stated_color = np.array(surface.get("baseColorFactor", ()), np.float32)
        if not np.array_equal(stated_color, color):
            surface["baseColorFactor"] = color.astype(np.float64).tolist()
        texture, base = int(parts["material_textures"][number]), surface.pop(_BASE, None)
        if texture >= 0:
            sampler = "" if base is None else undrawn.textures[base["index"]].sampler
            surface[_BASE] = (base or {}) | {"index": self._drawn_texture(texture, sampler)}
        cutoff = float(parts["material_cutoffs"][number])
        if np.isnan(cutoff):
            material.pop("alphaCutoff", None)
            if material.get("alphaMode") == "MASK":
                del material["alphaMode"]
        else:
            # glTF does not allow negative cutoffs; like 0 they cut nothing out.
            material["alphaMode"] = "MASK"
            if np.float32(material.get("alphaCutoff", 0.5)) != np.float32(cutoff) or cutoff < 0:
                material["alphaCutoff"] = max(cutoff, 0.0)
        self._used_extensions |= set(material.get("extensions", {}))
        material = _sorted(material)
        self._link(material, undrawn.textures)
        emission_texture = int(parts["material_emission_textures"][number])
        if undrawn is _PLAIN and emission_texture >= 0:
            return _sorted(material | {MAP: {"index": self._drawn_texture(emission_texture, "")}})
        return material

    def _link(self, value: dict[str, Any], textures: tuple[TextureSource, ...]) -> None:
        """Write the textures that a material refers to, and replace their indices by those in the file."""
        for key, item in value.items():
            if not isinstance(item, dict):
                continue
            if not is_texture(key, item):
                self._link(item, textures)
                continue
            if TRANSFORM in item.get("extensions", {}):
                self._used_extensions.add(TRANSFORM)
            if key != _BASE:
                source = textures[item["index"]]
                assert source.image is not None
                item["index"] = self._texture(source.image, source.sampler)

    def _drawn_texture(self, texture: int, sampler: str) -> int:
        """Write a texture of the scene; `sampler` is the JSON of the source's sampler, kept for its undrawn entries."""
        drawn: tuple[int, int, int] = tuple(self._parts["texture_samplers"][texture].tolist())
        if samplers.from_gltf(json.loads(sampler or "{}")) != drawn:
            sampler = json.dumps(samplers.to_gltf(drawn))
        if texture not in self._base_images:
            self._base_images[texture] = self._encode(self._parts["textures"][texture])
        return self._texture(self._base_images[texture], sampler)

    def _texture(self, image: EncodedImage, sampler: str) -> int:
        # Base colour and emission may share an image.
        if image.data not in self._image_numbers:
            self._image_numbers[image.data] = len(self._images)
            self._images.append({"bufferView": self._writer.view(image.data), "mimeType": image.media_type})
        texture: dict[str, Any] = {"source": self._image_numbers[image.data]}
        if image.media_type not in _PLAIN_KINDS:
            name = _KIND_EXTENSIONS[image.media_type]
            texture = {"extensions": {name: texture}}
            self._used_extensions.add(name)
            self._required_extensions.add(name)
        if sampler:
            texture["sampler"] = _index_of(self._samplers, json.loads(sampler))
        return _index_of(self._textures, texture)


def _sorted(material: dict[str, Any]) -> dict[str, Any]:
    """Copy with sorted keys, so that equal content gives equal bytes."""
    return json.loads(json.dumps(material, sort_keys=True))  # type: ignore[no-any-return]


def _index_of(entries: list[dict[str, Any]], entry: dict[str, Any]) -> int:
    """Return the index of an entry in a list; append it if it is missing."""
    if entry not in entries:
        entries.append(entry)
    return entries.index(entry)


def read(reader: glb.Reader, *, upright: bool) -> tuple[dict[str, Any], dict[int, GltfMaterial]]:
    """Read the materials and textures that `SurfaceWriter` wrote.

    Images are `upright`, with row 0 on top, in all files except those of early versions. Return the materials and
    textures as arguments of `_core.Scene`, and the materials' undrawn properties by tag.
    """
    document = reader.document
    materials = document.get("materials", [])
    surfaces = [material[_SURFACE] for material in materials]
    sources = [
        _image_and_sampler(document, surface[_BASE]["index"]) if _BASE in surface else None for surface in surfaces
    ]
    known = list(dict.fromkeys(source for source in sources if source is not None))
    undrawn = [undrawn_parts.of_gltf(material, lambda number: _texture(reader, number))[0] for material in materials]
    images = {number: _image(reader, number) for number, _ in known}
    texels = {number: _texels(image.data, upright=upright) for number, image in images.items()}
    # Images of early versions have row 0 at the bottom.
    emissions = _Emissions([(images[number], sampler) for number, sampler in known] if upright else [], len(known))
    rows = []
    for surface, source, material, gltf in zip(surfaces, sources, materials, undrawn, strict=True):
        color = surface.get("baseColorFactor", (1.0, 1.0, 1.0, 1.0))
        cutoff = material.get("alphaCutoff", 0.5) if material.get("alphaMode") == "MASK" else None
        if not (np.array(color).shape == (4,) and all(0 <= part <= 1 for part in color)):
            raise ValueError("expected base colours within 0..1")
        if cutoff is not None and not abs(cutoff) <= MAX_CUTOFF:
            raise ValueError(f"expected alpha cutoffs up to {MAX_CUTOFF:g}")
        texture = NO_TEXTURE if source is None else known.index(source)
        light, emission_texture = emissions.light_and_texture(gltf)
        unlit, tag = (False, 0) if gltf is None else (is_unlit(gltf.material), gltf.tag)
        rows.append(Material(color, texture, cutoff, light, emission_texture, unlit, tag))
    textures = [(texels[number], sampler) for number, sampler in known] + emissions.textures
    return surface_arguments(rows, textures), {gltf.tag: gltf for gltf in undrawn if gltf is not None}


class _Emissions:
    """Emission textures: those in `known` keep their index, new ones are numbered from `first`."""

    def __init__(self, known: Sequence[tuple[EncodedImage, Sampler]], first: int) -> None:
        self.textures: list[tuple[NDArray[np.uint8], Sampler]] = []
        self._first = first
        self._numbers = {texture: number for number, texture in enumerate(known)}

    def light_and_texture(self, undrawn: GltfMaterial | None) -> tuple[Light, int]:
        """Emission of a material, and the index of its texture; −1 for none."""
        light = DARK if undrawn is None else emission_of(undrawn.material)
        if undrawn is None or light == DARK or MAP not in undrawn.material:
            return light, NO_TEXTURE
        info = undrawn.material[MAP]
        image = undrawn.textures[info["index"]].image
        number = NO_TEXTURE if image is None else self._number(image, undrawn.sampler(info))
        # No emission if the image cannot be decoded.
        return (DARK if number == NO_TEXTURE else light), number

    def _number(self, image: EncodedImage, sampler: Sampler) -> int:
        key = (image, sampler)
        if key not in self._numbers:
            texels = ktx2.decode(image.data, Budget(MAX)) if image.media_type == ktx2.KIND else texels_of(image.data)
            self._numbers[key] = NO_TEXTURE if texels is None else self._first + len(self.textures)
            if texels is not None:
                self.textures.append((texels, sampler))
        return self._numbers[key]


def _image_and_sampler(document: dict[str, Any], texture: int) -> tuple[int, Sampler]:
    """Index of a texture's image, and the drawn part of its sampler."""
    return _source(document, texture), samplers.from_gltf(_sampler(document, texture))


def _sampler(document: dict[str, Any], texture: int) -> dict[str, Any]:
    """Entry of a texture's sampler; empty for none."""
    texture_entry = glb.entry(document, "textures", texture)
    return glb.entry(document, "samplers", texture_entry["sampler"]) if "sampler" in texture_entry else {}


def _source(document: dict[str, Any], texture: int) -> int:
    """Index of a texture's image."""
    texture_entry = glb.entry(document, "textures", texture)
    entry = texture_entry if "source" in texture_entry else next(iter(texture_entry["extensions"].values()))
    return entry["source"]  # type: ignore[no-any-return]


def _image(reader: glb.Reader, number: int) -> EncodedImage:
    image_entry = glb.entry(reader.document, "images", number)
    return EncodedImage(bytes(reader.bytes(image_entry["bufferView"])), str(image_entry["mimeType"]))


def _texture(reader: glb.Reader, number: int) -> TextureSource:
    sampler = _sampler(reader.document, number)
    image = _image(reader, _source(reader.document, number))
    if image.media_type not in (*_PLAIN_KINDS, *_KIND_EXTENSIONS):
        raise ValueError(f"expected images of known kinds, got {image.media_type!r}")
    return TextureSource(image, json.dumps(sampler) if sampler else "")


def _texels(data: bytes, *, upright: bool) -> NDArray[np.uint8]:
    from PIL import Image

    try:
        with Image.open(io.BytesIO(data), formats=["png"]) as image:
            if image.size[0] * image.size[1] > MAX_TEXELS:
                raise ValueError("too large")
            texels = np.asarray(image.convert("RGBA"))
            return np.ascontiguousarray(texels if upright else texels[::-1])
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise ValueError(f"expected a readable texture, got {error}") from None
