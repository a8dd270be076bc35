"""Valid calls of every public callable of `nf.stream`, and of the page's writer."""

from __future__ import annotations

from typing import Any

import nearfar as nf
from tests.support.valid_fields import fields
from tests.support.valid_objects import ZONES, Valid


def streams(valid: Valid) -> dict[str, dict[str, Any]]:
    """Return valid keywords by the callable's name."""
    scene, center = valid.scene, ZONES["center"]
    return {
        "nearfar.stream.Bundle": fields(valid.bundle),
        "nearfar.stream.Bundle.at": {"ring": 1, "radius": 1.0},
        "nearfar.stream.blend": {"old": valid.frame, "new": valid.frame, "share": 0.5},
        "nearfar.stream.Growth": {"radii": [2.0, 4.0], "speed": 1.0},
        "nearfar.stream.Growth.pixels": {"focal": 300.0},
        "nearfar.stream.Growth.radius": {"ring": 1, "time": 1.0},
        "nearfar.stream.Growth.seconds": {"ring": 1},
        "nearfar.stream.Growth.share": {"time": 1.0},
        "nearfar.stream.Growth.strength": {"ring": 1, "time": 1.0},
        "nearfar.stream.Growth.described": {},
        "nearfar.stream.Bundle.map": {"ring": 1},
        "nearfar.stream.Bundle.nearest": {"point": center},
        "nearfar.stream.Bundle.neighbours": {"region": 0},
        "nearfar.stream.Bundle.region": {"region": 0},
        "nearfar.stream.Bundle.read": {"name": next(iter(valid.bundle.files))},
        "nearfar.stream.Bundle.show": {"camera": valid.camera},
        "nearfar.stream.Bundle.summary": {},
        "nearfar.stream.Bundle.verify": {},
        "nearfar.stream.RingMaps": fields(valid.ring_maps),
        "nearfar.stream.RingMaps.changed_tiles": {"ring": 1},
        "nearfar.stream.RingMaps.map": {"ring": 1},
        "nearfar.stream.Rings": fields(valid.ring_maps.rings),
        "nearfar.stream.Rings.codes": {},
        "nearfar.stream.Rings.objects": {"ring": 1},
        "nearfar.stream.Rings.summary": {},
        "nearfar.stream.assign": {"scene": scene, "center": center, "radii": [2.0, 4.0]},
        "nearfar.stream.bake_maps": {"rings": valid.ring_maps.rings, "face_size": 4},
        "nearfar.stream.export": {
            "scene": scene, "path": valid.folder / "exported", "center": center, "radii": [3.0], "face_size": 64,
            "samples": 1, "pixels_per_degree": 20.0, "split_px": 50.0, "by_footprint": True,
        },
        "nearfar.stream.export @regions": {
            "scene": scene, "path": valid.folder / "exported", "center": valid.regions, "grid": 0.5, "radii": [2.0],
            "face_size": 64, "samples": 1,
        },
        "nearfar.stream.export @levels": {
            "scene": valid.leveled, "path": valid.folder / "exported", "center": center, "radii": [20.0],
            "face_size": 64, "samples": 1, "lod": "depth",
        },
        "nearfar.stream.footprints": {"scene": scene, "center": center, "face_size": 4},
        "nearfar.stream.Link": {"mbps": 50.0, "rtt_ms": 20.0, "loss": 0.01, "http": 1},
        "nearfar.stream.Link @trace": {"trace": ([0.0, 1.0], [50.0, 20.0])},
        "nearfar.stream.Timeline": fields(valid.timeline),
        "nearfar.stream.Timeline.bytes_at": {"time": [0.0, 1.0]},
        "nearfar.stream.Timeline.plot": {"value": "radius"},
        "nearfar.stream.Timeline.to_dict": {},
        "nearfar.stream.Timeline.to_json": {"path": valid.folder / "timeline.json"},
        "nearfar.stream.open": {"path": valid.folder / "bundle"},
        "nearfar.stream.radius_for": {"bundle": valid.bundle, "link": nf.stream.Link(50.0), "seconds": 1.0},
        "nearfar.stream.simulate": {
            "bundle": valid.bundle, "link": nf.stream.Link(50.0, rtt_ms=20.0, loss=0.01), "head_path": center,
        },
        "nearfar.stream.simulate @seen": {
            "bundle": valid.bundle, "link": nf.stream.Link(50.0), "strategy": "clovrd", "scene": scene, "size": 16,
            "camera": valid.camera,
        },
        "nearfar.stream.rings": {"scene": scene, "center": center, "r_max": 20.0, "base_radius": 8.0},
        "nearfar.stream.snap": {"center": center, "grid": 2.0},
        "nearfar.view.write_page": {"path": valid.folder / "bundle"},
    }  # fmt: skip
