"""Reduction of 3D scenes that are too heavy for a thin VR device, and measures of the loss in image quality."""

# Imports follow the order of the pipeline, not the alphabet.
# ruff: noqa: I001
from nearfar._base.errors import DeviceError, Error, FormatError, SceneError
from nearfar._base.version import __version__
from nearfar._camera.camera import Camera, CubeFace, Fov, Orthographic
from nearfar._camera.depth import depth_from_range, range_error, range_from_depth
from nearfar._camera.shot import Shot
from nearfar._scene.builder import SceneBuilder
from nearfar._scene.scene import Scene
from nearfar._cubemap.envmap import EnvMap
from nearfar._cubemap.layouts import convert_envmap, envmap_directions, envmap_texels
from nearfar._cubemap.lookup import cube_lookup, cube_mips, cube_solid_angles
from nearfar._trace.nearest import Nearest, nearest_points
from nearfar._trace.rays import Hits, cast_rays
from nearfar._partition.load_curve import LoadCurve, load_curve
from nearfar._partition.partition import Partition, partition, triangle_radii
from nearfar._morph import morph
from nearfar._bend import bend_rays, fold_margin
from nearfar._tessellate import tessellate
from nearfar._bounds import bounding_sphere, bounding_spheres, solid_angle
from nearfar._render.frame import Frame
from nearfar._render.renderable import Renderable
from nearfar._render.sequence import render_path
from nearfar._render.truth import render
from nearfar._reduce.reduce import reduce
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._metrics.comparison import Comparison, compare
from nearfar._metrics.discontinuity import boundary, discontinuity
from nearfar._metrics.pixel_errors import object_completion, psnr, rmse
from nearfar._metrics.result import Similarity
from nearfar._metrics.similarity import ms_ssim, ssim, ssim_pairs, visual_continuity
from nearfar._lens.lens import ChromaticLens, RadialLens, corrected_solid_angle
from nearfar._lens.warp import WarpMesh
from nearfar.hmd._hmd import Hmd
from nearfar import datasets, hmd, gpu, lod

__all__ = [
    "Camera",
    "ChromaticLens",
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
    "LoadCurve",
    "Nearest",
    "Orthographic",
    "Partition",
    "RadialLens",
    "ReducedScene",
    "Renderable",
    "Scene",
    "SceneBuilder",
    "SceneError",
    "Shot",
    "Similarity",
    "WarpMesh",
    "__version__",
    "bend_rays",
    "boundary",
    "bounding_sphere",
    "bounding_spheres",
    "cast_rays",
    "compare",
    "convert_envmap",
    "corrected_solid_angle",
    "cube_lookup",
    "cube_mips",
    "cube_solid_angles",
    "datasets",
    "depth_from_range",
    "discontinuity",
    "envmap_directions",
    "envmap_texels",
    "fold_margin",
    "gpu",
    "hmd",
    "load_curve",
    "lod",
    "morph",
    "ms_ssim",
    "nearest_points",
    "object_completion",
    "partition",
    "psnr",
    "range_error",
    "range_from_depth",
    "reduce",
    "render",
    "render_path",
    "rmse",
    "solid_angle",
    "ssim",
    "ssim_pairs",
    "tessellate",
    "triangle_radii",
    "visual_continuity",
]
