"""`nearfar compare`: compares the conventional and the continuous method, and impostors, with the truth."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import typer

import nearfar as nf
from nearfar._base import check as checks, files, formats
from nearfar._camera.density import with_density
from nearfar._reduce import default_radii, findings
from nearfar.cli import _options as options, _page, _thresholds, _viewpoint
from nearfar.cli._groups import Options, flag, option
from nearfar.cli._methods import DENSITY, METHODS, Methods, choose_view, is_measurable, render_all
from nearfar.cli._output import (
    Clock,
    count,
    metres,
    note_rows,
    radii_rows,
    reduction_texts,
    rounded,
    show,
    triangles_text,
)
from nearfar.cli._partition import curve_points
from nearfar.cli._render import camera
from nearfar.cli._scenes import SceneOptions, is_reduced, open_reduced, open_scene

VERSION = 1

MEASURES = {
    "tear": "tear along the boundary at r₂, pixels",
    "tear_kink": "of which change of slope",
    "psnr": "PSNR, dB",
    "ssim": "SSIM",
    "rmse": "RMSE",
    "flip": "FLIP",
    "discontinuity": "discontinuity δ, mean",
    "discontinuity_p99": "discontinuity δ, 99th percentile",
    "boundary": "discontinuity δ along the boundary at r₂",
}
"""Labels of the measures."""

CAPTIONS = {
    "side_by_side.png": "Truth and methods",
    "discontinuity.png": "Discontinuity of both methods with a map, on one scale",
    "load_curve.png": "Triangles left as geometry",
}


@dataclass(frozen=True, kw_only=True)
class ViewOptions(options.PictureOptions):
    """A user's view, and the size of its pictures."""

    user: str | None = option(None, "X,Y,Z", "User's eye U in metres. By default beside the centre.")
    distance: float | None = option(
        None, "METRES", "Distance of U from O without --user. By default the lesser of 0.3 (r2 - r1) and 0.9 r1."
    )
    target: str | None = option(None, "X,Y,Z", "Point to look at, metres. By default the boundary at r2 is in view.")
    fov: float = option(90.0, "DEGREES", "Horizontal field of view.")

    def __post_init__(self) -> None:
        super().__post_init__()
        options.check_angle(self.fov)
        if self.distance is not None:
            checks.positive("--distance", self.distance)

    @cached_property
    def stand_keywords(self) -> dict[str, Any]:
        eye, target = options.read_point("--user", self.user), options.read_point("--target", self.target)
        return {"fov": self.fov, "user": eye, "target": target, "distance": self.distance}


@dataclass(frozen=True, kw_only=True)
class MethodOptions(Options):
    """Methods that are compared, and how exactly."""

    impostors: bool = flag("--impostors", "Compare impostors, too; for a folder that has them, they always are.")
    exact: bool = flag("--exact", "Bend a ray for every pixel; trace the far part instead of using the map.")


def compare(
    *,
    scene: options.SceneOrFolder,
    output: options.Folder,
    truth: str | None = option(
        None, "SCENE", "Full scene of the folder that -i names. By default the scene that its report names."
    ),
    zones: options.MapOptions,
    view: ViewOptions,
    methods: MethodOptions,
    limits: _thresholds.LimitOptions,
    backend: options.Backend = None,
    scene_options: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Compare the conventional and the continuous method, and impostors, with the truth, seen from one eye.

    Thresholds apply to the continuous method; the exit status is 3 if one is not met or could not be measured.
    """
    clock, saved_reduction, quads, truth_source = Clock(), None, None, scene
    if is_reduced(scene):
        zones.refuse("with a folder as -i, which has its own")
        if methods.exact:
            raise ValueError("exact: expected none with a folder as -i, which has no far geometry to trace")
    elif truth is not None:
        raise ValueError(f"--truth: expected none with a scene as -i, got {checks.shortened(truth)}")
    with files.atomic_folder(output, marker="compare.json") as folder:
        with clock.step("scene"):
            if is_reduced(scene):
                saved = open_reduced(scene)
                quads = saved if isinstance(saved, nf.Impostors) else None
                saved_reduction = saved.published if isinstance(saved, nf.Impostors) else saved
                truth_source, full_scene = _viewpoint.open_truth(scene, truth, scene_options.loading)
            else:
                full_scene = open_scene(scene, scene_options.loading)
        with clock.step("place"):
            viewpoint = _viewpoint.choose(
                full_scene, truth_source, zones.point if saved_reduction is None else saved_reduction.center
            )
            radii = saved_reduction or zones.choose_radii(full_scene, viewpoint)
            r1, r2 = radii.r1, radii.r2
            stands = _viewpoint.stands(full_scene, viewpoint, r1, r2, **view.stand_keywords)
            cameras = [camera(stand.user, stand.target, view.fov, view.pixels) for stand in stands]
        with clock.step("load curve"):
            curve = nf.load_curve(full_scene, center=viewpoint.eye)
        # The discontinuity of far pixels needs their scene points, which are computed from the map's range.
        env = None if saved_reduction is None else saved_reduction.env
        texels = zones.face_size if env is None else env.face_size
        place_and_map = {"center": viewpoint.eye, "r1": r1, "r2": r2, "channels": ("color", "range")}
        reduction = place_and_map | {"face_size": texels, "backend": backend}
        with clock.step("reduce"):
            shown_methods = Methods.prepare(
                full_scene, reduction, saved=saved_reduction, positions=True, exact=methods.exact
            )
        if methods.impostors and quads is None:
            with clock.step("impostors"):
                baking = nf.ImpostorSettings(face_size=max(texels, 64))
                quads = nf.reduce(full_scene, center=viewpoint.eye, r2=r2, far="impostors", settings=baking)
        with clock.step("view"):
            chosen = choose_view(shown_methods, cameras)
            user_view, user_camera = stands[chosen.number], cameras[chosen.number]
        pictures: dict[str, Any] = {"samples": view.samples, "channels": ("color", "position")}
        frames = render_all(full_scene, shown_methods, user_camera, clock, pictures, backend)
        if quads is not None:
            with clock.step("picture of impostors"):
                frames["impostors"] = nf.render(quads, user_camera, backend=backend, **pictures)
        with clock.step("dense pictures"):
            dense_camera = with_density(user_camera, DENSITY)
            dense = {name: shown_methods.positions(name, dense_camera) for name in METHODS}
        with clock.step("measures"):
            boundary: dict[str, Any] = {"center": viewpoint.eye, "radius": r2}
            shown = {name: frame for name, frame in frames.items() if name != "truth"}
            comparisons = {name: nf.compare(frames["truth"], frame, **boundary) for name, frame in shown.items()}
            tears = {name: nf.metrics.boundary_tear(frame, **boundary) for name, frame in dense.items()}
            measures = {name: _measures_document(comparisons[name], tears.get(name)) for name in shown}
        with clock.step("pictures"):
            _page.save_pictures(folder, {name: frame.to_image() for name, frame in frames.items()})
            has_plots = _page.save_curve(folder, curve, r2)
            if has_plots:
                _page.save_heat_maps(folder, {name: comparisons[name].torn for name in METHODS})
        margin = nf.fold_margin(user_view.user, center=viewpoint.eye, r1=r1, r2=r2)
        is_shown = _shows_boundary(measures)
        crosses = any(comparison.boundary_pixels for comparison in comparisons.values())
        results = limits.results(measures["continuous"])
        document = formats.header("compare", VERSION, origin=full_scene.origin.tolist(), color_space="sRGB") | {
            "source": scene,
            "truth": truth_source,
            "unit_note": full_scene.report.unit_note,
            "notes": list(full_scene.report.notes),
            "triangles": int(full_scene.triangle_count),
            "triangles_left": int(shown_methods.reduced.stats["drawn"]),
            "map_bytes": int(shown_methods.reduced.stats["map_bytes"]),
            "triangles_of_impostors": None if quads is None else quads.triangle_count,
            "center": list(viewpoint.eye),
            "user": list(user_view.user),
            "views": {"considered": len(stands), "measurable": chosen.others + is_shown},
            "fold_margin": rounded(margin, 3),
            "r1": r1,
            "r2": r2,
            "radii_reason": radii.reason if isinstance(radii, default_radii.Choice) else "",
            "face_size": texels,
            "samples": view.samples,
            "size": list(view.pixels),
            "method": "exact" if methods.exact else "vertex",
            "pictures": measures,
            "thresholds": results,
            "findings": findings.of_reduction(shown_methods.reduced.stats, r2)
            + findings.of_view(crosses=crosses, is_measurable=is_shown, fold_margin=margin, r2=r2),
            "load_curve": curve_points(curve),
            "seconds": clock.seconds,
            "files": sorted([path.name for path in folder.iterdir()] + ["compare.json", "report.html", "report.md"]),
        }
        _report(document).save(folder, "compare.json")
    if not has_plots:
        typer.echo("nearfar: left plots out, because matplotlib is not installed", err=True)
    show(document, _rows(document, output), title=scene, as_json=as_json)
    unmet = [check for check in results if not check["kept"]]
    for check in unmet:
        typer.echo(f"nearfar: {_thresholds.describe_failure(check)}", err=True)
    if unmet:
        raise typer.Exit(_thresholds.BROKEN)


def _measures_document(comparison: nf.Comparison, tear: nf.metrics.BoundaryTear | None) -> dict[str, Any]:
    """Return rounded measures for the report, without the map of discontinuity.

    Measures along the boundary are None if no pixel there sees both sides, because one side occludes the other, and
    for impostors, which have no `tear`. `unmeasured` has the reason for each missing measure.
    """
    values = {
        "tear": None if tear is None else rounded(tear.tear),
        "tear_kink": None if tear is None else rounded(tear.kink),
        "tear_shared": None if tear is None else rounded(tear.shared),
        "tear_density": None if tear is None else rounded(tear.pixels_per_degree),
        "psnr": rounded(comparison.psnr, 4),
        "ssim": rounded(comparison.ssim),
        "rmse": rounded(comparison.rmse),
        "flip": rounded(comparison.flip),
        "discontinuity": None if tear is None else rounded(comparison.discontinuity),
        "discontinuity_p99": None if tear is None else rounded(comparison.discontinuity_p99),
        "boundary": rounded(comparison.boundary_discontinuity) if tear is not None and tear.shared else None,
        "boundary_pixels": comparison.boundary_pixels,
    }
    reasons = _thresholds.UNMEASURED
    if tear is None:
        reasons = dict.fromkeys(reasons, _thresholds.UNMEASURED_IMPOSTORS) | {"flip": reasons["flip"]}
    return values | {"unmeasured": {name: reason for name, reason in reasons.items() if values[name] is None}}


def _footnotes(document: dict[str, Any]) -> list[str]:
    """Return a sentence for each reason why rows of the table of measures are not measurable."""
    methods: dict[str, list[str]] = {}
    for method, values in document["pictures"].items():
        for reason in dict.fromkeys(values["unmeasured"].values()):
            methods.setdefault(reason, []).append(method)
    return [f"{', '.join(names)}: {reason}" for reason, names in methods.items()]


def _shows_boundary(pictures: dict[str, dict[str, Any]]) -> bool:
    """Return whether the boundary can be measured in the pictures of both methods, from their measures."""
    return is_measurable(pictures[name]["tear_shared"] for name in METHODS)


def _rows(document: dict[str, Any], output: Path) -> list[tuple[str, str]]:
    pictures = document["pictures"]
    rows = [(label, " | ".join(_text(key, values) for values in pictures.values())) for key, label in MEASURES.items()]
    return [
        ("triangles", triangles_text(document)),
        *(
            [("triangles with impostors", count(with_quads))]
            if (with_quads := document["triangles_of_impostors"])
            else []
        ),
        ("centre, user", f"{metres(document['center'])}; {metres(document['user'])}"),
        ("views", _views_text(document)),
        *radii_rows(document),
        ("", " | ".join(pictures)),
        *rows,
        *(("not measurable" if not number else "", text) for number, text in enumerate(_footnotes(document))),
        *((check["option"], _thresholds.result(check)) for check in document["thresholds"]),
        *note_rows(document),
        ("written to", str(output)),
    ]


def _views_text(document: dict[str, Any]) -> str:
    views = document["views"]
    if views["considered"] == 1:
        return f"the boundary {'can' if views['measurable'] else 'cannot'} be measured in the only view considered"
    found = f"the boundary can be measured in {views['measurable']} of the {views['considered']} views considered"
    if not views["measurable"]:
        return found
    is_shown = _shows_boundary(document["pictures"])
    return f"{found}; the best of them is shown" if is_shown else f"{found}, but not in the one shown"


def _text(measure: str, values: dict[str, Any]) -> str:
    value = values[measure]
    if value is not None:
        return f"{value:.4g}"
    return {"psnr": "equal pictures", "flip": "needs nearfar[flip]"}.get(measure, "not measurable")


def _report(document: dict[str, Any]) -> _page.Page:
    pictures, margin = document["pictures"], document["fold_margin"]
    shares = (values["tear_shared"] for values in pictures.values())
    tables = {
        "Against the truth": [
            ["measure", *pictures],
            *([label, *(_text(key, values) for values in pictures.values())] for key, label in MEASURES.items()),
            [
                "boundary pixels that see both sides",
                *("–" if share is None else f"{100 * share:.0f} %" for share in shares),
            ],
            ["pixels along the boundary", *(count(values["boundary_pixels"]) for values in pictures.values())],
        ],
        "Triangles left": _page.load_curve_rows(document),
        "Time": _page.time_rows(document),
        **_page.notes_table(document),
    }
    if document["thresholds"]:
        rows = [
            [
                check["option"],
                f"{check['limit']:.4g}",
                _text(check["measure"], pictures["continuous"]),
                _thresholds.result(check),
            ]
            for check in document["thresholds"]
        ]
        tables["Thresholds"] = [["threshold", "limit", "continuous", "result"], *rows]
    has_folded = margin is None or margin < 0
    folds = "the picture has folded" if has_folded else f"the picture folds {margin:.1f} m farther away from O"
    views = _views_text(document).capitalize()
    texts = {"method": document["method"], "folds": folds, "views": views, **reduction_texts(document)}
    notes = [f"Note: {note}." for note in (document["unit_note"], *document["findings"]) if note]
    footnotes = [f"Not measurable for {text}." for text in _footnotes(document)]
    title = f"Near-far comparison of {document['source']}"
    paragraphs = [*notes, *_page.paragraphs("comparison.md", **texts), *footnotes]
    return _page.Page(document, title, paragraphs, CAPTIONS, tables)
