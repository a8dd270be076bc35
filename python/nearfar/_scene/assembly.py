"""Collects the materials, meshes and placements of a scene."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import background, check
from nearfar._scene.arrays import (
    MAX_CUTOFF,
    colors_of,
    faces_of,
    normals_of,
    numbers_of,
    positions_of,
    texture_of,
    transforms_of,
)
from nearfar._scene.budget import Budget
from nearfar._scene.emission import DARK, MAX_EMISSION
from nearfar._scene.material_list import MaterialList
from nearfar._scene.materials import BaseColor
from nearfar._scene.names import MAX_OBJECTS, Names, names_of
from nearfar._scene.placing import OWN_OBJECTS, MeshList, Placements, core_scene


class Assembly:
    """Implementation of `nearfar.SceneBuilder`, which adds `build`."""

    def __init__(self) -> None:
        self._materials = MaterialList()
        self._meshes = MeshList()
        self._instance_columns: list[tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.int32]]] = []
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
            Alpha below which nothing is drawn; None draws everything opaque.
        emission
            Linear RGB of the emitted light, 0..65503, added to the reflected light.
        emission_texture
            Image that multiplies the emission, in the form of `texture`; its alpha is ignored.
        unlit
            True shows the base colour unshaded. Such a material emits nothing, as in glTF.
        """
        colors = check.array("base_color", base_color, columns=None, dtype=np.float32)
        if colors.shape != (4,):
            raise ValueError(f"base_color: expected linear RGBA, four numbers in 0..1, got shape {colors.shape}")
        if not ((colors >= 0) & (colors <= 1)).all():
            raise ValueError(f"base_color: expected linear RGBA, four numbers in 0..1, got {colors.tolist()}")
        light = check.array("emission", emission, columns=None, dtype=np.float32)
        if light.shape != (3,) or not ((light >= 0) & (light <= MAX_EMISSION)).all():
            got = f"shape {light.shape}" if light.shape != (3,) else light.tolist()
            raise ValueError(f"emission: expected linear RGB, three numbers in 0..{MAX_EMISSION:g}, got {got}")
        if check.flag("unlit", unlit) and light.any():
            raise ValueError(f"unlit: expected False for a material that emits light, got True and {light.tolist()}")
        red, green, blue, alpha = colors.tolist()
        cutoff = None if cutoff is None else check.in_range("cutoff", cutoff, -MAX_CUTOFF, MAX_CUTOFF)
        for name, image in (("texture", texture), ("emission_texture", emission_texture)):
            if image is not None:
                texture_of(name, image)
        rgb = (light[0].item(), light[1].item(), light[2].item())
        return self._materials.add(BaseColor((red, green, blue, alpha), texture, cutoff, rgb, emission_texture, unlit))

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
            (F, 3) vertex numbers, counter-clockwise from outside. C-contiguous uint32 is borrowed like `positions`.
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
        objects: int | NDArray[np.int32] = OWN_OBJECTS
        if face_object is not None:
            objects = numbers_of("face_object", face_object, count, self.object_count, copy=copy)
        limit = len(self._materials)
        if isinstance(material, int | np.integer):
            materials: int | NDArray[np.int32] = check.integer("material", material, 0, limit - 1)
        else:
            materials = numbers_of("material", material, count, limit, copy=True)
        core = _core.Mesh(
            local,
            triangles,
            uvs=None if uvs is None else check.array("uvs", uvs, columns=2, dtype=np.float32),
            colors=None if colors is None else colors_of("colors", colors, len(local)),
            normals=None if normals is None else normals_of("normals", normals, len(local), copy=copy),
            objects=objects,
            materials=materials,
        )
        return self._meshes.add(core, base, has_objects=face_object is not None)

    @property
    def object_count(self) -> int:
        """Number of objects named or declared so far."""
        return len(self._names) if self._nameless is None else self._nameless

    def objects(self, names: Sequence[str] | int) -> None:
        """Declare the objects of `face_object` by name or by number, before any other object is named."""
        if self._names or self._nameless is not None:
            raise ValueError("objects: expected a call before any object is named, got one after")
        if isinstance(names, int):
            self._nameless = check.integer("names", names, 0, MAX_OBJECTS)
        else:
            self._names = {name: number for number, name in enumerate(names_of("names", names))}

    def object(self, name: str) -> int:
        """Return the number of the object with that name; a new name gets a new number."""
        if self._nameless is not None:
            got = check.type_and_value(name)
            raise ValueError(f"name: expected no names of objects that were declared by number, got {got}")
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
            Object that the mesh belongs to. Meshes with the same name form one object; the transform of the first mesh
            is the object's load transform. None only for meshes with a `face_object`.
        """
        matrix = np.eye(4) if transform is None else transforms_of("transform", transform)
        if matrix.ndim != 2:
            raise ValueError(f"transform: expected one 4x4 matrix, got shape {matrix.shape}")
        if self._meshes.has_objects(mesh) != (name is None):
            raise ValueError("name: expected a name for a mesh without face_object, and None for a mesh with it")
        number = OWN_OBJECTS if name is None else self.object(name)
        self._instance_columns.append((np.array([mesh], np.int64), matrix[None], np.array([number], np.int32)))

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
        if self._meshes.has_objects(mesh):
            raise ValueError("mesh: expected one without face_object")
        if isinstance(names, str):
            names = [f"{names}_{index}" for index in range(len(matrices))]
        names = check.texts("names", names)
        if len(names) != len(matrices):
            raise ValueError(f"names: expected {len(matrices)}, one for each transform, got {len(names)}")
        self._place(np.full(len(matrices), mesh, np.int64), matrices, names)

    def _place(self, meshes: NDArray[np.int64], transforms: NDArray[np.float64], names: Sequence[str]) -> None:
        """Place K meshes without `face_object`, each with a handle, a checked transform and an object name."""
        numbers = np.fromiter((self.object(name) for name in names), np.int32, len(names))
        self._instance_columns.append((meshes, transforms, numbers))

    def _assemble(
        self, dynamic: Iterable[str] = (), budget: Budget | None = None, origin: NDArray[np.float64] | None = None
    ) -> dict[str, Any]:
        """Merge static meshes placed once, and return the arguments of `Scene`; an origin (3,) is chosen if it is None.

        A `budget` counts the copies of meshes that are merged although they are placed several times.
        """
        instances = Placements.from_columns(self._instance_columns, self._meshes.bases())
        names = Names(tuple(self._names) if self._nameless is None else self._nameless)
        moves = names.flags("dynamic", dynamic)
        # The appended entry, index −1, is for meshes with `face_object`.
        merges = instances.merges(np.append(moves, False)[instances.object], names)
        if budget is not None:
            budget.count_unpacked(instances.copied_bytes(merges, self._meshes))
        origin = instances.origin(self._meshes) if origin is None else origin
        core = core_scene(instances, merges, origin, self._meshes, self._materials.arguments())
        undrawn = self._materials.undrawn
        return {"core": core.with_moving(moves), "names": names, "frames": self._frames(), "undrawn": undrawn}

    def _frames(self) -> NDArray[np.float64] | None:
        """Load transforms (N, 4, 4) of the objects, each from its first instance; None if all are identities."""
        frames = np.tile(np.eye(4), (len(self._names), 1, 1))
        for _, matrices, objects in reversed(self._instance_columns):
            if len(objects) and objects[0] != OWN_OBJECTS:
                frames[objects[::-1]] = matrices[::-1]
        return frames if len(frames) and (frames != np.eye(4)).any() else None


def one_mesh(
    vertices: ArrayLike, faces: ArrayLike, face_object: ArrayLike | None, names: Sequence[str] | None, *, copy: bool
) -> dict[str, Any]:
    """Return the arguments of `Scene` for one mesh; its faces belong to one object, or to those in `face_object`."""
    assembly = Assembly()

    def assemble() -> dict[str, Any]:
        positions = check.array("vertices", vertices)
        if face_object is None:
            listed = names or ["object_0"]
            assembly.objects(listed)
            assembly.instance(assembly.mesh(positions, faces, copy=copy), name=listed[0])
        else:
            numbers = check.array("face_object", face_object, columns=None, dtype=np.int32)
            assembly.objects(max(0, int(numbers.max(initial=-1)) + 1) if names is None else names)
            assembly.instance(assembly.mesh(positions, faces, face_object=face_object, copy=copy))
        return assembly._assemble()

    # NumPy takes seconds for arrays of gigabytes, in functions that signals cannot interrupt.
    return background.run(assemble)
