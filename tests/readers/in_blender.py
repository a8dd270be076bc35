"""Renders views of a GLB in Blender: blender -b --python in_blender.py -- JOB.

The job is a JSON file: {"file": PATH, "views": [{"eye", "target", "size", "angle", "to"}]}, metres with y up, the
vertical angle in degrees, and the path of a PNG with a transparent background.
"""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from mathutils import Vector

# Debian's NumPy 1.24 lacks the names that Blender 3.4's glTF add-on uses.
setattr(np, "bool", bool)  # noqa: B010

TRANSPARENT_BOUNCES = 64
"""Greatest number of transparent texels along a ray."""


def main() -> None:
    job = json.loads(Path(sys.argv[sys.argv.index("--") + 1]).read_text())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=job["file"])
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = "CPU", 1, False
    scene.cycles.pixel_filter_type, scene.cycles.max_bounces = "BOX", 0
    scene.cycles.transparent_max_bounces = TRANSPARENT_BOUNCES
    scene.render.film_transparent = True
    scene.render.image_settings.file_format, scene.render.image_settings.color_mode = "PNG", "RGBA"
    scene.view_settings.view_transform = "Standard"
    for view in job["views"]:
        _render(scene, view)


def _render(scene: Any, view: dict[str, Any]) -> None:
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.angle_y = "VERTICAL", math.radians(view["angle"])
    data.clip_start, data.clip_end = 0.05, 20_000.0
    camera = bpy.data.objects.new("camera", data)
    scene.collection.objects.link(camera)
    eye, target = (Vector((x, -z, y)) for x, y, z in (view["eye"], view["target"]))
    camera.location, camera.rotation_mode = eye, "QUATERNION"
    camera.rotation_quaternion = (target - eye).to_track_quat("-Z", "Y")
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = view["size"]
    scene.render.filepath = view["to"]
    bpy.ops.render.render(write_still=True)


main()
