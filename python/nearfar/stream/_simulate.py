"""Simulation of loading strategies on a virtual clock."""

from __future__ import annotations

import math
import zlib
from collections.abc import Callable
from typing import SupportsFloat, SupportsIndex, Unpack

from nearfar._base import check
from nearfar._base.settings import gather
from nearfar._scene.scene import Scene
from nearfar.stream._bundle import Bundle
from nearfar.stream._client_pictures import SceneParts, measure
from nearfar.stream._link import Link
from nearfar.stream._loading import Loader, follow
from nearfar.stream._store import MANIFEST
from nearfar.stream._strategies import ClientKeywords, ClientSettings, HeadPath, plan_of
from nearfar.stream._timeline import Timeline
from nearfar.stream._transport import Transport

MAX_SECONDS = 1e6
"""Greatest duration, seconds."""
MIN_GZIP_BYTES, MAX_GZIP_BYTES = 1 << 10, 1 << 26
"""Files smaller or larger than these sizes in bytes are sent uncompressed; the manifest may be larger."""
MAX_GZIP_RATIO = 0.95
"""Greatest ratio of compressed to original size for which the compressed copy is sent."""
COMPRESSED_SUFFIXES = (".webp", ".range")
"""Suffixes of files whose content is already compressed."""

_GZIP_WBITS = 16 + zlib.MAX_WBITS
"""zlib's `wbits` for the gzip format."""
_gzip_sizes: dict[str, int] = {}
"""Compressed sizes by file name, which identifies the content except that of the manifest."""


def simulate(
    bundle: Bundle,
    *,
    link: Link,
    gzip: bool = False,
    duration: SupportsFloat | None = None,
    seed: SupportsIndex = 0,
    scene: Scene | None = None,
    size: SupportsIndex = 128,
    every: SupportsFloat = 0.5,
    settings: ClientSettings | None = None,
    **keywords: Unpack[ClientKeywords],
) -> Timeline:
    """Load a region of a bundle over a link as the page does, on a virtual clock.

    Files are requested in the page's order, at most six at a time; a ring's files are requested before the previous
    ring is shown. Rings fade in and grow by the page's rules. Returns arrivals, shown states and drawn triangles over
    time. ValueError for unknown strategies, numbers out of range, and "vis0" or "vis1" for a bundle exported without
    `by_footprint`. Source: CloVR (2024): the four strategies.

    Parameters
    ----------
    bundle
        The bundle; its current region is loaded.
    link
        The link to the server.
    gzip
        Whether the server compresses uncompressed files, as `nearfar serve` does; plain file servers often do not.
    duration
        Seconds after which the simulation ends; by default when nothing changes any more.
    seed
        Seed of the packet losses.
    scene
        The exported scene, to measure how much of it the user sees. Its rings and maps are drawn without the losses of
        file encoding. None measures nothing.
    size
        Pixels along an edge of the six measured cube faces, 16 to 4096; unused if there is a `camera`.
    every
        Seconds between measured frames. Frames in which a ring or a cross-fade begins are measured, too.
    settings
        The client, as `ClientSettings`.
    keywords
        Fields of `settings`, which they replace.
    """
    client = gather(ClientSettings, settings, keywords)
    check.instance("bundle", bundle, Bundle)
    check.instance("link", link, Link)
    path = HeadPath.parse(client.head_path, bundle.center)
    end = math.inf if duration is None else check.in_range("duration", duration, 0.0, MAX_SECONDS)
    pixels, gap = check.integer("size", size, 16, 4096), check.in_range("every", every, 1e-3, MAX_SECONDS)
    if scene is not None:
        check.instance("scene", scene, Scene)
    plan = plan_of(client.strategy, bundle._region, bundle.number, bundle._manifest["dynamic"])
    transport = Transport(link, seed=check.integer("seed", seed, 0, 2**63 - 1))
    loader = Loader(plan, _sizes(bundle, check.flag("gzip", gzip)), transport, client.seconds_per_byte)
    fold_margin = float(bundle.fold_margins[bundle.number])
    course = follow(loader, bundle.growth, path, fold_margin, rate=client.rate, duration=end)
    line = Timeline._build(plan, course, transport, client)
    if scene is None:
        return line
    parts = SceneParts.bake(scene, bundle, client.camera, pixels)
    return measure(line, parts, path, every=gap, rate=client.rate, end=end)


def radius_for(bundle: Bundle, *, link: Link, seconds: SupportsFloat, gzip: bool = False) -> float:
    """Return the radius of the last ring that a client receives within some seconds of requesting the manifest.

    The region is loaded as by `simulate` with the strategy "clovrd", in which no ring waits for a cross-fade. Returns
    metres; 0 if not even ring 1 arrives in time.

    Parameters
    ----------
    bundle, link, gzip
        As for `simulate`.
    seconds
        Seconds from the request of the manifest to the arrival of the ring.
    """
    limit = check.positive("seconds", seconds)
    line = simulate(bundle, link=link, strategy="clovrd", gzip=gzip, duration=min(limit, MAX_SECONDS))
    times = line.ring_times
    return max((radius for radius, time in zip(bundle.radii, times[1:], strict=True) if time <= limit), default=0.0)


def _sizes(bundle: Bundle, gzip: bool) -> dict[str, tuple[int, int]]:
    """Return transfer size and unpacked size of each file, in bytes."""
    sizes = {name: int(entry["bytes"]) for name, entry in bundle._manifest["files"].items()}
    sizes[MANIFEST] = len(bundle._reader.read(MANIFEST))
    read = bundle._reader.read
    return {name: (transfer_size(name, size, read) if gzip else size, size) for name, size in sizes.items()}


def transfer_size(name: str, size: int, read: Callable[[str], bytes]) -> int:
    """Return the transfer size of a file in bytes."""
    is_manifest = name == MANIFEST
    if name.endswith(COMPRESSED_SUFFIXES) or size < MIN_GZIP_BYTES or (size > MAX_GZIP_BYTES and not is_manifest):
        return size
    packed = None if is_manifest else _gzip_sizes.get(name)
    if packed is None:
        packed = _gzip_sizes[name] = len(zlib.compress(read(name), wbits=_GZIP_WBITS))
    return packed if packed < MAX_GZIP_RATIO * size else size
