"""Values that single parameters must refuse, besides the hostile ones that all of them receive.

Names are patterns as in `tests.support.parameters`, of callables or of single calls, where "?@" begins a call's word.
"""

from __future__ import annotations

import functools
import math
from typing import Any

import numpy as np

import nearfar as nf
from tests.support.name_patterns import match_length

FLAT = nf.Orthographic(-1, 1, -1, 1)

UNLIKE_POSES: list[Any] = [
    {"nobody": np.eye(4)}, {"far": np.eye(3)}, {"far": np.stack([np.eye(4)] * 2)},
    {"far": np.full((4, 4), math.nan)}, {"far": np.diag([1.0, 0.0, 1.0, 1.0])}, {"far": np.diag([1.0, 1.0, 1.0, 2.0])},
    {"far": np.diag([1e31, 1.0, 1.0, 1.0])}, {"near": np.eye(4)},
]  # fmt: skip
"""Poses of an unknown object, invalid matrices, and the pose of an object that does not move."""

WRONG: dict[str, list[Any]] = {
    "Scene.at.poses ReducedScene.at.poses before_at render.at": UNLIKE_POSES,
    "*.OrthoTree.at.poses": UNLIKE_POSES[:-1],
    "aabb": [[[1.0, 1.0, 1.0], [0.0, 0.0, 0.0]]],
    "orientation": [(0.0, 0.0, 0.0, 2.0), (0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, math.inf)],
    "rotation": [(0.0, 0.0, 0.0, 0.5), (0.0, 0.0, 0.0)],
    "render*.size Camera.*size *.render_size *.warp.size *.explore.size": [(0, 5), (5, 0), (2.5, 5), (1, 2, 3)],
    "Camera.size": [(4, 2**17)],
    "*.explore.size": [(64, 5000)],
    "EnvMap.range": [np.full((6, 4, 4), -1.0)],
    "directions": [np.zeros((2, 3), np.float32)],
    "gaze": [(0.0, 0.0, 0.0)],
    "range_dtype": [np.float64],
    "orthoview.*.gaze": [(1.0, math.nan)],
    "triangle_radii.faces Scene.from_arrays.faces SceneBuilder.mesh.faces": [
        [[0, 1, 99]],
        [[0, 1, -1]],
        [[0.5, 1, 2]],
        [[0, 1, 2**40]],
    ],
    "Scene.from_arrays.vertices": [np.full((6, 3), 2e30), np.full((6, 3), -1e300)],
    "Scene.from_arrays?@objects.face_object": [[-2, 0], [2, 0]],
    "Scene.from_arrays?@objects.object_names": [["a", "a"]],
    "stream.*.radii": [[10.0, 9.0], [10.0, 10.0], [-1.0], [math.nan]],
    "bounding_spheres.offsets": [[0, 5, 3], [0, 5, 5], [-1, 5], [0.5, 5], [0, 99]],
    "ratios": [[0.5, 0.0], [1.5]],
    "depth_from_range.ranges": [[[0.05]], [[-1.0]]],
    "range_from_depth.depth": [[[-1e-9]], [[1.0001]], np.full((1, 2), 2**24, np.uint32)],
    "range_from_depth.near": [1e-310],
    "range_from_depth.projection": [nf.CubeFace(0), FLAT],
    "range_from_depth?@matrix.depth_range": [None],
    "range_from_depth?@matrix.projection": [np.ones((4, 4))],
    "weights": [[-1.0], []],
    "eccentricity_deg": [-1.0],
    "*.__call__.x": [-1.0],
    "stream.Bundle.read.name": ["../manifest.json"],
    "gpu.discontinuity.truth_camera": [nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(48, 30))],
    "gpu.morph.points": [np.zeros((3, 3))],
    "Clip.planes": [[(1, 0, 0, 1)] * 9, [(1, 0, 0, 1)] * 3, [(0, 0, 0, 1)]],
    "Clip.box": [[[-1.0, -1.0, -1.0], [1.0, -1.0, 1.0]]],
    "Hmd.name": [""],
    "Hmd.triangle_budget": [(5, 3)],
    "Hmd.lens corrected_solid_angle.lens lod.select.lens": [nf.RadialLens((0.1,), (0.1, 0.0))],
    "RadialLens.k": [[0.1] * 65, [0.1, -1e300], [1e100]],
    "RadialLens.tangential": [[0.1], [0.1, math.inf]],
    "RadialLens.warp.image": [np.zeros((3, 3), np.int32)],
    "Hmd.with_lens.lens_radius": [1.0],
    "Hmd.with_lens.source": ["measured"],
    "Scene.subset?@triangles.objects": [["near"]],
    "Scene.subset?@triangles.triangles": [None, [-1], [0.5]],
    "SceneBuilder.mesh.colors": [np.full((6, 3), 0.5), np.zeros((2, 4), np.uint8)],
    "SceneBuilder.mesh.material": [1, [0] * 3],
    "SceneBuilder.mesh.normals": [np.zeros((5, 3)), np.full((6, 3), math.nan)],
    "SceneBuilder.mesh.uvs": [np.zeros((2, 2))],
    "SceneBuilder.material.base_color": [(2, 0, 0, 1)],
    "SceneBuilder.material.emission": [(1, 1), (0, 0, -1), (0, 0, math.nan)],
    "SceneBuilder.material.*texture": [np.full((2, 2, 4), 0.5), np.zeros((2, 2, 3), np.uint8)],
    "choose_radii.budget RadiusSettings.budget": [1000],
    "choose_radii.r2": [None],
    "gpu.cube_lookup.faces": [np.zeros((5, 4, 4, 3), np.float32)],
    "corrected_solid_angle.camera lod.select.camera": [nf.Camera((0, 0, 0), fov=nf.CubeFace(0), size=(8, 8))],
    "*solid_angle.radii lod.select.radii": [[-1.0]],
    "lod.place?@named.model_index": [
        ["ball", "yolk"],
        ["", "ball"],
        [0, 2],
        [0.5, 0],
        [b"ball", b"ball"],
        ["ball"],
        [["ball", "ball"]],
    ],
    "lod.select.camera lod.select.models": [[]],
    "lod.select.model_index": [[1], [-1], [0.5]],
    "lod.select?@fovea.previous": [[2], [-2]],
    "lod.LodModel.sigma": [(1.0, 0.1)],
    "lod.LodRules.weight": ["object"],
    "lod.select.price lod.Selector.select.price": [0.1],
    "orthoview.ViewSettings.normal_bits": [20],
    "range_from_depth?@matrix.near": [0.1],
    "range_from_depth?@matrix.reverse": [True, False],
    "regions?@area.path": [[(0.0, 1.0, 1.0), (0.0, 1.0, 2.0)]],
    "regions?@area.area regions?@area.budget": [None],
    "regions?@area.r2": [4.0],
    "regions.path": [np.zeros((0, 3))],
    "reduce.boundary": ["r1"],
    "reduce.channels regions.channels": [("color", "normal")],
    "render?@levels.before_at": [{}],
    "render_eyes.scale": [0.5],
    "render_path.at": [[{}]],
    "metrics.flip.data_range": [None, 100],
    "psnr.data_range": [None],
    "metrics.rmse.reference metrics.rmse.test psnr.test ssim.test": [
        np.full((16, 24), value) for value in (math.nan, math.inf, 1e200)
    ],
    "ssim.data_range": [1e-200, 1e200],
    "ssim.mask": [np.ones((16, 24)), np.zeros((16, 24), bool)],
    "ssim.masking": ["windows"],
    "stereo.mono_plane_for.error_px": [1e-9],
    "stream.ExportSettings.face_size": [100],
    "stream.Link?@trace.mbps": [1.0],
    "stream.Link?@trace.trace": [
        ([0, 2, 1], [1, 1, 1]),
        ([1, 2], [1, 1]),
        ([0, 2], [1, -1]),
        ([0, 2], [1, 0]),
        ([0, 2], [1]),
        ([], []),
    ],
    "stream.client.*.certificate": [__file__],
    "stream.client.*.name": ["a\nb", "a\u200bb", "é" * 33],
    "stream.client.*.room": ["", "a/b", "..", "é" * 33],
    "stream.client.*.url": ["127.0.0.1:8080", "http://here/?a=b", "http://here:99999/", "ftp://here/"],
    "stream.client.*.pose.left": [(0.0, 0.0, 0.0)],
    "stream.client.*.pose.pointer": [("foot", 1.0), ("head", -1.0)],
    "stream.client.*.pose.position": [(0.0, 2e6, 0.0)],
    "stream.export.center": [[(0, 0, 0), (0, 0.0004, 0)], np.arange(3003.0).reshape(-1, 3), [(1e31, 0, 0)]],
    "stream.export?@levels.center": [[(0, 0, 0), (1, 0, 0), (0, 0, 0)]],
    "stream.simulate.head_path": [[[1.0, 0, 0, 0], [1.0, 0, 0, 0]], np.zeros((0, 4))],
    "tessellate.camera tessellate?@*.camera": [nf.Camera((0, 0, 0), fov=FLAT, size=(9, 9))],
    "tessellate.tolerance_px tessellate?@*.tolerance_px": [1e-9],
    "tessellate.user_region tessellate?@*.user_region": [3.0],
    "user_region": [-1.0, [[1, 2, 3], [0, 0, 0]]],
    "origins": [(0.0, 1e300, 0.0)],
}
"""Further values that parameters must refuse."""


@functools.cache
def wrong_values(*names: str) -> list[Any]:
    """Return further values that a parameter must refuse; its names are those of a callable and of a call."""
    found = (values for patterns, values in WRONG.items() if any(match_length(name, patterns) for name in names))
    return [value for values in found for value in values]
