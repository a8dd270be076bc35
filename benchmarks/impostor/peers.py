"""Impostors beside other methods for the far part, with equal bytes and equal triangles, by the users' distance."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import folder_or_temporary, save_figure, start, subplots, table
from benchmarks.harness.views import center_for
from benchmarks.impostor import quality
from benchmarks.impostor.methods import maps, measures, meshes, octahedral, orthoviews, place as places
from benchmarks.impostor.methods.measures import Measures
from benchmarks.impostor.methods.place import Method, Place
from nearfar.cli._page import caption

DISTANCES = (0.25, 1.0, 4.0, 8.0)

FIELD = 62.0
"""Horizontal field of view in degrees: with 640 pixels 10.7 pixels a degree in the middle, as in quality.py."""

CELLS = (1.0,)
"""Reach in metres of small view cells."""


def bake(place: Place, reach: float) -> nf.Impostors:
    """Bake impostors; the only place that knows their call."""
    settings = nf.ImpostorSettings(reach=reach, visible=False, **place.baking)
    return quality.bake(place.scene, place.center, place.r2, settings)


def spots(quick: bool, size: tuple[int, int], count: int, only: list[str]) -> Iterator[Place]:
    """Yield the places whose scenes are available, or those with the names in `only`."""
    makers: dict[str, Callable[[], Place | None]] = {
        "city": lambda: _city(quick, size, count),
        "forest": lambda: _forest(size, count),
        "Tokyo core": lambda: _tokyo(size, count),
        "garage": lambda: _garage(size, count),
        "factory": lambda: _factory(size, count),
    }
    for name in only or (["city"] if quick else makers):
        place = makers[name]()
        if place is not None:
            yield place


Size = tuple[int, int]


def _city(quick: bool, size: Size, count: int) -> Place:
    center, _ = nf.datasets.street_view()
    place = Place("city", scenes.city(quick), center, 8.0, 50.0, baking={"face_size": 128} if quick else {})
    return _with_users(place, (1.0, 8.0) if quick else DISTANCES, size, count)


def _forest(size: Size, count: int) -> Place:
    baking: dict[str, Any] = {"error_px": 4.0, "face_size": 512}
    place = Place("forest", nf.datasets.forest(trees=6000), (0.0, 1.7, 0.0), 8.0, 30.0, baking=baking)
    return _with_users(place, DISTANCES, size, count)


def _tokyo(size: Size, count: int) -> Place | None:
    scene = scenes.load("Tokyo core")
    if scene is None:
        return None
    return _with_users(Place("Tokyo core", scene, center_for(scene, 50.0), 8.0, 50.0), DISTANCES, size, count)


def _garage(size: Size, count: int) -> Place | None:
    scene = scenes.load("garage")
    if scene is None:
        return None
    return _with_users(Place("garage", scene, (0.0, 1.5, 0.3), 0.75, 1.5), (0.25, 0.5, 0.75), size, count)


def _factory(size: Size, count: int) -> Place:
    center, _ = nf.datasets.factory_view()
    place = Place("factory", nf.datasets.factory(), center, 2.0, 10.0)
    return _with_users(place, (0.25, 0.5, 1.0, 2.0), size, count)


def _with_users(place: Place, distances: tuple[float, ...], size: Size, count: int) -> Place:
    """Add users, at each distance in another direction, where there is room."""
    fov = nf.Fov.symmetric(FIELD, size[0] / size[1])
    users = {}
    for number, distance in enumerate(distances):
        cameras = quality.ring(place.scene, place.center, distance, size, count + number)
        chosen = cameras[number:] or cameras[-count:]
        if chosen:
            users[distance] = [nf.Camera(user.position, user.orientation, fov=fov, size=size) for user in chosen]
    return replace(place, users=users)


@dataclass(frozen=True, eq=False)
class Result:
    """A method at a place, with the means of its measures by distance."""

    name: str
    method: Method
    seconds: float
    by_distance: dict[float, Measures] = field(default_factory=dict)

    @property
    def mean(self) -> Measures:
        """Mean over all distances."""
        return measures.mean(list(self.by_distance.values()))


def methods(place: Place, folder: Path, quick: bool) -> Iterator[tuple[str, Callable[[], Method]]]:
    """Yield names of methods and functions that make them; the first one is impostors, which set the budgets."""
    ours = bake(place, place.reach)
    if ours.far is None:
        raise ValueError(f"{place.name}: expected a far part that is seen")
    first = _impostors(place, ours)
    count, budget = first.triangles, first.bytes
    yield "impostors", lambda: first
    for reach in CELLS:
        if reach < place.reach and not quick:
            yield f"impostors for a cell of {reach:g} m", lambda reach=reach: _impostors(place, bake(place, reach))  # type: ignore[misc]
    made: dict[maps.Kind, maps.CubeMap] = {}

    def cube_map(kind: maps.Kind) -> Method:
        if not made:
            made.update(maps.cube_maps(place, budget))
        return made[kind]

    for kind in maps.KINDS:
        yield f"cube map, {kind}", lambda kind=kind: cube_map(kind)  # type: ignore[misc]
    yield "map with range, every texel", lambda: maps.reprojected(place, budget)
    size = 96 if quick else 384
    yield (
        "map with range, simplified",
        lambda: meshes.relief_mesh(place, triangles=count, budget=budget, size=size),
    )
    visible = meshes.Visible(place)
    for library in meshes.LIBRARIES:
        yield f"{library}, triangles", lambda library=library: meshes.simplified(place, visible, library, count)  # type: ignore[misc]
        yield (
            f"{library}, bytes",
            lambda library=library: meshes.simplified(place, visible, library, visible.count, budget),  # type: ignore[misc]
        )
    yield "octahedral impostors", lambda: octahedral.octahedral(place, triangles=count, budget=budget)
    yield "orthoviews", lambda: orthoviews.orthoviews(place, budget, folder / f"{place.name}.zarr")


def _impostors(place: Place, baked: nf.Impostors) -> meshes.Mesh:
    stats = baked.stats
    assert baked.far is not None
    width, height = stats["atlas"]
    text = f"error_px = {baked.settings.error_px:.3g}, {len(baked.layers)} centres, texture of {width} × {height}"
    return meshes.Mesh(baked.far, meshes.file_bytes(baked.far, place), text, place.center)


def compare(place: Place, folder: Path, quick: bool, jod: bool) -> tuple[list[Result], dict[str, nf.Frame]]:
    """Make and measure all methods at a place; return also the pictures of the last user."""
    truths = {}
    for users in place.users.values():
        for user in users:
            samples = nf.render(place.scene, places.fine(user), channels=("color", "position"))
            truths[user] = (samples, places.average(samples, user))
    last = max(place.users)
    results, pictures = [], {"truth": truths[place.users[last][-1]][1]}
    for name, make in methods(place, folder, quick):
        since = time.perf_counter()
        method = make()
        result = Result(name, method, time.perf_counter() - since)
        for distance, users in place.users.items():
            rows = []
            for user in users:
                samples, is_far = method.picture(place, user)
                frame = places.average(samples, user)
                truth_samples, truth = truths[user]
                rows.append(measures.measure(truth, frame, (truth_samples, samples), is_far))
                pictures[name] = frame
            result.by_distance[distance] = measures.mean(rows)
        results.append(result)
        curve = ", ".join(f"{distance:g} m {row.psnr:.1f} dB" for distance, row in result.by_distance.items())
        print(f"{place.name}, {name}: {curve}; {method.setting}", flush=True)
    if jod:
        qualities = measures.jods(pictures, folder)
        for result in results:
            result.by_distance[last] = replace(result.by_distance[last], jod=qualities.get(result.name, np.nan))
    return results, pictures


HEADER = (
    "method | triangles {:,} | kB {:,.0f} | PSNR, dB {:.1f} | SSIM {:.3f} | FLIP {:.3f} | JOD {:.2f} |"
    " tear, px {:.2f} | missing, % {:.2f} | made in s {:.0f} | setting"
)


def rows_of(results: list[Result]) -> Iterator[list[Any]]:
    for result in results:
        shown = result.mean
        quality = [shown.psnr, shown.ssim, shown.flip, shown.jod, shown.tear, 100.0 * shown.missing]
        cells = [value if np.isfinite(value) else "–" for value in quality]
        method = result.method
        yield [result.name, method.triangles, method.bytes / 1e3, *cells, result.seconds, method.setting]


def draw_curves(results: dict[str, list[Result]], path: Path) -> None:
    """Plot PSNR and FLIP by the users' distance, a column for each place."""
    figure, grid = subplots(2, len(results), figsize=(3.6 * len(results), 7.2), squeeze=False, sharex="col")
    names = list(dict.fromkeys(result.name for column in results.values() for result in column))
    for axes, (place, column) in zip(grid.T, results.items(), strict=True):
        for result in column:
            style = _style(names, result.name)
            distances = list(result.by_distance)
            axes[0].plot(distances, [row.psnr for row in result.by_distance.values()], label=result.name, **style)
            axes[1].plot(distances, [row.flip for row in result.by_distance.values()], label=result.name, **style)
        axes[0].set_title(place)
        axes[1].set(xscale="log", xlabel="metres from the centre")
        axes[1].set_xticks(distances, [f"{value:g}" for value in distances])
        axes[1].minorticks_off()
        for part in axes:
            part.grid(alpha=0.3)
    grid[0, 0].set_ylabel("PSNR, dB")
    grid[1, 0].set_ylabel("FLIP (0 is equal)")
    handles, labels = grid[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=len(results) + 1, fontsize=8)
    save_figure(figure, path)


def _style(names: list[str], name: str) -> dict[str, Any]:
    if name == "impostors":
        return {"color": "#c8102e", "linewidth": 2.5, "marker": "o", "zorder": 5}
    number = names.index(name)
    line, marker = ("-", "--", ":")[number % 3], "os^vD"[number % 5]
    return {"color": f"C{number % 10}", "linestyle": line, "marker": marker, "markersize": 4}


def draw_pictures(pictures: dict[str, nf.Frame], path: Path, columns: int = 4) -> None:
    """Save the pictures of one user under their names."""
    tiles = [np.asarray(caption(frame.to_image(), name)) for name, frame in pictures.items()]
    blank = np.full_like(tiles[0], 255)
    tiles += [blank] * (-len(tiles) % columns)
    lines = [np.concatenate(tiles[k : k + columns], axis=1) for k in range(0, len(tiles), columns)]
    sheet = Image.fromarray(np.concatenate(lines))
    width = min(sheet.width, 1600)
    sheet = sheet.resize((width, sheet.height * width // sheet.width), Image.Resampling.LANCZOS)
    sheet.save(path, quality=82, optimize=True)


def versions() -> str:
    """Return the versions of the programs that are compared, or that measure."""
    found = []
    for name in ("fast-simplification", "flip-evaluator", "cvvdp"):
        try:
            found.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            found.append(f"{name} is not installed")
    return ", ".join(found)


def main() -> None:
    options = start(
        __doc__,
        "--quick",
        "--plots",
        users=(1, "users at each distance"),
        only={"nargs": "*", "default": [], "help": "names of places; by default all"},
    )
    size = (160, 90) if options.quick else (640, 360)
    print(versions(), flush=True)
    found: dict[str, list[Result]] = {}
    with folder_or_temporary() as folder:
        for place in spots(options.quick, size, options.users, options.only):
            found[place.name], pictures = compare(place, folder, options.quick, jod=not options.quick)
            where = ", ".join(f"{distance:g}" for distance in place.users)
            title = f"{place.name}: reach {place.reach:g} m, r2 = {place.r2:g} m, means of users at {where} m"
            print(table(title, HEADER, rows_of(found[place.name])), flush=True)
            if options.plots is not None:
                draw_pictures(pictures, options.plots / f"impostor_peers_{place.name.split()[0]}.jpg")
                draw_curves(found, options.plots / "impostor_peers.png")


if __name__ == "__main__":
    main()
