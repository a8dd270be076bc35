"""A user's connection to a room: sends messages and receives events."""

from __future__ import annotations

import asyncio
import os
import random
import time
from contextlib import suppress
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar.stream import _room_frames as frames
from nearfar.stream._room_connection import Address, Connection, broken_error, complete, require_aiohttp
from nearfar.stream._room_events import (
    Ended,
    Event,
    Inbox,
    Joined,
    Left,
    PointerOrigin,
    Pose,
    Posed,
    RoomError,
    RoundTrips,
    To,
    User,
)

ENTRY_TIMEOUT = 30.0
"""Timeout for entering the room, seconds."""

RECONNECT_PAUSES = (0.05, 5.0)
"""First and longest pause before a reconnection attempt, seconds; the pause doubles, with random jitter."""

PAUSE_RESET_SECONDS = 10.0
"""Time in the room, seconds, after which the pause is reset to the first one."""

RECONNECT_WINDOW = 120.0
"""Time after the connection broke, seconds, after which no further attempt to reconnect begins."""

RECONNECT_REASONS = ("gone", "slow", "silent", "ending")
"""Reasons after which the client reconnects; all other reasons would occur again."""

HandPose = tuple[ArrayLike, ArrayLike]
"""Position in metres and unit quaternion (x, y, z, w)."""

Payload = bytes | bytearray | memoryview
"""Payload of `say` and `signal`."""


class Room:
    """A user's place in a room during an `async with` block; created by `join`.

    Iteration with `async for` yields events until the connection has ended for good.
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
        require_aiohttp()
        self._address = Address.build(url, room, token, certificate)
        self._name, self._group = frames.user_name("name", name), check.integer("group", group, 0, 2**16 - 1)
        self._reconnects = check.flag("reconnect", reconnect)
        self._users: dict[int, User] = {}
        self._user: int | None = None
        self._ticket = b""
        self._expected_users: int | None = None
        self._sequence = 0
        self._pause, self._entry_time = RECONNECT_PAUSES[0], time.monotonic()
        self._inbox, self._round_trips = Inbox(), RoundTrips()
        self._connection: Connection | None = None
        self._is_ready = asyncio.Event()
        self._end: Ended | None = None
        self._reader: asyncio.Task[None] | None = None
        self._was_entered = False

    @property
    def users(self) -> dict[int, User]:
        """Other users in the room, by number."""
        return dict(self._users)

    @property
    def user(self) -> int:
        """The user's own number; RoomError before joining."""
        if self._user is None:
            raise _not_joined_error()
        return self._user

    @property
    def group(self) -> int:
        """The user's own group."""
        return self._group

    @property
    def is_connected(self) -> bool:
        """Whether the user is in the room now; false before joining and while reconnecting."""
        return self._end is None and self._is_ready.is_set()

    @property
    def round_trips(self) -> NDArray[np.float64]:
        """Round-trip times of the last 10,000 acknowledged poses in seconds, the newest last."""
        return self._round_trips.seconds

    @property
    def dropped(self) -> int:
        """Number of events that were discarded unread: at most 4,096 events and 1 MiB of payload are queued."""
        return self._inbox.dropped

    async def pose(
        self,
        position: ArrayLike,
        rotation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
        *,
        left: HandPose | None = None,
        right: HandPose | None = None,
        pointer: tuple[PointerOrigin, float] | None = None,
        stops: bool = False,
        acknowledged: bool = False,
    ) -> int:
        """Send the pose of the user's head, hands and pointer to the group; return the number that `Settled` reports.

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
            Whether the group's users acknowledge the pose, so that its round-trip time is measured.
        """
        head = frames.parse_pose(("position", "rotation"), position, rotation)
        hands = frames.parse_hand("left", left), frames.parse_hand("right", right)
        ray = frames.parse_pointer(pointer, *hands)
        flags = check.flag("acknowledged", acknowledged), check.flag("stops", stops)
        self._check_end()
        self._sequence += 1
        now = time.monotonic_ns()
        message = Pose(self._sequence, now // 1000, *flags, head, *hands, ray)
        if acknowledged and self._has_peers():
            self._round_trips.send(message.sequence, 1e-9 * now)
        if self._is_ready.is_set() and self._connection is not None:
            # The reading task handles a broken connection.
            with suppress(RoomError):
                await self._connection.send(frames.pose(message))
        return message.sequence

    async def say(self, data: Payload, *, to: To = "group") -> None:
        """Send at most 4,096 bytes to the group or the room; while disconnected, wait for the reconnection.

        RoomError if the connection has ended, or breaks, so that the message may be lost.
        """
        check.choice("to", to, ("group", "room"))
        await self._send_when_joined(frames.say(to, _payload(data, frames.MAX_SAY_BYTES)))

    async def signal(self, user: int, data: Payload) -> None:
        """Send at most 16,384 bytes to one user; the server ignores unknown users. Otherwise like `say`."""
        number = check.integer("user", user, 0, 2**16 - 1)
        await self._send_when_joined(frames.signal(number, _payload(data, frames.MAX_SIGNAL_BYTES)))

    async def __aenter__(self) -> Self:
        if self._was_entered:
            raise RoomError("bye", "expected a Room that was not entered before; join makes another one")
        await self._enter()
        self._was_entered = True
        self._reader = asyncio.create_task(self._run())
        return self

    async def __aexit__(self, *error: object) -> None:
        if self._reader is not None:
            self._finish(RoomError("bye", "the user left"))
            self._reader.cancel()
            try:
                await complete(self._reader)
            finally:
                # A task that is cancelled before its first step does not run its own cleanup.
                await self._leave()

    def __aiter__(self) -> Self:
        return self

    async def __anext__(self) -> Event:
        if not self._was_entered:
            raise _not_joined_error()
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
            async with asyncio.timeout(ENTRY_TIMEOUT):
                await connection.open()
                await connection.send(frames.hello(self._group, self._name, self._ticket))
                self._expected_users = None
                while self._expected_users is None or self._expected_users > 0:
                    await self._receive(connection)
        except TimeoutError:
            await connection.close()
            raise RoomError("silent", f"the server did not admit the user within {ENTRY_TIMEOUT:g} s") from None
        except BaseException:
            await connection.close()
            raise
        self._connection = connection
        self._entry_time = time.monotonic()
        self._is_ready.set()

    async def _run(self) -> None:
        """Process messages, reconnect after a broken connection, and record the reason for the end."""
        try:
            end = await self._read()
            while self._reconnects and end.reason in RECONNECT_REASONS:
                self._inbox.add(Ended(end.reason, end.sentence, returns=True))
                await self._reconnect()
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
                await self._receive(self._connection)
            return broken_error()
        except RoomError as end:
            return end
        finally:
            await self._leave()

    async def _reconnect(self) -> None:
        """Reconnect, with repeated attempts; RoomError if that fails for good."""
        shortest, longest = RECONNECT_PAUSES
        if time.monotonic() - self._entry_time > PAUSE_RESET_SECONDS:
            self._pause = shortest
        deadline = time.monotonic() + RECONNECT_WINDOW
        while True:
            # Jitter: users whom a server has lost do not all reconnect at the same time.
            await asyncio.sleep(self._pause * random.uniform(0.5, 1.0))
            # The pause also grows for a user who is admitted and disconnected repeatedly.
            self._pause = min(2.0 * self._pause, longest)
            try:
                await self._enter()
            except RoomError as error:
                self._clear_users()
                if error.reason not in RECONNECT_REASONS or time.monotonic() > deadline:
                    raise
            else:
                return

    async def _leave(self) -> None:
        """Close the connection, if any, and forget all users."""
        self._is_ready.clear()
        self._clear_users()
        if self._connection is not None:
            connection, self._connection = self._connection, None
            await connection.close()

    def _clear_users(self) -> None:
        self._users.clear()
        self._round_trips.forget()

    def _finish(self, end: RoomError) -> None:
        """Record the final reason as the last event, unless one is recorded already."""
        if self._end is None:
            self._end = Ended(end.reason, end.sentence, returns=False)
            self._inbox.add(self._end)
            self._inbox.end()
            # Wakes up senders that wait for the reconnection.
            self._is_ready.set()

    async def _receive(self, connection: Connection) -> None:
        """Receive a message and acknowledge its poses; RoomError if the connection has ended."""
        message = await connection.receive()
        if message is None:
            raise broken_error()
        acks = b"".join(self._process(frame) for frame in frames.read(message))
        if acks:
            await connection.send(acks)

    def _process(self, frame: frames.Frame) -> bytes:
        """Process a frame; return the response frame, or no bytes."""
        match frame:
            case frames.Welcome(user, others, ticket):
                self._user, self._expected_users, self._ticket = user, others, ticket
                return b""
            case frames.Refused(reason, sentence):
                raise RoomError(reason, sentence)
            case frames.SettledUpTo(sequence):
                for event in self._round_trips.settle(sequence, time.monotonic()):
                    self._inbox.add(event)
                return b""
            case Joined(user, name, group):
                self._users[user] = User(user, name, group)
                self._expected_users = (self._expected_users or 0) - 1
            case Left(user):
                self._users.pop(user, None)
                if not self._has_peers():
                    self._round_trips.forget()
        self._inbox.add(frame)
        if isinstance(frame, Posed) and frame.pose.is_acknowledged:
            return frames.ack(frame.user, frame.pose.sequence)
        return b""

    def _has_peers(self) -> bool:
        return any(user.group == self._group for user in self._users.values())

    async def _send_when_joined(self, frame: bytes) -> None:
        """Send a frame once the user is in the room; RoomError if the connection is broken or has ended."""
        self._check_end()
        await self._is_ready.wait()
        self._check_end()
        if self._connection is not None:
            await self._connection.send(frame)

    def _check_end(self) -> None:
        if not self._was_entered:
            raise _not_joined_error()
        if self._end is not None:
            raise RoomError(self._end.reason, self._end.sentence)


def _not_joined_error() -> RoomError:
    return RoomError("unreached", "expected a user who has joined the room with `async with`")


def _payload(data: Payload, max_bytes: int) -> bytes:
    if not isinstance(data, bytes | bytearray | memoryview):
        raise TypeError(f"data: expected bytes, such as text.encode() makes, got {check.type_and_value(data)}")
    payload = bytes(data)
    if len(payload) > max_bytes:
        raise ValueError(f"data: expected at most {max_bytes:,} bytes, got {len(payload):,}")
    return payload
