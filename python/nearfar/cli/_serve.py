"""`nearfar serve`, `invite` and `view`: serve bundles, reduced scenes, and on-demand regions of scenes."""

from __future__ import annotations

import contextlib
import shlex
import signal
import threading
import webbrowser
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal
from urllib.parse import quote

import typer

import nearfar as nf
from nearfar._base import cache, check
from nearfar.cli import _sites
from nearfar.cli._groups import Options, choice, flag, option
from nearfar.cli._scenes import ServedOptions, is_procedural
from nearfar.serve import _addresses
from nearfar.serve._limits import Limits, Rooms, ensure_key, read_key, token
from nearfar.serve._server import Certificate, Server, begin_log

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
    self_signed: bool = flag("--self-signed", "Encrypt with a certificate made here; browsers ask before trusting it.")

    def choose(self, address: AddressOptions) -> Certificate | None:
        """Return the certificate for an address; None without encryption."""
        if self.self_signed:
            if self.certificate is not None or self.key is not None:
                raise ValueError("--self-signed: expected no --certificate and no --key beside it")
            host = _addresses.parse_host(address.host)
            names = _addresses.hosts_of(host) if address.name is None else address.name
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


@dataclass(frozen=True, kw_only=True)
class RoomOptions(Options):
    """Rooms of a server."""

    rooms: bool = flag("--rooms", "Let users who name the same room see each other's heads, hands and pointers.")
    rooms_key: str | None = option(
        None, "FILE", "Secret of 16 bytes or more; users need a token that `nearfar invite` makes with it."
    )
    most_rooms: int | None = option(None, "NUMBER", "Greatest number of rooms; by default 64.")
    most_users: int | None = option(None, "NUMBER", "Greatest number of users in a room; by default 256.")
    no_peers: bool = flag("--no-peers", "Pages of a room take files only from the server, not from each other.")
    no_datagrams: bool = flag("--no-datagrams", "Users of rooms connect only by WebSocket, not by WebTransport.")

    def make(self, sources: list[str]) -> Rooms | None:
        """Return the rooms of a server of these sources; None without --rooms, which all other options here need."""
        if not self.rooms:
            for name in self.given_options():
                raise ValueError(f"{name}: expected --rooms beside it")
            return None
        if len(sources) > 1:
            # Else users of different scenes would share a room; besides, pages look for rooms beside their own scene.
            raise ValueError(f"--rooms: expected one source, got {len(sources)}")
        limits = {"rooms": self.most_rooms, "users": self.most_users}
        counts = {name: check.integer(f"most_{name}", n, 1, 2**16 - 2) for name, n in limits.items() if n is not None}
        return Rooms(
            **counts,
            # A new user receives all others at once, with 72 bytes each.
            queue_bytes=max(Rooms.queue_bytes, 128 + 72 * counts.get("users", 0)),
            key=ensure_key(cache.folder() / "rooms" / "key" if self.rooms_key is None else self.rooms_key),
            needs_token=self.rooms_key is not None,
            peers=not self.no_peers,
            datagrams=not self.no_datagrams,
        )


def serve(
    *,
    sources: Annotated[
        list[str],
        typer.Argument(
            metavar="[NAME=]SOURCE...",
            help="Folders that `nearfar export` or `nearfar reduce` wrote, bundles' URLs, or scenes, whose regions are "
            "made where clients request them; a page lists several sources.",
            show_default=False,
        ),
    ],
    address: AddressOptions,
    encryption: EncryptionOptions,
    access: AccessOptions,
    meeting: RoomOptions,
    log: Literal["text", "json", "off"] = choice("text", "Log of answers and warnings, on standard error."),
    regions: _sites.RegionOptions,
    scene_options: ServedOptions,
    only_check: bool = flag("--check", "Open everything that would be served, also scenes, list it, and exit."),
) -> None:
    """Serve scenes to browsers and headsets, with the page that shows them. Ctrl-C ends it."""
    limits = Limits(connections=access.connections, per_client=access.per_client)
    certificate, rooms = encryption.choose(address), meeting.make(sources)
    sites, scenes = _sites.read(sources, scene_options.loading, regions)
    if not scenes:
        scene_options.refuse("for bundles and reduced scenes")
        regions.refuse("for bundles and reduced scenes")
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
                typer.echo(_sites.loaded_text(scene))
            return
        _print_addresses(server, sources, certificate)
        _print_links(server.urls[0], rooms, meeting.rooms_key)
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


@contextlib.contextmanager
def _end_signal() -> Iterator[threading.Event]:
    """Yield an event that is set by SIGINT and SIGTERM."""
    end = threading.Event()
    previous = {number: signal.signal(number, lambda *_: end.set()) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield end
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)


def _print_links(url: str, rooms: Rooms | None, key: str | None) -> None:
    if rooms is None:
        return
    links = f"Users whose page has ?room=NAME see each other, {rooms.users} in each of {rooms.rooms} rooms at most"
    if key is None:
        typer.echo(f"{links}.")
    else:
        typer.echo(f"{links}; for each `nearfar invite NAME --rooms-key {shlex.quote(key)} --url {url}` makes a link.")


def invite(
    room: Annotated[str, typer.Argument(metavar="ROOM", help="Name of the room.", show_default=False)],
    rooms_key: str = option(..., "FILE", "The file that `nearfar serve --rooms-key` is started with."),
    hours: float = option(24.0, "NUMBER", "Hours for which the token is valid."),
    url: str | None = option(None, "ADDRESS", "Address of the scene's page; prints a link to it instead of the token."),
) -> None:
    """Print a token that lets one user at a time into a room."""
    user_token = token(room, read_key(rooms_key), hours=hours)
    typer.echo(
        user_token if url is None else f"{_addresses.check_page(url)}?room={quote(room, safe='')}&token={user_token}"
    )


def view(
    folder: Annotated[
        str,
        typer.Argument(
            help="Folder that `nearfar export`, `reduce` or `orthoview build` wrote, or a bundle's URL.",
            show_default=False,
        ),
    ],
    port: int = option(0, "NUMBER", "Port on 127.0.0.1; 0 for any that is free."),
    browser: Annotated[bool, typer.Option(help="Open the page in the browser.")] = True,
    write: bool = flag("--write", "Write the page into the folder for any web server instead, and serve nothing."),
) -> None:
    """Show a bundle, a reduced scene or a tree of orthoviews in the browser. Ctrl-C ends it."""
    path = Path(folder)
    if path.suffix != ".json" if path.is_file() else is_procedural(folder) and not path.exists():
        name = shlex.quote(folder)
        raise ValueError(
            f"{folder}: expected a folder that `nearfar export`, `reduce` or `orthoview build` wrote, got a scene; "
            f"`nearfar serve {name}` shows it, and `nearfar reduce {name} -o FOLDER` makes it light"
        )
    if write:
        nf.view.write_page(folder)
        typer.echo(f"{folder}/index.html shows it from any web server.")
        return
    # Ctrl-C ends the server even while it starts.
    with Server.of_bundle(folder, port=port) as server, contextlib.suppress(KeyboardInterrupt):
        typer.echo(f"{server.url} shows {folder}; Ctrl-C ends it.")
        if browser:
            webbrowser.open(server.url)
        threading.Event().wait()
