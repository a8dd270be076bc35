"""`nearfar compare`: compares conventional and continuous method with the truth and checks thresholds."""

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
            "Distance of U from O if --user is not given. By default 6 for radii of 30 and 50 m, else less.",
        ),
    ] = None
    target: Annotated[
        str | None,
        option("--target", "X,Y,Z", "Point to look at, metres. By default a view that the boundary at r2 crosses."),
    ] = None
    fov: Annotated[float, option("--fov", "DEGREES", "Horizontal field of view.")] = 90.0

    def __post_init__(self) -> None:
        super().__post_init__()
        options.check_angle(self.fov)
        if self.distance is not None:
            checks.positive("--distance", self.distance)

    @cached_property
    def stand(self) -> dict[str, Any]:
        """Keywords of `_viewpoint.stand`."""
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
    clock, saved, source = Clock(), None, scene
    if is_reduced(scene):
        _source.refuse("which has its own", **asdict(zones))
        _source.refuse("which has no far geometry to trace", exact=exact or None)
    elif truth is not None:
        raise ValueError(f"--truth: expected none with a scene as -i, got {checks.shortened(truth)}")
    output.parent.mkdir(parents=True, exist_ok=True)
    with files.atomic_folder(output, marker="compare.json") as folder:
        with clock.step("scene"):
            if is_reduced(scene):
                saved = nf.ReducedScene.load(scene)
                source, loaded = _source.open_truth(scene, truth, file.loading)
            else:
                loaded = open_scene(scene, file.loading)
        with clock.step("place"):
            place = _viewpoint.choose(loaded, source, zones.point if saved is None else saved.center)
            chosen = saved or zones.choose_radii(loaded, place)
            inner, outer = chosen.r1, chosen.r2
            stand = _viewpoint.stand(loaded, place, inner, outer, **view.stand)
            shot = camera(stand.user, stand.target, view.fov, view.pixels)
        with clock.step("load curve"):
            curve = nf.load_curve(loaded, center=place.eye)
        # The discontinuity of far pixels needs their scene points, which are computed from the map's range.
        texels = zones.texels if saved is None or saved.env is None else saved.env.face_size
        place_and_map = {"center": place.eye, "r1": inner, "r2": outer, "channels": ("color", "range")}
        rendered = render_all(
            loaded,
            shot,
            clock,
            pictures={"samples": view.samples, "channels": ("color", "position")},
            reduction=place_and_map | {"face_size": texels, "backend": backend},
            drawing={"method": "exact", "env": False} if exact else None,
            saved=saved,
        )
        frames, reduced = rendered.frames, rendered.reduced
        with clock.step("measures"):
            measured = {
                name: nf.compare(frames["truth"], frames[name], center=place.eye, radius=outer) for name in METHODS
            }
            torn = {name: nf.boundary_tear(rendered.dense[name], center=place.eye, radius=outer) for name in METHODS}
            values = {name: _document(measured[name], torn[name]) for name in METHODS}
        with clock.step("pictures"):
            _pictures.save_pictures(folder, {name: frame.to_image() for name, frame in frames.items()})
            plotted = _pictures.save_curve(folder, curve, outer)
            if plotted:
                _pictures.save_heat_maps(folder, {name: comparison.torn for name, comparison in measured.items()})
        margin = nf.fold_margin(stand.user, center=place.eye, r1=inner, r2=outer)
        crosses = any(comparison.boundary_pixels for comparison in measured.values())
        checked = [threshold.check(values["continuous"]) for threshold in limits.thresholds]
        document = formats.header("compare", VERSION, origin=[float(v) for v in loaded.origin], color_space="sRGB") | {
            "source": scene,
            "truth": source,
            "unit_note": loaded.report.unit_note,
            "notes": list(loaded.report.notes),
            "triangles": int(loaded.triangle_count),
            "triangles_left": int(reduced.stats["drawn"]),
            "map_bytes": int(reduced.stats["map_bytes"]),
            "center": list(place.eye),
            "user": list(stand.user),
            "fold_margin": round(margin, 3) if math.isfinite(margin) else None,
            "r1": inner,
            "r2": outer,
            "radii_reason": chosen.reason if isinstance(chosen, default_radii.Choice) else "",
            "face_size": texels,
            "samples": view.samples,
            "size": list(view.pixels),
            "method": "exact" if exact else "vertex",
            "pictures": values,
            "thresholds": checked,
            "findings": [
                *findings.of_reduction(reduced.stats, outer),
                *findings.of_view(crosses=crosses, fold_margin=margin, r2=outer),
            ],
            "load_curve": curve_points(curve),
            "seconds": clock.seconds,
            "files": sorted([path.name for path in folder.iterdir()] + ["compare.json", "report.html", "report.md"]),
        }
        _page.save(folder, "compare.json", document, _comparison_page.page(document))
    if not plotted:
        typer.echo("nearfar: left plots out, because matplotlib is not installed", err=True)
    show(document, _rows(document, output), title=scene, as_json=as_json)
    broken = [check for check in checked if not check["kept"]]
    for check in broken:
        typer.echo(f"nearfar: {_thresholds.sentence(check)}", err=True)
    if broken:
        raise typer.Exit(_thresholds.BROKEN)


def _document(measured: nf.Comparison, torn: nf.BoundaryTear) -> dict[str, Any]:
    """Return rounded measures for the report, without the map of discontinuity."""
    return {
        "tear": _rounded(torn.tear),
        "tear_kink": _rounded(torn.kink),
        "tear_shared": _rounded(torn.shared),
        "tear_density": _rounded(torn.pixels_per_degree),
        "psnr": round(measured.psnr, 4) if math.isfinite(measured.psnr) else None,
        "ssim": round(measured.ssim, 6),
        "rmse": round(measured.rmse, 6),
        "discontinuity": _rounded(measured.discontinuity),
        "discontinuity_p99": _rounded(measured.discontinuity_p99),
        "boundary": _rounded(measured.boundary),
        "boundary_pixels": measured.boundary_pixels,
    }


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 6)


def _rows(document: dict[str, Any], output: Path) -> list[tuple[str, str]]:
    pictures = document["pictures"]
    both = [
        (label, " → ".join(_comparison_page.text(pictures[name][key]) for name in METHODS))
        for key, label in _comparison_page.MEASURES.items()
    ]
    return [
        ("triangles", triangles_text(document)),
        ("centre, user", f"{metres(document['center'])}; {metres(document['user'])}"),
        *radii_rows(document),
        ("", "conventional → continuous"),
        *both,
        *((check["option"], _thresholds.result(check)) for check in document["thresholds"]),
        *note_rows(document),
        ("written to", str(output)),
    ]
