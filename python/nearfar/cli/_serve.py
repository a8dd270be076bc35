"""`nearfar serve`: serves bundles, reduced scenes, and on-demand regions of scenes to many clients."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

import typer

from nearfar._base import cache
from nearfar.cli import _rooms, _sites
from nearfar.cli._groups import Options, choice, flag, option
from nearfar.cli._scenes import ServedOptions
from nearfar.serve import _addresses
from nearfar.serve._certificate import Certificate
from nearfar.serve._limits import Limits
from nearfar.serve._server import Server, begin_log

_DEFAULT = Limits()


@dataclass(frozen=True, kw_only=True)
class AddressOptions(Options):
    """Where the server listens, and its names."""

    host: str = option(_addresses.LOCAL, "ADDRESS", "Address to listen at: 0.0.0.0 for all networks of this machine.")
    port: int = option(8080, "NUMBER", "Port to listen at; 0 for any that is free.")
    name: list[str] | None = option(
        None,
        "HOST",
        "Only name by which clients may call the server, such as example.org; repeat it for several. By default "
        "localhost if only this machine can reach the server, else any name.",
    )


@dataclass(frozen=True, kw_only=True)
class EncryptionOptions(Options):
    """The server's certificate."""

    certificate: str | None = option(None, "FILE", "Certificate of the server in PEM, with those that signed it.")
    key: str | None = option(None, "FILE", "Key of the certificate, in PEM.")
    self_signed: bool = flag(
        "--self-signed", "Encrypt with a certificate made here; browsers ask before they trust it."
    )

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

    origin: str | None = option(
        None, "ORIGIN", "Origin whose pages may read the files, such as https://example.org, or * for all."
    )
    connections: int = option(_DEFAULT.connections, "NUMBER", "Connections at the same time; others wait.")
    per_client: int = option(_DEFAULT.per_client, "NUMBER", "Connections of one address of another machine.")


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
    log: Literal["text", "json", "off"] = choice("text", "Log of answers and warnings, on standard error."),
    regions: _sites.RegionOptions,
    file: ServedOptions,
    only_check: bool = flag("--check", "Open everything that would be served, also scenes, list it, and exit."),
) -> None:
    """Serve scenes to browsers and headsets, with the page that shows them. Ctrl-C ends it."""
    limits = Limits(connections=access.connections, per_client=access.per_client)
    certificate, rooms = encryption.choose(address), meeting.make(sources)
    sites, scenes = _sites.read(sources, file.loading, regions)
    if log != "off" and not only_check:
        begin_log(as_json=log == "json")
    with (
        _end_signal() as end,
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
            for name, site in sites.items():
                typer.echo(f"{server.url}{f'{name}/' if name else ''} can be served: {site.title}")
            for scene in scenes:
                typer.echo(_sites.loaded(scene))
            return
        _print_addresses(server, sources, certificate)
        _rooms.print_links(server.urls[0], rooms, meeting.rooms_key)
        _sites.print_when_loaded(scenes)
        end.wait()


def _print_addresses(server: Server, sources: list[str], certificate: Certificate | None) -> None:
    first_url, *further_urls = server.urls
    content = sources[0] if len(sources) == 1 else f"{len(sources)} scenes"
    typer.echo(f"{first_url} shows {content}; Ctrl-C ends it.")
    for url in further_urls:
        typer.echo(f"  also {url}")
    if certificate is not None:
        typer.echo(f"certificate {certificate.certificate}, {certificate.days} days left, SHA-256:")
        typer.echo(f"  {certificate.fingerprint}")


@contextmanager
def _end_signal() -> Iterator[threading.Event]:
    """Yield an event that is set by SIGINT and SIGTERM."""
    end = threading.Event()
    previous = {number: signal.signal(number, lambda *_: end.set()) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield end
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)
