"""`nearfar serve`: serves bundles, reduced scenes, and on-demand regions of scenes to many clients."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer

from nearfar._base import cache, check
from nearfar.cli import _options as options, _rooms, _sites
from nearfar.cli._options import option
from nearfar.serve import _addresses, _log
from nearfar.serve._certificate import Certificate
from nearfar.serve._limits import Limits
from nearfar.serve._scene import LoadedScene
from nearfar.serve._server import Server
from nearfar.serve._site import CACHE_BYTES, Site

_DEFAULT = Limits()


def serve(
    sources: Annotated[
        list[str],
        typer.Argument(
            metavar="[NAME=]SOURCE...",
            help="Folders that `nearfar export` or `nearfar reduce` wrote, bundles' URLs, or scenes, whose regions are "
            "made for the places that clients ask for; a page lists several.",
            show_default=False,
        ),
    ],
    host: Annotated[
        str, option("--host", "ADDRESS", "Address to listen at: 0.0.0.0 for all networks of this machine.")
    ] = _addresses.LOCAL,
    port: Annotated[int, option("--port", "NUMBER", "Port to listen at; 0 for any that is free.")] = 8080,
    name: Annotated[
        list[str] | None,
        option(
            "--name",
            "HOST",
            "Name by which alone clients may call the server, such as example.org; repeat it for more. By default "
            "localhost if only this machine reaches it, else any.",
        ),
    ] = None,
    certificate: Annotated[
        str | None, option("--certificate", "FILE", "Certificate of the server in PEM, with those that signed it.")
    ] = None,
    key: Annotated[str | None, option("--key", "FILE", "Key of the certificate, in PEM.")] = None,
    self_signed: Annotated[
        bool,
        typer.Option("--self-signed", help="Encrypt with a certificate made here; browsers ask before they trust it."),
    ] = False,
    origin: Annotated[
        str | None,
        option("--origin", "ORIGIN", "Whose pages may read the files, such as https://example.org, or * for all."),
    ] = None,
    connections: Annotated[
        int, option("--connections", "NUMBER", "Connections at the same time; others wait.")
    ] = _DEFAULT.connections,
    per_client: Annotated[
        int, option("--per-client", "NUMBER", "Connections of one address of another machine.")
    ] = _DEFAULT.per_client,
    with_rooms: Annotated[
        bool,
        typer.Option("--rooms", help="Let users who name the same room see each other's heads, hands and pointers."),
    ] = False,
    rooms_key: _rooms.Key = None,
    most_rooms: Annotated[
        int | None, option("--most-rooms", "NUMBER", "Rooms at the same time; by default 64.")
    ] = None,
    most_users: Annotated[
        int | None, option("--most-users", "NUMBER", "Users of a room at the same time; by default 256.")
    ] = None,
    no_peers: Annotated[
        bool, typer.Option("--no-peers", help="Pages of a room take files from the server alone, not from each other.")
    ] = False,
    no_datagrams: Annotated[
        bool, typer.Option("--no-datagrams", help="Users of rooms connect by WebSocket alone, not by WebTransport.")
    ] = False,
    log: Annotated[str, option("--log", "text|json|off", "Log of answers and warnings, on standard error.")] = "text",
    grid: Annotated[
        float, option("--grid", "METRES", "Scenes: spacing of the grid to which the centres of regions move.")
    ] = 2.0,
    radii: options.RingRadii = None,
    face_size: options.FaceSize = None,
    samples: options.Samples = 4,
    cache_bytes: Annotated[
        int, option("--cache-bytes", "BYTES", "Scenes: bytes of each one's regions to keep on disk; 0 for none.")
    ] = CACHE_BYTES,
    up: options.Up = "y",
    scale: options.Scale = None,
    max_bytes: options.MaxBytes = None,
    blend: options.Blend = "opaque",
    on_invalid: options.Invalid = "raise",
    only_check: Annotated[
        bool, typer.Option("--check", help="Open all that would be served, scenes too, tell it, and end.")
    ] = False,
) -> None:
    """Serve scenes to browsers and headsets, with the page that shows them. Ctrl-C ends it."""
    check.choice("--log", log, ("text", "json", "off"))
    limits = Limits(connections=connections, per_client=per_client)
    used = _certificate(certificate, key, self_signed, host, name)
    most = {"rooms": most_rooms, "users": most_users}
    without = {"peers": no_peers, "datagrams": no_datagrams}
    rooms = _rooms.configure_rooms(with_rooms, sources, rooms_key, most, without)
    loading = _sites.Loading(up=up, on_invalid=on_invalid, scale=scale, max_bytes=max_bytes, blend=blend)
    regions = _sites.Regions(
        cache_bytes=check.integer("--cache-bytes", cache_bytes, 0, 1 << 62),
        grid=grid,
        radii=options.read_radii(radii),
        face_size=options.faces(face_size),
        samples=samples,
    )
    sites, scenes = _sites.read(sources, loading, regions)
    if log != "off" and not only_check:
        _log.begin(as_json=log == "json")
    with (
        _ended() as end,
        Server(
            sites, host=host, port=port, names=name, certificate=used, origin=origin, limits=limits, rooms=rooms
        ) as server,
    ):
        if only_check:
            _tell_what_is_there(server, sites, scenes)
            return
        _tell(server, sources, used)
        _rooms.tell(server.urls[0], rooms, rooms_key)
        _sites.tell_of(scenes)
        end.wait()


def _certificate(
    certificate: str | None, key: str | None, self_signed: bool, host: str, names: list[str] | None
) -> Certificate | None:
    if self_signed:
        if certificate is not None or key is not None:
            raise ValueError("--self-signed: expected no --certificate and no --key beside it")
        called = names if names is not None else _addresses.reached(_addresses.address(host))
        return Certificate.self_signed(cache.folder() / "certificate", called)
    if (certificate is None) != (key is None):
        raise ValueError("--certificate: expected --certificate and --key together")
    return None if certificate is None or key is None else Certificate(Path(certificate), Path(key))


def _tell(server: Server, sources: list[str], certificate: Certificate | None) -> None:
    first, *others = server.urls
    shown = sources[0] if len(sources) == 1 else f"{len(sources)} scenes"
    typer.echo(f"{first} shows {shown}; Ctrl-C ends it.")
    for url in others:
        typer.echo(f"  also {url}")
    if certificate is not None:
        typer.echo(f"certificate {certificate.certificate}, {certificate.days} days left, SHA-256:")
        typer.echo(f"  {certificate.fingerprint}")


def _tell_what_is_there(server: Server, sites: Mapping[str, Site], scenes: Sequence[LoadedScene]) -> None:
    """Print everything that can be served; raise ValueError for a scene that cannot."""
    for name, site in sites.items():
        typer.echo(f"{server.url}{f'{name}/' if name else ''} can be served: {site.title}")
    for scene in scenes:
        typer.echo(_sites.loaded(scene))


@contextmanager
def _ended() -> Iterator[threading.Event]:
    """Yield an event that is set by SIGINT and SIGTERM."""
    end = threading.Event()
    before = {number: signal.signal(number, lambda *_: end.set()) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield end
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
