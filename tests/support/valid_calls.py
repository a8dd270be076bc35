"""A valid call of every public callable, with small scenes and pictures, for tests that replace single arguments."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

import nearfar as nf
from nearfar._scene.names import Names
from tests.support import valid_orthoviews as orthoviews
from tests.support.valid_clients import ROOM_CALLS, clients, room
from tests.support.valid_fields import fields
from tests.support.valid_objects import EYE, MATRIX, SIZE, ZONES, Valid
from tests.support.valid_steady import steady
from tests.support.valid_streams import streams

NEEDS = {
    "nearfar.LoadCurve.plot": "matplotlib",
    "nearfar.ReducedScene.explore": "ipywidgets",
    "nearfar.ReducedScene.show": "anywidget",
    "nearfar.lod.LodModel.plot": "matplotlib",
    "nearfar.lod.simplify": "fast_simplification",
    "nearfar.orthoview.FlightLog.plot": "matplotlib",
    "nearfar.orthoview.OrthoTree": "zarr",
    "nearfar.orthoview.build": "zarr",
    "nearfar.orthoview.open": "zarr",
    "nearfar.stream.Bundle.show": "anywidget",
    **dict.fromkeys(ROOM_CALLS, "aiohttp"),
    "nearfar.stream.Timeline.plot": "matplotlib",
}
"""Parts of `tests.support.PARTS` that callables need."""

NEED_ADAPTER = (
    "nearfar.gpu.",
    *(f"nearfar.{name}.begin" for name in ("Scene", "ReducedScene", "orthoview.OrthoTree", "orthoview.Flight")),
)
"""Beginnings of the names of callables that need a graphics adapter."""


def instances(valid: Valid) -> Mapping[str, Callable[[], Any]]:
    """Return what makes an instance of each public class that has methods, or of the class for one call."""
    model = valid.model
    return {
        "nearfar.ReducedScene.at_levels": lambda: valid.reduced_leveled,
        "nearfar.ReducedScene.render @levels": lambda: valid.reduced_leveled,
        "nearfar.Scene.at_levels": lambda: valid.leveled,
        "nearfar.SceneBuilder.objects": nf.SceneBuilder,
        "nearfar.Camera": lambda: valid.camera,
        "nearfar.ChromaticLens": lambda: valid.chromatic,
        "nearfar.EnvMap": lambda: valid.env,
        "nearfar.Frame": lambda: valid.frame,
        "nearfar.Hmd": lambda: valid.hmd,
        "nearfar.LoadCurve": lambda: nf.load_curve(valid.scene, center=ZONES["center"]),
        "nearfar.Partition": lambda: nf.partition(valid.scene, **ZONES),
        "nearfar.RadialLens": lambda: valid.lens,
        "nearfar.ReducedScene": lambda: valid.reduced,
        "nearfar.Scene": lambda: valid.scene,
        "nearfar.SceneBuilder": valid.builder,
        "nearfar.StereoFrame": lambda: valid.stereo,
        "nearfar.datasets.Asteroids": lambda: nf.datasets.asteroids(3, 48),
        "nearfar.datasets.SphereTask": lambda: valid.task,
        "nearfar.datasets.World": lambda: nf.datasets.world(1),
        "nearfar.gpu.DeviceFrame": lambda: valid.device_frame,
        "nearfar.lod.Curve4PL": lambda: model.curves,
        "nearfar.lod.Levels": lambda: valid.levels,
        "nearfar.lod.LodModel": lambda: model,
        "nearfar.lod.LodModel.refit": lambda: valid.measured,
        "nearfar.lod.LodThreshold": nf.lod.LodThreshold,
        "nearfar.lod.Selection": lambda: _selection(valid),
        "nearfar.lod.Selector": nf.lod.Selector,
        "nearfar.lod.Switches": lambda: nf.lod.switches(model, view=valid.camera),
        "nearfar.orthoview.Flight": lambda: orthoviews.flight(valid),
        "nearfar.orthoview.FlightLog": lambda: valid.flown,
        "nearfar.orthoview.OrthoCut": lambda: orthoviews.cut(valid),
        "nearfar.orthoview.OrthoTree": lambda: orthoviews.tree(valid),
        "nearfar.orthoview.Steady": nf.orthoview.Steady,
        "nearfar.stream.Bundle": lambda: valid.bundle,
        "nearfar.stream.Growth": lambda: nf.stream.Growth((2.0, 4.0)),
        "nearfar.stream.RingMaps": lambda: valid.ring_maps,
        "nearfar.stream.Timeline": lambda: valid.timeline,
        "nearfar.stream.client.Room": room,
        "nearfar.stream.Rings": lambda: valid.ring_maps.rings,
        "nearfar.stereo.AdaptivePlane": lambda: nf.stereo.AdaptivePlane(valid.hmd),
        "nearfar.stereo.TemporalAntialiasing": nf.stereo.TemporalAntialiasing,
        "nearfar.stereo.HybridRig": lambda: nf.stereo.HybridRig.of(valid.hmd, mono_plane=8.0, size=SIZE),
        "nearfar.Recentering": lambda: valid.reduced.recentered(ZONES["center"]),
        "nearfar.Regions": lambda: valid.regions,
        "nearfar.Walk": lambda: valid.regions.walk(),
    }


def _selection(valid: Valid) -> nf.lod.Selection:
    return nf.lod.select([valid.model], [0, 0], np.zeros((2, 3)), [1.0, 2.0], camera=valid.camera, full=True)


def valid_arguments(valid: Valid) -> dict[str, dict[str, Any]]:
    """Return valid keywords of every public callable, by its name; other arguments keep their defaults.

    A name followed by " @" and a word is another call of the same callable, which reaches other checks.
    """
    makers = (_scenes, _pictures, _arrays, orthoviews.orthoviews, _devices, _levels, streams, clients, steady)
    return {name: arguments for make in makers for name, arguments in make(valid).items()}


def _scenes(valid: Valid) -> dict[str, dict[str, Any]]:
    scene, camera, poses = valid.scene, valid.camera, {"far": np.eye(4)}
    shot = {"shot": valid.shot}
    begin = {"device": None, "shot": valid.shot}
    return {
        "nearfar.Camera": {"position": EYE, "fov": nf.Fov.symmetric(90.0), "size": SIZE},
        "nearfar.Camera.look_at": {"eye": EYE, "target": (0.0, 0.0, 0.0), "fov": camera.fov, "size": SIZE},
        "nearfar.Camera.project": {"points": valid.vertices},
        "nearfar.Camera.rays": {},
        "nearfar.CubeFace": {"face": 2},
        "nearfar.Fov": {"left": -1.0, "right": 1.0, "down": -1.0, "up": 1.0},
        "nearfar.Fov.from_angles": {"left": -1.0, "right": 1.0, "up": 1.0, "down": -1.0},
        "nearfar.Fov.symmetric": {"horizontal_deg": 90.0},
        "nearfar.Orthographic": {"left": -1.0, "right": 1.0, "down": -1.0, "up": 1.0},
        "nearfar.Shot": {
            "cameras": (camera,),
            "channels": ("color",),
            "mask": np.ones(camera.size[::-1], bool),
            "instances": np.ones(3, bool),
        },
        "nearfar.Scene": {"core": scene._core, "names": Names(["near", "far"])},
        "nearfar.Scene.at": {"poses": poses},
        "nearfar.Scene.at_levels": {"levels": [0, 1]},
        "nearfar.Scene.begin": begin,
        "nearfar.Scene.displayed": {"points": valid.vertices, "user": EYE},
        "nearfar.Scene.from_arrays": {"vertices": valid.vertices, "faces": valid.faces, "copy": True},
        "nearfar.Scene.from_arrays @objects": {
            "vertices": valid.vertices,
            "faces": valid.faces,
            "face_object": [0, 1],
            "object_names": ["a", "b"],
            "copy": True,
        },
        "nearfar.Scene.from_trimesh": {"loaded": valid.mesh},
        "nearfar.Scene.load": {"path": valid.file("Scene")},
        "nearfar.Scene.query": {"aabb": [[-1, -1, -1], [1, 1, 1]], "detail": 0.5},
        "nearfar.Scene.shown_to": {"user": EYE},
        "nearfar.Scene.subset": {"objects": ["near"]},
        "nearfar.Scene.subset @triangles": {"triangles": [0]},
        "nearfar.Scene.touches": {"aabb": [[-1, -1, -1], [1, 1, 1]]},
        "nearfar.Scene.trace": shot,
        "nearfar.Scene.transform": {"name": "near"},
        "nearfar.Scene.triangles": {},
        "nearfar.Scene.with_dynamic": {"names": ["near"]},
        "nearfar.Scene.with_levels": {"models": {"near": valid.model}},
        "nearfar.SceneBuilder": {},
        "nearfar.SceneBuilder.build": {},
        "nearfar.SceneBuilder.instance": {"mesh": 0, "name": "second"},
        "nearfar.SceneBuilder.material": {},
        "nearfar.SceneBuilder.mesh": {"positions": valid.vertices, "faces": valid.faces, "copy": True},
        "nearfar.SceneBuilder.object": {"name": "second"},
        "nearfar.SceneBuilder.objects": {"names": ["second"]},
        "nearfar.SceneBuilder.place_many": {"mesh": 0, "transforms": valid.transforms, "names": "many"},
        "nearfar.LoadCurve": {"core": nf.load_curve(scene, center=EYE)._core, "center": EYE},
        "nearfar.LoadCurve.count": {"r2": 3.0},
        "nearfar.LoadCurve.plot": {},
        "nearfar.LoadCurve.radius": {"budget": 2},
        "nearfar.Partition": {"_core": nf.partition(scene, **ZONES)._core, "scene": scene, "source": scene, **ZONES},
        "nearfar.Partition.summary": {},
        "nearfar.Partition.validate": {},
        "nearfar.open_source": {"path": valid.file("Scene")},
        "nearfar.write_tiles": {"source": scene, "folder": valid.folder / "tiles", "cell": 4.0},
        "nearfar.load_curve": {"scene": scene, "center": ZONES["center"]},
        "nearfar.partition": {"scene": scene, **ZONES},
        "nearfar.Radii": fields(nf.choose_radii(scene, EYE, r2=60.0)),
        "nearfar.choose_radii": {"scene": scene, "center": EYE, "r2": 60.0},
        "nearfar.reduce": {"scene": scene, **ZONES, "face_size": 4, "samples": 1, "backend": "cpu"},
        "nearfar.ReducedScene": {
            "scene": scene,
            "zones": valid.reduced.partition,
            "env": valid.reduced.env,
            "morph": "blend",
            "boundary": "r2",
            "counts": valid.reduced._counts,
        },
        "nearfar.ReducedScene.at": {"poses": poses},
        "nearfar.ReducedScene.at_levels": {"levels": [0, 1]},
        "nearfar.ReducedScene.begin": begin,
        "nearfar.ReducedScene.displayed": {"points": valid.vertices, "user": EYE},
        "nearfar.ReducedScene.explore": {},
        "nearfar.ReducedScene.show": {"camera": camera},
        "nearfar.ReducedScene.load": {"path": valid.file("ReducedScene")},
        "nearfar.ReducedScene.recentered": {"center": EYE},
        "nearfar.ReducedScene.render": {"camera": camera, "backend": "cpu"},
        "nearfar.ReducedScene.render @levels": {"camera": camera, "lod": "depth", "backend": "cpu"},
        "nearfar.ReducedScene.save": {"path": valid.folder / "saved"},
        "nearfar.ReducedScene.shown_to": {"user": EYE},
        "nearfar.ReducedScene.trace": shot,
        "nearfar.ReducedScene.with_morph": {"morph": "cylinder"},
        "nearfar.ReducedScene.with_growth": {"radius": 1.0, "strength": 0.5},
        "nearfar.ReducedScene.with_r1": {"r1": 2.0},
        **_walks(valid),
        "nearfar.datasets.Asteroids": {"count": 1, "polygons": 48},
        "nearfar.datasets.Asteroids.levels": {"detail": 9.0},
        "nearfar.datasets.Asteroids.query": {"aabb": [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]]},
        "nearfar.datasets.Asteroids.scene": {"detail": 9.0},
        "nearfar.datasets.CountTask": fields(nf.datasets.count_task()[1]),
        "nearfar.datasets.SphereTask": fields(valid.task),
        "nearfar.datasets.SphereTask.pose": {"t": 0.5},
        "nearfar.datasets.SphereTask.position": {"t": 0.5},
        "nearfar.datasets.TapeTask": fields(nf.datasets.tape_task()[1]),
        "nearfar.datasets.World": {"km": 1},
        "nearfar.datasets.World.query": {"aabb": [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]], "detail": 400.0},
        "nearfar.datasets.asteroids": {"count": 1, "polygons": 48},
        "nearfar.datasets.beams": {"count": 1},
        "nearfar.datasets.city": {"blocks": 1, "detail": 0},
        "nearfar.datasets.count_task": {},
        "nearfar.datasets.factory": {"detail": 0},
        "nearfar.datasets.factory_view": {},
        "nearfar.datasets.find": {"relative": "nothing.glb"},
        "nearfar.datasets.forest": {"trees": 1, "detail": 0},
        "nearfar.datasets.landscape": {"trees": 1, "detail": 0},
        "nearfar.datasets.room": {"detail": 0},
        "nearfar.datasets.room_view": {},
        "nearfar.datasets.sphere_task": {},
        "nearfar.datasets.spheres": {"count": 1, "detail": 0},
        "nearfar.datasets.street_view": {},
        "nearfar.datasets.tape_task": {},
        "nearfar.datasets.world": {"km": 1},
    }


def _walks(valid: Valid) -> dict[str, dict[str, Any]]:
    regions = valid.regions
    small = {"reach": 0.5, "hysteresis": 0.1, "face_size": 4, "samples": 1, "backend": "cpu"}
    corners = [(-0.5, 0.0), (0.5, 1.0)]
    return {
        "nearfar.Recentering": {"center": EYE, "make": lambda: 3},
        "nearfar.Recentering.result": {},
        "nearfar.Regions": {"scene": valid.scene, "centers": [EYE], "radii": regions.radii, "hysteresis": 0.1},
        "nearfar.Regions.index": {"position": EYE, "current": 0},
        "nearfar.Regions.jump": {"i": 0, "j": 1, "camera": valid.camera},
        "nearfar.Regions.prefetch": {"position": EYE, "velocity": (0.0, 0.0, 1.0)},
        "nearfar.Regions.ready": {"i": 0},
        "nearfar.Regions.reduced": {"i": 0},
        "nearfar.Regions.walk": {},
        "nearfar.Walk": {"regions": regions},
        "nearfar.Walk.render": {"camera": valid.camera, "seconds": 0.0},
        "nearfar.regions": {"scene": valid.scene, "path": [(0.0, 1.0, 1.0), (0.0, 1.0, 2.0)], "r2": 4.0, **small},
        "nearfar.regions @area": {"scene": valid.scene, "path": None, "area": corners, "budget": 2, **small},
    }


def _pictures(valid: Valid) -> dict[str, dict[str, Any]]:
    scene, camera, frame, hmd = valid.scene, valid.camera, valid.frame, valid.hmd
    pair = {"reference": valid.picture, "test": valid.picture[::-1]}
    warp = {"image": valid.picture, "fov": "symmetric"}
    stack = valid.picture[None]
    points = {"r": [0.1, 0.2]}
    return {
        "nearfar.Frame": {"camera": camera, "color": frame.color},
        "nearfar.Frame.load": {"path": valid.file("Frame")},
        "nearfar.Frame.require": {"channel": "color"},
        "nearfar.Frame.save": {"path": valid.folder / "saved.exr"},
        "nearfar.Frame.to_image": {},
        "nearfar.render": {"scene": scene, "camera": camera, "backend": "cpu"},
        "nearfar.render @motion": {
            "scene": scene, "camera": camera, "before": camera, "before_at": {"far": np.eye(4)},
            "channels": ("motion",), "backend": "cpu",
        },
        "nearfar.render @levels": {"scene": valid.leveled, "camera": camera, "lod": "depth", "backend": "cpu"},
        "nearfar.render @reduced": {"scene": valid.reduced, "camera": camera, "user": EYE, "backend": "cpu"},
        "nearfar.render_eyes": {"source": scene, "hmd": hmd, "position": EYE, "size": SIZE, "backend": "cpu"},
        "nearfar.render_path": {"source": scene, "cameras": [camera], "backend": "cpu"},
        "nearfar.render_path @levels": {"source": valid.leveled, "cameras": [camera], "lod": [0, 1], "backend": "cpu"},
        "nearfar.Comparison": fields(nf.compare(frame, frame, center=EYE, radius=4.0)),
        "nearfar.boundary": {"frame": frame, "center": EYE, "radius": 4.0},
        "nearfar.BoundaryTear": fields(nf.boundary_tear(frame, center=EYE, radius=4.0)),
        "nearfar.boundary_tear": {"frame": frame, "center": EYE, "radius": 4.0},
        "nearfar.compare": {"reference": frame, "test": frame, "center": EYE, "radius": 4.0},
        "nearfar.discontinuity": {"frame": frame},
        "nearfar.tear": {"frame": frame},
        "nearfar.ms_ssim": {**pair, "data_range": 255, "weights": (1.0,)},
        "nearfar.object_completion": {"reference_ids": [1, 2], "test_ids": [2, 2]},
        "nearfar.psnr": {**pair, "data_range": 255},
        "nearfar.rmse": pair,
        "nearfar.ssim": {**pair, "data_range": 255},
        "nearfar.ssim @frames": {"reference": frame, "test": frame},
        "nearfar.ssim_pairs": {"references": stack, "tests": stack, "data_range": 255},
        "nearfar.visual_continuity": {"frames": [valid.picture, valid.picture], "data_range": 255},
        "nearfar.Similarity": {"mean": 0.5},
        "nearfar.Clip": {"planes": [(0.0, 1.0, 0.0, 2.0)], "box": [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]},
        "nearfar.ChromaticLens": {"red": valid.lens, "green": valid.lens, "blue": valid.lens},
        "nearfar.ChromaticLens.warp": {**warp, "image": np.dstack([valid.picture] * 3)},
        "nearfar.ChromaticLens.warp_mesh": {"size": SIZE, "fov": "symmetric", "cells": (4, 4)},
        "nearfar.RadialLens": {"k": [0.1]},
        "nearfar.RadialLens.derivative": points,
        "nearfar.RadialLens.distort": points,
        "nearfar.RadialLens.distort_points": {"points": [[0.1, 0.2]]},
        "nearfar.RadialLens.undistort": points,
        "nearfar.RadialLens.undistort_points": {"points": [[0.1, 0.2]]},
        "nearfar.RadialLens.warp": warp,
        "nearfar.RadialLens.warp @frame": {"image": frame, "output_fov": camera.fov},
        "nearfar.RadialLens.warp_mesh": {"size": SIZE, "fov": "symmetric", "cells": (4, 4)},
        "nearfar.WarpMesh": fields(valid.lens.warp_mesh(SIZE, fov="symmetric", cells=(4, 4))),
        "nearfar.corrected_solid_angle": {
            "centers": [[0.0, 1.0, 0.0]], "radii": 0.1, "camera": camera, "lens": valid.lens,
        },
        "nearfar.Hmd": fields(hmd),
        "nearfar.Hmd.camera": {"eye": "left", "position": EYE},
        "nearfar.Hmd.load": {"path": valid.file("Hmd")},
        "nearfar.Hmd.save": {"path": valid.folder / "saved.json"},
        "nearfar.Hmd.with_ipd": {"ipd": 0.06},
        "nearfar.Hmd.with_lens": {"lens": valid.lens},
        "nearfar.StereoFrame": {
            **fields(valid.stereo), "center": valid.stereo.left,
        },
        "nearfar.StereoFrame.save": {"path": valid.folder / "stereo.png"},
        "nearfar.StereoFrame.warped": {"size": SIZE},
        "nearfar.hmd.Eye": {"fov": camera.fov, "position": (0.03, 0.0, 0.0)},
        "nearfar.hmd.Eye.from_matrix": {"fov": camera.fov, "eye_to_head": np.eye(4)[:3]},
        "nearfar.hmd.TotalFov": {"horizontal_deg": 1.0, "vertical_deg": 1.0, "diagonal_deg": 1.0, "overlap_deg": 1.0},
        "nearfar.hmd.get": {"name": "QUEST_2"},
        "nearfar.hmd.names": {},
        "nearfar.stereo.AdaptivePlane": {"hmd": hmd},
        "nearfar.stereo.AdaptivePlane.update": {"depth": 20.0, "seconds": 0.1},
        "nearfar.stereo.AdaptivePlane.wanted": {"depth": 20.0},
        "nearfar.stereo.HybridRig": {
            "left": hmd.left, "right": hmd.right, "mono_plane": 8.0, "size": SIZE, "hmd": hmd,
        },
        "nearfar.stereo.HybridRig.cameras": {"position": EYE},
        "nearfar.stereo.HybridRig.clip": {"position": EYE, "near": 0.1, "far": 9.0},
        "nearfar.stereo.HybridRig.error_field": {"eye": "left"},
        "nearfar.stereo.HybridRig.homography": {"eye": "left"},
        "nearfar.stereo.HybridRig.kink_angle": {"eye": "left", "at": [[0.1, 0.2]], "direction": [[1.0, 0.0]]},
        "nearfar.stereo.HybridRig.max_error": {},
        "nearfar.stereo.HybridRig.of": {"hmd": hmd, "mono_plane": 8.0},
        "nearfar.stereo.HybridRig.render": {"source": valid.scene, "position": EYE, "near": 0.5, "far": 50.0},
        "nearfar.stereo.HybridRig.shown": {"eye": "left", "at": [0.1, 0.2]},
        "nearfar.stereo.HybridRig.triangles": {"scene": valid.scene, "position": EYE},
        "nearfar.stereo.HybridRig.view_vectors": {"eye": "left", "points": valid.vertices, "position": EYE},
        "nearfar.stereo.HybridRig.with_plane": {"mono_plane": 4.0},
        "nearfar.stereo.QuadLayer": {"position": (0.0, 0.0, -8.0), "size": (20.0, 20.0)},
        "nearfar.stereo.TemporalAntialiasing": {"share": 0.2, "offsets": 4},
        "nearfar.stereo.TemporalAntialiasing.render": {
            "rig": nf.stereo.HybridRig.of(hmd, mono_plane=8.0, size=SIZE), "source": valid.scene, "position": EYE,
            "near": 0.5, "far": 50.0,
        },
        "nearfar.stereo.TemporalAntialiasing.restart": {},
        "nearfar.stereo.mono_plane_for": {"hmd": hmd, "error_px": 1.0},
        "nearfar.stereo.view_vector_shader": {"language": "wgsl"},
    }  # fmt: skip


def _arrays(valid: Valid) -> dict[str, dict[str, Any]]:
    depth = {"projection": valid.camera.fov, "near": 0.1}
    users = {"user": (0.5, 1.0, 0.0), **ZONES}
    hits = nf.cast_rays(valid.scene, [EYE], [(0.0, 0.0, -1.0)])
    return {
        "nearfar.Hits": fields(hits),
        "nearfar.Nearest": fields(nf.nearest_points(valid.scene, [EYE])),
        "nearfar.cast_rays": {"scene": valid.scene, "origins": [EYE] * 2, "directions": valid.directions},
        "nearfar.nearest_points": {"scene": valid.scene, "points": [EYE]},
        "nearfar.triangle_radii": {"vertices": valid.vertices, "faces": valid.faces, "center": EYE},
        "nearfar.EnvMap": {"center": EYE, "color": valid.cube},
        "nearfar.EnvMap.load": {"path": valid.file("EnvMap")},
        "nearfar.EnvMap.sample": {"directions": valid.directions},
        "nearfar.EnvMap.save": {"path": valid.folder / "saved.exr"},
        "nearfar.EnvMap.save_equirectangular": {"path": valid.folder / "flat.png", "height": 4},
        "nearfar.convert_envmap": {"values": valid.cube, "source": "cube", "target": "octahedral", "size": 4},
        "nearfar.cube_lookup": {"faces": valid.cube, "directions": valid.directions},
        "nearfar.cube_mips": {"faces": valid.cube},
        "nearfar.cube_solid_angles": {"size": 4},
        "nearfar.envmap_directions": {"size": 4},
        "nearfar.envmap_texels": {"directions": valid.directions, "size": 4},
        "nearfar.depth_from_range": {"ranges": np.full((2, 3), 2.0, np.float32), **depth},
        "nearfar.range_from_depth": {"depth": np.full((2, 3), 0.5, np.float32), **depth},
        "nearfar.range_error": {"distance": [2.0, 3.0], "near": 0.1},
        "nearfar.bend_rays": {"directions": valid.directions, **users, "tolerance": 0.01},
        "nearfar.fold_margin": users,
        "nearfar.morph": {"points": valid.vertices, **users},
        "nearfar.tessellate": {
            "mesh": valid.scene, **ZONES, "user_region": 0.1, "tolerance_px": 100.0, "camera": valid.camera,
        },
        "nearfar.tessellate @cylinder": {
            "mesh": valid.scene, **ZONES, "user_region": 0.1, "tolerance_px": 100.0, "camera": valid.camera,
            "kind": "cylinder", "radius": ZONES["r2"] / 2, "strength": 0.5,
        },
        "nearfar.tessellate @trimesh": {
            "mesh": valid.mesh, **ZONES, "user_region": 0.1, "tolerance_px": 100.0, "camera": valid.camera,
        },
        "nearfar.range_from_depth @matrix": {
            "depth": np.full((2, 3), 0.5, np.float32), "projection": MATRIX, "depth_range": "0..1",
        },
        "nearfar.bounding_sphere": {"points": valid.vertices},
        "nearfar.bounding_spheres": {"points": valid.vertices, "offsets": [0, 3, 6]},
        "nearfar.solid_angle": {"centers": [[0.0, 1.0, 0.0]], "radii": 0.1, "eye": EYE},
    }  # fmt: skip


def has_adapter() -> bool:
    """Whether a graphics adapter can be used."""
    return any(adapter.usable for adapter in nf.gpu.adapters())


def _devices(valid: Valid) -> dict[str, dict[str, Any]]:
    """Calls of `nearfar.gpu`."""
    adapter = {
        "name": "", "backend": "gl", "kind": "virtual", "driver": "", "usable": True, "refused": "",
        "largest_binding": 1, "largest_image": 1,
    }  # fmt: skip
    calls: dict[str, dict[str, Any]] = {
        "nearfar.gpu.Adapter": adapter,
        "nearfar.gpu.adapters": {},
        "nearfar.gpu.select": {"adapter": None},
        "nearfar.gpu.selected": {},
        "nearfar.gpu.stats": {},
        "nearfar.gpu.measure": {"source": valid.scene, "camera": valid.camera},
        "nearfar.gpu.render": {"source": valid.scene, "camera": valid.camera},
        "nearfar.gpu.cube_lookup": {"faces": valid.cube, "directions": valid.single},
        "nearfar.gpu.morph": {"points": valid.vertices, "user": (0.5, 1.0, 0.0), **ZONES},
        "nearfar.gpu.DeviceFrame": {},
        "nearfar.gpu.DeviceFrame.read": {},
        "nearfar.gpu.DeviceFrame.require": {"channel": "color"},
        "nearfar.gpu.discontinuity": {},
        "nearfar.gpu.ssim": {},
    }
    if has_adapter():
        frame, device = valid.device_frame, valid.device
        calls["nearfar.gpu.DeviceFrame"] = fields(frame)
        calls["nearfar.gpu.discontinuity"] = {"frame": frame}
        calls["nearfar.gpu.ssim"] = {"reference": frame, "test": frame}
        for name in ("Scene", "ReducedScene", "orthoview.OrthoTree", "orthoview.Flight"):
            calls[f"nearfar.{name}.begin"] = {"device": device, "shot": valid.shot}
    return calls


def _levels(valid: Valid) -> dict[str, dict[str, Any]]:
    model, camera = valid.model, valid.camera
    sizes = np.geomspace(1e-4, 0.3, 8)
    settings = {"fov": nf.Fov.symmetric(90.0), "size": (32, 32), "views": 4, "distances": 4, "samples": 1}
    chosen = _selection(valid)
    select = {"models": [model], "model_index": [0], "centers": [[0.0, 0.0, 0.0]], "radii": [1.0], "camera": camera}
    return {
        "nearfar.lod.Curve4PL": fields(model.curves),
        "nearfar.lod.Curve4PL.__call__": {"x": [0.1]},
        "nearfar.lod.Curve4PL.__getitem__": {"index": 0},
        "nearfar.lod.Level": {"scene": valid.scene},
        "nearfar.lod.Levels": {"levels": list(valid.levels)},
        "nearfar.lod.Levels.__getitem__": {"index": 0},
        "nearfar.lod.LodModel": fields(model),
        "nearfar.lod.LodModel.export": {"path": valid.folder / "model.glb", "view": camera},
        "nearfar.lod.LodModel.load": {"path": valid.file("LodModel")},
        "nearfar.lod.LodModel.of_levels": {"numbers": np.array([0])},
        "nearfar.lod.LodModel.plot": {},
        "nearfar.lod.LodModel.refit": {"percentile": 50.0},
        "nearfar.lod.LodModel.save": {"path": valid.folder / "model.json"},
        "nearfar.lod.LodModel.selector": {"mode": "depth"},
        "nearfar.lod.LodThreshold": {},
        "nearfar.lod.LodThreshold.__call__": {"sigma": 0.1, "reference": 0.2},
        "nearfar.lod.LodThreshold.line": {"reference": 0.2},
        "nearfar.lod.MeasureSettings": settings,
        "nearfar.lod.Samples": {"sigma": sizes, "score": np.ones((2, 8)), "views": None},
        "nearfar.lod.Selection": {"level": chosen.level, "counts": chosen.counts, "columns": {}},
        "nearfar.lod.Selector": {},
        "nearfar.lod.Selector.select": select,
        "nearfar.lod.Spent": {"price": 0.1, "triangles": 9, "score": 0.9},
        "nearfar.lod.Switches": fields(nf.lod.switches(model, view=camera)),
        "nearfar.lod.Switches.coverages": {},
        "nearfar.lod.Switches.of_levels": {"numbers": np.array([0])},
        "nearfar.lod.Switches.remarks": {"level": 0},
        "nearfar.lod.acuity": {"eccentricity_deg": 10.0},
        "nearfar.lod.distortion": {"eccentricity_deg": 10.0, "lens": valid.lens, "view": camera},
        "nearfar.lod.panel_magnification": {"eccentricity_deg": 10.0, "lens": valid.lens, "view": camera},
        "nearfar.lod.export": {"scene": valid.leveled, "path": valid.folder / "scene.glb", "view": camera},
        "nearfar.lod.fit_4pl": {"x": sizes, "y": 1.0 - sizes},
        "nearfar.lod.measure": {"levels": nf.lod.Levels([valid.levels[1]]), **settings, "backend": "cpu"},
        "nearfar.lod.measure @many": {"levels": {"a": nf.lod.Levels([valid.levels[1]])}, **settings, "backend": "cpu"},
        "nearfar.lod.place": {"models": [model], "model_index": [0, 0], "transforms": valid.transforms},
        "nearfar.lod.place @named": {
            "models": {"ball": model}, "model_index": ["ball", "ball"], "transforms": valid.transforms,
        },
        "nearfar.lod.reference_solid_angle": {"view": camera},
        "nearfar.lod.select": select,
        "nearfar.lod.select @fovea": {
            **select, "mode": "fovea", "lens": valid.lens, "gaze": (0.0, 0.0, -1.0), "previous": [1], "full": True,
        },
        "nearfar.lod.simplify": {"mesh": valid.mesh, "ratios": (1.0, 0.5)},
        "nearfar.lod.switches": {"model": model, "view": camera},
    }  # fmt: skip
