"""Frames per second of the page and of whole scenes in plain three.js, after loading and while a bundle loads.

The city and the factory at two centres each. After loading, a level head turns once, a metre (city) or half a metre
(factory) beside the centre; measured are frames as displayed by the browser, at most 60 per second, and frames that are
drawn and waited for, but not displayed. Whole scenes are one GLB without textures, seen by the user at the first
centre: with a node for each copy of a mesh, or with copies as separate meshes, as in scenes without instances. Loading
is measured over 50 Mbit/s and 20 ms, by each strategy. Chromium draws in software unless NEARFAR_BROWSER_DRAWING has
other flags, such as "--use-gl=angle --use-angle=gl-egl --ignore-gpu-blocklist"; the renderer is printed. Each turn has
a separate browser, and pictures are taken after turns: check that they are complete.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.loads import Network, network
from benchmarks.harness.report import folder_or_temporary, make_folder, start, table
from benchmarks.stream._loaded import Bundle, plan, show
from benchmarks.stream._near import Place, one_file
from benchmarks.stream.real import LINK, STRATEGIES, all_places
from benchmarks.view._turns import measure_turn, open_bundle, open_full_scene, photo, renderer
from benchmarks.view.load import ANGLE, write_script
from nearfar.stream._strategies import Strategy
from tests.support.browser import started

SCREEN = (1920, 1080)
EYES = (3664, 1920)
"""Size of one picture that replaces those of a headset's two eyes of 1832 × 1920, with as many pixels."""
COPIES = {"whole, instances": True, "whole, copies": False}
LOCAL = Network(nf.stream.Link(1000), None)
"""No link between server and page."""

WINDOW = 0.5
"""Length of the window of a rate, seconds."""

# The head turns by 15 degrees per second. A frame is its start time and the ring shown, -1 for none.
WATCH = """(() => {
  const frames = [];
  window.loadFrames = frames;
  const watch = (now) => {
    const { nearfar } = window;
    if (nearfar) {
      frames.push([now, nearfar.viewer.facts.shown?.ring ?? -1]);
      nearfar.setPose({ ...nearfar.pose, yaw: ((now - frames[0][0]) / 1000) * Math.PI / 12, pitch: 0 });
    }
    requestAnimationFrame(watch);
  };
  requestAnimationFrame(watch);
})()"""


@dataclass(frozen=True)
class Loading:
    """A load, from the first frame until the last ring is shown."""

    seconds: float
    picture: float
    """Seconds until the first picture."""
    rates: list[float]
    """Frames per second in each window."""
    longest_ms: float
    """Duration of the longest frame."""


def rates(begins: Sequence[float]) -> list[float]:
    """Frames per second in windows, from the start times of frames, seconds; the last window is complete."""
    times = np.array(begins) - begins[0]
    counts = np.bincount((times / WINDOW).astype(int))[: max(int(times[-1] / WINDOW), 1)]
    return [*map(float, counts / WINDOW)]


def loading(connection: Network, chromium: Any, url: str, bundle: Bundle, strategy: Strategy, size: Any) -> Loading:
    """Open a bundle's page by a strategy, and watch until everything is shown."""
    last = len(plan(bundle, strategy).radii)
    with connection.page(chromium, size) as page:
        page.add_init_script(WATCH)
        show(page, url, strategy, last)
        frames = page.evaluate("() => window.loadFrames")
    times = [now / 1e3 for now, _ in frames]
    first = next(now / 1e3 for now, ring in frames if ring >= 0)
    # The last frame may be the one that shows the last ring.
    end = next((index for index, (_, ring) in enumerate(frames) if ring >= last), len(frames) - 1)
    times = times[: end + 1]
    return Loading(times[-1] - times[0], first - times[0], rates(times), float(np.diff(times).max(initial=0.0)) * 1e3)


def place_bundle(parent: Path, place: Place) -> nf.stream.Bundle:
    """Open a place's bundle in a folder; it is exported if it is missing."""
    folder = parent / _name(place.name)
    if (folder / "manifest.json").exists():
        return nf.stream.open(folder)
    return nf.stream.export(place.make(), folder, center=place.center, by_footprint=True)


def full_scene(parent: Path, place: Place, *, instanced: bool) -> Path:
    """Return a folder with the page of a full scene; missing files are written."""
    folder = parent / _name(f"{place.name} full {'instances' if instanced else 'copies'}")
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / "scene.glb").exists():
        (folder / "scene.glb").write_bytes(one_file(place.make(instanced=instanced), named=True))
    if not (folder / "full.js").exists():
        write_script("_full.mjs", folder / "full.js")
    (folder / "view.json").write_text(json.dumps({"eye": eye(place), "angle": ANGLE}))
    (folder / "index.html").write_text('<body style="margin:0"><script type="module" src="full.js"></script>')
    return folder


def _name(text: str) -> str:
    return text.replace(",", "").replace(" ", "-")


def eye(place: Place) -> list[float]:
    return [*map(float, np.add(place.center, place.users[0]))]


class Run:
    """Scenes, sizes and times of a measurement."""

    def __init__(self, folder: Path, pictures: Path | None, seconds: float, *, quick: bool) -> None:
        self._folder, self._pictures, self._seconds = folder, pictures, seconds
        self._sizes = [(width // 4, height // 4) if quick else (width, height) for width, height in (SCREEN, EYES)]
        self.renderer = ""
        """Name of the renderer, as reported by WebGL."""
        self.turns, self.loads = list[list[object]](), list[list[object]]()
        """Rows of the tables."""

    def turn(self, place: str, drawn: str, page: Any) -> None:
        """Turn the head in a page."""
        width, height = page.viewport_size["width"], page.viewport_size["height"]
        if not self.renderer:
            self.renderer = renderer(page)
            print(self.renderer, flush=True)
        turn = measure_turn(page, self._seconds)
        shown, waited = rate(turn.shown), rate(turn.waited)
        self.turns.append([place, drawn, f"{width} × {height}", shown, waited, turn.script, turn.triangles / 1e6])
        if self._pictures:
            photo(page, self._pictures / f"{_name(f'{place} {drawn} {width}')}.jpg")
        print(place, drawn, width, shown, flush=True)

    def reduced(self, place: Place) -> None:
        """Turn in the page of a bundle."""
        with LOCAL.serve_bundle(Path(place_bundle(self._folder, place)._reader.location)) as url:
            for size in self._sizes:
                with started() as chromium, open_bundle(chromium, url, size, eye(place)) as page:
                    self.turn(place.name, "nearfar", page)

    def full(self, place: Place) -> None:
        """Turn in full scenes."""
        for drawn, instanced in COPIES.items():
            with LOCAL.serve_files(full_scene(self._folder, place, instanced=instanced)) as url:
                for size in self._sizes:
                    with started() as chromium, open_full_scene(chromium, url, size) as page:
                        self.turn(place.name, drawn, page)

    def loading(self, place: Place) -> None:
        """Load a bundle by each strategy."""
        bundle = place_bundle(self._folder, place)
        folder = Path(bundle._reader.location)
        with network(LINK) as connection, connection.serve_bundle(folder) as url, connection.browser(url) as chromium:
            print(place.name, connection.name)
            load = partial(loading, connection, chromium, url, bundle, size=self._sizes[0])
            # The first load of a browser also compiles its shaders.
            load("clovrd")
            for strategy in STRATEGIES:
                each = load(strategy)
                mean, least = rate(each.rates), min(each.rates)
                self.loads.append([place.name, strategy, each.picture, each.seconds, mean, least, each.longest_ms])
                print(place.name, strategy, mean, flush=True)


def rate(values: Sequence[float]) -> str:
    """Format mean and standard deviation."""
    return f"{np.mean(values):.1f} ± {np.std(values):.1f}"


def main() -> None:
    options = start(
        __doc__,
        "--quick",
        place=("", "places whose names have this in them, such as factory"),
        parts={"default": ["reduced", "whole", "loading"], "nargs": "+", "choices": ("reduced", "whole", "loading")},
        seconds=(6.0, "of a turn; half of it where frames are waited for"),
        folder=(Path, "folder that keeps bundles and scenes for the next run"),
        pictures=(make_folder, "folder for pictures of each page"),
    )
    with folder_or_temporary(options.folder) as folder:
        run = Run(folder, options.pictures, options.seconds, quick=options.quick)
        scenes = set[str]()
        for place in all_places(options.quick):
            scene = place.name.partition(",")[0]
            is_first = scene not in scenes
            scenes.add(scene)
            if options.place not in place.name:
                continue
            if "reduced" in options.parts:
                run.reduced(place)
            if "whole" in options.parts and is_first:
                run.full(place)
            if "loading" in options.parts:
                run.loading(place)
    if run.turns:
        header = " |  | pixels | shown | drawn and waited for | ms of script {:.2f} | M triangles drawn {:.2f}"
        print(table("Frames a second after loading, mean ± sd of a turn's sectors", header, run.turns))
    if run.loads:
        header = " |  | first picture, s {:.2f} | all, s {:.2f} | frames a second | least in half a second {:.0f}"
        print(table("Frames while loading", header + " | longest frame, ms {:.0f}", run.loads))


if __name__ == "__main__":
    main()
