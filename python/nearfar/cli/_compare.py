"""`nearfar compare`: compares the conventional and the continuous method with the truth; checks thresholds."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any

import typer

import nearfar as nf
from nearfar._base import check as checks, files, formats
from nearfar._reduce import default_radii, findings
from nearfar.cli import _comparison_page, _options as options, _page, _pictures, _source, _thresholds, _viewpoint
from nearfar.cli._methods import METHODS, render_all
from nearfar.cli._options import option
from nearfar.cli._output import Clock, metres, note_rows, radii_rows, show, triangles_text
from nearfar.cli._partition import curve_points
from nearfar.cli._render import camera
from nearfar.cli._scenes import SceneOptions, is_reduced, open_scene

VERSION = 1


@dataclass(frozen=True, kw_only=True)
class ViewOptions(options.PictureOptions):
    """A user's view, and the size of its pictures."""

    user: Annotated[str | None, option("--user", "X,Y,Z", "User's eye U in metres. By default beside the centre.")] = (
        None
    )
    distance: Annotated[
        float | None,
        option(
            "--distance",
            "METRES",
            "Distance of U from O if --user is not given. By default 6 m if the radii are 30 and 50 m, else less.",
        ),
    ] = None
    target: Annotated[
        str | None,
        option("--target", "X,Y,Z", "Point to look at, metres. By default the boundary at r2 is in view."),
    ] = None
    fov: Annotated[float, option("--fov", "DEGREES", "Horizontal field of view.")] = 90.0

    def __post_init__(self) -> None:
        super().__post_init__()
        options.check_angle(self.fov)
        if self.distance is not None:
            checks.positive("--distance", self.distance)

    @cached_property
    def stand_keywords(self) -> dict[str, Any]:
        """Keyword arguments of `_viewpoint.stand`."""
        eye, target = options.read_point("--user", self.user), options.read_point("--target", self.target)
        return {"fov": self.fov, "user": eye, "target": target, "distance": self.distance}


def compare(
    *,
    scene: options.SceneOrFolder,
    output: options.Folder,
    truth: Annotated[
        str | None,
        option(
            "--truth", "SCENE", "Full scene of the folder that -i names. By default the scene that its report names."
        ),
    ] = None,
    zones: options.MapOptions,
    view: ViewOptions,
    exact: Annotated[
        bool, typer.Option("--exact", help="Bend a ray for every pixel; trace the far part instead of using the map.")
    ] = False,
    limits: _thresholds.LimitOptions,
    backend: options.Backend = None,
    file: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Compare the conventional and the continuous method with the truth, seen from one eye.

    Thresholds apply to the continuous method; the exit status is 3 if one is not met or could not be measured.
    """
    options.check_backend(backend)
    clock, saved_reduction, truth_source = Clock(), None, scene
    if is_reduced(scene):
        _source.refuse("which has its own", **asdict(zones))
        _source.refuse("which has no far geometry to trace", exact=exact or None)
    elif truth is not None:
        raise ValueError(f"--truth: expected none with a scene as -i, got {checks.shortened(truth)}")
    output.parent.mkdir(parents=True, exist_ok=True)
    with files.atomic_folder(output, marker="compare.json") as folder:
        with clock.step("scene"):
            if is_reduced(scene):
                saved_reduction = nf.ReducedScene.load(scene)
                truth_source, full_scene = _source.open_truth(scene, truth, file.loading)
            else:
                full_scene = open_scene(scene, file.loading)
        with clock.step("place"):
            viewpoint = _viewpoint.choose(
                full_scene, truth_source, zones.point if saved_reduction is None else saved_reduction.center
            )
            radii = saved_reduction or zones.choose_radii(full_scene, viewpoint)
            r1, r2 = radii.r1, radii.r2
            user_view = _viewpoint.stand(full_scene, viewpoint, r1, r2, **view.stand_keywords)
            user_camera = camera(user_view.user, user_view.target, view.fov, view.pixels)
        with clock.step("load curve"):
            curve = nf.load_curve(full_scene, center=viewpoint.eye)
        # The discontinuity of far pixels needs their scene points, which are computed from the map's range.
        texels = (
            zones.texels if saved_reduction is None or saved_reduction.env is None else saved_reduction.env.face_size
        )
        place_and_map = {"center": viewpoint.eye, "r1": r1, "r2": r2, "channels": ("color", "range")}
        rendered = render_all(
            full_scene,
            user_camera,
            clock,
            pictures={"samples": view.samples, "channels": ("color", "position")},
            reduction=place_and_map | {"face_size": texels, "backend": backend},
            drawing={"method": "exact", "env": False} if exact else None,
            saved=saved_reduction,
        )
        frames, reduced = rendered.frames, rendered.reduced
        with clock.step("measures"):
            comparisons = {
                name: nf.compare(frames["truth"], frames[name], center=viewpoint.eye, radius=r2) for name in METHODS
            }
            tears = {
                name: nf.metrics.boundary_tear(rendered.dense[name], center=viewpoint.eye, radius=r2)
                for name in METHODS
            }
            measures = {name: _measures_document(comparisons[name], tears[name]) for name in METHODS}
        with clock.step("pictures"):
            _pictures.save_pictures(folder, {name: frame.to_image() for name, frame in frames.items()})
            has_plots = _pictures.save_curve(folder, curve, r2)
            if has_plots:
                _pictures.save_heat_maps(folder, {name: comparison.torn for name, comparison in comparisons.items()})
        margin = nf.fold_margin(user_view.user, center=viewpoint.eye, r1=r1, r2=r2)
        crosses = any(comparison.boundary_pixels for comparison in comparisons.values())
        results = [threshold.check(measures["continuous"]) for threshold in limits.thresholds]
        document = formats.header(
            "compare", VERSION, origin=[float(v) for v in full_scene.origin], color_space="sRGB"
        ) | {
            "source": scene,
            "truth": truth_source,
            "unit_note": full_scene.report.unit_note,
            "notes": list(full_scene.report.notes),
            "triangles": int(full_scene.triangle_count),
            "triangles_left": int(reduced.stats["drawn"]),
            "map_bytes": int(reduced.stats["map_bytes"]),
            "center": list(viewpoint.eye),
            "user": list(user_view.user),
            "fold_margin": round(margin, 3) if math.isfinite(margin) else None,
            "r1": r1,
            "r2": r2,
            "radii_reason": radii.reason if isinstance(radii, default_radii.Choice) else "",
            "face_size": texels,
            "samples": view.samples,
            "size": list(view.pixels),
            "method": "exact" if exact else "vertex",
            "pictures": measures,
            "thresholds": results,
            "findings": [
                *findings.of_reduction(reduced.stats, r2),
                *findings.of_view(crosses=crosses, fold_margin=margin, r2=r2),
            ],
            "load_curve": curve_points(curve),
            "seconds": clock.seconds,
            "files": sorted([path.name for path in folder.iterdir()] + ["compare.json", "report.html", "report.md"]),
        }
        _page.save(folder, "compare.json", document, _comparison_page.page(document))
    if not has_plots:
        typer.echo("nearfar: left plots out, because matplotlib is not installed", err=True)
    show(document, _rows(document, output), title=scene, as_json=as_json)
    unmet = [check for check in results if not check["kept"]]
    for check in unmet:
        typer.echo(f"nearfar: {_thresholds.sentence(check)}", err=True)
    if unmet:
        raise typer.Exit(_thresholds.BROKEN)


def _measures_document(comparison: nf.Comparison, tear: nf.metrics.BoundaryTear) -> dict[str, Any]:
    """Return rounded measures for the report, without the map of discontinuity."""
    return {
        "tear": _rounded(tear.tear),
        "tear_kink": _rounded(tear.kink),
        "tear_shared": _rounded(tear.shared),
        "tear_density": _rounded(tear.pixels_per_degree),
        "psnr": round(comparison.psnr, 4) if math.isfinite(comparison.psnr) else None,
        "ssim": round(comparison.ssim, 6),
        "rmse": round(comparison.rmse, 6),
        "discontinuity": _rounded(comparison.discontinuity),
        "discontinuity_p99": _rounded(comparison.discontinuity_p99),
        "boundary": _rounded(comparison.boundary_discontinuity),
        "boundary_pixels": comparison.boundary_pixels,
    }


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 6)


def _rows(document: dict[str, Any], output: Path) -> list[tuple[str, str]]:
    pictures = document["pictures"]
    measure_rows = [
        (label, " → ".join(_comparison_page.text(pictures[name][key]) for name in METHODS))
        for key, label in _comparison_page.MEASURES.items()
    ]
    return [
        ("triangles", triangles_text(document)),
        ("centre, user", f"{metres(document['center'])}; {metres(document['user'])}"),
        *radii_rows(document),
        ("", "conventional → continuous"),
        *measure_rows,
        *((check["option"], _thresholds.result(check)) for check in document["thresholds"]),
        *note_rows(document),
        ("written to", str(output)),
    ]
