"""Rooms of `nearfar serve`, and `nearfar invite`, which makes tokens for users."""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from typing import Annotated
from urllib.parse import quote

import typer

from nearfar._base import cache, check
from nearfar.cli._groups import Options, flag, option
from nearfar.serve import _addresses
from nearfar.serve._rooms import Rooms, ensure_key, read_key, token


def invite(
    room: Annotated[str, typer.Argument(metavar="ROOM", help="Name of the room.", show_default=False)],
    rooms_key: str = option(..., "FILE", "The file that `nearfar serve --rooms-key` is started with."),
    hours: float = option(24.0, "NUMBER", "Hours after which the token admits nobody."),
    url: str | None = option(None, "ADDRESS", "Address of the scene's page; prints a link to it instead of the token."),
) -> None:
    """Print a token that lets one user at a time into a room."""
    user_token = token(room, read_key(rooms_key), hours=hours)
    typer.echo(
        user_token if url is None else f"{_addresses.check_page(url)}?room={quote(room, safe='')}&token={user_token}"
    )


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
        """Return the rooms of a server of these sources; None without rooms, which need no option of rooms then."""
        if not self.rooms:
            for name in self.changed_options():
                raise ValueError(f"{name}: expected --rooms beside it")
            return None
        if len(sources) > 1:
            # Users of different scenes would share a room, and pages look for rooms beside their own scene.
            raise ValueError(f"--rooms: expected one source, got {len(sources)}")
        limits = {"rooms": self.most_rooms, "users": self.most_users}
        counts = {name: check.integer(f"most_{name}", n, 1, 2**16 - 2) for name, n in limits.items() if n is not None}
        return Rooms(
            **counts,
            # A new user is told of all others at once, with 72 bytes each.
            queue_bytes=max(Rooms.queue_bytes, 128 + 72 * counts.get("users", 0)),
            key=ensure_key(cache.folder() / "rooms" / "key" if self.rooms_key is None else self.rooms_key),
            needs_token=self.rooms_key is not None,
            peers=not self.no_peers,
            datagrams=not self.no_datagrams,
        )


def print_links(url: str, rooms: Rooms | None, key: str | None) -> None:
    if rooms is None:
        return
    links = (
        f"Users who open a page with ?room=NAME see each other, {rooms.users} in each of {rooms.rooms} rooms at most"
    )
    if key is None:
        typer.echo(f"{links}.")
    else:
        typer.echo(f"{links}; for each `nearfar invite NAME --rooms-key {shlex.quote(key)} --url {url}` makes a link.")
