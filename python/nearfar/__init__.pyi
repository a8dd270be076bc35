# Public names in the order of the pipeline, not of the alphabet. Type checkers read this file, and lazy_loader reads
# it to find a name on first use.
# ruff: noqa: I001
from ._base.errors import DeviceError, Error, FormatError, SceneError
from ._base.version import __version__
from ._camera.camera import Camera, CubeFace, Fov, Orthographic
from ._camera.clip import Clip
from ._camera.depth import depth_from_range, range_error, range_from_depth
from ._camera.shot import Shot
from ._scene.builder import SceneBuilder
from ._scene.options import LoadOptions
from ._scene.scene import Scene
from ._source.open import open_source
from ._source.protocol import SceneSource
from ._source.write import write_tiles
from ._cubemap.envmap import EnvMap
from ._cubemap.layouts import convert_envmap, envmap_directions, envmap_texels
from ._cubemap.lookup import cube_lookup, cube_mips, cube_solid_angles
from ._trace.nearest import Nearest, nearest_points
from ._trace.rays import Hits, cast_rays
from ._partition.load_curve import LoadCurve, load_curve
from ._partition.partition import Partition, partition, triangle_radii
from ._morph import morph
from ._bend import bend_rays, fold_margin
from ._tessellate import tessellate
from ._bounds import bounding_sphere, bounding_spheres, solid_angle
from ._render.frame import Frame
from ._render.renderable import Renderable
from ._render.settings import RenderSettings
from ._render.sequence import render_path
from ._render.truth import render
from .metrics._comparison import Comparison, compare
from .metrics._pixel_errors import psnr
from .metrics._similarity import ssim
from .metrics._window import Similarity, SsimSettings
from ._impostor.settings import ImpostorSettings
from ._reduce.choose_radii import Radii, RadiusSettings, choose_radii
from ._reduce.baking import MapSettings
from ._reduce.drawing import MorphSettings
from ._reduce.impostors import Impostors
from ._reduce.reduce import reduce
from ._reduce.reduced_scene import ReducedScene
from ._reduce.walk.plan import regions
from ._reduce.walk.recentering import Recentering
from ._reduce.walk.regions import Regions
from ._reduce.walk.walker import Walk
from ._lens.lens import ChromaticLens, RadialLens, corrected_solid_angle
from ._lens.warp import WarpMesh
from .hmd._hmd import Hmd
from .hmd._stereo import StereoFrame, render_eyes
from . import datasets, metrics, hmd, stereo, gpu, lod, orthoview, stream, view

__all__ = [
    "Camera",
    "ChromaticLens",
    "Clip",
    "Comparison",
    "CubeFace",
    "DeviceError",
    "EnvMap",
    "Error",
    "FormatError",
    "Fov",
    "Frame",
    "Hits",
    "Hmd",
    "ImpostorSettings",
    "Impostors",
    "LoadCurve",
    "LoadOptions",
    "MapSettings",
    "MorphSettings",
    "Nearest",
    "Orthographic",
    "Partition",
    "RadialLens",
    "Radii",
    "RadiusSettings",
    "Recentering",
    "ReducedScene",
    "Regions",
    "RenderSettings",
    "Renderable",
    "Scene",
    "SceneBuilder",
    "SceneError",
    "SceneSource",
    "Shot",
    "Similarity",
    "SsimSettings",
    "StereoFrame",
    "Walk",
    "WarpMesh",
    "__version__",
    "bend_rays",
    "bounding_sphere",
    "bounding_spheres",
    "cast_rays",
    "choose_radii",
    "compare",
    "convert_envmap",
    "corrected_solid_angle",
    "cube_lookup",
    "cube_mips",
    "cube_solid_angles",
    "datasets",
    "depth_from_range",
    "envmap_directions",
    "envmap_texels",
    "fold_margin",
    "gpu",
    "hmd",
    "load_curve",
    "lod",
    "metrics",
    "morph",
    "nearest_points",
    "open_source",
    "orthoview",
    "partition",
    "psnr",
    "range_error",
    "range_from_depth",
    "reduce",
    "regions",
    "render",
    "render_eyes",
    "render_path",
    "solid_angle",
    "ssim",
    "stereo",
    "stream",
    "tessellate",
    "triangle_radii",
    "view",
    "write_tiles",
]
