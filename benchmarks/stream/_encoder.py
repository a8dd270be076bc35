"""Speed of the geometry's encoder: CPU seconds with and without meshoptimizer's compression."""

from __future__ import annotations

from functools import partial

import nearfar as nf
from benchmarks.harness.timing import best
from benchmarks.stream._near import exporter

HEADER = (
    " | MB in {:.1f} | gathered, CPU ms {:.0f} | and encoded {:.0f} | MB/s a core, all {:.0f} | encoding alone {:.0f}"
)


def row(name: str, rings: nf.stream.Rings) -> list[object]:
    """MB of the compressed arrays, CPU milliseconds, MB/s per core.

    The time of compression alone is the difference to the same files without it, which copy their arrays, with longer
    normals: a few milliseconds too little. It is not shown if it is less than a tenth of the total.
    """
    raw = encode(rings, compressed=True)
    plain, packed = (best(partial(encode, rings, compressed=compressed), repeat=5).cpu for compressed in (False, True))
    megabytes, alone = raw / 1e6, packed - plain
    speed = megabytes / alone if alone > 0.1 * packed else "–"
    return [name, megabytes, 1e3 * plain, 1e3 * packed, megabytes / packed, speed]


def encode(rings: nf.stream.Rings, *, compressed: bool) -> int:
    """Encode the rings' files; return the bytes of their arrays before compression."""
    export = exporter(rings.scene, rings.codes(), rings.count + 2, named=True, images=True, compressed=compressed)
    shared = export.shared()
    uris: list[str | None] = [f"{number}.bin" for number in range(len(shared))]
    files = [export.glb(ring, uris=uris) for ring in range(1, rings.count + 1)]
    return sum(facts["raw_bytes"] for facts in [*(facts for *_, facts in shared), *(facts for _, facts in files)])
