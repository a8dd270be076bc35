"""`nearfar serve`: serves bundles, reduced scenes, and on-demand regions of scenes to many clients."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from nearfar._base import cache, check
from nearfar.cli import _rooms, _sites
from nearfar.cli._groups import Options
from nearfar.cli._options import option
from nearfar.cli._scenes import ServedOptions
from nearfar.serve import _addresses
from nearfar.serve._certificate import Certificate
from nearfar.serve._limits import Limits
from nearfar.serve._scene import LoadedScene
from nearfar.serve._server import Server, begin_log
from nearfar.serve._site import Site

_DEFAULT = Limits()


@dataclass(frozen=True, kw_only=True)
class AddressOptions(Options):
    """Where the server listens, and its names."""

    host: Annotated[
        str, option("--host", "ADDRESS", "Address to listen at: 0.0.0.0 for all networks of this machine.")
    ] = _addresses.LOCAL
    port: Annotated[int, option("--port", "NUMBER", "Port to listen at; 0 for any that is free.")] = 8080
    name: Annotated[
        list[str] | None,
        option(
            "--name",
            "HOST",
            "Only name by which clients may call the server, such as example.org; repeat it for several. By default "
            "localhost if only this machine can reach the server, else any name.",
        ),
    ] = None


@dataclass(frozen=True, kw_only=True)
class EncryptionOptions(Options):
    """The server's certificate."""

    certificate: Annotated[
        str | None, option("--certificate", "FILE", "Certificate of the server in PEM, with those that signed it.")
    ] = None
    key: Annotated[str | None, option("--key", "FILE", "Key of the certificate, in PEM.")] = None
    self_signed: Annotated[
        bool,
        typer.Option("--self-signed", help="Encrypt with a certificate made here; browsers ask before they trust it."),
    ] = False

    def choose(self, address: AddressOptions) -> Certificate | None:
        """Return the certificate for an address; None without encryption."""
        if self.self_signed:
            if self.certificate is not None or self.key is not None:
                raise ValueError("--self-signed: expected no --certificate and no --key beside it")
            names = (
                address.name if address.name is not None else _addresses.hosts_of(_addresses.parse_host(address.host))
            )
            return Certificate.self_signed(cache.folder() / "certificate", names)
        if self.certificate is None and self.key is None:
            return None
        if self.certificate is None or self.key is None:
            raise ValueError("--certificate: expected --certificate and --key together")
        return Certificate(Path(self.certificate), Path(self.key))


@dataclass(frozen=True, kw_only=True)
class AccessOptions(Options):
    """Clients that may connect, and limits on their numbers."""

    origin: Annotated[
        str | None,
        option(
            "--origin", "ORIGIN", "Origin whose pages may read the files, such as https://example.org, or * for all."
        ),
    ] = None
    connections: Annotated[int, option("--connections", "NUMBER", "Connections at the same time; others wait.")] = (
        _DEFAULT.connections
    )
    per_client: Annotated[int, option("--per-client", "NUMBER", "Connections of one address of another machine.")] = (
        _DEFAULT.per_client
    )


def serve(
    *,
    sources: Annotated[
        list[str],
        typer.Argument(
            metavar="[NAME=]SOURCE...",
            help="Folders that `nearfar export` or `nearfar reduce` wrote, bundles' URLs, or scenes, whose regions are "
            "made for the places that clients ask for; a page lists several.",
            show_default=False,
        ),
    ],
    address: AddressOptions,
    encryption: EncryptionOptions,
    access: AccessOptions,
    meeting: _rooms.RoomOptions,
    log: Annotated[str, option("--log", "text|json|off", "Log of answers and warnings, on standard error.")] = "text",
    regions: _sites.RegionOptions,
    file: ServedOptions,
    only_check: Annotated[
        bool, typer.Option("--check", help="Open everything that would be served, also scenes, list it, and exit.")
    ] = False,
) -> None:
    """Serve scenes to browsers and headsets, with the page that shows them. Ctrl-C ends it."""
    check.choice("--log", log, ("text", "json", "off"))
    limits = Limits(connections=access.connections, per_client=access.per_client)
    certificate, rooms = encryption.choose(address), meeting.make(sources)
    sites, scenes = _sites.read(sources, file.loading, regions)
    if log != "off" and not only_check:
        begin_log(as_json=log == "json")
    with (
        _ended() as end,
        Server(
            sites,
            host=address.host,
            port=address.port,
            names=address.name,
            certificate=certificate,
            origin=access.origin,
            limits=limits,
            rooms=rooms,
        ) as server,
    ):
        if only_check:
            _tell_what_is_there(server, sites, scenes)
            return
        _tell(server, sources, certificate)
        _rooms.tell(server.urls[0], rooms, meeting.rooms_key)
        _sites.tell_of(scenes)
        end.wait()


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
