"""Memory and resources held by the page during an hour in a room, on a simulated clock.

Eight others send poses at 72 Hz; users join, leave and speak, pointers are switched on and off, users are muted, and
the connection is lost once a minute. Every 36th frame is drawn. Bytes are those of the page's objects after a garbage
collection.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import nearfar as nf
from benchmarks.harness.report import start, table
from nearfar.serve._limits import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support.browser import started
from tests.support.used_room import use, used

HOUR, QUICK = 3600.0, 120.0
COUNTED = ("geometries", "textures", "programs", "Buffer", "Texture")


def main() -> None:
    seconds = QUICK if start(__doc__, "--quick").quick else HOUR
    rows: list[list[object]] = []
    with tempfile.TemporaryDirectory() as folder, started() as program:
        bundle = Path(folder) / "bundle"
        scene = nf.datasets.city(blocks=2, detail=1)
        nf.stream.export(scene, bundle, center=(3.0, 1.7, -2.0), radii=(10.0,), face_size=64)
        with Server({"": Site.of_bundle(bundle)}, rooms=Rooms()) as server:
            url = f"{server.url}?aa=0&strategy=clovrd&room=hour&datagrams=off"
            with used(program, url, 1) as page:
                for part, resources in enumerate(use(page, seconds), 1):
                    counts = (resources.objects[name] for name in COUNTED)
                    rows.append([part * seconds / 600, resources.poses, resources.heap / 1e6, *counts])
    print(table("A page in a room", ["minutes {:.1f}", "poses of others {:,}", "heap, MB {:.2f}", *COUNTED], rows))


if __name__ == "__main__":
    main()
