"""Arguments of calls that draw, map, warp and compare pictures, if parameter names do not determine them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tests.support.valid_calls.fields import fields
from tests.support.valid_calls.objects import EYE, MATRIX, SIZE
from tests.support.valid_calls.values import Make

NEAR_PLANE = {"near": 0.5, "far": 50.0}
DEPTH = np.full((2, 3), 0.5, np.float32)

PICTURES: dict[str, Make] = {
    "Camera": lambda v: {"size": SIZE},
    "Clip": lambda v: {"planes": [(0.0, 1.0, 0.0, 2.0)], "box": [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]},
    "Shot": lambda v: {
        "cameras": (v.camera,), "channels": ("color",), "mask": np.ones(v.camera.size[::-1], bool),
        "instances": np.ones(3, bool),
    },
    "depth_from_range": lambda v: {"ranges": 4.0 * DEPTH, "near": 0.1},
    "range_error": lambda v: {"distance": [2.0, 3.0]},
    "range_from_depth": lambda v: {"depth": DEPTH, "near": 0.1},
    "range_from_depth @matrix": lambda v: {"depth": DEPTH, "projection": MATRIX, "depth_range": "0..1"},
    "Frame": lambda v: {"color": v.frame.color},
    "Frame.load": lambda v: {"path": v.file("Frame")},
    "Frame.save": lambda v: {"path": v.folder / "saved.exr"},
    "render @motion": lambda v: {"before": v.camera, "before_at": {"far": np.eye(4)}, "channels": ("motion",)},
    "render @levels": lambda v: {"scene": v.leveled, "lod": "depth"},
    "render @reduced": lambda v: {"scene": v.reduced, "user": EYE},
    "render_path @levels": lambda v: {"source": v.leveled, "lod": [0, 1]},
    "stream.blend": lambda v: {"old": v.frame, "new": v.frame, "share": 0.5},
    "EnvMap": lambda v: fields(v.env),
    "EnvMap.load": lambda v: {"path": v.file("EnvMap")},
    "EnvMap.save": lambda v: {"path": v.folder / "saved.exr"},
    "EnvMap.save_equirectangular": lambda v: {"path": v.folder / "flat.png", "height": 4},
    "convert_envmap": lambda v: {"source": "cube", "target": "octahedral", "size": 4},
    "cube_lookup": lambda v: {"faces": v.cube},
    "cube_lookup @cone": lambda v: {"faces": v.cube, "filter": "min", "radius": 0.1},
    "cube_mips": lambda v: {"faces": v.cube},
    "cube_solid_angles": lambda v: {"size": 4},
    "envmap_directions": lambda v: {"size": 4},
    "envmap_texels": lambda v: {"size": 4},
    "Similarity": lambda v: {"mean": 0.5},
    "compare": lambda v: {"reference": v.frame, "test": v.frame},
    "metrics.motion_ssim": lambda v: {
        "earlier": v.frame, "later": replace(v.frame, motion=np.zeros((*v.camera.size[::-1], 2), np.float32)),
    },
    "metrics.flip": lambda v: {"data_range": 255},
    "metrics.jod": lambda v: {"data_range": 255, "pixels_per_degree": 20.0},
    "metrics.ms_ssim": lambda v: {"data_range": 255, "weights": (1.0,)},
    "metrics.object_completion": lambda v: {"reference_ids": [1, 2], "test_ids": [2, 2]},
    "psnr": lambda v: {"data_range": 255},
    "ssim": lambda v: {"data_range": 255},
    "ssim @frames": lambda v: {"reference": v.frame, "test": v.frame},
    "metrics.visual_continuity": lambda v: {"frames": [v.picture] * 2, "data_range": 255},
    "ChromaticLens": lambda v: dict.fromkeys(("red", "green", "blue"), v.lens),
    "ChromaticLens.warp": lambda v: {"image": np.dstack([v.picture] * 3), "fov": "symmetric"},
    "ChromaticLens.warp_mesh": lambda v: {"fov": "symmetric", "cells": (4, 4)},
    "RadialLens.distort_points": lambda v: {"points": [[0.1, 0.2]]},
    "RadialLens.undistort_points": lambda v: {"points": [[0.1, 0.2]]},
    "RadialLens.warp": lambda v: {"fov": "symmetric"},
    "RadialLens.warp @frame": lambda v: {"image": v.frame, "output_fov": v.camera.fov},
    "RadialLens.warp_mesh": lambda v: {"fov": "symmetric", "cells": (4, 4)},
    "corrected_solid_angle": lambda v: {"radii": 0.1},
    "solid_angle": lambda v: {"radii": 0.1},
    "bounding_spheres": lambda v: {"offsets": [0, 3, len(v.points)]},
    "Hmd": lambda v: fields(v.hmd),
    "Hmd.camera": lambda v: {"eye": "left"},
    "Hmd.load": lambda v: {"path": v.file("Hmd")},
    "Hmd.save": lambda v: {"path": v.folder / "saved.json"},
    "StereoFrame": lambda v: {**fields(v.stereo), "center": v.stereo.left},
    "StereoFrame.save": lambda v: {"path": v.folder / "stereo.png"},
    "StereoFrame.warped": lambda v: {"size": SIZE},
    "hmd.Eye": lambda v: {"position": (0.03, 0.0, 0.0)},
    "hmd.get": lambda v: {"name": "QUEST_2"},
    "render_eyes": lambda v: {"size": SIZE},
    "stereo.AdaptivePlane.update": lambda v: {"depth": 20.0},
    "stereo.AdaptivePlane.wanted": lambda v: {"depth": 20.0},
    "stereo.HybridRig": lambda v: {"left": v.hmd.left, "right": v.hmd.right, "hmd": v.hmd},
    "stereo.HybridRig.": lambda v: {"eye": "left"},
    "stereo.HybridRig.clip": lambda v: {"near": 0.1, "far": 9.0},
    "stereo.HybridRig.draws": lambda v: {"centers": [[0.0, 0.0, -8.0]], "radii": 0.5},
    "stereo.HybridRig.kink_angle": lambda v: {"at": [[0.1, 0.2]]},
    "stereo.HybridRig.render": lambda v: NEAR_PLANE,
    "stereo.HybridRig.shown": lambda v: {"at": [0.1, 0.2]},
    "stereo.TemporalAntialiasing": lambda v: {"share": 0.2, "offsets": 4},
    "stereo.TemporalAntialiasing.render": lambda v: {"rig": v.rig, **NEAR_PLANE},
    "stereo.mono_plane_for": lambda v: {"error_px": 1.0},
    "gpu.": lambda v: {"frame": v.device_frame, "reference": v.device_frame, "test": v.device_frame},
    "gpu.cube_lookup": lambda v: {"faces": v.cube, "directions": v.single},
    "gpu.measure": lambda v: {"backend": None},
    "gpu.render": lambda v: {"backend": None},
    "gpu.morph": lambda v: {"points": v.vertices},
}  # fmt: skip
