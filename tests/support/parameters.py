"""Values that parameters accept: kinds by their annotations, ranges of numbers and exceptions by their names.

Names in the tables are those of parameters, or patterns such as "lod.*.k" of callables and parameters.
"""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from inspect import Parameter
from typing import Any

from tests.support.name_patterns import match_length

ANNOTATIONS: dict[str, str] = {
    r"None": "none", r"(.*')?(Supports)?[Ff]loat('\))?": "number big", r"int|SupportsIndex": "whole", r"bool": "flag",
    r"os\.PathLike\[str\]": "path", r"ArrayLike|NDArray.*|Point": "rows",
    r"NDArray\[np.bool_\]": "flags", r"(Sequence|Iterable|tuple)\[(float|int).*": "rows", r"Payload|bytes": "bytes",
    r"(Mapping|dict|InitVar\[Mapping).*": "mapping", r"(Sequence|Iterable|Collection|tuple)\[str.*": "texts",
    r"Callable.*|Report|Listener": "callable", r"(Sequence|Iterable|tuple|list)\[[A-Z_].*": "objects",
    r"Scene|Renderable|SceneSource|Mesh": "scene", r"trimesh\..*|Mesh": "mesh", r"Frame": "frame", r"Camera": "camera",
    r"Hmd": "hmd", r"RadialLens": "lens", r"Measured.*|Lod|LodModel": "model mapping",
}  # fmt: skip
"""Kinds of hostile values that may be valid, by parts of an annotation."""

TAKEN: dict[str, str] = {
    "rows": "LoadCurve.count.r2 LoadCurve.radius.budget *.visual_continuity.frames",
    "endless": "*.visual_continuity.frames",
    "any": "RenderSettings.lod lod.Curve4PL.[abcd] *.reason *.rms *.status Frame.lod Scene.dropped Scene.frames"
    " Scene.notes Scene.load_placements"
    " Scene.table Scene.undrawn Scene.used lod.Selection.counts lod.Selection.level lod.Selection.spent similarities"
    " *.shown_to.user",
    "number big": "LoadCurve.*.budget LoadCurve.*.r2 Frame.lod *.bytes_at.time eccentricity_deg *.__call__.sigma r"
    " lod.Curve4PL.__getitem__.index corrected_solid_angle.radii *.select.radii solid_angle.radii range_dtype"
    " *.HybridRig.draws.radii"
    " range_error.distance user_region",
    "nan": "stereo.AdaptivePlane.*.depth *.__call__.sigma Similarity.mean RadialLens.warp.fill *.shown.depth",
    "nans": "*.__call__.x Frame.color *.__call__.sigma cube_*.faces *.displayed.points lod.fit_4pl.* morph.points"
    " *.project.points convert_envmap.values RadialLens.warp.image gpu.cube_lookup.faces gpu.*.points",
    "infs": "*.__call__.x Frame.color LoadCurve.*.r2 lod.LodModel.sigma *.__call__.sigma *.query.aabb *.touches.aabb"
    " *.update.aabb cube_*.faces gpu.cube_lookup.faces *.displayed.points convert_envmap.values EnvMap.range"
    " depth_from_range.ranges eccentricity_deg lod.fit_4pl.* morph.points *.project.points RadialLens.warp.image"
    " gpu.*.points",
    "empty": "Clip.planes *.__call__.x lod.LodModel.errors LoadCurve.*.r2 LoadCurve.*.budget *.__call__.sigma r ratios"
    " RadialLens.k Scene.subset.triangles *.bytes_at.time corrected_solid_angle.centers solid_angle.centers"
    " *.HybridRig.draws.centers"
    " EnvMap.sample.directions bend_rays.directions cube_lookup.directions envmap_texels.directions eccentricity_deg"
    " Scene.from_arrays.faces SceneBuilder.mesh.faces triangle_radii.faces lod.Curve4PL.__getitem__.index"
    " *.project.points *.displayed.points morph.points nearest_points.points *.view_vectors.points"
    " range_error.distance",
    "hollow": "Clip.planes lod.LodModel.errors LoadCurve.*.r2 LoadCurve.*.budget *.__call__.sigma r ratios frames"
    " Scene.subset.triangles *.__call__.x *.bytes_at.time eccentricity_deg range_error.distance",
    "shape": "*.__call__.x LoadCurve.*.r2 *.__call__.sigma RadialLens.k r bounding_spheres.offsets *.bytes_at.time"
    " eccentricity_deg *.visual_continuity.frames",
    "axes": "*.__call__.x r *.bytes_at.time EnvMap.sample.directions *cube_lookup.directions envmap_texels.directions"
    " depth_from_range.ranges stream.export.center lod.fit_4pl.* range_error.distance range_from_depth.depth ratios"
    " *.ssim_pairs.references *.ssim_pairs.tests RadialLens.warp.image *.visual_continuity.frames",
    "columns": "stream.Growth.radii RadialLens.k r Scene.subset.triangles stream.assign.radii *.bytes_at.time"
    " cube_*.faces gpu.cube_lookup.faces convert_envmap.values bounding_spheres.offsets depth_from_range.ranges ratios"
    " range_error.distance *.__call__.x range_from_depth.depth RadialLens.warp.image *.visual_continuity.frames",
    "fewer": "*.project.points *.displayed.points *.warp.image RadialLens.*.r regions.path ratios"
    " EnvMap.sample.directions bend_rays.directions *cube_lookup.directions envmap_texels.directions"
    " Scene.from_arrays.faces SceneBuilder.mesh.faces triangle_radii.faces SceneBuilder.place_many.transforms"
    " bounding_sphere.points bounding_spheres.offsets depth_from_range.ranges range_from_depth.depth gpu.morph.points"
    " morph.points nearest_points.points *.view_vectors.points range_error.distance stream.Growth.radii"
    " stream.assign.radii *.bytes_at.time *.visual_continuity.frames",
    "callable": "render_path.lod",
    "free": "Hmd.name LoadOptions.height lod.Level.note lod.*.name SceneBuilder.*.name SceneBuilder.place_many.names"
    " relative stream.client.*.room stream.client.*.name stream.client.*.token",
    "path": "relative",
    "names": "object_names Hmd.sources SceneBuilder.objects.names Shot.channels",
    "entries": "*.stats lod.LodModel.measured ReducedScene.counts lod.Selection.columns",
    "mapping": "render_path.at",
    "set": "stream.Growth.radii stream.assign.radii stream.export.radii",
    "flag": "lod.Levels.__getitem__.index",
}
"""Kinds of values that single parameters accept besides those of their annotations."""

RANGES: dict[str, str] = {
    "(0, inf)": "acuity_limit_deg anchor aspect blend cell data_range distance error_px eye_height focal k1 k2"
    " lens_radius limit_deg moving pixel radius *.AdaptivePlane.rate reach reference refresh_hz scale seconds shear"
    " sigma speed step tolerance tolerance_px RadiusSettings.r2 ImpostorSettings.reach"
    " choose_radii.r2 regions.r2 r_max mono_plane depth_from_range.near"
    " stereo.mono_plane_for.slope range_from_depth.near range_error.near regions.budget",
    "(0, 4294967295)": "orthoview.OrthoTree.render.budget",
    "(0, inf]": "depth MorphSettings.tolerance_px ReducedScene.render.tolerance_px cast_rays.t_max",
    "[0, inf)": "acuity_slope datasets.Asteroids.*.detail datasets.World.*.detail detail error floor hysteresis near"
    " pixel_deg slope time stream.Growth.fade budget cache_bytes MorphSettings.radius"
    " ReducedScene.*.radius *.AdaptivePlane.update.seconds standard_error ImpostorSettings.height",
    "(-inf, inf)": "cutoff d k t lod.Level.* orthoview.*.time Walk.render.seconds index",
    "[-inf, inf]": "Similarity.mean Scene.dropped *.shown.depth RadialLens.warp.fill",
    "[0, r2)": "r1",
    "(r1, inf)": "r2",
    "(0, 100]": "ImpostorSettings.error_px",
    "(near, inf]": "far",
    "(t_min, inf]": "t_max",
    "[0, inf]": "t_min price",
    "(0, r_max]": "base_radius",
    "(-inf, right)": "left",
    "(left, inf)": "right",
    "(-inf, up)": "down",
    "(down, inf)": "up",
    "(0, r2]": "tessellate.radius",
    "[0, 4)": "ReducedScene.with_r1.r1",
    "[0, 4]": "ReducedScene.render.radius stream.Bundle.at.radius *.view.direction",
    "[1e-6, 1e9]": "bandwidth decode_mbs",
    "[1e-6, 1e4]": "epsilon min_distance",
    "[1e-3, 1e6]": "every grid",
    "[1e-6, 1]": "stream.*.step *.TemporalAntialiasing.share",
    "[1e-6, 0.005]": "range_error",
    "[0.001, 1000]": "split_px",
    "[0.04, 0.09]": "ipd",
    "[0.1, 1e5]": "nearest",
    "[0, 0.5]": "loss",
    "[0, 1]": "ImpostorSettings.missing least pursuit share shutter spread strength lod.*.fade lod.*.hysteresis"
    " level place lod.*.quality",
    "[-1, 1]": "saturated",
    "[0, 1.5708)": "angle cube_lookup.radius",
    "(0, 3.2)": "orthoview.size_for.fov",
    "[0, 10]": "handshake",
    "[0, 10)": "LoadOptions.lod",
    "[0, 60]": "fade",
    "[0, 90]": "lift_deg",
    "(0, 90)": "kink_deg",
    "[0, 100]": "delay gain intercept lapse lapses reaction reaction_spread search tremor tremor_time percentile"
    " hidden_area_percent quality stream.collect.*.slope",
    "[0, 180]": "margin_deg",
    "(0, 180)": "horizontal_deg",
    "[0, 255]": "fill",
    "[0, 60000]": "rtt_ms",
    "[0, 86400]": "hold pause rest",
    "(0, 86400]": "stream.collect.*.duration",
    "[0, 1e6]": "duration latency rise stream.collect.*.distance",
    "(0, 1e6]": "mbps",
    "(0, 1000]": "stream.collect.*.radius",
    "[0, 1e9]": "frame_ms orthoview.Flight.wait.seconds",
    "[0, 1e15]": "map_bytes",
    "[1, 1e15]": "triangles_per_second",
    "[1, 500]": "pixels_per_degree",
    "[1, 1000]": "rate width distances",
    "[1, 2]": "http layers *.changed_tiles.ring",
    "[1, 8]": "views",
    "[1, 17]": "gpu.ssim.size",
    "[1, 26]": "orthoview.*.directions",
    "[1, 64]": "blocks groups users threads poses orthoview.*.samples ImpostorSettings.centers",
    "[1, 255]": "trials",
    "[1, 256]": "convert_envmap.samples",
    "[1, 1024]": "samples offsets ReducedScene.explore.face_size",
    "[1, 4096]": "workers",
    "[1, 10000]": "luminance km",
    "[1, 16384]": "face_size size",
    "[1, 32768]": "*.height",
    "[1, 65536]": "stream.*.face_size",
    "[1, 1e6]": "count trees orthoview.size_for.pixels",
    "[1, 2e6]": "datasets.forest.trees",
    "[1, inf)": "max_bytes triangles ImpostorSettings.bytes convert_envmap.size envmap_*.size",
    "[2, 15]": "boxes rectangles",
    "[3, 65536]": "keep",
    "[4, 4096]": "orthoview.ViewSettings.size",
    "[4, 1048576]": "lod.*.views",
    "[8, 16]": "depth_bits",
    "[16, 24]": "normal_bits",
    "[16, 4096]": "stream.simulate.size",
    "[48, 4e6]": "polygons",
    "[64, 4096]": "stream.ExportSettings.face_size",
    "[64, 8192]": "ImpostorSettings.face_size",
    "[-3, 2]": "channel_axis",
    "[0, 0]": "layer region mesh material",
    "[0, 2]": "i j current ring",
    "[0, 3]": "*.Rings.objects.ring",
    "[0, 5]": "face",
    "[0, 7]": "datasets.*.detail",
    "[0, 1000]": "iterations",
    "[0, 65535]": "group user",
    "[0, 4294967295]": "stream.collect.*.seed SceneBuilder.objects.names",
    "[0, 9223372036854775807]": "seed",
}
"""Numbers that parameters accept; a bound may be another argument."""


@dataclass(frozen=True)
class Range:
    """Numbers between two bounds, each inclusive or exclusive."""

    low: float
    high: float
    has_low: bool
    has_high: bool

    @classmethod
    def parse(cls, text: str, arguments: Mapping[str, Any]) -> Range:
        """Read "[0, r2)" in a call with these arguments."""

        def number(bound: str, unbounded: float) -> float:
            if bound == "inf" or not bound.isidentifier():
                return float(bound)
            given = arguments.get(bound)
            return unbounded if given is None else float(given)

        low, high = text[1:-1].split(", ")
        return cls(number(low, -math.inf), number(high, math.inf), text[0] == "[", text[-1] == "]")

    def __contains__(self, value: float) -> bool:
        return (self.low < value or (self.has_low and value == self.low)) and (
            value < self.high or (self.has_high and value == self.high)
        )

    def outside(self, *, is_whole: bool) -> list[float]:
        """Numbers just beyond the finite bounds."""
        found: list[float] = []
        for bound, belongs, sign in ((self.low, self.has_low, -1), (self.high, self.has_high, 1)):
            if math.isfinite(bound):
                step = 1 if is_whole else max(1e-9, 0.01 * abs(bound))
                found.append((int(bound) if is_whole else bound) + sign * belongs * step)
        return found


@functools.cache
def added_kinds(name: str) -> frozenset[str]:
    """Return kinds that a parameter accepts besides those of its annotation."""
    return frozenset(
        kind for kinds, patterns in TAKEN.items() if match_length(name, patterns) for kind in kinds.split()
    )


def kinds_of(parameter: Parameter) -> frozenset[str]:
    """Return the kinds of values that an annotation may permit."""
    found = {"none"} if parameter.default is None else set()
    for part in str(parameter.annotation).split(" | "):
        for pattern, kinds in ANNOTATIONS.items():
            if re.fullmatch(pattern, part):
                found.update(kinds.split())
    return frozenset(found)


def range_of(name: str, arguments: Mapping[str, Any]) -> Range:
    """Return the numbers that a parameter accepts in a call with these arguments."""
    best = max(RANGES, key=lambda text: match_length(name, RANGES[text]))
    assert match_length(name, RANGES[best]), f"{name}: no range of numbers is stated"
    return Range.parse(best, arguments)
