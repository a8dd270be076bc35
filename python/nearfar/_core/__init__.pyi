"""The compiled kernels. Private: Python modules of nearfar check and convert, then call these."""

from collections.abc import Callable
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from nearfar._core.export import (
    Export as Export,
    decode_ranges as decode_ranges,
    encode_ranges as encode_ranges,
    halved_texture as halved_texture,
    texels_per_radian as texels_per_radian,
)
from nearfar._core.gpu import (
    GpuDevice as GpuDevice,
    GpuFrame as GpuFrame,
    GpuJob as GpuJob,
    gpu_adapters as gpu_adapters,
    gpu_close as gpu_close,
    gpu_cube_lookup as gpu_cube_lookup,
    gpu_discontinuity as gpu_discontinuity,
    gpu_forked as gpu_forked,
    gpu_is_hardware as gpu_is_hardware,
    gpu_keep as gpu_keep,
    gpu_morph as gpu_morph,
    gpu_similarity as gpu_similarity,
)
from nearfar._core.lod import (
    carry as carry,
    check_weights as check_weights,
    collapse as collapse,
    first_alike as first_alike,
    fit_4pl as fit_4pl,
    pieces as pieces,
    select_levels as select_levels,
    spend_triangles as spend_triangles,
)
from nearfar._core.orthoview import (
    OrthoCells as OrthoCells,
    OrthoParent as OrthoParent,
    OrthoRule as OrthoRule,
    OrthoSplats as OrthoSplats,
    OrthoViews as OrthoViews,
    blend_orthoviews as blend_orthoviews,
    blend_past as blend_past,
    blur_motion as blur_motion,
    expected_orthoviews as expected_orthoviews,
    gpu_keep_orthoviews as gpu_keep_orthoviews,
    gpu_orthoview_bytes as gpu_orthoview_bytes,
    orthoview_axes as orthoview_axes,
    orthoview_steps as orthoview_steps,
    orthoview_surfels as orthoview_surfels,
    splat_orthoviews as splat_orthoviews,
)
from nearfar._core.serve import (
    Server as Server,
    begin_log as begin_log,
    certificate as certificate,
    room_token as room_token,
    self_signed as self_signed,
)
from nearfar._core.stereo import HybridRig as HybridRig
from nearfar._core.stored import StoredMeshes as StoredMeshes

_Report = Callable[[int, int], object] | None
_F32 = NDArray[np.float32]
_F64 = NDArray[np.float64]
_I32 = NDArray[np.int32]
_I64 = NDArray[np.int64]
_U8 = NDArray[np.uint8]
_U16 = NDArray[np.uint16]
_U32 = NDArray[np.uint32]
_U64 = NDArray[np.uint64]
_Bools = NDArray[np.bool_]
_Point = tuple[float, float, float]
_Quad = tuple[float, float, float, float]

# base ---------------------------------------------------------------------------------------------------------------
class Error(Exception): ...
class SceneError(Error): ...
class FormatError(Error): ...
class DeviceError(Error): ...

def uniform(seed: int, cell: int, index: _U64) -> _F64: ...
def thread_count() -> int: ...
def probe(behaviour: str, report: _Report = None) -> None: ...

# scene --------------------------------------------------------------------------------------------------------------
_FaceMap = int | _I32 | tuple[_U32, _I32]

@final
class Mesh:
    def __new__(
        cls,
        positions: _F32,
        faces: _U32,
        *,
        uvs: _F32 | None = None,
        colors: _U8 | None = None,
        normals: _F32 | None = None,
        objects: _FaceMap,
        materials: _FaceMap,
    ) -> Mesh: ...
    @staticmethod
    def merged(meshes: list[Mesh], placements: _F64, objects: _I32) -> Mesh: ...
    def flip_faces(self) -> Mesh: ...
    def bounds(self) -> _F64: ...
    @property
    def vertex_count(self) -> int: ...
    @property
    def face_count(self) -> int: ...

@final
class Scene:
    def __new__(
        cls,
        *,
        origin: _Point,
        meshes: list[Mesh],
        placements: _F64,
        objects: _I32,
        standing_count: int,
        material_colors: _F32,
        material_textures: _I32,
        material_cutoffs: _F32,
        material_emissions: _F32,
        material_emission_textures: _I32,
        material_unlit: _Bools,
        material_tags: _U64,
        textures: list[_U8],
    ) -> Scene: ...
    def merged(self) -> Mesh: ...
    def of_mesh(self, mesh: Mesh) -> Scene: ...
    def posed(self, placements: _F64) -> Scene: ...
    def with_moving(self, chosen: _Bools) -> Scene: ...
    def subset_of_objects(self, chosen: _Bools) -> Scene: ...
    def without_objects(self, chosen: _Bools) -> Scene: ...
    def subset_of_triangles(self, chosen: _Bools) -> Scene: ...
    def query(self, least: _Point, greatest: _Point, builds: bool) -> tuple[Scene, _U32 | None]: ...
    def touches(self, least: _Point, greatest: _Point) -> bool: ...
    @staticmethod
    def join(scenes: list[Scene], objects: list[_I32]) -> Scene: ...
    def moving_placements(self) -> _F64: ...
    def moving_objects(self) -> _I32: ...
    @property
    def origin(self) -> _Point: ...
    @property
    def material_count(self) -> int: ...
    @property
    def texture_count(self) -> int: ...
    def degenerate_count(self) -> int: ...
    def bytes(self) -> int: ...
    def mesh_ids(self) -> _U64: ...
    def build(self, report: _Report = None) -> None: ...
    @property
    def triangle_count(self) -> int: ...
    @property
    def standing_triangle_count(self) -> int: ...
    @property
    def instance_count(self) -> int: ...
    def triangle_offsets(self) -> _I64: ...
    def bounds(self) -> _F64: ...
    def triangles(self) -> _F32: ...

@final
class Levels:
    def __new__(cls, models: list[list[Mesh]]) -> Levels: ...
    def choose(self, scene: Scene, models: _I32, chosen: _I32) -> Scene: ...

def with_surfaces(scene: Scene, others: list[Scene]) -> tuple[Scene, list[Mesh]]: ...
def with_instances(scene: Scene, meshes: list[Mesh], placements: _F64, objects: _I32, standing_count: int) -> Scene: ...
def placements_of(scene: Scene, chosen: _Bools) -> tuple[_F64, _I32]: ...
def exchange_paths(first: str, second: str) -> bool: ...
def read_wavefront(text: bytes) -> tuple[Any, list[str], list[str], list[tuple[Any, Any, _U32, _U32]], int]: ...
def decode_meshopt(data: _U8, count: int, stride: int, mode: str, filter: str) -> _U32: ...  # noqa: A002
def triangulate_polygons(points: _F64, rings: _I64, polygons: _I64) -> tuple[_U32, _I64]: ...
def polygon_prisms(points: _F64, rings: _I64, polygons: _I64, has_floor: _Bools) -> tuple[_U32, _I64]: ...
def read_wkb(data: _U8, offsets: _I64) -> tuple[_F64, _I64, _I64, _I64, int]: ...
def scene_parts(scene: Scene) -> dict[str, Any]: ...
def mesh_parts(mesh: Mesh) -> dict[str, Any]: ...

# camera -------------------------------------------------------------------------------------------------------------
@final
class Camera:
    def __new__(
        cls,
        position: _Point,
        orientation: _Quad,
        size: tuple[int, int],
        *,
        kind: str,
        bounds: _Quad = ...,
        face: int = 0,
    ) -> Camera: ...
    def project(self, points: _F64) -> _F64: ...
    def rays(self) -> tuple[_F64, _F64]: ...
    @property
    def is_parallel(self) -> bool: ...
    @property
    def least_pixel_angle(self) -> float: ...

@final
class DepthBuffer:
    def __new__(
        cls, size: tuple[int, int], *, kind: str, bounds: _Quad = ..., near: float, far: float, reverse: bool
    ) -> DepthBuffer: ...
    @staticmethod
    def from_matrix(size: tuple[int, int], rows: list[list[float]], low: float) -> DepthBuffer: ...
    def ranges(self, depth: NDArray[Any]) -> NDArray[Any]: ...
    def depths(self, ranges: NDArray[np.float32 | np.float64]) -> NDArray[Any]: ...

# trace --------------------------------------------------------------------------------------------------------------
def cast_rays(
    scene: Scene,
    origins: NDArray[np.float32 | np.float64],
    directions: NDArray[np.float32 | np.float64],
    t_max: float,
    report: _Report = None,
) -> tuple[_F32, _I64, _I32, _F32]: ...
def nearest_points(
    scene: Scene, points: _F32 | _F64, *, facing: _F32 | None = None, report: _Report = None
) -> tuple[_F64, _I64, _F64]: ...
def instruction_sets() -> list[str]: ...
def use_instruction_set(name: str) -> None: ...

# partition ----------------------------------------------------------------------------------------------------------
def triangle_radii(
    vertices: _F32 | _F64, faces: _U32 | None, center: _Point, report: _Report = None
) -> _F32 | _F64: ...
def object_radii(
    scene: Scene, object_count: int, *, center: _Point, reach: float, rule: str, report: _Report = None
) -> tuple[_F32, int]: ...
def ring_loads(scene: Scene, rings: _U16, count: int) -> _I64: ...

@final
class Partition:
    def __new__(cls, scene: Scene, *, center: _Point, r1: float, r2: float, report: _Report = None) -> Partition: ...
    def triangles(self, part: str) -> _I64: ...
    def near_objects(self) -> _I32: ...
    def counts(self) -> dict[str, int]: ...
    def validate(self, report: _Report = None) -> None: ...

@final
class LoadCurve:
    def __new__(cls, scene: Scene, *, center: _Point, report: _Report = None) -> LoadCurve: ...
    def count(self, r2: _F64) -> _I64: ...
    def radius(self, budget: _I64) -> _F64: ...
    @property
    def total(self) -> int: ...
    @property
    def moving(self) -> int: ...

# morph --------------------------------------------------------------------------------------------------------------
def morph(
    points: _F32 | _F64,
    shown: NDArray[Any],
    *,
    user: _Point,
    center: _Point,
    r1: float,
    r2: float,
    kind: str,
    strength: float,
) -> int: ...

# bend ---------------------------------------------------------------------------------------------------------------
def bend_rays(
    directions: _F64,
    *,
    user: _Point,
    center: _Point,
    r1: float,
    r2: float,
    kind: str,
    strength: float,
    tolerance: float,
    report: _Report = None,
) -> tuple[_F64, int]: ...
def fold_margin(user: _Point, *, center: _Point, r1: float, r2: float, kind: str, strength: float) -> float: ...

# tessellate ---------------------------------------------------------------------------------------------------------
def tessellate_scene(
    scene: Scene,
    *,
    center: _Point,
    radii: tuple[float, float],
    stages: tuple[float, bool] | None,
    reach: float,
    tolerance: float,
    chosen: _Bools | None = None,
    report: _Report = None,
) -> tuple[Scene, dict[str, int]]: ...
def tessellate_arrays(
    vertices: _F64,
    faces: _U32,
    *,
    center: _Point,
    radii: tuple[float, float],
    stages: tuple[float, bool] | None,
    reach: float,
    tolerance: float,
    report: _Report = None,
) -> dict[str, NDArray[Any]]: ...

# cubemap ------------------------------------------------------------------------------------------------------------
_InOut = tuple[NDArray[Any], NDArray[Any]]
_Shape = tuple[str, int, int]

def cube_lookup(maps: _InOut, directions: NDArray[Any], filter: str) -> None: ...  # noqa: A002
def cube_nearest(maps: _InOut, directions: NDArray[Any]) -> None: ...
def cube_footprint(maps: _InOut, directions: NDArray[Any], filter: str, radius: float) -> None: ...  # noqa: A002
def cube_next_level(levels: _InOut, filter: str) -> None: ...  # noqa: A002
def cube_solid_angles(out: _F64) -> None: ...
def convert_envmap(
    pictures: _InOut,
    shapes: tuple[_Shape, _Shape],
    *,
    filter: str,  # noqa: A002
    samples: int,
    report: _Report = None,
) -> None: ...
def convert_envmap_nearest(pictures: _InOut, shapes: tuple[_Shape, _Shape], *, report: _Report = None) -> None: ...
def envmap_directions(shape: _Shape, out: _F64) -> None: ...
def envmap_texels(shape: _Shape, directions: NDArray[Any], out: _I64) -> None: ...

# render -------------------------------------------------------------------------------------------------------------
def render_truth(
    scene: Scene, camera: Camera, settings: dict[str, Any], *, report: _Report = None
) -> dict[str, NDArray[Any]]: ...
def silhouettes(scene: Scene, cameras: list[Camera]) -> _Bools: ...
def luma_near(
    scene: Scene, cameras: list[Camera], shown: _Bools, *, samples: int, weights: _Point, reach: int
) -> _F64: ...
def sample_offsets(samples: int) -> list[list[float]]: ...
def gather_frames(color: _F32, motion: _F32, distance: _F32, gathered: _F32, share: float) -> _F32: ...
def encode_srgb(linear: _F32) -> _U8: ...

# reduce -------------------------------------------------------------------------------------------------------------
def bake(
    scene: Scene,
    *,
    center: _Point,
    radius: float,
    size: int,
    samples: int,
    range: bool,  # noqa: A002
    object_id: bool,
    report: _Report = None,
) -> tuple[dict[str, NDArray[Any]], int]: ...
def bake_rings(
    scene: Scene,
    *,
    center: _Point,
    size: int,
    samples: int,
    range: bool,  # noqa: A002
    object_id: bool,
    rings: _U16,
    count: int,
    report: _Report = None,
) -> tuple[dict[str, NDArray[Any]], list[tuple[_I64, dict[str, NDArray[Any]]]]]: ...

@final
class Reduced:
    def __new__(
        cls,
        partition: Partition,
        *,
        morph: str,
        boundary: float,
        size: int = 0,
        color: _F32 | None = None,
        range: _F32 | None = None,  # noqa: A002
        object_id: _I32 | None = None,
        report: _Report = None,
    ) -> Reduced: ...
    def render(
        self,
        scene: Scene,
        camera: Camera,
        settings: dict[str, Any],
        *,
        user: _Point | None,
        radius: float | None,
        strength: float,
        method: str,
        mapped: bool,
        tolerance_px: float,
        conventional_dynamic: str,
        report: _Report = None,
    ) -> dict[str, Any]: ...
    def fold_margin(self, user: _Point, radius: float | None, strength: float) -> float: ...
    @property
    def near_bytes(self) -> int: ...

# metrics ------------------------------------------------------------------------------------------------------------
_Settings = tuple[str, int, float, tuple[float, float], int, bool, bool, bool]

def mean_squared_errors(
    references: NDArray[Any], tests: NDArray[Any], *, ranges: bool
) -> list[tuple[float, float, float]]: ...
def similarity(
    references: NDArray[Any],
    tests: NDArray[Any],
    *,
    settings: _Settings,
    masks: _U8 | None = None,
    map_shape: tuple[int, ...] | None = None,
    report: _Report = None,
) -> tuple[list[list[float]], NDArray[Any] | None]: ...
def multiscale(
    references: NDArray[Any], tests: NDArray[Any], *, settings: _Settings, scales: int
) -> list[tuple[list[list[float]], float, float]]: ...
def discontinuity(
    position: _F32,
    *,
    origin: _Point,
    width: int,
    camera: Camera,
    epsilon: float,
    min_distance: float,
    report: _Report = None,
) -> _F32: ...
def tear(
    position: _F32,
    *,
    origin: _Point,
    width: int,
    camera: Camera,
    epsilon: float,
    side: _Bools | None = None,
    wanted: _Bools | None = None,
    report: _Report = None,
) -> tuple[_F32, _Bools]: ...
def object_completion(reference: _I32, test: _I32) -> tuple[float, float] | None: ...

# bounds -------------------------------------------------------------------------------------------------------------
def bounding_sphere(points: _F32 | _F64, *, method: str) -> list[float]: ...
def bounding_spheres(
    points: _F32 | _F64, offsets: _I64, *, method: str, report: _Report = None
) -> list[list[float]]: ...
def solid_angles(centers: _F64, radii: _F64, eye: _Point) -> _F64: ...

# lens ---------------------------------------------------------------------------------------------------------------
@final
class RadialLens:
    def __new__(cls, k: list[float], tangential: tuple[float, float]) -> RadialLens: ...
    @property
    def r_max(self) -> float: ...
    @property
    def x_max(self) -> float: ...
    @property
    def reach(self) -> float: ...
    def table_bound(self) -> tuple[float, float]: ...
    def distort(self, r: NDArray[Any], refuse: bool) -> NDArray[Any]: ...
    def derivative(self, r: NDArray[Any], refuse: bool) -> NDArray[Any]: ...
    def undistort(self, r: NDArray[Any], method: str, iterations: int, refuse: bool) -> NDArray[Any]: ...
    def distort_points(self, places: NDArray[Any], refuse: bool) -> NDArray[Any]: ...
    def undistort_points(self, places: NDArray[Any], refuse: bool) -> NDArray[Any]: ...

def warp(
    lenses: list[RadialLens],
    picture: NDArray[Any],
    *,
    from_fov: _Quad,
    to_fov: _Quad,
    tan_omega: float,
    size: tuple[int, int],
    distort: bool,
    filter: str,  # noqa: A002
    fill: float,
) -> NDArray[Any]: ...
def warp_mesh(
    lenses: list[RadialLens],
    *,
    from_fov: _Quad,
    to_fov: _Quad,
    tan_omega: float,
    cells: tuple[int, int],
    size: tuple[int, int],
    distort: bool,
) -> tuple[_F64, _F64, _U32, float]: ...
def corrected_solid_angles(
    lens: RadialLens, centers: _F64, radii: _F64, *, eye: _Point, forward: _Point, tan_omega: float, exact: bool
) -> _F64: ...

# exr ----------------------------------------------------------------------------------------------------------------
_Part = tuple[str, dict[str, NDArray[Any]], dict[str, str | _Point]]

def encode_exr(parts: list[_Part]) -> _U8: ...
def decode_exr(data: bytes) -> list[_Part]: ...
