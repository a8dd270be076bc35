"""`nearfar reduce`: reduces a scene to a folder for thin clients and writes a report; `nearfar demo`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
import typer
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import check, files, formats
from nearfar._reduce import default_radii, findings
from nearfar.cli import _options as options, _page, _users, _viewpoint
from nearfar.cli._groups import Options, choice, flag, option
from nearfar.cli._methods import Methods, render_all
from nearfar.cli._output import (
    Clock,
    bytes_text,
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

_POSITIONS = "relative to the centre in light.glb and far.glb, world coordinates in near.glb"


@dataclass(frozen=True, kw_only=True)
class FarOptions(Options):
    """Far part: textured quads, their region and budgets, or the published map."""

    far: Literal["impostors", "map"] = choice(
        "impostors", "Far part: textured quads, which keep their parallax, or the map of the published method alone."
    )
    reach: float | None = option(
        None, "METRES", "Radius around the centre within which users see quads right. By default 8, at most half of r2."
    )
    error_px: float = option(2.0, "PIXELS", "Greatest error of quads, in pixels of 1/20 degree.")
    budget_triangles: int | None = option(None, "N", "Greatest number of triangles of near and far part together.")
    budget_bytes: int | None = option(None, "N", "Greatest size of light.glb.")
    keep_hidden: bool = flag("--keep-hidden", "Keep near triangles that no user within reach sees.")
    textures: Literal["webp", "png"] = choice("webp", "Images of light.glb and far.glb; not all programs read WebP.")
    geometry: Literal["meshopt", "plain"] = choice(
        "meshopt", "Geometry of light.glb and far.glb; not all programs read meshopt."
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("budget_triangles", "budget_bytes"):
            if (value := getattr(self, name)) is not None:
                check.integer(name, value, 1, 2**62)
        if self.far == "map":
            for name in self.given_options():
                if name != "far":
                    raise ValueError(f"{name}: expected none with --far map")

    @property
    def keywords(self) -> dict[str, Any]:
        """Fields of `ImpostorSettings`."""
        budgets = {"triangles": self.budget_triangles, "bytes": self.budget_bytes}
        return {"reach": self.reach, "error_px": self.error_px, **budgets, "visible": not self.keep_hidden}


def reduce(
    *,
    scene: options.Input,
    output: options.Folder,
    zones: options.MapOptions,
    far: FarOptions,
    with_range: options.WithRange = False,
    equirectangular: Literal["exr", "png"] | None = choice(
        None, "Also write the map as one picture, far-equirectangular.exr or .png."
    ),
    picture: options.PictureOptions,
    backend: options.Backend = None,
    scene_options: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """Reduce a scene to light.glb, which engines load, and write a report with pictures.

    The pictures show the truth, the conventional and the continuous method, and the quads of light.glb, for a user
    beside the centre. The folder also has near.glb, far.glb, far.exr (the published map) and reduced.json; with --far
    map it has no quads. `nearfar render`, `nearfar compare`, `nearfar.Impostors.load` and `nearfar.ReducedScene.load`
    read it.
    """
    clock, loading = Clock(), scene_options.loading
    if far.far == "impostors" and zones.r1 is not None:
        raise ValueError("r1: expected none with impostors, which are not morphed; --far map takes it")
    with files.atomic_folder(output, marker="reduced.json") as folder:
        with clock.step("scene"):
            loaded = open_scene(scene, loading)
        with clock.step("place"):
            viewpoint = _viewpoint.choose(loaded, scene, zones.point)
            radii = zones.choose_radii(loaded, viewpoint)
        impostors = None
        if far.far == "impostors":
            with clock.step("impostors"):
                settings = nf.ImpostorSettings(**far.keywords, face_size=max(zones.face_size, 64))
                impostors = _bake(loaded, viewpoint.eye, zones.r2, settings)
            if impostors.r2 != radii.r2:
                radii = default_radii.choose(loaded, viewpoint, None, impostors.r2)
        with clock.step("user"):
            r1, r2 = radii.r1, radii.r2
            distance = default_radii.user_distance(r1, r2)
            within = distance if impostors is None else min(distance, impostors.reach)
            stand = _viewpoint.stands(loaded, viewpoint, r1, r2, distance=within)[0]
        view = camera(stand.user, stand.target, 90.0, picture.pixels)
        with clock.step("load curve"):
            curve = nf.load_curve(loaded, center=viewpoint.eye)
        reduction = {"center": viewpoint.eye, "r1": r1, "r2": r2, "face_size": zones.face_size, "backend": backend}
        reduction |= {"samples": picture.samples, "channels": ("color", "range") if with_range else ("color",)}
        drawing: dict[str, Any] = {"samples": picture.samples, "channels": ("color",)}
        with clock.step("reduce"):
            methods = Methods.prepare(loaded, reduction)
        frames, reduced = render_all(loaded, methods, view, clock, drawing, backend), methods.reduced
        sources: dict[str, nf.Renderable] = {"conventional": reduced.with_morph("none"), "continuous": reduced}
        if impostors is not None:
            sources["impostors"] = impostors
            with clock.step("picture of impostors"):
                frames["impostors"] = nf.render(impostors, view, backend=backend, **drawing)
        published_r1 = default_radii.PUBLISHED * r2
        if radii.is_by_ground and published_r1 > r1:
            with clock.step("published radii"):
                frames["published"] = reduced.with_r1(published_r1).render(view, **drawing)
        with clock.step("files"):
            lost: tuple[str, ...] = ()
            if impostors is None:
                reduced.save(folder)
            else:
                lost = impostors.save(folder, published=reduced, textures=far.textures, geometry=far.geometry)
            if equirectangular is not None and reduced.env is not None:
                reduced.env.save_equirectangular(folder / f"far-equirectangular.{equirectangular}")
        with clock.step("pictures"):
            pictures = {name: frame.to_image() for name, frame in frames.items()}
            shown = ("truth", "conventional", "continuous", "impostors", "published")
            _page.save_pictures(folder, {name: pictures[name] for name in shown if name in pictures})
            has_plot = _page.save_curve(folder, curve, r2)
        with clock.step("users"):
            reach = default_radii.user_distance(r1, r2) if impostors is None else impostors.reach
            users = _users.choose_users(loaded, viewpoint.eye, reach, picture.pixels)
            users_document = _users.measure(loaded, sources, users, picture.samples)
            _users.plot(folder / "users.png", users_document)
        margin = nf.fold_margin(stand.user, center=viewpoint.eye, r1=r1, r2=r2)
        document = formats.header("report", VERSION, origin=loaded.origin.tolist(), color_space="sRGB") | {
            "source": scene,
            **{name: getattr(loading, name) for name in ("up", "on_invalid", "scale", "blend")},
            "parts": {name: value for name in PARTS if (value := getattr(loading, name)) is not None},
            "unit_note": loaded.report.unit_note,
            "notes": [*loaded.report.notes, *(f"light.glb: {note}" for note in lost)],
            "triangles": int(loaded.triangle_count),
            "triangles_left": int(reduced.stats["drawn"]) if impostors is None else impostors.triangle_count,
            "map_bytes": int(reduced.stats["map_bytes"]),
            "map_file_bytes": (folder / "far.exr").stat().st_size if reduced.env is not None else 0,
            "pictures": {name: _difference(pictures["truth"], pictures[name]) for name in frames if name != "truth"},
            "users": users_document,
            "sizes": _sizes(folder, reduced, impostors),
            "impostors": None if impostors is None else {"reason": impostors.reason, **impostors.stats},
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
            "findings": (
                findings.of_reduction(reduced.stats, r2)
                if impostors is None
                else _notes(impostors, _missing(users_document))
            )
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


def _bake(scene: nf.Scene, center: options.Point, r2: float | None, settings: nf.ImpostorSettings) -> nf.Impostors:
    """Bake impostors; errors of budgets name the option."""
    try:
        return nf.reduce(scene, center=center, r2=r2, far="impostors", settings=settings)
    except ValueError as error:
        if str(error).startswith(("triangles:", "bytes:")):
            raise ValueError(f"budget_{error}") from None
        raise


def _notes(impostors: nf.Impostors, missing: float) -> list[str]:
    """Return sentences about impostors without a near or far part, and about quads that were dropped for a budget.

    `missing` is the share of the users' pixels that show nothing where the truth shows a surface.
    """
    notes = [impostors.reason] if impostors.far is None else []
    if not impostors.near.triangle_count:
        notes.append(f"nothing is near: no triangle lies within r2 = {impostors.r2:g} m; another centre may show more")
    if count_dropped := impostors.stats["dropped_quads"]:
        holes = f"which leaves holes of {100.0 * missing:.2g} % of the users' pixels; a lower r2 leaves more for quads"
        notes.append(f"{count_dropped:,} quads were dropped for the budget, {holes}")
    return notes


def _missing(users: dict[str, Any]) -> float:
    """Return the mean share of missing pixels of impostors for all users."""
    return float(np.mean(users["methods"]["impostors"]["missing"] or [0.0]))


def _sizes(folder: Path, reduced: nf.ReducedScene, impostors: nf.Impostors | None) -> dict[str, dict[str, int]]:
    """Return triangles and bytes of files of each method."""
    size = {path.name: path.stat().st_size for path in folder.iterdir()}
    both = {"triangles": int(reduced.stats["drawn"]), "bytes": size["near.glb"] + size.get("far.exr", 0)}
    sizes = {"conventional": both, "continuous": both}
    if impostors is not None:
        sizes["impostors"] = {"triangles": impostors.triangle_count, "bytes": size.get("light.glb", 0)}
    return sizes


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
    equal = sum(_users.equal_views(document))
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
        **reduction_texts(document) | {"far": _far_text(document)},
        equal=f" ({equal} of them, for whom a picture equals the truth, are left out of the means)" if equal else "",
        users=_page.table(*rows) + "\n\n" if (rows := _users.rows(document)) else "",
        users_plot="![PSNR against the user's distance](users.png)\n\n" if "users.png" in document["files"] else "",
    )


def _far_text(document: dict[str, Any]) -> str:
    """Describe the far part of a reduction."""
    impostors = document["impostors"]
    if impostors is None:
        return f"a cube map of 6 × {document['face_size']}² texels ({map_text(document)})"
    size = bytes_text(document["sizes"]["impostors"]["bytes"])
    if not impostors["quads"]:
        return f"no quads, only geometry (light.glb: {size})"
    quads = f"{impostors['quads']:,} textured quads of {impostors['triangles']:,} triangles"
    return f"{quads} (light.glb: {size})"


def _published_text(document: dict[str, Any]) -> str:
    if "published" not in document["pictures"]:
        return ""
    r1, published_r1 = document["r1"], default_radii.PUBLISHED * document["r2"]
    picture = f"The last picture of side_by_side.png has r1 = {published_r1:g} m, the published ratio to r2"
    return f"{picture}. It shears the ground more than the one with r1 = {r1:g} m.\n\n"


def _rows(document: dict[str, Any], output: Path) -> list[tuple[str, str]]:
    return [
        ("triangles", triangles_text(document)),
        ("centre", metres(document["center"])),
        *radii_rows(document),
        ("far part", _far_text(document)),
        *([("positions", _POSITIONS)] if document["impostors"] else []),
        *((line[0], f"PSNR {line[1]}, worst {line[2]}; SSIM {line[3]}") for line in _users.rows(document)[1:]),
        ("took", f"{sum(document['seconds'].values()):.1f} s"),
        *note_rows(document),
        ("written to", str(output)),
    ]
