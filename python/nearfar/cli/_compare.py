"""`nearfar compare`: compares conventional and continuous method with the truth and checks thresholds."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, Any

import typer

import nearfar as nf
from nearfar._base import check as checks, files, formats
from nearfar._reduce import default_radii, findings
from nearfar.cli import _comparison_page, _options as options, _page, _report_page, _source, _thresholds, _viewpoint
from nearfar.cli._methods import METHODS, render_all
from nearfar.cli._options import option
from nearfar.cli._output import Clock, metres, note_rows, radii_rows, show, triangles_text
from nearfar.cli._partition import curve_points
from nearfar.cli._render import camera

VERSION = 1


def compare(
    scene: options.SceneOrFolder,
    output: options.Folder,
    center: options.Center = None,
    user: Annotated[
        str | None, option("--user", "X,Y,Z", "User's eye U in metres. By default beside the centre.")
    ] = None,
    distance: Annotated[
        float | None,
        option("--distance", "METRES", "Distance of U from O without --user. By default 6 for 30 and 50 m, else less."),
    ] = None,
    truth: Annotated[
        str | None,
        option("--truth", "SCENE", "For a folder as -i: its whole scene. By default the one that its report names."),
    ] = None,
    target: options.Target = None,
    fov: options.Degrees = 90.0,
    r1: options.Inner = None,
    r2: options.Outer = None,
    face_size: options.FaceSize = None,
    size: options.Size = "960x600",
    samples: options.Samples = 4,
    exact: Annotated[
        bool, typer.Option("--exact", help="Bend a ray for every pixel; trace the far part instead of using the map.")
    ] = False,
    min_psnr: Annotated[
        float | None, option("--min-psnr", "DB", "Least PSNR in decibels; exit status 3 below it.")
    ] = None,
    min_ssim: Annotated[float | None, option("--min-ssim", "VALUE", "Least SSIM; exit status 3 below it.")] = None,
    max_tear: Annotated[
        float | None, option("--max-tear", "PIXELS", "Greatest mean tear along the boundary; exit status 3 above it.")
    ] = None,
    max_discontinuity: Annotated[
        float | None, option("--max-discontinuity", "VALUE", "Greatest mean discontinuity; exit status 3 above it.")
    ] = None,
    max_boundary: Annotated[
        float | None,
        option(
            "--max-boundary-discontinuity",
            "VALUE",
            "Greatest mean discontinuity along the boundary; exit status 3 above it.",
        ),
    ] = None,
    backend: options.Backend = None,
    up: options.Up = "y",
    scale: options.Scale = None,
    max_bytes: options.MaxBytes = None,
    blend: options.Blend = "opaque",
    tile_error: options.TileError = None,
    tile_triangles: options.TileTriangles = None,
    tile_origin: options.TileOrigin = None,
    city_lod: options.CityLod = None,
    city_height: options.CityHeight = None,
    on_invalid: options.Invalid = "raise",
    as_json: options.Json = False,
) -> None:
    """Compare the conventional and the continuous method with the truth, seen from one eye.

    Thresholds apply to the continuous method; the exit status is 3 if one is not met or could not be measured.
    """
    options.check_radii(r1, r2)
    options.check_angle(fov)
    options.check_backend(backend)
    thresholds = _thresholds.thresholds(
        min_psnr=min_psnr,
        min_ssim=min_ssim,
        max_tear=max_tear,
        max_discontinuity=max_discontinuity,
        max_boundary_discontinuity=max_boundary,
    )
    pixels, middle = options.read_size("--size", size), options.read_point("--center", center)
    eye, aim = options.read_point("--user", user), options.read_point("--target", target)
    away, clock = None if distance is None else checks.positive("--distance", distance), Clock()
    saved, source = None, scene
    if options.is_reduced(scene):
        reason = "which has its own"
        _source.refuse(reason, center=center, r1=r1, r2=r2, face_size=face_size)
        _source.refuse("which has no far geometry to trace", exact=exact or None)
    elif truth is not None:
        raise ValueError(f"--truth: expected none with a scene as -i, got {checks.shortened(truth)}")
    parts = options.parts_of(tile_error, tile_triangles, tile_origin, city_lod, city_height)
    output.parent.mkdir(parents=True, exist_ok=True)
    with files.atomic_folder(output, marker="compare.json") as folder:
        with clock.step("scene"):
            if options.is_reduced(scene):
                saved = nf.ReducedScene.load(scene)
                source, loaded = _source.open_truth(
                    scene,
                    truth,
                    up=up,
                    on_invalid=on_invalid,
                    scale=scale,
                    max_bytes=max_bytes,
                    blend=blend,
                    parts=parts,
                )
            else:
                loaded = options.open_scene(
                    scene, up=up, on_invalid=on_invalid, scale=scale, max_bytes=max_bytes, blend=blend, parts=parts
                )
        with clock.step("place"):
            place = _viewpoint.choose(loaded, source, middle if saved is None else saved.center)
            chosen = saved or default_radii.choose(loaded, place, r1, r2)
            inner, outer = chosen.r1, chosen.r2
            stand = _viewpoint.stand(loaded, place, inner, outer, fov=fov, user=eye, target=aim, distance=away)
            view = camera(stand.user, stand.target, fov, pixels)
        with clock.step("load curve"):
            curve = nf.load_curve(loaded, center=place.eye)
        # The discontinuity of far pixels needs their scene points, which are computed from the map's range.
        texels = options.faces(face_size) if saved is None or saved.env is None else saved.env.face_size
        place_and_map = {"center": place.eye, "r1": inner, "r2": outer, "channels": ("color", "range")}
        rendered = render_all(
            loaded,
            view,
            clock,
            pictures={"samples": samples, "channels": ("color", "position")},
            reduction=place_and_map | {"face_size": texels, "backend": backend},
            drawing={"method": "exact", "env": False} if exact else None,
            saved=saved,
        )
        frames, reduced = rendered.frames, rendered.reduced
        with clock.step("measures"):
            measured = {
                name: nf.compare(frames["truth"], frames[name], center=place.eye, radius=outer) for name in METHODS
            }
            torn = {
                name: nf.metrics.boundary_tear(rendered.dense[name], center=place.eye, radius=outer) for name in METHODS
            }
            values = {name: _document(measured[name], torn[name]) for name in METHODS}
        with clock.step("pictures"):
            _report_page.save_pictures(folder, {name: frame.to_image() for name, frame in frames.items()})
            plotted = _report_page.save_curve(folder, curve, outer)
            if plotted:
                _comparison_page.save_heat_maps(
                    folder, {name: comparison.torn for name, comparison in measured.items()}
                )
        margin = nf.fold_margin(stand.user, center=place.eye, r1=inner, r2=outer)
        crosses = any(comparison.boundary_pixels for comparison in measured.values())
        checked = [threshold.check(values["continuous"]) for threshold in thresholds]
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
            "samples": samples,
            "size": list(pixels),
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


def _document(measured: nf.Comparison, torn: nf.metrics.BoundaryTear) -> dict[str, Any]:
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
        "boundary": _rounded(measured.boundary_discontinuity),
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
