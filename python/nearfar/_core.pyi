"""The compiled kernels. Private: Python modules of nearfar check and convert, then call these."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

_Report = Callable[[int, int], object]

# base ---------------------------------------------------------------------------------------------------------------
class Error(Exception): ...
class SceneError(Error): ...
class FormatError(Error): ...
class DeviceError(Error): ...

def uniform(seed: int, cell: int, index: NDArray[np.uint64]) -> NDArray[np.float64]: ...
def thread_count() -> int: ...

# scene --------------------------------------------------------------------------------------------------------------
_FaceMap = int | NDArray[np.int32] | tuple[NDArray[np.uint32], NDArray[np.int32]]

class Mesh:
    def __new__(
        cls,
        positions: NDArray[np.float32],
        faces: NDArray[np.uint32],
        *,
        uvs: NDArray[np.float32] | None = None,
        colors: NDArray[np.uint8] | None = None,
        objects: _FaceMap,
        materials: _FaceMap,
    ) -> Mesh: ...
    @property
    def vertex_count(self) -> int: ...
    @property
    def face_count(self) -> int: ...

class Scene:
    def __new__(
        cls,
        *,
        origin: tuple[float, float, float],
        meshes: list[Mesh],
        placements: NDArray[np.float64],
        objects: NDArray[np.int32],
        standing_count: int,
        material_colors: NDArray[np.float32],
        material_textures: NDArray[np.int32],
        material_cutoffs: NDArray[np.float32],
        textures: list[NDArray[np.uint8]],
    ) -> Scene: ...
    def posed(self, placements: NDArray[np.float64]) -> Scene: ...
    def build(self, report: _Report | None = None) -> None: ...
    @property
    def triangle_count(self) -> int: ...
    @property
    def standing_triangle_count(self) -> int: ...
    @property
    def instance_count(self) -> int: ...
    def triangle_offsets(self) -> NDArray[np.int64]: ...
    def bounds(self) -> NDArray[np.float64]: ...
    def triangles(self) -> NDArray[np.float32]: ...
