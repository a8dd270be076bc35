"""glTF materials with their undrawn properties, so that files written from a scene preserve them."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from nearfar._scene import emission, samplers
from nearfar._scene.coordinates import (
    SPECULAR_GLOSSINESS,
    TRANSFORM,
    Coordinates,
    drawn_texture_coordinates,
    is_number,
    is_texture,
    numbers_of,
    object_of,
    relative,
)

EXTENSIONS = frozenset(
    f"KHR_materials_{name}"
    for name in (
        *("anisotropy", "clearcoat", "diffuse_transmission", "dispersion", "emissive_strength", "ior", "iridescence"),
        *("pbrSpecularGlossiness", "sheen", "specular", "transmission", "unlit", "volume"),
    )
)
"""Material extensions that can be copied, because they refer only to textures."""

_METALLIC_ROUGHNESS = "pbrMetallicRoughness"
_BASE_TEXTURE = "baseColorTexture"
_METALLIC_ROUGHNESS_SIZES = {"baseColorFactor": 4, "metallicFactor": 1, "roughnessFactor": 1}
"""Number of components of numeric entries of `pbrMetallicRoughness`."""
_SIZES = {"emissiveFactor": 3, "alphaCutoff": 1}
"""Number of components of other numeric entries of a material."""
_TEXTURES = ("normalTexture", "occlusionTexture", emission.MAP)
_DRAWN_EXTENSIONS = (emission.UNLIT, emission.STRENGTH, SPECULAR_GLOSSINESS)
"""Extensions that affect drawing."""

PLAIN = {_METALLIC_ROUGHNESS: {"metallicFactor": 0.0}, "doubleSided": True}
"""glTF material without a base colour; with it, other programs draw a mesh as nearfar does."""


@dataclass(frozen=True)
class EncodedImage:
    """An image file."""

    data: bytes
    media_type: str
    """Media type, such as "image/png"."""

    @cached_property
    def digest(self) -> str:
        """Hash of the bytes."""
        return hashlib.sha256(self.data).hexdigest()


@dataclass(frozen=True)
class TextureSource:
    """A texture of a glTF file, with its sampler."""

    image: EncodedImage | None = None
    """Image; None for the base colour's texture, whose texels the scene holds, and for images of unknown kinds."""
    sampler: str = ""
    """JSON of the sampler; empty for none."""


@dataclass(frozen=True, eq=False)
class GltfMaterial:
    """A glTF material with all properties that can be written back."""

    material: Mapping[str, Any]
    """Entries as in glTF, except that each texture's `index` is an index into `textures`."""
    textures: tuple[TextureSource, ...] = ()

    @cached_property
    def tag(self) -> int:
        """Content hash from 1 to 2⁶⁴ − 1, by which kernels distinguish materials."""
        textures = [(source.sampler, "" if source.image is None else source.image.digest) for source in self.textures]
        text = json.dumps([self.material, textures], sort_keys=True)
        return int.from_bytes(hashlib.blake2b(text.encode(), digest_size=8).digest()) or 1

    @property
    def has_maps(self) -> bool:
        """Whether it has textures other than the base colour's."""
        return any(texture.image is not None for texture in self.textures)

    def sampler(self, info: Any) -> samplers.Sampler:
        """Drawn part of the sampler that a texture reference uses; the default sampler for None."""
        text = "" if info is None else self.textures[info["index"]].sampler
        return samplers.from_gltf(json.loads(text or "{}"))

    def without_textures(self) -> GltfMaterial | None:
        """Copy for meshes without texture coordinates. Emission with a texture is left out as a whole."""
        material = emission.strip_emission(self.material) if emission.MAP in self.material else self.material
        return _none_if_plain(replace(self, material=without_textures(material), textures=()))


def of_gltf(
    material: Any, texture_of: Callable[[int], TextureSource | None]
) -> tuple[GltfMaterial | None, tuple[str, ...]]:
    """Collect the properties of a glTF material, an entry of a document; parts of wrong types count as absent.

    `texture_of` returns a texture, with its image, by index; None if it cannot be read. Return the properties, or None
    for a material that is drawn completely, and notes on what is drawn differently, phrased to follow "2 materials".
    """
    if not isinstance(material, dict):
        return None, ()
    collector = _Collector(texture_of)
    undrawn = GltfMaterial(collector.material(material), tuple(collector.textures))
    return _none_if_plain(undrawn), (*_differences(undrawn), *dict.fromkeys(collector.losses))


def _none_if_plain(undrawn: GltfMaterial) -> GltfMaterial | None:
    """Return the material; None if it differs from `PLAIN` only in properties that the scene itself stores."""
    material = {key: value for key, value in undrawn.material.items() if key != "alphaCutoff"}
    surface = material.get(_METALLIC_ROUGHNESS, {})
    material[_METALLIC_ROUGHNESS] = {key: value for key, value in surface.items() if not key.startswith("baseColor")}
    if material.get("alphaMode") in ("OPAQUE", "MASK"):
        del material["alphaMode"]
    return None if material == PLAIN and all(texture == TextureSource() for texture in undrawn.textures) else undrawn


def without_textures(value: Any) -> Any:
    """Copy of a material without references to textures."""
    if not isinstance(value, dict):
        return value
    return {key: without_textures(item) for key, item in value.items() if not is_texture(key, item)}


class _Collector:
    """Copies the known entries of a material, and numbers the textures that they refer to."""

    def __init__(self, texture_of: Callable[[int], TextureSource | None]) -> None:
        self._texture_of = texture_of
        self.textures: list[TextureSource] = []
        self.losses: list[str] = []
        self._base_coordinates: Coordinates | None = None

    def material(self, source: dict[str, Any]) -> dict[str, Any]:
        surface = object_of(source, _METALLIC_ROUGHNESS)
        self._base_coordinates = drawn_texture_coordinates(source)
        entries: dict[str, Any] = {}
        if isinstance(source.get("name"), str):
            entries["name"] = source["name"]
        infos = self._texture_infos(surface, (_BASE_TEXTURE, "metallicRoughnessTexture"))
        if metallic_roughness := numbers_of(surface, _METALLIC_ROUGHNESS_SIZES) | infos:
            entries[_METALLIC_ROUGHNESS] = metallic_roughness
        entries |= numbers_of(source, _SIZES) | self._texture_infos(source, _TEXTURES)
        if source.get("alphaMode") in ("OPAQUE", "MASK", "BLEND"):
            entries["alphaMode"] = source["alphaMode"]
        if isinstance(source.get("doubleSided"), bool):
            entries["doubleSided"] = source["doubleSided"]
        for name, content in object_of(source, "extensions").items():
            if name in EXTENSIONS and isinstance(content, dict):
                entries.setdefault("extensions", {})[name] = self._extension(content)
            else:
                self.losses.append(f"with the extension {name} drawn and saved without it")
        if is_texture(emission.MAP, source.get(emission.MAP)) and emission.MAP not in entries:
            # The factor without its map would make dark parts glow.
            return emission.strip_emission(entries)
        return entries

    def _texture_infos(self, source: dict[str, Any], names: Iterable[str]) -> dict[str, Any]:
        infos = {name: self._texture_info(name, source[name]) for name in names if is_texture(name, source.get(name))}
        return {name: info for name, info in infos.items() if info is not None}

    def _extension(self, content: dict[str, Any]) -> dict[str, Any]:
        numbers_and_texts = {key: value for key, value in content.items() if _is_copyable(value)}
        return numbers_and_texts | self._texture_infos(content, content)

    def _texture_info(self, name: str, source: dict[str, Any]) -> dict[str, Any] | None:
        """Reference to a texture; None if it cannot be written back."""
        base = None if name == _BASE_TEXTURE else self._base_coordinates
        # The map's transform relative to the meshes' texture coordinates; None if it cannot be expressed.
        transform = {} if base is None else relative(source, base)
        if transform is None:
            subject = "emission" if name == emission.MAP else "a map"
            self.losses.append(f"with {subject} on other texture coordinates drawn and saved without it")
            return None
        texture = self._texture_of(source["index"]) if isinstance(source["index"], int) else None
        if texture is None or (name != _BASE_TEXTURE and texture.image is None):
            if name != _BASE_TEXTURE:
                subject = "an unreadable map of emission drawn and" if name == emission.MAP else "an unreadable map"
                self.losses.append(f"with {subject} saved without it")
            return None
        if name == _BASE_TEXTURE:
            texture = replace(texture, image=None)
        if texture not in self.textures:
            self.textures.append(texture)
        info: dict[str, Any] = {"index": self.textures.index(texture)}
        info |= {key: source[key] for key in ("scale", "strength") if is_number(source.get(key))}
        return info | ({"extensions": {TRANSFORM: transform}} if transform else {})


def _is_copyable(value: object) -> bool:
    return all(map(is_number, value)) if isinstance(value, list) else isinstance(value, str | bool) or is_number(value)


def _differences(undrawn: GltfMaterial) -> list[str]:
    """Notes on properties that are drawn differently, phrased to follow "2 materials"."""
    material = undrawn.material
    notes = [] if emission.is_unlit(material) else _lighting_differences(material)
    if not material.get("doubleSided", False):
        notes.append("with single-sided faces drawn from both sides")
    names = [name for name in material.get("extensions", {}) if name not in _DRAWN_EXTENSIONS]
    return notes + [f"with the extension {name} drawn without it" for name in names]


def _lighting_differences(material: Mapping[str, Any]) -> list[str]:
    surface = material.get(_METALLIC_ROUGHNESS, {})
    is_shiny = surface.get("metallicFactor", 1) > 0 or surface.get("roughnessFactor", 1) < 1
    is_shiny |= SPECULAR_GLOSSINESS in object_of(material, "extensions")
    notes = {
        "with emission on other texture coordinates drawn without it": not emission.uses_base_coordinates(material),
        "with a normal map drawn without it": "normalTexture" in material,
        "with an occlusion map drawn without it": "occlusionTexture" in material,
        "with metal or gloss drawn matt": is_shiny or "metallicRoughnessTexture" in surface,
    }
    return [note for note, applies in notes.items() if applies]
