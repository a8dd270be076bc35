"""Speed of the geometry's encoder: CPU seconds with and without meshoptimizer's compression."""

from __future__ import annotations

from functools import partial

import nearfar as nf
from benchmarks.harness.timing import best
from benchmarks.stream._near import STEP
from nearfar import _core

HEADER = ["", "MB in", "gathered, CPU ms", "and encoded", "MB/s a core, all", "encoding alone"]


def row(name: str, rings: nf.stream.Rings) -> list[str]:
    """MB of the compressed arrays, CPU milliseconds, MB/s per core.

    The time of compression alone is the difference to the same files without it, which copy their arrays, with longer
    normals: a few milliseconds too little. It is not shown if it is less than a tenth of the total.
    """
    raw = encode(rings, compressed=True)
    plain, packed = (best(partial(encode, rings, compressed=compressed), repeat=5).cpu for compressed in (False, True))
    alone = packed - plain
    shown = f"{raw / alone / 1e6:.0f}" if alone > 0.1 * packed else "–"
    milliseconds = (f"{seconds * 1e3:.0f}" for seconds in (plain, packed))
    return [name, f"{raw / 1e6:.1f}", *milliseconds, f"{raw / packed / 1e6:.0f}", shown]


def encode(rings: nf.stream.Rings, *, compressed: bool) -> int:
    """Encode the rings' files; return the bytes of their arrays before compression."""
    scene = rings.scene
    textures = len(_core.scene_parts(scene._core)["textures"])
    export = _core.Export(
        scene._core,
        rings.codes(),
        rings.count + 2,
        names=list(scene.object_names),
        images=[f"{number}.webp" for number in range(textures)],
        step=STEP,
        compressed=compressed,
    )
    shared = export.shared()
    uris: list[str | None] = [f"{number}.bin" for number in range(len(shared))]
    files = [export.glb(ring, uris=uris) for ring in range(1, rings.count + 1)]
    return sum(facts["raw_bytes"] for facts in [*(facts for *_, facts in shared), *(facts for _, facts in files)])
