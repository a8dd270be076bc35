"""A simulated user of the task in a room of a real server."""

from __future__ import annotations

import asyncio
import math
from contextlib import suppress

import numpy as np

from nearfar._base import check
from nearfar._base.errors import FormatError
from nearfar._camera.camera import viewing_direction
from nearfar.stream._room import Room
from nearfar.stream._room_events import Ended, Event, Joined, Left, Pose, Posed, RoomError, Said
from nearfar.stream.collect._messages import audience, read, write
from nearfar.stream.collect._person import Person, Pointing
from nearfar.stream.collect._settings import Settings
from nearfar.stream.collect._simulate import RATE, Outcome, outcomes, stance_of
from nearfar.stream.collect._spheres import Ray
from nearfar.stream.collect._task import Task

MEASUREMENT_INTERVAL = 0.25
"""Seconds between poses whose round-trip time is measured."""


async def play(
    room: Room, settings: Settings | None = None, *, person: Person | None = None, seed: int = 0
) -> list[Outcome]:
    """Let a simulated user take part in its group's run, in real time, until the last trial has ended.

    The user with the lowest number in its group conducts the run and starts it when `settings.users` are present. Users
    of the web page in the same group take part. Returns the results of the group's trials, as far as the user has
    received them. RoomError if the connection ends for good before the run does.

    Parameters
    ----------
    room
        The user's connection to a room, already entered. `play` consumes its events.
    settings
        Settings of the task, if this user conducts it; by default the published ones.
    person
        Parameters of the user; by default those of the literature.
    seed
        Seed of the user's random numbers, 0 to 2³² − 1.
    """
    check.instance("room", room, Room)
    rules = Settings() if settings is None else check.instance("settings", settings, Settings)
    people = Person() if person is None else check.instance("person", person, Person)
    user = _User(room, rules, people, check.integer("seed", seed, 0, 2**32 - 1))
    hearing = asyncio.create_task(user.hear())
    moving = asyncio.create_task(user.move())
    try:
        await asyncio.wait((hearing, moving), return_when=asyncio.FIRST_COMPLETED)
        if moving.done():
            moving.result()
        else:
            hearing.result()
    finally:
        for task in (hearing, moving):
            task.cancel()
        await asyncio.wait((hearing, moving))
    return outcomes(user.task)


class _User:
    def __init__(self, room: Room, settings: Settings, person: Person, seed: int) -> None:
        self._room, self._settings, self._person, self._seed = room, settings, person, seed
        self._order = asyncio.Lock()
        self._clock = asyncio.get_running_loop().time
        self._begin()

    def _begin(self) -> None:
        """Reset the task's state and register all users in the group."""
        room = self._room
        self.task = Task(room.user, room.group)
        self._pointing = Pointing(self._person, self._seed, room.user)
        self._rays: dict[int, Ray] = {}
        # Greatest sequence number received from each user: datagrams can overtake each other and the stream.
        self._newest: dict[int, int] = {}
        # Groups of the other users when the processed event happened; `room.users` may already be newer.
        self._groups = {number: other.group for number, other in room.users.items()}
        for number, group in self._groups.items():
            if group == room.group:
                self.task.add_user(number)

    async def hear(self) -> None:
        """Process events until the last trial or the connection has ended."""
        async for event in self._room:
            if self._room.user != self.task.user:
                # A new user number means a new user, so all state is reset.
                self._begin()
            self._follow(event)
            await self._conduct()
            if isinstance(event, Ended) and not event.returns:
                raise RoomError(event.reason, event.sentence)

    async def move(self) -> None:
        """Send poses until the run is over."""
        measurement_time, due = -math.inf, self._clock()
        while not self.task.is_over:
            now = self._clock()
            stance = stance_of(self._pointing, self.task, now)
            if stance is not None:
                self._rays[self.task.user] = stance.ray
                is_measured = now - measurement_time >= MEASUREMENT_INTERVAL
                measurement_time = now if is_measured else measurement_time
                await self._room.pose(
                    stance.eyes,
                    stance.rotation,
                    right=(stance.hand, stance.rotation),
                    pointer=("right", stance.length),
                    acknowledged=is_measured,
                )
            await self._conduct()
            # A late step does not delay the following ones; steps missed in a pause are skipped.
            due = max(due + 1.0 / RATE, now)
            await asyncio.sleep(due - self._clock())

    async def _conduct(self) -> None:
        # Messages are sent in the order of the state changes.
        async with self._order:
            if not self._room.is_connected:
                return
            now, task = self._clock(), self.task
            messages = task.conduct(now, self._rays)
            if task.trial is None and task.conductor == task.user and len(task.present) >= self._settings.users:
                messages += task.start(self._settings, now)
            # The next conductor continues from its own state; the broken connection is reported as an event.
            with suppress(RoomError):
                for message in messages:
                    await self._room.say(write(message), to=audience(message))

    def _follow(self, event: Event) -> None:
        match event:
            case Joined(user, _, group):
                self._newest.pop(user, None)
                self._groups[user] = group
                if group == self._room.group and user not in self.task.present:
                    self.task.add_user(user)
            case Left(user):
                self.task.remove_user(user)
                self._groups.pop(user, None)
                self.task.forget_scores({self.task.group, *self._groups.values()})
                self._rays.pop(user, None)
                self._newest.pop(user, None)
            case Ended():
                self.task.forget_users()
                self._groups.clear()
                self._rays.clear()
                self._newest.clear()
            case Posed(user, pose):
                if user in self.task.present and pose.sequence > self._newest.get(user, -1):
                    self._newest[user] = pose.sequence
                    self._see(user, pose)
            case Said(user, data) if user in self._groups:
                # Malformed messages are ignored.
                with suppress(FormatError):
                    message = read(data)
                    if message is not None:
                        self.task.hear(message, self._clock(), sender=user, group=self._groups[user])

    def _see(self, user: int, pose: Pose) -> None:
        placed = None if pose.pointer is None else getattr(pose, pose.pointer.begin)
        if placed is None:
            self._rays.pop(user, None)
            return
        # The length of received quaternions may deviate from 1 by a tenth.
        rotation = placed.rotation / np.linalg.norm(placed.rotation)
        self._rays[user] = tuple(placed.position.tolist()), viewing_direction(tuple(rotation.tolist()))
