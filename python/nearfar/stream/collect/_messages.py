"""Binary messages of the sphere collection, sent as payloads of a room; docs/collect.md specifies every field."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from dataclasses import dataclass

from nearfar._base.errors import FormatError
from nearfar.stream._room_events import To

Vector = tuple[float, float, float]

MARK, VERSION = 0xC5, 1
"""First byte of all messages of the task, and their format version."""

MAX_COORDINATE, MAX_SPEED, MAX_RADIUS, MAX_SECONDS = 1e6, 100.0, 1000.0, 86_400.0
"""Greatest coordinate, speed, radius and time, in metres and seconds."""

MAX_USERS, MAX_TRIALS = 64, 255
"""Greatest number of seated users in a group, and of trials."""

LEVELS = ("easy", "intermediate", "hard")
"""Names of the levels, in the order of their codes."""

EVENTS = ("told", "selected", "lost")
"""Events of an `Aims` message, in the order of their codes; `told` if it only states who aims."""

_FLAGS = (False, True)
"""Flags, in the order of their codes."""

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
    """Run and trial of a message; run numbers of a group increase."""

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
    """A sphere that appeared `age` seconds ago with this position and velocity; the faces of its box reflect it."""

    stage: Stage
    number: int
    level: int
    age: float
    position: Vector
    velocity: Vector


@dataclass(frozen=True)
class Aims:
    """Users who aim at a sphere; sent when a user selects or loses it, or without an event (`told`)."""

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


Message = Trial | Sphere | Aims | Collected | Score


def audience(message: Message) -> To:
    """Return the recipients of a message: the room for scores, else the group."""
    return "room" if isinstance(message, Score) else "group"


def write(message: Message) -> bytes:
    kind, body = _body(message)
    return bytes([MARK, VERSION, kind]) + _STAGE.pack(message.stage.run, message.stage.trial) + body


def read(data: bytes) -> Message | None:
    """Decode a payload; None if it is not a message of the task, FormatError for a damaged message."""
    if not data or data[0] != MARK:
        return None
    try:
        if data[1] != VERSION:
            raise _fault(f"expected version {VERSION}, got {data[1]}")
        return _read_body(data[2], Stage(*_STAGE.unpack_from(data, 3)), data[3 + _STAGE.size :])
    except (struct.error, IndexError):
        raise _fault("its length or a code in it is wrong") from None


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


def _read_body(kind: int, stage: Stage, body: bytes) -> Message:
    match kind:
        case 1:
            return _read_trial(stage, body)
        case 2:
            number, level, age, *vectors = _SPHERE.unpack(body)
            position, velocity = _vector(vectors[:3]), _vector(vectors[3:], MAX_SPEED)
            return Sphere(stage, number, _level(level), _seconds(age), position, velocity)
        case 3:
            return _read_aims(stage, body)
        case 4:
            number, level, misses, seconds = _COLLECTED.unpack(body)
            return Collected(stage, number, _level(level), misses, _seconds(seconds))
        case 5:
            over, spheres, misses = _SCORE.unpack(body)
            return Score(stage, _FLAGS[over], spheres, misses)
    raise _fault(f"a message has the unknown kind {kind}")


def _read_trial(stage: Stage, body: bytes) -> Trial:
    trials, over, users, seed, *numbers = _TRIAL.unpack_from(body)
    offset = _TRIAL.size + len(LEVELS) * _TALLY.size
    tallies = [Tally(n, misses, _seconds(time)) for n, misses, time in _TALLY.iter_unpack(body[_TRIAL.size : offset])]
    if len(body) != offset + 1 + body[offset] * _SEAT.size:
        raise _fault("its length is wrong")
    seats = tuple(Seat(user, _vector(position)) for user, *position in _SEAT.iter_unpack(body[offset + 1 :]))
    if len(seats) > MAX_USERS or not 1 <= users <= MAX_USERS or not 1 <= stage.trial <= trials:
        raise _fault("a number of users or trials is out of its range")
    elapsed, duration, hold, pause, rest = map(_seconds, numbers[:5])
    radius = _check_range(numbers[5], 0.0, MAX_RADIUS)
    if radius == 0.0 or duration == 0.0:
        raise _fault("a sphere has radius 0, or a trial duration 0")
    slow, middle, fast = (_check_range(speed, 0.0, MAX_SPEED) for speed in numbers[6:9])
    box, area = ((_vector(numbers[n : n + 3]), _vector(numbers[n + 3 : n + 6])) for n in (9, 15))
    if any(low > high for least, greatest in (box, area) for low, high in zip(least, greatest, strict=True)):
        raise _fault("a box has a least coordinate above its greatest one")
    return Trial(
        stage, trials, _FLAGS[over], users, seed, elapsed, duration, hold, pause, rest, radius,
        (slow, middle, fast), box, area, (tallies[0], tallies[1], tallies[2]), seats,
    )  # fmt: skip


def _read_aims(stage: Stage, body: bytes) -> Aims:
    number, event, user, misses, held = _AIMS.unpack_from(body)
    count = body[_AIMS.size]
    users = struct.unpack(f"<{count}H", body[_AIMS.size + 1 :])
    if list(users) != sorted(set(users)) or count > MAX_USERS:
        raise _fault("the users who aim are not in ascending order")
    return Aims(stage, number, EVENTS[event], user, misses, None if held == -1.0 else _seconds(held), users)


def _level(number: int) -> int:
    if number >= len(LEVELS):
        raise _fault(f"there is no level {number}")
    return number


def _vector(values: Iterable[float], greatest: float = MAX_COORDINATE) -> Vector:
    x, y, z = (_check_range(value, -greatest, greatest) for value in values)
    return x, y, z


def _seconds(value: float) -> float:
    return _check_range(value, 0.0, MAX_SECONDS)


def _check_range(value: float, low: float, high: float) -> float:
    # NaN fails the comparison.
    if not low <= value <= high:
        raise _fault("a number is out of its range")
    return value


def _fault(sentence: str) -> FormatError:
    return FormatError(f"expected a message of the sphere collection: {sentence}")
