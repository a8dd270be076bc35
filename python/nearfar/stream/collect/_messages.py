"""Binary messages of the sphere collection, sent as payloads of a room; docs/collect.md specifies every field."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TypeAlias

from nearfar._base.errors import FormatError
from nearfar.stream._room_events import To

Vector: TypeAlias = tuple[float, float, float]

MARK, VERSION = 0xC5, 1
"""First byte of all messages of the task, and their format version."""

FARTHEST, FASTEST, LARGEST, LONGEST = 1e6, 100.0, 1000.0, 86_400.0
"""Greatest coordinate, speed, radius and time, in metres and seconds."""

MAX_USERS, MAX_TRIALS = 64, 255
"""Greatest number of seated users in a group, and of trials."""

LEVELS = ("easy", "intermediate", "hard")
"""Names of the levels, in the order of their codes."""

EVENTS = ("told", "selected", "lost")
"""Reasons for an `Aims` message, in the order of their codes; `told` for all reasons without an event."""

_STAGE = struct.Struct("<HB")
_TRIAL = struct.Struct("<BBBI21f")
_TALLY = struct.Struct("<HHf")
_SEAT = struct.Struct("<H3f")
_SPHERE = struct.Struct("<HB7f")
_AIMS = struct.Struct("<HBHHf")
_COLLECTED = struct.Struct("<HBHf")
_SCORE = struct.Struct("<BHH")


@dataclass(frozen=True)
class Seat:
    """Seat of a user."""

    user: int
    position: Vector
    """Position of the eyes, metres from the scene's origin."""


@dataclass(frozen=True)
class Tally:
    """Totals of the collected spheres of a level."""

    spheres: int = 0
    misses: int = 0
    seconds: float = 0.0
    """Sum of the times from appearance to collection."""


@dataclass(frozen=True)
class Stage:
    """Run and trial that a message belongs to; a group's next run has a greater number."""

    run: int
    trial: int


@dataclass(frozen=True)
class Trial:
    """A trial: its rules, elapsed time and results."""

    stage: Stage
    trials: int
    is_over: bool
    users: int
    seed: int
    elapsed: float
    """Seconds since its start."""
    duration: float
    hold: float
    pause: float
    rest: float
    radius: float
    speeds: Vector
    box: tuple[Vector, Vector]
    """Least and greatest coordinates of sphere centres."""
    area: tuple[Vector, Vector]
    """Least and greatest coordinates of seats."""
    tallies: tuple[Tally, Tally, Tally]
    """Tallies by level."""
    seats: tuple[Seat, ...]


@dataclass(frozen=True)
class Sphere:
    """A sphere appeared `age` seconds ago with a position and a velocity; it is reflected at the faces of its box."""

    stage: Stage
    number: int
    level: int
    age: float
    position: Vector
    velocity: Vector


@dataclass(frozen=True)
class Aims:
    """Users who aim at a sphere, sent when a user selects or loses it, or for another reason (`told`)."""

    stage: Stage
    number: int
    event: str
    user: int
    misses: int
    """Misses of this sphere."""
    held: float | None
    """Seconds for which all required users have aimed at it; None while some do not."""
    users: tuple[int, ...]


@dataclass(frozen=True)
class Collected:
    """A sphere has been collected."""

    stage: Stage
    number: int
    level: int
    misses: int
    seconds: float
    """Seconds since it appeared."""


@dataclass(frozen=True)
class Score:
    """Score of the sender's group, sent to the whole room."""

    stage: Stage
    is_over: bool
    spheres: int
    misses: int


Message: TypeAlias = Trial | Sphere | Aims | Collected | Score


def audience(message: Message) -> To:
    """Return the recipients of a message: the room for scores, else the group."""
    return "room" if isinstance(message, Score) else "group"


def write(message: Message) -> bytes:
    """Encode a message."""
    kind, body = _body(message)
    return bytes([MARK, VERSION, kind]) + _STAGE.pack(message.stage.run, message.stage.trial) + body


def read(data: bytes) -> Message | None:
    """Decode a payload; None if it is not a message of the task, FormatError for a damaged message."""
    if not data or data[0] != MARK:
        return None
    try:
        if data[1] != VERSION:
            raise _fault(f"expected version {VERSION}, got {data[1]}")
        stage = Stage(*_STAGE.unpack_from(data, 3))
        return _READERS[data[2]](stage, data[3 + _STAGE.size :])
    except (struct.error, IndexError, KeyError):
        raise _fault("its length or a number in it is wrong") from None


def _body(message: Message) -> tuple[int, bytes]:
    match message:
        case Trial():
            return 1, _trial_bytes(message)
        case Sphere(_, number, level, age, position, velocity):
            return 2, _SPHERE.pack(number, level, age, *position, *velocity)
        case Aims(_, number, event, user, misses, held, users):
            head = _AIMS.pack(number, EVENTS.index(event), user, misses, -1.0 if held is None else held)
            return 3, head + bytes([len(users)]) + struct.pack(f"<{len(users)}H", *users)
        case Collected(_, number, level, misses, seconds):
            return 4, _COLLECTED.pack(number, level, misses, seconds)
        case Score(_, is_over, spheres, misses):
            return 5, _SCORE.pack(is_over, spheres, misses)


def _trial_bytes(trial: Trial) -> bytes:
    corners = [value for corner in (*trial.box, *trial.area) for value in corner]
    times = (trial.elapsed, trial.duration, trial.hold, trial.pause, trial.rest, trial.radius)
    head = _TRIAL.pack(trial.trials, trial.is_over, trial.users, trial.seed, *times, *trial.speeds, *corners)
    tallies = b"".join(_TALLY.pack(tally.spheres, tally.misses, tally.seconds) for tally in trial.tallies)
    seats = b"".join(_SEAT.pack(seat.user, *seat.position) for seat in trial.seats)
    return head + tallies + bytes([len(trial.seats)]) + seats


def _read_trial(stage: Stage, body: bytes) -> Trial:
    trials, over, users, seed, *rest = _TRIAL.unpack_from(body)
    at = _TRIAL.size
    tallies = []
    for _ in LEVELS:
        spheres, misses, seconds = _TALLY.unpack_from(body, at)
        tallies.append(Tally(spheres, misses, *_check_range((seconds,), 0.0, LONGEST)))
        at += _TALLY.size
    count, at = body[at], at + 1
    _is_whole(body, at + count * _SEAT.size)
    seats = []
    for place in range(count):
        user, *position = _SEAT.unpack_from(body, at + place * _SEAT.size)
        seats.append(Seat(user, _vector(position)))
    if count > MAX_USERS or not 1 <= users <= MAX_USERS or not 1 <= stage.trial <= trials or over > 1:
        raise _fault("a number of users or trials is none that there can be")
    elapsed, duration, hold, pause, between = _check_range(rest[:5], 0.0, LONGEST)
    (radius,) = _check_range(rest[5:6], 0.0, LARGEST)
    if radius == 0.0 or duration == 0.0:
        raise _fault("a sphere has no size, or the trial no time")
    slow, middle, fast = _check_range(rest[6:9], 0.0, FASTEST)
    box, area = ((_vector(rest[n : n + 3]), _vector(rest[n + 3 : n + 6])) for n in (9, 15))
    if any(low > high for least, most in (box, area) for low, high in zip(least, most, strict=True)):
        raise _fault("a box ends before it begins")
    return Trial(
        stage, trials, bool(over), users, seed, elapsed, duration, hold, pause, between, radius,
        (slow, middle, fast), box, area, (tallies[0], tallies[1], tallies[2]), tuple(seats),
    )  # fmt: skip


def _read_sphere(stage: Stage, body: bytes) -> Sphere:
    _is_whole(body, _SPHERE.size)
    number, level, age, *rest = _SPHERE.unpack(body)
    (passed,) = _check_range((age,), 0.0, LONGEST)
    return Sphere(stage, number, _level(level), passed, _vector(rest[:3]), _vector(rest[3:], FASTEST))


def _read_aims(stage: Stage, body: bytes) -> Aims:
    number, event, user, misses, held = _AIMS.unpack_from(body)
    count = body[_AIMS.size]
    _is_whole(body, _AIMS.size + 1 + 2 * count)
    users = struct.unpack_from(f"<{count}H", body, _AIMS.size + 1)
    if list(users) != sorted(set(users)) or count > MAX_USERS:
        raise _fault("who aims is not in order")
    time = None if held == -1.0 else _check_range((held,), 0.0, LONGEST)[0]
    return Aims(stage, number, EVENTS[event], user, misses, time, users)


def _read_collected(stage: Stage, body: bytes) -> Collected:
    _is_whole(body, _COLLECTED.size)
    number, level, misses, seconds = _COLLECTED.unpack(body)
    return Collected(stage, number, _level(level), misses, *_check_range((seconds,), 0.0, LONGEST))


def _read_score(stage: Stage, body: bytes) -> Score:
    _is_whole(body, _SCORE.size)
    over, spheres, misses = _SCORE.unpack(body)
    if over > 1:
        raise _fault("a trial is over or not")
    return Score(stage, bool(over), spheres, misses)


_READERS: dict[int, Callable[[Stage, bytes], Message]] = {
    1: _read_trial,
    2: _read_sphere,
    3: _read_aims,
    4: _read_collected,
    5: _read_score,
}


def _level(number: int) -> int:
    if number >= len(LEVELS):
        raise _fault("there is no such level")
    return number


def _vector(values: Iterable[float], most: float = FARTHEST) -> Vector:
    x, y, z = _check_range(values, -most, most)
    return x, y, z


def _check_range(values: Iterable[float], low: float, high: float) -> list[float]:
    found = list(values)
    # NaN fails the comparison.
    if not all(low <= value <= high for value in found) or not all(map(math.isfinite, found)):
        raise _fault("a number is out of its range")
    return found


def _is_whole(body: bytes, size: int) -> None:
    if len(body) != size:
        raise _fault("its length is wrong")


def _fault(sentence: str) -> FormatError:
    return FormatError(f"expected a message of the sphere collection: {sentence}")
