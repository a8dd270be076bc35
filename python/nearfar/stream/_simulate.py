"""Loading strategies on a virtual clock."""

from __future__ import annotations

import math
from typing import Any, SupportsFloat, SupportsIndex

from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._scene.scene import Scene
from nearfar.stream import _store
from nearfar.stream._bundle import Bundle
from nearfar.stream._client_pictures import SceneParts
from nearfar.stream._compressed import sent, sent_now
from nearfar.stream._head_path import HeadPath
from nearfar.stream._link import Link
from nearfar.stream._loading import MANIFEST, Course, Loader, follow
from nearfar.stream._measures import measured
from nearfar.stream._stage import Rates, least_radius
from nearfar.stream._strategies import STRATEGIES, Plan, plan_of
from nearfar.stream._timeline import Timeline
from nearfar.stream._transport import Transport

RATE = 72.0
"""Frames a second of the headset in CloVR (2024)."""
MOST_SECONDS = 1e6
"""Greatest duration."""


def simulate(
    bundle: Bundle,
    *,
    link: Link,
    strategy: str = "clovr",
    gzip: bool = False,
    head_path: ArrayLike | None = None,
    duration: SupportsFloat | None = None,
    rate: SupportsFloat = RATE,
    decode_mbs: SupportsFloat | None = None,
    frame_ms: SupportsFloat = 0.0,
    triangles_per_second: SupportsFloat | None = None,
    seed: SupportsIndex = 0,
    scene: Scene | None = None,
    camera: Camera | None = None,
    size: SupportsIndex = 128,
    every: SupportsFloat = 0.5,
) -> Timeline:
    """Load a region of a bundle over a link as the page does, on a virtual clock.

    Files are asked for in the page's order, at most six at a time, those of the next ring ahead. Rings fade in and grow
    by the page's rules.

    Parameters
    ----------
    bundle
        The bundle; the region that it speaks of is loaded.
    link
        The link to its server.
    strategy
        "clovr": rings fade in, and the morph grows. "clovrd": the same rings at once. "vis0": blank until the near
        objects that the centre sees and the last map are there. "vis1": these objects as they come, the map last. The
        last two need `export(by_footprint=True)`.
    gzip
        Whether the server compresses what is not compressed yet, as `nearfar serve` does; plain servers of files
        often do not.
    head_path
        Where the user's eye is: one position in world metres, or rows of a time in seconds and a position, (N, 4),
        which is linear between them and stays before and after. The centre by default.
    duration
        Seconds after which the simulation ends; by default when nothing changes any more.
    rate
        Frames a second, 1 to 1000.
    decode_mbs
        Megabytes a second that a worker decodes, of files of maps and, in another one, of geometry; None for no time.
    frame_ms, triangles_per_second
        What a frame takes: milliseconds, and more for its triangles; None for no time.
    seed
        Seed of the lost packets.
    scene
        The scene that was exported, to measure what the user sees of it: its rings before maps without the losses of
        files. None measures nothing.
    camera
        The view in which it is measured, moved to the user's eye; by default all directions, as six faces of `size`².
    size
        Pixels along a face, 16 to 4096.
    every
        Seconds between the frames that are looked at, besides those in which a ring, or a cross-fade, begins.

    Returns
    -------
    Timeline
        What was there, and what was shown and drawn, by time.

    Raises
    ------
    ValueError
        For unknown strategies, a bundle without objects by footprint where they are needed, and numbers out of range.
    TypeError
        For arguments of another type.

    References
    ----------
    CloVR (2024): the four strategies.
    """
    check.instance("bundle", bundle, Bundle)
    check.instance("link", link, Link)
    check.choice("strategy", strategy, STRATEGIES)
    path = HeadPath.of(head_path, bundle.center)
    ends = math.inf if duration is None else check.within("duration", duration, 0.0, MOST_SECONDS)
    frames = check.within("rate", rate, 1.0, 1000.0)
    per_byte = 0.0 if decode_mbs is None else 1e-6 / check.within("decode_mbs", decode_mbs, 1e-6, 1e9)
    frame = check.within("frame_ms", frame_ms, 0.0, 1e9) / 1e3
    pace = triangles_per_second
    each = 0.0 if pace is None else 1.0 / check.within("triangles_per_second", pace, 1.0, 1e15)
    pixels, gap = check.integer("size", size, 16, 4096), check.within("every", every, 1e-3, MOST_SECONDS)
    if scene is not None:
        check.instance("scene", scene, Scene)
    if camera is not None:
        check.instance("camera", camera, Camera)
    plan = plan_of(strategy, bundle._region, bundle.number, bundle._manifest["dynamic"])
    transport = Transport(link, seed=check.integer("seed", seed, 0, 2**63 - 1))
    sizes = _sizes(bundle, check.flag("gzip", gzip))
    course = _course(bundle, plan, transport, path, sizes, rate=frames, duration=ends, seconds_per_byte=per_byte)
    line = Timeline._of(strategy, plan, course, transport.curve, frame_seconds=frame, triangle_seconds=each)
    if scene is None:
        return line
    parts = SceneParts.of(scene, bundle, camera, pixels)
    return measured(line, parts, path, every=gap, rate=frames, duration=ends)


def radius_for(bundle: Bundle, *, link: Link, seconds: SupportsFloat, gzip: bool = False) -> float:
    """Find the radius of the last ring that a client at a link has within some seconds.

    Parameters
    ----------
    bundle
        The bundle; the region that it speaks of is loaded, as `simulate` does by "clovrd": no ring waits until another
        one has faded in.
    link
        The client's link.
    seconds
        Seconds from the request of the manifest to the arrival of the ring.
    gzip
        Whether the server compresses, as for `simulate`.

    Returns
    -------
    float
        Metres; 0 if not even ring 1 comes in time.

    Raises
    ------
    ValueError, TypeError
        For arguments of another type, and seconds that are not above 0.
    """
    limit = check.positive("seconds", seconds)
    line = simulate(bundle, link=link, strategy="clovrd", gzip=gzip, duration=min(limit, MOST_SECONDS))
    times = line.ring_times
    return max((radius for radius, time in zip(bundle.radii, times[1:], strict=True) if time <= limit), default=0.0)


def _sizes(bundle: Bundle, gzip: bool) -> dict[str, tuple[int, int]]:
    """Bytes of each file on its way, and unpacked."""
    sizes = {name: (int(entry["bytes"]),) * 2 for name, entry in bundle._manifest["files"].items()}
    manifest = bundle._reader.read(_store.MANIFEST)
    sizes[MANIFEST] = (len(manifest),) * 2
    if gzip:
        read = bundle._reader.read
        sizes = {name: (sent(name, size, read), size) for name, (size, _) in sizes.items() if name != MANIFEST}
        sizes[MANIFEST] = sent_now(manifest), len(manifest)
    return sizes


def _course(
    bundle: Bundle, plan: Plan, transport: Transport, path: HeadPath, sizes: dict[str, tuple[int, int]], **settings: Any
) -> Course:
    per_byte = settings.pop("seconds_per_byte")
    loader = Loader(plan, sizes, transport, per_byte, lambda ring: True)
    growth = bundle.growth
    rates = Rates(plan.radii, math.radians(growth.speed) / growth.reach, growth.fade)
    margin = float(bundle.fold_margins[bundle.number])

    def least(time: float) -> float:
        return least_radius(path.away(time), margin)

    return follow(plan, loader, rates, least=least, moves=path.moves_after, **settings)
