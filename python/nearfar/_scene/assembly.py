"""Collects materials, meshes and placements, and decides which meshes are merged and which stay instances."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._scene.arrays import (
    MOST_CUTOFF,
    colors_of,
    faces_of,
    normals_of,
    numbers_of,
    origin_for,
    positions_of,
    texture_of,
    transforms_of,
    uvs_of,
)
from nearfar._scene.budget import Budget
from nearfar._scene.emission import DARK, MOST_EMISSION
from nearfar._scene.material_list import MaterialList
from nearfar._scene.materials import BaseColor
from nearfar._scene.names import MOST_OBJECTS, names_of
from nearfar._scene.undrawn import Undrawn

_OWN_OBJECTS = -1
"""Object number of an instance whose mesh has an object number for each face."""

_ROW = 12
"""Bytes of a vertex's position, and of a face."""

_MOST_VERTICES = 2**32 - 2**16
"""Greatest number of vertices of a merged mesh, whose indices have 32 bits."""


@dataclass(frozen=True)
class Assembled:
    """The parts of a `nearfar.Scene`."""

    core: _core.Scene
    names: Sequence[str] | int
    frames: NDArray[np.float64] | None
    """Load transforms of the objects (N, 4, 4), object→world; None where all are identities."""
    dropped: int = 0
    """Number of the source's faces that were left out."""
    notes: tuple[str, ...] = ()
    """Parts of the source that are ignored or drawn differently, one sentence each."""
    used: tuple[str, ...] = ()
    """Parts of the source that the scene uses, one phrase each."""
    undrawn: Mapping[int, Undrawn] = field(default_factory=dict)
    """Properties of materials that are not drawn, by their tags in `core`."""


@dataclass(frozen=True)
class _Mesh:
    core: _core.Mesh
    base: NDArray[np.float64]
    """Whole metres (3,) that were subtracted from the vertices."""
    has_objects: bool


@dataclass(frozen=True)
class _Placements:
    """For each of K instances: mesh (K,), transform mesh→world including the mesh's base (K, 4, 4), object (K,)."""

    mesh: NDArray[np.int64]
    transform: NDArray[np.float64]
    object: NDArray[np.int32]


class Assembly:
    """Implementation of `nearfar.SceneBuilder`, which adds the step to a `Scene`."""

    def __init__(self) -> None:
        self._materials = MaterialList()
        self._meshes: list[_Mesh] = []
        self._placed: list[tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.int32]]] = []
        self._names: dict[str, int] = {}
        self._nameless: int | None = None

    def material(
        self,
        base_color: Sequence[float] = (0.8, 0.8, 0.8, 1.0),
        texture: NDArray[np.uint8] | None = None,
        cutoff: float | None = None,
        *,
        emission: Sequence[float] = DARK,
        emission_texture: NDArray[np.uint8] | None = None,
        unlit: bool = False,
    ) -> int:
        """Add a material and return its number; equal ones share a number.

        Parameters
        ----------
        base_color
            Linear RGB and alpha, 0..1, multiplied with the texture and the vertex colours.
        texture
            (H, W, 4) uint8, sRGB with linear alpha, row 0 on top. Passing the same array again shares the texture.
        cutoff
            Least alpha that is drawn; None draws everything opaque.
        emission
            Linear RGB of the light that the surface emits, 0..65503, added to what it reflects.
        emission_texture
            Image that the emission is multiplied with, as `texture`; its alpha counts for nothing.
        unlit
            True shows the base colour as it is, whatever the light. Such a material emits nothing, as in glTF.
        """
        colors = check.array("base_color", base_color, columns=None, dtype=np.float32)
        if colors.shape != (4,):
            raise ValueError(f"base_color: expected linear RGBA, four numbers in 0..1, got shape {colors.shape}")
        if not ((colors >= 0) & (colors <= 1)).all():
            raise ValueError(f"base_color: expected linear RGBA, four numbers in 0..1, got {colors.tolist()}")
        light = check.array("emission", emission, columns=None, dtype=np.float32)
        if light.shape != (3,) or not ((light >= 0) & (light <= MOST_EMISSION)).all():
            got = f"shape {light.shape}" if light.shape != (3,) else light.tolist()
            raise ValueError(f"emission: expected linear RGB, three numbers in 0..{MOST_EMISSION:g}, got {got}")
        if check.flag("unlit", unlit) and light.any():
            raise ValueError(f"unlit: expected False for a material that emits light, got True and {light.tolist()}")
        red, green, blue, alpha = colors.tolist()
        cutoff = None if cutoff is None else check.within("cutoff", cutoff, -MOST_CUTOFF, MOST_CUTOFF)
        for name, image in (("texture", texture), ("emission_texture", emission_texture)):
            if image is not None:
                texture_of(name, image)
        glow = (light[0].item(), light[1].item(), light[2].item())
        return self._material(BaseColor((red, green, blue, alpha), texture, cutoff, glow, emission_texture, unlit))

    def _material(self, material: BaseColor) -> int:
        """Add a material of usable values."""
        return self._materials.add(material)

    def mesh(
        self,
        positions: ArrayLike,
        faces: ArrayLike,
        *,
        material: int | ArrayLike = 0,
        uvs: ArrayLike | None = None,
        colors: ArrayLike | None = None,
        normals: ArrayLike | None = None,
        face_object: ArrayLike | None = None,
        copy: bool = False,
    ) -> int:
        """Add a mesh and return its handle.

        Parameters
        ----------
        positions
            (V, 3) metres in the mesh's own frame. C-contiguous float32 is borrowed and made read-only unless `copy`.
        faces
            (F, 3) vertex numbers, counter-clockwise from outside. C-contiguous uint32 is borrowed likewise.
        material
            Number of a material, or one for each face.
        uvs
            (V, 2) texture coordinates, v pointing up.
        colors
            (V, 3) or (V, 4) uint8, sRGB with linear alpha.
        normals
            (V, 3) outward directions for shading: interpolated between corners, normalised, and turned to the viewer's
            side of the face. A vertex with zeros uses the face's normal. C-contiguous float32 of unit length is
            borrowed like `positions`. None shades faces flat.
        face_object
            Object number of each face (see `objects`), for meshes that hold many objects.
        """
        copy = check.flag("copy", copy)
        if not self._materials:
            self.material()
        local, base = positions_of("positions", positions, copy=copy)
        triangles = faces_of("faces", faces, copy=copy)
        count = len(triangles)
        objects: int | NDArray[np.int32] = _OWN_OBJECTS
        if face_object is not None:
            objects = numbers_of("face_object", face_object, count, self.object_count, copy=copy)
        core = _core.Mesh(
            local,
            triangles,
            uvs=None if uvs is None else uvs_of("uvs", uvs),
            colors=None if colors is None else colors_of("colors", colors, len(local)),
            normals=None if normals is None else normals_of("normals", normals, len(local), copy=copy),
            objects=objects,
            materials=self._face_materials(material, count),
        )
        self._meshes.append(_Mesh(core, base, face_object is not None))
        return len(self._meshes) - 1

    def _face_materials(self, material: int | ArrayLike, count: int) -> int | NDArray[np.int32]:
        limit = len(self._materials)
        if not isinstance(material, int | np.integer):
            return numbers_of("material", material, count, limit, copy=True)
        return check.integer("material", material, 0, limit - 1)

    @property
    def object_count(self) -> int:
        """Number of objects named or announced so far."""
        return len(self._names) if self._nameless is None else self._nameless

    def objects(self, names: Sequence[str] | int) -> None:
        """Announce the objects of `face_object` by names or by their number, before any other object is named."""
        if self._names or self._nameless is not None:
            raise ValueError("objects: expected to come before any other object, got it after some")
        if isinstance(names, int):
            self._nameless = check.integer("names", names, 0, MOST_OBJECTS)
        else:
            self._names = {name: number for number, name in enumerate(names_of("names", names))}

    def object(self, name: str) -> int:
        """Return the number of the object of that name; a new name gets a new number."""
        if self._nameless is not None:
            raise ValueError(f"name: expected none after nameless objects, got {check.described(name)}")
        return self._names.setdefault(check.text("name", name), len(self._names))

    def instance(self, mesh: int, transform: ArrayLike | None = None, *, name: str | None = None) -> None:
        """Place a mesh.

        Parameters
        ----------
        mesh
            Handle from `mesh`.
        transform
            (4, 4) object→world for column vectors; None stands for the identity.
        name
            Object that the mesh belongs to. Meshes of one name form one object; the transform of the first mesh is the
            object's load transform. None only for meshes with a `face_object`.
        """
        matrix = np.eye(4) if transform is None else transforms_of("transform", transform)
        if matrix.ndim != 2:
            raise ValueError(f"transform: expected one 4x4 matrix, got shape {matrix.shape}")
        if self._checked(mesh).has_objects != (name is None):
            raise ValueError("name: expected one exactly for meshes without face_object")
        number = _OWN_OBJECTS if name is None else self.object(name)
        self._placed.append((np.array([mesh], np.int64), matrix[None], np.array([number], np.int32)))

    def place_many(self, mesh: int, transforms: ArrayLike, names: Sequence[str] | str) -> None:
        """Place a mesh many times.

        Parameters
        ----------
        mesh
            Handle from `mesh`.
        transforms
            (K, 4, 4) object→world for column vectors.
        names
            Object of each instance, or a prefix: the objects are then called ``prefix_0``, ``prefix_1``, …
        """
        matrices = transforms_of("transforms", transforms)
        if matrices.ndim != 3:
            raise ValueError(f"transforms: expected shape (K, 4, 4), got {matrices.shape}")
        if self._checked(mesh).has_objects:
            raise ValueError("mesh: expected one without face_object")
        if isinstance(names, str):
            names = [f"{names}_{index}" for index in range(len(matrices))]
        names = check.texts("names", names)
        if len(names) != len(matrices):
            raise ValueError(f"names: expected {len(matrices)}, one for each transform, got {len(names)}")
        self._place(np.full(len(matrices), mesh, np.int64), matrices, names)

    def _place(self, meshes: NDArray[np.int64], transforms: NDArray[np.float64], names: Sequence[str]) -> None:
        """Place meshes without `face_object`: a handle, a usable transform and an object's name for each of K."""
        numbers = np.fromiter((self.object(name) for name in names), np.int32, len(names))
        self._placed.append((meshes, transforms, numbers))

    def _checked(self, mesh: int) -> _Mesh:
        if not self._meshes:
            raise ValueError("mesh: expected a handle of this builder, which has no mesh yet")
        return self._meshes[check.integer("mesh", mesh, 0, len(self._meshes) - 1)]

    def _assemble(
        self,
        dynamic: Iterable[str] = (),
        budget: Budget | None = None,
        origin: NDArray[np.float64] | None = None,
    ) -> Assembled:
        """Merge static meshes that are placed once, keep the others as instances, and choose the origin unless given.

        A `budget` counts the copies of meshes that are merged although they are placed many times.
        """
        placed = self._placements()
        movers = np.zeros(self.object_count + 1, bool)  # the last entry, index -1, is for meshes with `face_object`
        named = [dynamic] if isinstance(dynamic, str) else check.items("dynamic", dynamic, str, "names of objects")
        movers[[self._object_number(name) for name in named]] = True
        merges = self._is_merged(placed, movers[placed.object])
        if budget is not None:
            budget.take(self._copied_bytes(placed.mesh[merges]))
        core = self._scene_at(placed, merges, np.zeros(3) if origin is None else origin)
        if origin is None and (chosen := origin_for(core.bounds())).any():
            core = self._scene_at(placed, merges, chosen)
        names = tuple(self._names) if self._nameless is None else self._nameless
        return Assembled(core.with_moving(movers[:-1]), names, self._frames(), undrawn=self._materials.undrawn)

    def _object_number(self, name: str) -> int:
        if name not in self._names:
            raise ValueError(f"dynamic: expected names of objects, got {check.shortened(name)}")
        return self._names[name]

    def _placements(self) -> _Placements:
        if not self._placed:
            return _Placements(np.zeros(0, np.int64), np.zeros((0, 4, 4)), np.zeros(0, np.int32))
        mesh = np.concatenate([handles for handles, _, _ in self._placed])
        transform = np.concatenate([matrices for _, matrices, _ in self._placed])
        bases = np.array([mesh.base for mesh in self._meshes])
        if bases.any():
            transform[:, :3, 3] += np.einsum("kij,kj->ki", transform[:, :3, :3], bases[mesh])
        return _Placements(mesh, transform, np.concatenate([objects for _, _, objects in self._placed]))

    def _copied_bytes(self, merged: NDArray[np.int64]) -> int:
        """Bytes of the merged copies of meshes beside the first of each."""
        copies = np.maximum(np.bincount(merged, minlength=len(self._meshes)) - 1, 0)
        used = np.flatnonzero(copies)
        sizes = [self._meshes[handle].core.vertex_count + self._meshes[handle].core.face_count for handle in used]
        return sum(_ROW * size * count for size, count in zip(sizes, copies[used].tolist(), strict=True))

    def _is_merged(self, placed: _Placements, moves: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Flags of the merged instances: static meshes placed once, and flat ones, whose transforms have no inverse."""
        once = np.bincount(placed.mesh, minlength=len(self._meshes))[placed.mesh] == 1
        scale = np.abs(placed.transform[:, :3, :3]).sum(axis=(1, 2)) ** 3
        # A determinant below 1e-30 of the size cubed is rounding error: float64 has 16 digits on each of three axes.
        flat = np.abs(np.linalg.det(placed.transform[:, :3, :3])) <= 1e-30 * scale
        if (flat & moves).any():
            name = tuple(self._names)[placed.object[np.argmax(flat & moves)]]
            raise ValueError(f"dynamic: expected objects with invertible transforms, got a flat one for {name!r}")
        merged: NDArray[np.bool_] = (once & ~moves) | flat
        return merged

    def _scene_at(self, placed: _Placements, merges: NDArray[np.bool_], origin: NDArray[np.float64]) -> _core.Scene:
        placements = placed.transform[:, :3].copy()
        placements[:, :, 3] -= origin
        groups = self._merge_groups(np.flatnonzero(merges), placed)
        if len(groups) == 1 and len(groups[0]) == 1 and np.array_equal(placements[groups[0][0]], np.eye(4)[:3]):
            merges, groups = np.zeros_like(merges), []  # a single mesh at the identity is used without a copy
        merged = [self._merged(rows, placed, placements) for rows in groups]
        rest = np.flatnonzero(~merges)
        identities = np.broadcast_to(np.eye(4)[:3], (len(merged), 3, 4))
        face_objects = np.full(len(merged), _OWN_OBJECTS, np.int32)
        return _core.Scene(
            origin=(float(origin[0]), float(origin[1]), float(origin[2])),
            meshes=merged + self._instanced(rest, placed),
            placements=np.concatenate([identities, placements[rest]]),
            objects=np.concatenate([face_objects, placed.object[rest]]),
            standing_count=len(merged) + len(rest),
            **self._materials.arguments(),
        )

    def _instanced(self, rows: NDArray[np.int64], placed: _Placements) -> list[_core.Mesh]:
        """Meshes of instances; mirrored instances get meshes with reversed faces, so that outsides stay outsides."""
        mirrored = np.linalg.det(placed.transform[rows, :3, :3]) < 0
        twins = {handle: self._meshes[handle].core.turned() for handle in set(placed.mesh[rows[mirrored]].tolist())}
        pairs = zip(placed.mesh[rows].tolist(), mirrored.tolist(), strict=True)
        return [twins[handle] if is_mirrored else self._meshes[handle].core for handle, is_mirrored in pairs]

    def _merge_groups(self, rows: NDArray[np.int64], placed: _Placements) -> list[NDArray[np.int64]]:
        if not len(rows):
            return []
        vertices = np.cumsum([self._meshes[handle].core.vertex_count for handle in placed.mesh[rows]])
        group = vertices // _MOST_VERTICES
        return np.split(rows, np.flatnonzero(np.diff(group)) + 1)

    def _merged(self, rows: NDArray[np.int64], placed: _Placements, placements: NDArray[np.float64]) -> _core.Mesh:
        meshes = [self._meshes[handle].core for handle in placed.mesh[rows]]
        return _core.Mesh.merged(meshes, placements[rows], placed.object[rows])

    def _frames(self) -> NDArray[np.float64] | None:
        """Load transforms of the objects (N, 4, 4), those of their first instances; None if all are identities."""
        frames = np.tile(np.eye(4), (len(self._names), 1, 1))
        for _, matrices, objects in reversed(self._placed):
            if len(objects) and objects[0] != _OWN_OBJECTS:
                frames[objects[::-1]] = matrices[::-1]
        return frames if len(frames) and (frames != np.eye(4)).any() else None
