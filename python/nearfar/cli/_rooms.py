"""Rooms of `nearfar serve`, and `nearfar invite`, which makes tokens for users."""

from __future__ import annotations

import shlex
from dataclasses import dataclass, fields
from typing import Annotated
from urllib.parse import quote

import typer

from nearfar._base import cache, check
from nearfar.cli._groups import Options
from nearfar.cli._options import option
from nearfar.serve import _addresses
from nearfar.serve._rooms import Rooms, ensure_key, read_key, token


def invite(
    room: Annotated[str, typer.Argument(metavar="ROOM", help="Name of the room.", show_default=False)],
    rooms_key: Annotated[
        str, option("--rooms-key", "FILE", "The file that `nearfar serve --rooms-key` is started with.")
    ],
    hours: Annotated[float, option("--hours", "NUMBER", "Hours after which the token admits nobody.")] = 24.0,
    url: Annotated[
        str | None, option("--url", "ADDRESS", "Address of the scene's page; prints a link to it instead of the token.")
    ] = None,
) -> None:
    """Print a token that lets one user at a time into a room."""
    made = token(room, read_key(rooms_key), hours=hours)
    typer.echo(made if url is None else f"{_addresses.check_page(url)}?room={quote(room, safe='')}&token={made}")


@dataclass(frozen=True, kw_only=True)
class RoomOptions(Options):
    """Rooms of a server."""

    rooms: Annotated[
        bool,
        typer.Option("--rooms", help="Let users who name the same room see each other's heads, hands and pointers."),
    ] = False
    rooms_key: Annotated[
        str | None,
        option(
            "--rooms-key", "FILE", "Secret of 16 bytes or more; users need a token that `nearfar invite` makes with it."
        ),
    ] = None
    most_rooms: Annotated[int | None, option("--most-rooms", "NUMBER", "Greatest number of rooms; by default 64.")] = (
        None
    )
    most_users: Annotated[
        int | None, option("--most-users", "NUMBER", "Greatest number of users in a room; by default 256.")
    ] = None
    no_peers: Annotated[
        bool, typer.Option("--no-peers", help="Pages of a room take files only from the server, not from each other.")
    ] = False
    no_datagrams: Annotated[
        bool, typer.Option("--no-datagrams", help="Users of rooms connect only by WebSocket, not by WebTransport.")
    ] = False

    def make(self, sources: list[str]) -> Rooms | None:
        """Return the rooms of a server of these sources; None without rooms, which need no option of rooms then."""
        if not self.rooms:
            unused = [field.name for field in fields(self) if getattr(self, field.name) != field.default]
            if unused:
                raise ValueError(f"--{unused[0].replace('_', '-')}: expected --rooms beside it")
            return None
        if len(sources) > 1:
            # Users of different scenes would share a room, and pages look for rooms beside their own scene.
            raise ValueError(f"--rooms: expected one source, got {len(sources)}")
        given = {"rooms": self.most_rooms, "users": self.most_users}
        counts = {name: count for name, count in given.items() if count is not None}
        for name, count in counts.items():
            check.integer(f"--most-{name}", count, 1, 2**16 - 2)
        return Rooms(
            **counts,
            # A new user is told of all others at once, with 72 bytes each.
            queue_bytes=max(Rooms.queue_bytes, 128 + 72 * counts.get("users", 0)),
            key=ensure_key(cache.folder() / "rooms" / "key" if self.rooms_key is None else self.rooms_key),
            needs_token=self.rooms_key is not None,
            peers=not self.no_peers,
            datagrams=not self.no_datagrams,
        )


def tell(url: str, rooms: Rooms | None, key: str | None) -> None:
    """Print how users enter rooms."""
    if rooms is None:
        return
    links = (
        f"Users who open a page with ?room=NAME see each other, {rooms.users} in each of {rooms.rooms} rooms at most"
    )
    if key is None:
        typer.echo(f"{links}.")
    else:
        typer.echo(f"{links}; for each `nearfar invite NAME --rooms-key {shlex.quote(key)} --url {url}` makes a link.")
