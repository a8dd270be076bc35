"""Frames per second of the page and of whole scenes in plain three.js, after loading and while a bundle loads.

The city and the factory at two centres each. After loading, a head turns once, level, a metre beside the centre (the
city) or half a metre (the factory): frames as displayed by the browser, at most 60 per second, and frames that are
drawn, waited for and not displayed. Whole scenes are one GLB without textures, from the user's place at the first
centre: with a node for each copy of a mesh, and with copies as separate meshes, as in scenes without instances. While
loading, bundles come over 50 Mbit/s and 20 ms, by each strategy. Chromium draws in software unless
NEARFAR_BROWSER_DRAWING has other flags, such as "--use-gl=angle --use-angle=gl-egl --ignore-gpu-blocklist"; a line
names the renderer. Each turn has a separate browser, and pictures are taken after turns: check that they are complete.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.loads import Network, network
from benchmarks.harness.report import folder_or_temporary, make_folder, start, table
from benchmarks.stream._near import Place
from benchmarks.stream.real import LINK, STRATEGIES, all_places
from benchmarks.view._loading import Loading, loading
from benchmarks.view._turns import Turn, measure_turn, of_page, of_whole, photo, renderer
from benchmarks.view.load import ANGLE, one_glb, write_script
from nearfar.stream._strategies import Strategy
from tests.support.browser import started

SCREEN = (1920, 1080)
EYES = (3664, 1920)
"""Size of one picture that replaces those of a headset's two eyes of 1832 × 1920, with as many pixels."""
COPIES = {"whole, instances": True, "whole, copies": False}
LOCAL = Network(nf.stream.Link(1000), None)
"""No link between server and page."""


@dataclass(frozen=True)
class Seen:
    """A turn in a scene."""

    place: str
    drawn: str
    size: str
    turn: Turn


@dataclass(frozen=True)
class Load:
    """A load at a place."""

    place: str
    strategy: Strategy
    load: Loading


class Files:
    """Bundles and whole scenes in a folder; made if they are missing."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def bundle(self, place: Place) -> nf.stream.Bundle:
        """Return a place's bundle."""
        folder = self._folder / _name(place.name)
        if (folder / "manifest.json").exists():
            return nf.stream.open(folder)
        return nf.stream.export(place.make(), folder, center=place.center, by_footprint=True)

    def whole(self, place: Place, *, instanced: bool) -> Path:
        """Return a folder with the page of a whole scene."""
        folder = self._folder / _name(f"{place.name} whole {'instances' if instanced else 'copies'}")
        folder.mkdir(parents=True, exist_ok=True)
        if not (folder / "scene.glb").exists():
            (folder / "scene.glb").write_bytes(one_glb(place.make(instanced=instanced)))
        if not (folder / "whole.js").exists():
            write_script("_whole.mjs", folder / "whole.js")
        (folder / "view.json").write_text(json.dumps({"eye": eye(place), "angle": ANGLE}))
        (folder / "index.html").write_text('<body style="margin:0"><script type="module" src="whole.js"></script>')
        return folder


def _name(text: str) -> str:
    return text.replace(",", "").replace(" ", "-")


def eye(place: Place) -> list[float]:
    """Position of the user."""
    return [*map(float, np.add(place.center, place.users[0]))]


class Run:
    """Scenes, sizes and times of a measurement."""

    def __init__(self, files: Files, pictures: Path | None, seconds: float, *, quick: bool) -> None:
        self.files, self._pictures, self._seconds = files, pictures, seconds
        self._sizes = [(width // 4, height // 4) if quick else (width, height) for width, height in (SCREEN, EYES)]
        self.renderer = ""
        """Name of the renderer, as reported by WebGL."""
        self.seen, self.loads = list[Seen](), list[Load]()

    def figures(self) -> dict[str, Any]:
        """Return all results, for a file."""
        return {
            "renderer": self.renderer,
            "turns": [asdict(one) for one in self.seen],
            "loads": [asdict(one) for one in self.loads],
        }

    def turn(self, place: str, drawn: str, page: Any) -> None:
        """Turn the head in a page."""
        width, height = page.viewport_size["width"], page.viewport_size["height"]
        if not self.renderer:
            self.renderer = renderer(page)
            print(self.renderer, flush=True)
        self.seen.append(Seen(place, drawn, f"{width} × {height}", measure_turn(page, self._seconds)))
        if self._pictures:
            photo(page, self._pictures / f"{_name(f'{place} {drawn} {width}')}.jpg")
        print(place, drawn, width, rate(self.seen[-1].turn.shown), flush=True)

    def reduced(self, place: Place) -> None:
        """Turn in the page of a bundle."""
        bundle = self.files.bundle(place)
        with LOCAL.serve_bundle(Path(bundle._reader.place)) as url:
            for size in self._sizes:
                with started() as chromium, of_page(chromium, url, size, eye(place)) as page:
                    self.turn(place.name, "nearfar", page)

    def whole(self, place: Place) -> None:
        """Turn in whole scenes."""
        for drawn, instanced in COPIES.items():
            with LOCAL.served(self.files.whole(place, instanced=instanced)) as url:
                for size in self._sizes:
                    with started() as chromium, of_whole(chromium, url, size) as page:
                        self.turn(place.name, drawn, page)

    def loading(self, place: Place) -> None:
        """Load a bundle by each strategy."""
        bundle = self.files.bundle(place)
        folder = Path(bundle._reader.place)
        with network(LINK) as way, way.serve_bundle(folder) as url, way.browser(url) as chromium:
            print(place.name, way.name)
            once = partial(loading, way, chromium, url, bundle, size=self._sizes[0])
            # The first load of a browser also compiles its shaders.
            once("clovrd")
            for strategy in STRATEGIES:
                found = once(strategy)
                self.loads.append(Load(place.name, strategy, found))
                print(place.name, strategy, rate(found.rates), flush=True)


def rate(values: Sequence[float]) -> str:
    """Format mean and standard deviation."""
    return f"{np.mean(values):.1f} ± {np.std(values):.1f}"


def turns_table(seen: list[Seen]) -> str:
    """Table of turns."""
    rows = []
    for one in seen:
        turn = one.turn
        numbers = rate(turn.shown), rate(turn.waited), turn.script, turn.triangles / 1e6
        rows.append([one.place, one.drawn, one.size, *numbers])
    header = " |  | pixels | shown | drawn and waited for | ms of script {:.2f} | M triangles drawn {:.2f}"
    return table("Frames a second after loading, mean ± sd of a turn's sectors", header, rows)


def loads_table(loads: list[Load]) -> str:
    """Table of loads."""
    rows = []
    for one in loads:
        load = one.load
        numbers = load.picture, load.seconds, rate(load.rates), min(load.rates), load.longest
        rows.append([one.place, one.strategy, *numbers])
    header = " |  | first picture, s {:.2f} | all, s {:.2f} | frames a second | least in half a second {:.0f}"
    return table("Frames while loading", header + " | longest frame, ms {:.0f}", rows)


def main() -> None:
    given = start(
        __doc__,
        "--quick",
        place=("", "places whose names have this in them, such as factory"),
        parts={"default": ["reduced", "whole", "loading"], "nargs": "+", "choices": ("reduced", "whole", "loading")},
        seconds=(6.0, "of a turn; half of it where frames are waited for"),
        folder=(Path, "folder that keeps bundles and scenes for the next run"),
        pictures=(make_folder, "folder for pictures of each page"),
        json=(Path, "file for all figures"),
    )
    with folder_or_temporary(given.folder) as folder:
        run = Run(Files(folder), given.pictures, given.seconds, quick=given.quick)
        firsts = set[object]()
        for place in all_places(given.quick):
            kind = place.name.partition(",")[0]
            is_first = kind not in firsts
            firsts.add(kind)
            if given.place not in place.name:
                continue
            if "reduced" in given.parts:
                run.reduced(place)
            if "whole" in given.parts and is_first:
                run.whole(place)
            if "loading" in given.parts:
                run.loading(place)
            if given.json:
                given.json.write_text(json.dumps(run.figures(), indent=1) + "\n")
    if run.seen:
        print(turns_table(run.seen))
    if run.loads:
        print(loads_table(run.loads))


if __name__ == "__main__":
    main()
