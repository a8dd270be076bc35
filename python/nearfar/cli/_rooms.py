"""Rooms of `nearfar serve`, and `nearfar invite`, which makes tokens for users."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from typing import Annotated
from urllib.parse import quote

import typer

from nearfar._base import cache, check
from nearfar.cli._options import option
from nearfar.serve import _addresses
from nearfar.serve._rooms import Rooms, kept_key, read_key, token

Key = Annotated[
    str | None,
    option(
        "--rooms-key", "FILE", "Secret of 16 bytes or more; users need a token that `nearfar invite` makes with it."
    ),
]
"""Key that signs users' tokens; `nearfar serve` creates a missing file."""


def invite(
    room: Annotated[str, typer.Argument(metavar="ROOM", help="Name of the room.", show_default=False)],
    rooms_key: Annotated[
        str, option("--rooms-key", "FILE", "The file that `nearfar serve --rooms-key` is started with.")
    ],
    hours: Annotated[float, option("--hours", "NUMBER", "Time after which nobody can enter with it.")] = 24.0,
    url: Annotated[
        str | None, option("--url", "ADDRESS", "Address of the scene's page; prints a link to it instead of the token.")
    ] = None,
) -> None:
    """Print a token that lets one user at a time into a room."""
    made = token(room, read_key(rooms_key), hours=hours)
    typer.echo(made if url is None else f"{_addresses.page(url)}?room={quote(room, safe='')}&token={made}")


def configure_rooms(
    is_wanted: bool, sources: list[str], key: str | None, most: Mapping[str, int | None], without: Mapping[str, bool]
) -> Rooms | None:
    """Return the rooms of a server; None for a server without rooms.

    Parameters
    ----------
    is_wanted
        Whether the server has rooms; if not, no option of rooms may be given.
    sources
        Sources that it serves.
    key
        File of the key for tokens; None if users need no token.
    most
        Greatest numbers of `rooms` and `users`; None for the default.
    without
        Whether `peers` and `datagrams` are disabled.
    """
    given = {name: count for name, count in most.items() if count is not None}
    if not is_wanted:
        unused = ["--rooms-key"] * (key is not None) + [f"--most-{name}" for name in given]
        unused += [f"--no-{name}" for name, is_off in without.items() if is_off]
        if unused:
            raise ValueError(f"{unused[0]}: expected --rooms beside it")
        return None
    if len(sources) > 1:
        # Users of different scenes would share a room, and pages look for rooms beside their own scene.
        raise ValueError(f"--rooms: expected one source, got {len(sources)}")
    for name, count in given.items():
        check.integer(f"--most-{name}", count, 1, 2**16 - 2)
    secret = kept_key(cache.folder() / "rooms" / "key" if key is None else key)
    # A new user is told of all others at once, with 72 bytes each.
    queue = max(Rooms.queue_bytes, 128 + 72 * given.get("users", 0))
    return Rooms(
        rooms=given.get("rooms", Rooms.rooms),
        users=given.get("users", Rooms.users),
        queue_bytes=queue,
        key=secret,
        needs_token=key is not None,
        peers=not without["peers"],
        datagrams=not without["datagrams"],
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
