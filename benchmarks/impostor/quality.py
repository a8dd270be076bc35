"""Image quality of impostors against the truth, beside the conventional map, for users at the end of their region."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.views import GOLDEN, Point, center_for, views
from nearfar._reduce.impostors import reduce_to_impostors
from nearfar.cli._page import caption

SAMPLES = 4
RADIANS_PER_PIXEL = np.radians(1.0 / 20.0)
CITY, R2 = "procedural city", 50.0


@dataclass(frozen=True)
class Case:
    """A scene, where its impostors are baked, and users."""

    name: str
    scene: nf.Scene
    center: Point
    users: list[nf.Camera]
    r2: float = R2
    settings: dict[str, Any] = field(default_factory=dict)
    """Further arguments of `nf.reduce`."""
    far_triangles: int | None = None
    """Budget of triangles of the far part alone."""

    @property
    def label(self) -> str:
        """Name and settings."""
        return ", ".join(
            [
                self.name,
                f"r2 = {self.r2:g}",
                *([] if self.far_triangles is None else ["budget"]),
                *(f"{key} = {value:g}" for key, value in self.settings.items()),
            ]
        )


def ring(scene: nf.Scene, center: Point, distance: float, size: tuple[int, int], count: int) -> list[nf.Camera]:
    """Choose users at one distance all around the centre, who look at right angles to the line from the centre.

    Places behind a surface, seen from the centre, are skipped; at most a hundred are tried.
    """
    turns = 2.0 * np.pi * GOLDEN * np.arange(100)
    directions = np.column_stack([np.cos(turns), np.zeros(100), np.sin(turns)])
    free = nf.cast_rays(scene, np.tile(center, (100, 1)), directions).t_hit > 1.2 * distance
    cameras = []
    for k in np.flatnonzero(free)[:count].tolist():
        user = np.add(center, distance * directions[k])
        sideways = np.array([-np.sin(turns[k]), -0.02, np.cos(turns[k])]) * (1 if k % 2 else -1)
        fov = nf.Fov.symmetric(90, size[0] / size[1])
        cameras.append(nf.Camera.look_at(user, user + sideways, fov=fov, size=size))
    return cameras


def cases(size: tuple[int, int], count: int, quick: bool) -> Iterator[Case]:
    """Yield the cases whose scenes are available."""
    city, (center, _) = scenes.city(quick), nf.datasets.street_view()
    face: dict[str, Any] = {"face_size": 128} if quick else {}
    walkers = list(views(nf.reduce(city, center=center, r1=30.0, r2=R2, face_size=64), size, count))
    yield Case(CITY, city, center, walkers, settings=face)
    yield Case(CITY, city, center, walkers, settings=face, far_triangles=300 if quick else 13000)
    for reach in (4.0, 1.0):
        yield Case(CITY, city, center, ring(city, center, reach, size, count), settings={"reach": reach, **face})
    if quick:
        return
    yield Case(CITY, city, center, ring(city, center, 8.0, size, count), settings={"reach": 8.0, "face_size": 2048})
    for name, tokyo in scenes.present("Tokyo core"):
        middle = center_for(tokyo, R2)
        yield Case(name, tokyo, middle, ring(tokyo, middle, 8.0, size, count))
    for name, garage in scenes.present("garage"):
        middle = (0.0, 1.5, 0.3)
        yield Case(name, garage, middle, ring(garage, middle, 0.75, size, count), 1.5, {"reach": 0.75})
    forest, middle = nf.datasets.forest(trees=6000), (0.0, 1.7, 0.0)
    settings = {"reach": 4.0, "error_px": 4.0, "face_size": 512}
    yield Case("forest", forest, middle, ring(forest, middle, 4.0, size, count), 30.0, settings)


def misplaced(truth: nf.Frame, frame: nf.Frame, reach: float) -> tuple[float, float]:
    """Share of pixels, in percent, that miss a surface, and of those that show another depth.

    The depth is another one if the inverse of the range is off by more than 2 px/(f R): for f = 1,146 pixels per
    radian, the difference that moves a point by 2 pixels when a user walks the radius R of the region.
    """
    expected, found = (1.0 / shown.require("range").astype(np.float64) for shown in (truth, frame))
    is_missing = (expected > 0.0) & (found == 0.0)
    is_off = ~is_missing & (np.abs(expected - found) > 2.0 * RADIANS_PER_PIXEL / reach)
    return 100.0 * float(is_missing.mean()), 100.0 * float(is_off.mean())


def bake(scene: nf.Scene, center: Point, r2: float, settings: nf.ImpostorSettings) -> nf.Impostors:
    """Bake quads, also where `nf.reduce` keeps the far triangles that users see, because they are fewer."""
    return reduce_to_impostors(scene, center, r2, settings, may_keep=False)


def measure_kept(case: Case, near: int) -> list[Any] | None:
    """Return a row for a case whose far triangles that users see stay geometry; None for others."""
    settings = nf.ImpostorSettings(**case.settings)
    kept = nf.reduce(case.scene, center=case.center, r2=case.r2, far="impostors", settings=settings)
    if kept.far is not None:
        return None
    quality = []
    for camera in case.users:
        truth, frame = (
            nf.render(source, camera, samples=SAMPLES, channels=("color", "range")) for source in (case.scene, kept)
        )
        quality.append([*similarity(truth, frame), *misplaced(truth, frame, kept.reach)])
    worst = float(np.min(quality, axis=0)[0])
    psnr, ssim, missing, off = np.mean(quality, axis=0).tolist()
    return [case.label, kept.triangle_count - near, psnr, ssim, worst, missing, off]


def measure(case: Case, folder: Path) -> list[Any]:
    """Bake, save and draw a case; return a row of the table."""
    since = time.perf_counter()
    settings = nf.ImpostorSettings(**case.settings)
    impostors = bake(case.scene, case.center, case.r2, settings)
    if case.far_triangles is not None:
        settings = replace(settings, triangles=impostors.near.triangle_count + case.far_triangles)
        impostors = bake(case.scene, case.center, case.r2, settings)
    seconds = time.perf_counter() - since
    size = case.settings.get("face_size", 1024)
    mapped = nf.reduce(case.scene, center=case.center, r1=0.5 * case.r2, r2=case.r2, face_size=size, morph="none")
    quality = []
    for camera in case.users:
        truth, frame = (
            nf.render(source, camera, samples=SAMPLES, channels=("color", "range"))
            for source in (case.scene, impostors)
        )
        map_frame = nf.render(mapped, camera, samples=SAMPLES, channels=("color",))
        places = misplaced(truth, frame, impostors.reach)
        quality.append([*similarity(truth, frame), *places, *similarity(truth, map_frame)])
    path = folder / "far.glb"
    impostors.save_glb(path, part="far")
    psnr, ssim, missing, off, map_psnr, map_ssim = np.mean(quality, axis=0).tolist()
    worst = float(np.min(quality, axis=0)[0])
    stats = impostors.stats
    counts = [len(case.users), stats["near_triangles"], stats["triangles"], stats["error_px"]]
    return [
        case.label,
        *counts,
        path.stat().st_size / 1e3,
        psnr,
        ssim,
        worst,
        missing,
        off,
        map_psnr,
        map_ssim,
        seconds,
    ]


HEADER = (
    "scene | users | near triangles {:,} | far triangles {:,} | error, px {:.3g} | kB {:,.0f} | PSNR, dB {:.1f} |"
    " SSIM {:.3f} | worst PSNR, dB {:.1f} | missing, % {:.3f} | off, % {:.2f} | map's PSNR, dB {:.1f} |"
    " map's SSIM {:.3f} | bake, s {:.1f}"
)


KEPT = (
    "scene | far triangles {:,} | PSNR, dB {:.1f} | SSIM {:.3f} | worst PSNR, dB {:.1f} | missing, % {:.3f} |"
    " off, % {:.2f}"
)


def draw(path: Path, size: tuple[int, int], quick: bool) -> None:
    """Draw the city for one user 7 m beside the centre: truth, both near-far methods, and impostors, each enlarged."""
    city, (center, _) = scenes.city(quick), nf.datasets.street_view()
    user = np.add(center, (-7.0, 0.0, 0.0))
    camera = nf.Camera.look_at(
        user, np.add(user, (0.0, 6.0, -40.0)), fov=nf.Fov.symmetric(90, size[0] / size[1]), size=size
    )
    reduced = nf.reduce(city, center=center, r1=30.0, r2=R2)
    impostors = nf.reduce(city, far="impostors", center=center)
    sources: dict[str, tuple[nf.Renderable, int]] = {
        "truth": (city, city.triangle_count),
        "conventional": (reduced.with_morph("none"), reduced.triangle_count),
        "continuous": (reduced, reduced.triangle_count),
        "impostors": (impostors, impostors.scene.triangle_count),
    }
    columns: list[Any] = []
    truth: nf.Frame | None = None
    for name, (source, count) in sources.items():
        frame = nf.render(source, camera, samples=8, channels=("color",))
        truth = truth or frame
        quality = "" if frame is truth else f", {nf.psnr(truth, frame):.1f} dB"
        columns.append(_column(frame.to_image(), f"{name}: {count:,} triangles{quality}"))
    Image.fromarray(np.concatenate(columns, axis=1)).save(path, quality=86, optimize=True)


def _column(picture: Any, text: str, width: int = 480) -> Any:
    """Scale a picture down under its caption, above an enlarged part, with a white edge."""
    whole = Image.fromarray(picture)
    small = whole.resize((width, width * whole.height // whole.width), Image.Resampling.LANCZOS)
    left, top, right, bottom = (
        share * side for share, side in zip((0.56, 0.22, 0.86, 0.72), whole.size * 2, strict=True)
    )
    tall = round(width * (bottom - top) / (right - left))
    large = whole.resize((width, tall), Image.Resampling.LANCZOS, box=(left, top, right, bottom))
    edge = np.full((6, width, 3), 255, np.uint8)
    column = np.concatenate([caption(np.asarray(small), text), edge, np.asarray(large)])
    return np.concatenate([column, np.full((len(column), 6, 3), 255, np.uint8)], axis=1)


def main() -> None:
    arguments = start(__doc__, "--quick", "--plots", users=(10, "users of each row"))
    size = (240, 136) if arguments.quick else (960, 540)
    rows, kept = list[list[Any]](), list[list[Any]]()
    with folder_or_temporary() as folder:
        for case in cases(size, arguments.users, arguments.quick):
            rows.append(measure(case, folder))
            print(*rows[-1], flush=True)
            if case.name != CITY and (row := measure_kept(case, rows[-1][2])) is not None:
                kept.append(row)
    print(table(f"Impostors against the truth, {size[0]} × {size[1]}, {SAMPLES} samples", HEADER, rows), flush=True)
    print(table("Far triangles that users see, instead of quads", KEPT, kept), flush=True)
    if arguments.plots is not None:
        draw(arguments.plots / "impostor.jpg", (480, 300) if arguments.quick else (1440, 900), arguments.quick)


if __name__ == "__main__":
    main()
