"""`nearfar reduce`: reduces a scene to a folder for thin clients and writes a report; `nearfar demo`."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal

import numpy as np
import typer
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import files, formats
from nearfar._reduce import default_radii, findings
from nearfar.cli import _options as options, _page, _viewpoint
from nearfar.cli._groups import choice
from nearfar.cli._methods import Methods, render_all
from nearfar.cli._output import (
    Clock,
    count,
    map_text,
    metres,
    note_rows,
    radii_rows,
    reduction_texts,
    show,
    triangles_text,
)
from nearfar.cli._partition import curve_points
from nearfar.cli._render import camera
from nearfar.cli._scenes import PARTS, SceneOptions, open_scene
from nearfar.metrics._comparison import visible_difference

VERSION = 1


def reduce(
    *,
    scene: options.Input,
    output: options.Folder,
    zones: options.MapOptions,
    with_range: options.WithRange = False,
    equirectangular: Literal["exr", "png"] | None = choice(
        None, "Also write the map as one picture, far-equirectangular.exr or .png."
    ),
    picture: options.PictureOptions,
    backend: options.Backend = None,
    file: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Reduce a scene to near.glb, far.exr and reduced.json for a client, and write a report with pictures.

    The pictures show the truth, the conventional and the continuous method for a user beside the centre.
    `nearfar render`, `nearfar compare` and `nearfar.ReducedScene.load` read the folder.
    """
    clock, loading = Clock(), file.loading
    with files.atomic_folder(output, marker="reduced.json") as folder:
        with clock.step("scene"):
            loaded = open_scene(scene, loading)
        with clock.step("place"):
            viewpoint = _viewpoint.choose(loaded, scene, zones.point)
            radii = zones.choose_radii(loaded, viewpoint)
            r1, r2 = radii.r1, radii.r2
            stand = _viewpoint.stands(loaded, viewpoint, r1, r2)[0]
        view = camera(stand.user, stand.target, 90.0, picture.pixels)
        with clock.step("load curve"):
            curve = nf.load_curve(loaded, center=viewpoint.eye)
        reduction = {"center": viewpoint.eye, "r1": r1, "r2": r2, "face_size": zones.face_size, "backend": backend}
        reduction |= {"samples": picture.samples, "channels": ("color", "range") if with_range else ("color",)}
        settings: dict[str, Any] = {"samples": picture.samples, "channels": ("color",)}
        with clock.step("reduce"):
            methods = Methods.prepare(loaded, reduction)
        frames, reduced = render_all(loaded, methods, view, clock, settings, backend), methods.reduced
        published_r1 = default_radii.PUBLISHED * r2
        if radii.is_by_ground and published_r1 > r1:
            with clock.step("published radii"):
                frames["published"] = reduced.with_r1(published_r1).render(view, **settings)
        with clock.step("files"):
            reduced.save(folder)
            if equirectangular is not None and reduced.env is not None:
                reduced.env.save_equirectangular(folder / f"far-equirectangular.{equirectangular}")
        with clock.step("pictures"):
            pictures = {name: frame.to_image() for name, frame in frames.items()}
            _page.save_pictures(folder, pictures)
            has_plot = _page.save_curve(folder, curve, r2)
        margin = nf.fold_margin(stand.user, center=viewpoint.eye, r1=r1, r2=r2)
        document = formats.header("report", VERSION, origin=loaded.origin.tolist(), color_space="sRGB") | {
            "source": scene,
            **{name: getattr(loading, name) for name in ("up", "on_invalid", "scale", "blend")},
            "parts": {name: value for name in PARTS if (value := getattr(loading, name)) is not None},
            "unit_note": loaded.report.unit_note,
            "notes": list(loaded.report.notes),
            "triangles": int(loaded.triangle_count),
            "triangles_left": int(reduced.stats["drawn"]),
            "map_bytes": int(reduced.stats["map_bytes"]),
            "map_file_bytes": (folder / "far.exr").stat().st_size if reduced.env is not None else 0,
            "pictures": {name: _difference(pictures["truth"], pictures[name]) for name in frames if name != "truth"},
            "seconds": clock.seconds,
            "center": list(viewpoint.eye),
            "user": list(stand.user),
            "target": list(stand.target),
            "r1": r1,
            "r2": r2,
            "radii_reason": radii.reason,
            "face_size": zones.face_size,
            "samples": picture.samples,
            "size": list(picture.pixels),
            "load_curve": curve_points(curve),
            "findings": findings.of_reduction(reduced.stats, r2)
            + findings.of_view(crosses=stand.shows_boundary, fold_margin=margin, r2=r2),
            "files": sorted([*(path.name for path in folder.iterdir()), "report.json", "report.md"]),
        }
        formats.write_json(folder / "report.json", document)
        (folder / "report.md").write_text(_markdown(document), encoding="utf-8")
    if not has_plot:
        typer.echo("nearfar: left load_curve.png out, because matplotlib is not installed", err=True)
    show(document, _rows(document, output), title=scene, as_json=as_json)


DEMO = {"scene": "city", "output": Path("demo")}
"""Defaults of `nearfar demo`, whose other options are those of `nearfar reduce`."""


def _difference(reference: NDArray[np.uint8], test: NDArray[np.uint8]) -> dict[str, float | int]:
    pixels, fraction, rmse = visible_difference(reference, test)
    return {"pixels": pixels, "share": round(fraction, 6), "rmse": round(rmse, 6)}


def _markdown(document: dict[str, Any]) -> str:
    percentage = 100.0 * document["triangles_left"] / max(document["triangles"], 1)
    differences = [
        [name, count(value["pixels"]), f"{100 * value['share']:.2f} %", f"{value['rmse']:.4f}"]
        for name, value in document["pictures"].items()
    ]
    notes = "".join(f"- {note}\n" for note in document["notes"])
    return _page.fill(
        "reduce.md",
        source=document["source"],
        unit_note=f"Note: {document['unit_note']}.\n\n" if document["unit_note"] else "",
        share=f"{percentage:.3g}",
        findings="".join(f"**Note:** {note}.\n\n" for note in document["findings"]),
        differences=_page.table(["picture", "pixels that differ from the truth", "share", "RMSE"], *differences),
        published=_published_text(document),
        load_curve=_page.table(*_page.load_curve_rows(document)),
        plot="![load curve](load_curve.png)\n\n" if "load_curve.png" in document["files"] else "",
        times=_page.table(*_page.time_rows(document)),
        notes=f"\nNot drawn as in the file:\n\n{notes}" if notes else "",
        generator=document["generator"],
        **reduction_texts(document),
    )


def _published_text(document: dict[str, Any]) -> str:
    if "published" not in document["pictures"]:
        return ""
    r1, published_r1 = document["r1"], default_radii.PUBLISHED * document["r2"]
    ratio = f"The last picture has r1 = {published_r1:g} m, the published ratio to r2"
    return f"{ratio}: it shears the ground more than {r1:g} m.\n\n"


def _rows(document: dict[str, Any], output: Path) -> list[tuple[str, str]]:
    return [
        ("triangles", triangles_text(document)),
        ("centre", metres(document["center"])),
        *radii_rows(document),
        ("map", map_text(document)),
        *((f"{name} differs in", f"{100 * p['share']:.2f} % of pixels") for name, p in document["pictures"].items()),
        ("took", f"{sum(document['seconds'].values()):.1f} s"),
        *note_rows(document),
        ("written to", str(output)),
    ]
