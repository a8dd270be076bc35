"""Seconds until a scene is on the screen over a link of 50 Mbit/s and 20 ms: the page, one GLB, and 3D Tiles.

All three run in the same headless Chromium, over a shaped link between two network namespaces if possible, else with
Chromium's own throttle. Python's own server sends the files without compression. The page shows the whole scene; the
GLB contains all of it, with a node for each copy; the tileset contains the near part only.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import time
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.loads import Network, network
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.stream._near import one_file
from tests.support.reader_cases import SECONDS

CHECKOUT = Path(__file__).resolve().parents[2]
READERS = CHECKOUT / "tests" / "readers" / "node_modules"
LINK = nf.stream.Link(50, rtt_ms=20)
CENTER = (0.0, 1.3, 0.0)
TARGET = (-2.0, 4.0, -40.0)
SIZE, ANGLE = (640, 400), 75.0

# Time at which each ring was first in a frame, by the page's own clock.
WATCH = """() => {
  const shown = [];
  window.shownRings = shown;
  const look = () => {
    const facts = window.nearfar?.viewer.facts;
    while (facts && facts.shown && shown.length <= facts.arrived) shown.push(performance.now());
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}"""

SCRIPT = """() => performance.getEntriesByType('resource').find((entry) => /page\\.js/.test(entry.name)).responseEnd"""


def write_script(name: str, path: Path) -> None:
    """Write a module of this folder, with the packages that it uses, as one script."""
    esbuild = CHECKOUT / "web" / "node_modules" / ".bin" / "esbuild"
    source = CHECKOUT / "benchmarks" / "view" / name
    command = [str(esbuild), str(source), "--bundle", "--minify", "--format=esm", f"--outfile={path}"]
    # For a module in its own folder, packages are looked up in NODE_PATH.
    subprocess.run(command, check=True, capture_output=True, env={**os.environ, "NODE_PATH": str(READERS)})


def prepare(scene: nf.Scene, folder: Path) -> dict[str, int]:
    """Write all files to serve; return their bytes."""
    bundle = nf.stream.export(scene, folder / "bundle", center=CENTER)
    nf.view.write_page(folder / "bundle")
    (folder / "scene.glb").write_bytes(one_file(scene, named=True))
    (folder / "view.json").write_text(json.dumps({"eye": CENTER, "target": TARGET, "angle": ANGLE}))
    (folder / "index.html").write_text('<body style="margin:0"><script type="module" src="peers.js"></script>')
    write_script("_peers.mjs", folder / "peers.js")
    rows = bundle.summary()
    kinds = ("dynamic", "geometry", "color", "range")
    return {
        "ring 0": sum(rows[0][kind] for kind in kinds),
        "page": sum(row[kind] for row in rows for kind in kinds),
        "glb": (folder / "scene.glb").stat().st_size,
        "tiles": sum(row["geometry"] + row["dynamic"] for row in rows),
    }


def page_times(connection: Network, chromium: Any, url: str, strategy: str) -> dict[str, float]:
    """Seconds from navigation until the script was loaded, and ring 0 and the last ring were shown."""
    with connection.page(chromium, SIZE) as page:
        page.add_init_script(f"({WATCH})()")
        page.goto(f"{url}bundle/?strategy={strategy}")
        rings = page.evaluate("async () => (await (await fetch('manifest.json')).json()).regions[0].rings.length")
        deadline = time.monotonic() + SECONDS
        while page.evaluate("() => window.shownRings.length") < rings:
            if time.monotonic() > deadline:
                raise TimeoutError(f"ring {rings - 1} does not come")
            time.sleep(0.2)
        ring_times = page.evaluate("() => window.shownRings")
        return {"script": page.evaluate(SCRIPT) / 1e3, "first": ring_times[0] / 1e3, "last": ring_times[-1] / 1e3}


def peer_times(connection: Network, chromium: Any, url: str) -> dict[str, float]:
    """The same for another program's page."""
    with connection.page(chromium, SIZE) as page:
        page.goto(url)
        page.wait_for_function("() => window.result", timeout=SECONDS * 1e3)
        result = page.evaluate("() => window.result")
        first = result.get("first") or result["last"]
        return {"script": result["started"] / 1e3, "first": first / 1e3, "last": result["last"] / 1e3}


def main() -> None:
    options = start(
        __doc__,
        "--quick",
        repeat=(3, "loads of each; the medians are printed"),
        throttle=(bool, "Chromium's own throttle instead of a shaped link"),
    )
    if not (READERS.is_dir() and shutil.which("node")):
        sys.exit("`npm ci --prefix tests/readers` has not run")
    scene, rows = nf.datasets.city(blocks=3, detail=1 if options.quick else 2), []
    with folder_or_temporary() as folder, network(LINK, real=False if options.throttle else None) as connection:
        sizes = prepare(scene, folder)
        print(connection.name)
        with connection.serve_files(folder) as url, connection.browser(url) as chromium:
            page, peer = partial(page_times, connection, chromium, url), partial(peer_times, connection, chromium)
            jobs = {
                "nearfar": ("page", partial(page, "clovr")),
                "nearfar, rings at once": ("page", partial(page, "clovrd")),
                "one GLB in three.js": ("glb", partial(peer, url + "?glb")),
                "3d-tiles-renderer, near part": ("tiles", partial(peer, url + "?tiles")),
            }
            for label, (kind, job) in jobs.items():
                runs = [job() for _ in range(options.repeat)]
                times = (np.median([run[part] for run in runs]) for part in ("script", "first", "last"))
                rows.append([label, sizes[kind] / 1e6, *times])
    title = f"{scene.triangle_count:,} triangles, seconds from navigation; ring 0 has {sizes['ring 0'] / 1e6:.2f} MB"
    print(table(title, " | MB {:.2f} | script there {:.2f} | first complete picture {:.2f} | all {:.2f}", rows))


if __name__ == "__main__":
    main()
