"""Follows a newcomer from an installation to light scenes, headset pictures and levels; times and shows each step.

`python scripts/first_hour.py [FILE_OR_FOLDER ...] [-o FOLDER] [--quick] [--install WHEEL]`

Each scene goes through the commands info, reduce, render, compare and lod, in this order; by default a procedural
city, room and forest, and a ring for the levels. `--install` makes a new environment for the wheel first. All
commands, times, texts and pictures are on FOLDER/index.html. The exit status is 1 if a step fails.
"""

from __future__ import annotations

import argparse
import html
import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parent.parent

SUFFIXES = (".glb", ".gltf", ".obj", ".ply", ".stl")
"""Suffixes of files in a folder that are loaded as scenes."""

PROCEDURAL = {"city": "city:blocks=4,detail=1", "room": "room", "forest": "forest:trees=200"}
"""Scenes by name if no files are given."""

PICTURES = (".png", ".jpg", ".svg")

IMPORTS = """
import time
start = time.process_time(); import numpy
between = time.process_time(); import nearfar
end = time.process_time()
print(f"import nearfar after NumPy: {1e3 * (end - between):.0f} ms; NumPy itself: {1e3 * (between - start):.0f} ms")
"""

STEP_TIMEOUT = 1800.0
"""Timeout of a step, seconds."""

STYLE = """
body { font: 16px/1.45 system-ui, sans-serif; margin: 1.5rem auto; max-width: 72rem; padding: 0 1rem; }
img { max-width: 100%; height: auto; display: block; margin: 0.4rem 0; }
pre { overflow-x: auto; background: #8882; padding: 0.6rem; font-size: 0.85rem; }
.failed { color: #c00; } figure { margin: 0.8rem 0; } table { border-collapse: collapse; }
td, th { padding: 0.15rem 0.8rem 0.15rem 0; text-align: left; } td.number { text-align: right; }
@media (prefers-color-scheme: dark) { body { background: #161616; color: #ddd; } a { color: #8bf; } }
"""


@dataclass
class Step:
    """A command that was run for a scene, and its results."""

    scene: str
    name: str
    command: list[str]
    seconds: float = 0.0
    status: int = 0
    text: str = ""
    pictures: list[str] = field(default_factory=list)
    """Paths relative to the folder of the page."""

    def run(self, folder: Path, results: Path | None = None) -> Step:
        """Run the command; `results` is the file or folder that it writes pictures to."""
        print(f"{self.scene}: {self.name} … ", end="", flush=True)
        started = time.perf_counter()
        environment = os.environ | {"NEARFAR_PROGRESS": "0", "COLUMNS": "100"}
        process = subprocess.run(
            self.command, capture_output=True, text=True, timeout=STEP_TIMEOUT, check=False, env=environment
        )
        self.seconds, self.status = time.perf_counter() - started, process.returncode
        self.text = (process.stdout + process.stderr).strip()
        written = [] if results is None else sorted(results.rglob("*")) if results.is_dir() else [results]
        pictures = [path for path in written if path.suffix in PICTURES and path.is_file()]
        self.pictures = [path.relative_to(folder).as_posix() for path in pictures]
        print(f"{self.seconds:.1f} s" + (f", failed with status {self.status}" if self.status else ""), flush=True)
        return self


def main() -> None:
    """Run all steps and write the page."""
    options = _options()
    folder = Path(options.output).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    scenes = _scenes(options.files)
    steps = list(_steps(options, folder, scenes))
    (folder / "steps.json").write_text(json.dumps([asdict(step) for step in steps], indent=1), encoding="utf-8")
    (folder / "index.html").write_text(_page(steps), encoding="utf-8")
    print(f"{len(steps)} steps, {sum(step.seconds for step in steps):.0f} s: {folder / 'index.html'}")
    if any(step.status for step in steps):
        sys.exit(1)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", type=Path, help="scenes, or folders of scenes; none for procedural ones")
    parser.add_argument("-o", "--output", default="out/first_hour", help="folder to write")
    parser.add_argument("--quick", action="store_true", help="small pictures and few measurements")
    parser.add_argument("--install", metavar="WHEEL", help="make a new environment in the folder for this wheel")
    parser.add_argument("--notebooks", action="store_true", help="run the notebooks 01 to 03 too")
    return parser.parse_args()


def _steps(options: argparse.Namespace, folder: Path, scenes: dict[str, str]) -> Iterator[Step]:
    """Run the steps one after the other."""
    python = sys.executable
    if options.install:
        python = str(folder / "environment" / "bin" / "python")
        make = [sys.executable, "-m", "venv", str(folder / "environment")]
        yield Step("installation", "environment", make).run(folder)
        wheel = f"{Path(options.install).resolve()}[lod,plot,notebook]"
        yield Step("installation", "wheel", [python, "-m", "pip", "install", "-q", wheel]).run(folder)
    yield Step("installation", "version", [python, "-m", "nearfar.cli", "--version"]).run(folder)
    yield Step("installation", "import", [python, "-c", IMPORTS.strip()]).run(folder)
    for name, scene in (scenes or PROCEDURAL).items():
        yield from _scene_steps(python, name, scene, folder, quick=options.quick)
    for name, model in (scenes or {"ring": _ring(folder)}).items():
        yield _levels(python, name, model, folder, quick=options.quick)
    if options.notebooks:
        script = str(CHECKOUT / "scripts" / "notebooks.py")
        for name in ("01_scene", "02_near_far", "03_headset"):
            yield Step("notebooks", name, [python, script, str(folder / "notebooks"), name]).run(
                folder, folder / "none"
            )


def _scenes(files: list[Path]) -> dict[str, str]:
    """Find scenes among files and folders, with unique names; exit if a file is missing or a folder contains none."""
    scenes: dict[str, str] = {}
    for file in files:
        if not file.exists():
            sys.exit(f"first_hour: there is no {file}")
        every = sorted(file.rglob("*")) if file.is_dir() else [file]
        paths = [path for path in every if not file.is_dir() or path.suffix.lower() in SUFFIXES]
        if not paths:
            sys.exit(f"first_hour: {file} holds none of {', '.join(SUFFIXES)}")
        for path in paths:
            same = sum(name.partition(" ")[0] == path.stem for name in scenes)
            scenes[f"{path.stem} {same + 1}" if same else path.stem] = str(path.resolve())
    return scenes


def _scene_steps(python: str, name: str, scene: str, folder: Path, *, quick: bool) -> Iterator[Step]:
    scene_folder = folder / name
    scene_folder.mkdir(exist_ok=True)
    size = ["--size", "320x200"] if quick else []
    eye_size = ["--size", "238x240"] if quick else []
    map_size = ["--face-size", "128"] if quick else []
    # Tears are measured at the density of a headset, so that a narrow view is faster.
    narrow = ["--fov", "45"] if quick else []
    nearfar = [python, "-m", "nearfar.cli"]
    light = str(scene_folder / "light")
    (scene_folder / "headset").mkdir(exist_ok=True)
    for step, arguments, output in (
        ("info", ["info", "-i", scene], ""),
        ("reduce", ["reduce", "-i", scene, *map_size, *size], "light"),
        ("info of the folder", ["info", "-i", light], ""),
        ("picture of the folder", ["render", "-i", light, *size], "light.png"),
        ("picture of the scene", ["render", "-i", scene, *size], "scene.png"),
        ("compare", ["compare", "-i", scene, *map_size, *size, *narrow], "compare"),
        ("headset", ["render", "-i", light, "--hmd", "quest_2", *eye_size], "headset/eyes.png"),
    ):
        command = [*nearfar, *arguments, *(["-o", str(scene_folder / output)] if output else [])]
        # The headset's pictures are several files in a folder.
        results = scene_folder / output.partition("/")[0] if output else None
        yield Step(name, step, command).run(folder, results)


def _levels(python: str, name: str, model: str, folder: Path, *, quick: bool) -> Step:
    (folder / name).mkdir(exist_ok=True)
    few = ["--views", "12", "--distances", "6", "--ratios", "0.5,0.2,0.05"] if quick else []
    command = [python, "-m", "nearfar.cli", "lod", "-i", model, "-o", str(folder / name / "levels.glb"), *few]
    return Step(name, "levels", command).run(folder, folder / name / "levels.png")


def _ring(folder: Path) -> str:
    """Write a ring of many triangles, for the levels of detail."""
    import trimesh

    path = folder / "ring.glb"
    trimesh.Scene([trimesh.creation.torus(1.0, 0.35, 96, 48)]).export(path)
    return str(path)


def _page(steps: list[Step]) -> str:
    """Page with a table of times, and each step's text and pictures."""
    rows, parts = [], []
    for number, step in enumerate(steps):
        state = f' class="failed">status {step.status}' if step.status else ">done"
        link = f'<a href="#{number}">{html.escape(step.name)}</a>'
        scene = html.escape(step.scene)
        rows.append(f'<tr><td>{scene}<td>{link}<td class="number">{step.seconds:.1f}<td{state}</tr>')
        figures = "".join(
            f'<figure><img src="{html.escape(path)}" loading="lazy" alt=""><figcaption>{html.escape(path)}</figcaption>'
            "</figure>"
            for path in step.pictures
        )
        command = html.escape(" ".join(step.command))
        parts.append(
            f'<h2 id="{number}">{scene}: {html.escape(step.name)}</h2><pre>{command}\n\n{html.escape(step.text)}</pre>'
            + figures
        )
    table = "<table><tr><th>scene<th>step<th>seconds<th>result</tr>" + "".join(rows) + "</table>"
    head = f'<meta charset="utf-8"><meta name="viewport" content="width=device-width"><style>{STYLE}</style>'
    return f'<!doctype html><html lang="en">{head}<title>First hour</title><h1>First hour</h1>{table}{"".join(parts)}'


if __name__ == "__main__":
    main()
