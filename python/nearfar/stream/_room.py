"""A user's connection to a room: sent messages and received events."""

from __future__ import annotations

import asyncio
import os
import random
import time
from types import TracebackType
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar.stream import _room_frames as frames, _room_names, _room_poses as poses
from nearfar.stream._room_connection import Address, Connection, broken, complete, require
from nearfar.stream._room_events import Begin, Ended, Event, Joined, Left, Pose, Posed, RoomError, To, User
from nearfar.stream._room_inbox import Inbox
from nearfar.stream._room_round_trips import RoundTrips

if TYPE_CHECKING:
    from typing import Self

ENTERING = 30.0
"""Timeout for entering the room, seconds."""

PAUSES = (0.05, 5.0)
"""First and longest pause before a reconnection attempt, seconds; the pause doubles, with random jitter."""

STAYED = 10.0
"""Seconds in the room after which the pause is reset."""

PATIENCE = 120.0
"""Seconds after which no further attempt begins."""

RETURNS = ("gone", "slow", "silent", "ending")
"""Reasons after which the client reconnects; the others would occur again."""

Placing = tuple[ArrayLike, ArrayLike]
"""Position and quaternion."""

Payload = bytes | bytearray | memoryview
"""Payload of `say` and `signal`."""


class Room:
    """A user's place in a room during an `async with` block; created by `join`.

    Iteration with `async for` yields events until the connection has ended for good.

    Parameters
    ----------
    url, room, name, group, token, reconnect, certificate
        As for `join`.
    """

    def __init__(
        self,
        url: str,
        *,
        room: str,
        name: str = "",
        group: int = 0,
        token: str | None = None,
        reconnect: bool = True,
        certificate: str | os.PathLike[str] | None = None,
    ) -> None:
        require()
        self._address = Address.build(url, room, token, certificate)
        self._name, self._group = _room_names.user("name", name), check.integer("group", group, 0, 2**16 - 1)
        self._reconnects = check.flag("reconnect", reconnect)
        self._users: dict[int, User] = {}
        self._user: int | None = None
        self._ticket = b""
        self._missing: int | None = None
        self._sequence = 0
        self._pause, self._entered = PAUSES[0], time.monotonic()
        self._inbox, self._trips = Inbox(), RoundTrips()
        self._connection: Connection | None = None
        self._there = asyncio.Event()
        self._end: Ended | None = None
        self._reading: asyncio.Task[None] | None = None
        self._was_entered = False

    @property
    def users(self) -> dict[int, User]:
        """Other users in the room, by number."""
        return dict(self._users)

    @property
    def user(self) -> int:
        """The user's own number; RoomError before joining."""
        if self._user is None:
            raise _outside()
        return self._user

    @property
    def group(self) -> int:
        """The user's own group."""
        return self._group

    @property
    def is_connected(self) -> bool:
        """Whether the user is in the room now; false before joining and while reconnecting."""
        return self._end is None and self._there.is_set()

    @property
    def round_trips(self) -> NDArray[np.float64]:
        """Round-trip times of acknowledged poses, in seconds: the last 10,000, the newest last."""
        return self._trips.seconds

    @property
    def dropped(self) -> int:
        """Number of discarded unread events: at most 4,096 events and 1 MiB of payload are queued."""
        return self._inbox.dropped

    async def pose(
        self,
        position: ArrayLike,
        rotation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
        *,
        left: Placing | None = None,
        right: Placing | None = None,
        pointer: tuple[Begin, float] | None = None,
        stops: bool = False,
        acknowledged: bool = False,
    ) -> int:
        """Send the pose of the user's head, hands and pointer to the group.

        While disconnected nothing is sent, because an old pose is useless.

        Parameters
        ----------
        position, rotation
            Head pose: metres from the scene's origin, y up, and a unit quaternion (x, y, z, w).
        left, right
            Positions and quaternions of the tracked hands.
        pointer
            Origin of the ray, "head", "left" or "right", and its length in metres; it points along −z of its origin.
        stops
            Whether no pose follows until the user moves again.
        acknowledged
            Whether the group's users acknowledge it, so that its round-trip time is measured.

        Returns
        -------
        int
            Sequence number of the pose, which `Settled` reports.
        """
        head = poses.parse_pose(("position", "rotation"), position, rotation)
        hands = poses.hand("left", left), poses.hand("right", right)
        ray = poses.pointer(pointer, *hands)
        flags = check.flag("acknowledged", acknowledged), check.flag("stops", stops)
        self._check_end()
        self._sequence += 1
        now = time.monotonic_ns()
        moved = Pose(self._sequence, now // 1000, *flags, head, *hands, ray)
        if acknowledged and self._has_peers():
            self._trips.send(moved.sequence, 1e-9 * now)
        if self._there.is_set():
            # The reading task handles a broken connection.
            await self._send(frames.pose(moved), or_else=False)
        return moved.sequence

    async def say(self, data: Payload, *, to: To = "group") -> None:
        """Send at most 4,096 bytes to the group or the room; while disconnected it waits for the reconnection.

        Raises
        ------
        RoomError
            If the connection breaks, so that the message may be lost, or has ended.
        """
        check.choice("to", to, ("group", "room"))
        await self._send_inside(frames.say(to, _payload(data, frames.MAX_SAY_BYTES)))

    async def signal(self, user: int, data: Payload) -> None:
        """Send at most 16,384 bytes to one user; the server ignores unknown users. Otherwise like `say`."""
        number = check.integer("user", user, 0, 2**16 - 1)
        await self._send_inside(frames.signal(number, _payload(data, frames.MAX_SIGNAL_BYTES)))

    async def __aenter__(self) -> Self:
        if self._was_entered:
            raise RoomError("bye", "expected a Room that was not entered before; join makes another one")
        await self._enter()
        self._was_entered = True
        self._reading = asyncio.create_task(self._read_on())
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._reading is not None:
            self._finish(RoomError("bye", "the user left"))
            self._reading.cancel()
            try:
                await complete(self._reading)
            finally:
                # A task that is cancelled before its first step does not run its own cleanup.
                await self._leave()

    def __aiter__(self) -> Self:
        return self

    async def __anext__(self) -> Event:
        if not self._was_entered:
            raise _outside()
        event = await self._inbox.take()
        if event is None:
            raise StopAsyncIteration
        return event

    def __repr__(self) -> str:
        return f"Room({self._address.url.partition('?')[0]!r}, user={self._user}, others={len(self._users)})"

    async def _enter(self) -> None:
        """Connect, send hello, and wait for the list of users; RoomError if that fails."""
        connection = Connection(self._address)
        try:
            async with asyncio.timeout(ENTERING):
                await connection.open()
                await connection.send(frames.hello(self._group, self._name, self._ticket))
                self._missing = None
                while self._missing is None or self._missing > 0:
                    await self._take(connection)
        except TimeoutError:
            await connection.close()
            raise RoomError("silent", f"the server has not let the user in within {ENTERING:g} s") from None
        except BaseException:
            await connection.close()
            raise
        self._connection = connection
        self._entered = time.monotonic()
        self._there.set()

    async def _read_on(self) -> None:
        """Process messages, reconnect after a broken connection, and record the final reason."""
        try:
            end = await self._read()
            while self._reconnects and end.reason in RETURNS:
                self._add(Ended(end.reason, end.sentence, returns=True))
                await self._return()
                end = await self._read()
        except RoomError as error:
            end = error
        except Exception as error:
            self._finish(RoomError("gone", check.one_line(f"the client failed: {error!r}", 300)))
            raise
        finally:
            await self._leave()
            self._inbox.end()
        self._finish(end)

    async def _read(self) -> RoomError:
        """Process messages until the connection has ended; return the reason."""
        try:
            while self._connection is not None:
                await self._take(self._connection)
            return broken()
        except RoomError as end:
            return end
        finally:
            await self._leave()

    async def _return(self) -> None:
        """Reconnect, with repeated attempts; RoomError if that fails for good."""
        shortest, longest = PAUSES
        if time.monotonic() - self._entered > STAYED:
            self._pause = shortest
        last = time.monotonic() + PATIENCE
        while True:
            # Jitter: users whom a server has lost do not all reconnect at the same time.
            await asyncio.sleep(self._pause * random.uniform(0.5, 1.0))
            # A user who is let in and thrown out again also waits longer each time.
            self._pause = min(2.0 * self._pause, longest)
            try:
                await self._enter()
            except RoomError as error:
                self._forget()
                if error.reason not in RETURNS or time.monotonic() > last:
                    raise
            else:
                return

    async def _leave(self) -> None:
        """Close the connection, if any, and forget all users."""
        self._there.clear()
        self._forget()
        if self._connection is not None:
            connection, self._connection = self._connection, None
            await connection.close()

    def _forget(self) -> None:
        self._users.clear()
        self._trips.forget()

    def _finish(self, end: RoomError) -> None:
        """Record the final reason as the last event, unless there is one."""
        if self._end is None:
            self._end = Ended(end.reason, end.sentence, returns=False)
            self._add(self._end)
            self._inbox.end()
            # Wakes up senders that wait for the reconnection.
            self._there.set()

    async def _take(self, connection: Connection) -> None:
        """Receive a message and acknowledge its poses; RoomError at the end."""
        message = await connection.receive()
        if message is None:
            raise broken()
        acks = b"".join(self._took(frame) for frame in frames.read(message))
        if acks:
            await connection.send(acks)

    def _took(self, frame: frames.Frame) -> bytes:
        """Process a frame; return the response frame, or no bytes."""
        match frame:
            case frames.Welcome(user, others, ticket):
                self._user, self._missing, self._ticket = user, others, ticket
            case frames.Refused(reason, sentence):
                raise RoomError(reason, sentence)
            case frames.SettledUpTo(sequence):
                for event in self._trips.settle(sequence, time.monotonic()):
                    self._add(event)
            case Joined(user, name, group):
                self._users[user] = User(user, name, group)
                self._missing = (self._missing or 0) - 1
                self._add(frame)
            case Left(user):
                self._users.pop(user, None)
                if not self._has_peers():
                    self._trips.forget()
                self._add(frame)
            case Posed(user, pose):
                self._add(frame)
                return frames.ack(user, pose.sequence) if pose.is_acknowledged else b""
            case _:
                self._add(frame)
        return b""

    def _has_peers(self) -> bool:
        return any(user.group == self._group for user in self._users.values())

    def _add(self, event: Event) -> None:
        self._inbox.add(event)

    async def _send_inside(self, frame: bytes) -> None:
        """Send a frame once the user is in the room; RoomError at the end."""
        self._check_end()
        await self._there.wait()
        self._check_end()
        await self._send(frame)

    async def _send(self, frame: bytes, *, or_else: bool = True) -> None:
        """Send a frame; RoomError if the connection is broken, unless `or_else` is false."""
        try:
            if self._connection is not None:
                await self._connection.send(frame)
        except RoomError:
            if or_else:
                raise

    def _check_end(self) -> None:
        if not self._was_entered:
            raise _outside()
        if self._end is not None:
            raise RoomError(self._end.reason, self._end.sentence)


def _outside() -> RoomError:
    return RoomError("unreached", "expected a user who has joined, by `async with`")


def _payload(data: Payload, most: int) -> bytes:
    if not isinstance(data, bytes | bytearray | memoryview):
        raise TypeError(f"data: expected bytes, such as text.encode() makes, got {check.type_and_value(data)}")
    payload = bytes(data)
    if len(payload) > most:
        raise ValueError(f"data: expected at most {most:,} bytes, got {len(payload):,}")
    return payload
