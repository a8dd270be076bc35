"""Simulation of loading strategies on a virtual clock."""

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
from nearfar.stream._compressed import sent_now, transfer_size
from nearfar.stream._head_path import HeadPath
from nearfar.stream._link import Link
from nearfar.stream._loading import MANIFEST, Course, Loader, follow
from nearfar.stream._measures import measured
from nearfar.stream._stage import Rates, least_radius
from nearfar.stream._strategies import STRATEGIES, Plan, plan_of
from nearfar.stream._timeline import Timeline
from nearfar.stream._transport import Transport

RATE = 72.0
"""Frames per second of the headset in CloVR (2024)."""
MAX_SECONDS = 1e6
"""Greatest duration, seconds."""


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

    Files are requested in the page's order, at most six at a time, those of the next ring ahead. Rings fade in and grow
    by the page's rules.

    Parameters
    ----------
    bundle
        The bundle; its current region is loaded.
    link
        The link to the server.
    strategy
        "clovr": rings fade in, and the morph grows. "clovrd": the same rings without transitions. "vis0": blank until
        the near objects visible from the centre and the last map have arrived. "vis1": these objects in order of
        arrival, the map last. The last two need `export(by_footprint=True)`.
    gzip
        Whether the server compresses uncompressed files, as `nearfar serve` does; plain file servers often do not.
    head_path
        Position of the user's eye: one position in world metres, or rows of a time in seconds and a position, (N, 4),
        interpolated linearly and constant before and after. Default: the centre.
    duration
        Seconds after which the simulation ends; by default when nothing changes any more.
    rate
        Frames per second, 1 to 1000.
    decode_mbs
        Megabytes per second that a worker decodes, one worker for maps and one for geometry; None for no decoding time.
    frame_ms, triangles_per_second
        Drawing time of a frame: fixed milliseconds, and triangles drawn per second; None for no time.
    seed
        Seed of the packet losses.
    scene
        The exported scene, to measure how much of it the user sees: its rings in front of maps, without the losses of
        file encoding. None measures nothing.
    camera
        View for the measurement, moved to the user's eye; by default all directions, as six cube faces of `size`².
    size
        Pixels along a face, 16 to 4096.
    every
        Seconds between measured frames, in addition to those in which a ring or a cross-fade begins.

    Returns
    -------
    Timeline
        Arrivals, shown states and drawn triangles over time.

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
    path = HeadPath.parse(head_path, bundle.center)
    ends = math.inf if duration is None else check.in_range("duration", duration, 0.0, MAX_SECONDS)
    frames = check.in_range("rate", rate, 1.0, 1000.0)
    per_byte = 0.0 if decode_mbs is None else 1e-6 / check.in_range("decode_mbs", decode_mbs, 1e-6, 1e9)
    frame = check.in_range("frame_ms", frame_ms, 0.0, 1e9) / 1e3
    pace = triangles_per_second
    each = 0.0 if pace is None else 1.0 / check.in_range("triangles_per_second", pace, 1.0, 1e15)
    pixels, gap = check.integer("size", size, 16, 4096), check.in_range("every", every, 1e-3, MAX_SECONDS)
    if scene is not None:
        check.instance("scene", scene, Scene)
    if camera is not None:
        check.instance("camera", camera, Camera)
    plan = plan_of(strategy, bundle._region, bundle.number, bundle._manifest["dynamic"])
    transport = Transport(link, seed=check.integer("seed", seed, 0, 2**63 - 1))
    sizes = _sizes(bundle, check.flag("gzip", gzip))
    course = _course(bundle, plan, transport, path, sizes, rate=frames, duration=ends, seconds_per_byte=per_byte)
    line = Timeline._build(strategy, plan, course, transport.curve, frame_seconds=frame, triangle_seconds=each)
    if scene is None:
        return line
    parts = SceneParts.bake(scene, bundle, camera, pixels)
    return measured(line, parts, path, every=gap, rate=frames, duration=ends)


def radius_for(bundle: Bundle, *, link: Link, seconds: SupportsFloat, gzip: bool = False) -> float:
    """Return the radius of the last ring that a client receives within some seconds.

    Parameters
    ----------
    bundle
        The bundle; its current region is loaded, as `simulate` does by "clovrd", where no ring waits for the
        cross-fade of another one.
    link
        The client's link.
    seconds
        Seconds from the request of the manifest to the arrival of the ring.
    gzip
        Whether the server compresses, as for `simulate`.

    Returns
    -------
    float
        Radius in metres; 0 if not even ring 1 arrives in time.

    Raises
    ------
    ValueError, TypeError
        For arguments of another type, and seconds that are not positive.
    """
    limit = check.positive("seconds", seconds)
    line = simulate(bundle, link=link, strategy="clovrd", gzip=gzip, duration=min(limit, MAX_SECONDS))
    times = line.ring_times
    return max((radius for radius, time in zip(bundle.radii, times[1:], strict=True) if time <= limit), default=0.0)


def _sizes(bundle: Bundle, gzip: bool) -> dict[str, tuple[int, int]]:
    """Transfer size and unpacked size of each file, in bytes."""
    sizes = {name: (int(entry["bytes"]),) * 2 for name, entry in bundle._manifest["files"].items()}
    manifest = bundle._reader.read(_store.MANIFEST)
    sizes[MANIFEST] = (len(manifest),) * 2
    if gzip:
        read = bundle._reader.read
        sizes = {name: (transfer_size(name, size, read), size) for name, (size, _) in sizes.items() if name != MANIFEST}
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
