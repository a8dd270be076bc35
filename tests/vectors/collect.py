"""Vectors of the sphere collection: bytes of its messages, positions of its spheres, and messages of its conductor."""

from __future__ import annotations

import math
import struct
from typing import Any

from tests.vectors.exact import document, single
from tests.vectors.rooms import little

STAGE = {"run": 2, "trial": 1}
RULES: dict[str, Any] = {
    "trials": 3, "over": False, "users": 4, "seed": 7, "elapsed": 1.5, "duration": 180.0, "hold": 2.0,
    "pause": single(1.65), "rest": 5.0, "radius": single(0.3), "speeds": [0.0, 0.5, 1.5],
    "box": [[-4.0, 0.25, -10.0], [4.0, 4.25, -6.0]], "area": [[-2.5, 1.75, -1.0], [2.5, 1.75, 1.0]],
    "tallies": [[1, 0, 4.5], [0, 0, 0.0], [2, 9, 12.25]],
}  # fmt: skip
"""A trial, without its seats."""

SEATS = [{"user": 3, "position": [-1.5, 1.75, 0.5]}, {"user": 513, "position": [2.0, 1.75, -1.0]}]
EVENTS = ("told", "selected", "lost")
LEVELS = ("easy", "intermediate", "hard")


def floats(*values: float) -> bytes:
    """Numbers of 4 bytes."""
    return struct.pack(f"<{len(values)}f", *values)


def stage(kind: int, fields: dict[str, Any]) -> bytes:
    """The header of a message."""
    return bytes([0xC5, 1, kind]) + little(fields["run"], 2) + little(fields["trial"], 1)


def trial(fields: dict[str, Any]) -> bytes:
    """A trial and its seats."""
    data = stage(1, fields) + little(fields["trials"], 1) + little(fields["over"], 1) + little(fields["users"], 1)
    data += little(fields["seed"], 4)
    data += floats(*(fields[name] for name in ("elapsed", "duration", "hold", "pause", "rest", "radius")))
    data += floats(*fields["speeds"], *fields["box"][0], *fields["box"][1], *fields["area"][0], *fields["area"][1])
    for spheres, misses, seconds in fields["tallies"]:
        data += little(spheres, 2) + little(misses, 2) + floats(seconds)
    seats = b"".join(little(seat["user"], 2) + floats(*seat["position"]) for seat in fields["seats"])
    return data + little(len(fields["seats"]), 1) + seats


def sphere(fields: dict[str, Any]) -> bytes:
    """A sphere."""
    data = stage(2, fields) + little(fields["number"], 2) + little(LEVELS.index(fields["level"]), 1)
    return data + floats(fields["age"], *fields["position"], *fields["velocity"])


def aims(fields: dict[str, Any]) -> bytes:
    """A list of aiming users."""
    data = stage(3, fields) + little(fields["number"], 2) + little(EVENTS.index(fields["event"]), 1)
    data += little(fields["user"], 2) + little(fields["misses"], 2)
    data += floats(-1.0 if fields["held"] is None else fields["held"]) + little(len(fields["users"]), 1)
    return data + b"".join(little(user, 2) for user in fields["users"])


def collected(fields: dict[str, Any]) -> bytes:
    """A collected sphere."""
    data = stage(4, fields) + little(fields["number"], 2) + little(LEVELS.index(fields["level"]), 1)
    return data + little(fields["misses"], 2) + floats(fields["seconds"])


def score(fields: dict[str, Any]) -> bytes:
    """A score."""
    data = stage(5, fields) + little(fields["over"], 1)
    return data + little(fields["spheres"], 2) + little(fields["misses"], 2)


WRITE = {"trial": trial, "sphere": sphere, "aims": aims, "collected": collected, "score": score}
MOVING = {"age": 0.75, "position": [1.0, 2.5, -7.0], "velocity": [0.5, -0.25, 1.25]}
MESSAGES: dict[str, dict[str, Any]] = {
    "a trial with two seats": {"kind": "trial", **STAGE, **RULES, "seats": SEATS},
    "a trial that is over, without seats": {"kind": "trial", **STAGE, **RULES, "over": True, "seats": []},
    "a sphere": {"kind": "sphere", **STAGE, "number": 4, "level": "hard", **MOVING},
    "a user selects": {
        "kind": "aims", **STAGE, "number": 4, "event": "selected", "user": 513, "misses": 3, "held": None,
        "users": [3, 513],
    },
    "all aim": {
        "kind": "aims", **STAGE, "number": 4, "event": "told", "user": 0, "misses": 3, "held": 1.25, "users": [3],
    },
    "a miss, after which nobody aims": {
        "kind": "aims", **STAGE, "number": 65535, "event": "lost", "user": 3, "misses": 65535, "held": None,
        "users": [],
    },
    "collected": {"kind": "collected", **STAGE, "number": 4, "level": "intermediate", "misses": 2, "seconds": 4.375},
    "a score": {"kind": "score", **STAGE, "over": True, "spheres": 26, "misses": 70},
}  # fmt: skip


def malformed_messages() -> dict[str, bytes]:
    """Bytes that begin like a message and are malformed."""
    good = {name: WRITE[fields["kind"]](fields) for name, fields in MESSAGES.items()}
    whole = {"kind": "trial", **STAGE, **RULES, "seats": SEATS}
    moving = {**STAGE, "number": 4, "level": "hard", **MOVING}
    first, nan = good["a trial with two seats"], float("nan")
    return {
        "nothing but the mark": first[:1],
        "another version": first[:1] + b"\x02" + first[2:],
        "a kind that there is not": first[:2] + b"\x06" + first[3:],
        "a trial without its end": first[:-1],
        "a trial that goes on": first + b"\x00",
        "a trial beyond the last": trial({**whole, "trial": 4}),
        "a trial of no users": trial({**whole, "users": 0}),
        "a trial of no time": trial({**whole, "duration": 0.0}),
        "spheres of no size": trial({**whole, "radius": 0.0}),
        "a box that ends before it begins": trial({**whole, "box": whole["box"][::-1]}),
        "a seat that is no place": trial({**whole, "seats": [{"user": 3, "position": [nan, 0.0, 0.0]}]}),
        "a time below 0": trial({**whole, "elapsed": -1.0}),
        "a sphere that goes on": good["a sphere"] + b"\x00",
        "a sphere of no level": good["a sphere"][:8] + b"\x03" + good["a sphere"][9:],
        "a sphere that is too fast": sphere({**moving, "velocity": [0.0, 101.0, 0.0]}),
        "a sphere that is nowhere": sphere({**moving, "position": [0.0, math.inf, 0.0]}),
        "users in disorder": aims({**MESSAGES["a user selects"], "users": [513, 3]}),
        "an event that there is not": good["all aim"][:8] + b"\x03" + good["all aim"][9:],
        "fewer users than are counted": good["all aim"][:-1],
        "collected in no time": collected({**MESSAGES["collected"], "seconds": nan}),
        "a score that goes on": good["a score"] + b"\x00",
        "a trial that is neither over nor not": good["a score"][:6] + b"\x02" + good["a score"][7:],
    }


# places of spheres and seats --------------------------------------------------------------------------------------
WORD = 2**64 - 1


def mixed(value: int) -> int:
    """SplitMix64's finaliser."""
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9 & WORD
    value = (value ^ (value >> 27)) * 0x94D049BB133111EB & WORD
    return value ^ (value >> 31)


def uniform(seed: int, cell: int, index: int) -> float:
    """A number in [0, 1) by docs/base.md."""
    golden = 0x9E3779B97F4A7C15
    state = mixed(seed + golden & WORD)
    for word in (cell, index):
        state = mixed((state ^ word) + golden & WORD)
    return (state >> 11) / 2**53


def places() -> list[dict[str, Any]]:
    """Spheres and seats of some groups, trials and numbers."""
    found = []
    for group, run, number_of_trial, number in ((0, 1, 1, 0), (1, 2, 1, 1), (65535, 65535, 3, 500)):
        cell = group << 24 | run << 8 | number_of_trial
        draws = [uniform(RULES["seed"], cell, 8 * number + n) for n in range(5)]
        least, greatest = RULES["box"]
        level = (0, 2, 1)[number % 3]
        speed, up, turn = RULES["speeds"][level], 2 * draws[3] - 1, 2 * math.pi * draws[4]
        across = math.sqrt(1 - up * up)
        seat = [uniform(RULES["seed"], cell, 2**32 + n) for n in range(2)]
        west, height, north, east, _, south = (value for corner in RULES["area"] for value in corner)
        found.append({
            "region": f"sphere {number} of trial {number_of_trial} of run {run} of group {group}",
            "group": group, "run": run, "trial": number_of_trial, "number": number, "level": LEVELS[level],
            "position": [low + share * (high - low) for low, high, share in zip(least, greatest, draws, strict=False)],
            "velocity": [speed * across * math.cos(turn), speed * up, speed * across * math.sin(turn)],
            "seat": [west + seat[0] * (east - west), height, north + seat[1] * (south - north)],
        })  # fmt: skip
    return found


# a play -----------------------------------------------------------------------------------------------------------
def plays() -> list[dict[str, Any]]:
    """Messages of users who receive each other's at once. In each step some join, leave or aim at the sphere."""

    def step(now: float, aiming: list[int], *said: str, comes: int | None = None, goes: int | None = None) -> Any:
        return {"now": now, "comes": comes, "goes": goes, "aiming": aiming, "said": list(said)}

    return [
        {
            "region": "misses, a late user, and another conductor",
            "rules": {"users": 2, "trials": 2, "duration": 5.0, "hold": 1.0, "pause": 0.5, "rest": 1.0},
            "group": 5,
            "users": [3, 7],
            "steps": [
                step(0.0, [], "3: trial 1", "3: score 0 0", "3: sphere 0 easy"),
                step(0.5, [3], "3: selected 3"),
                step(1.0, [3, 7], "3: selected 7, held 0"),
                step(1.5, [7], "3: lost 3, 1 missed"),
                step(1.75, [3, 7], "3: selected 3, held 0"),
                step(2.5, [3, 7]),
                step(2.75, [3, 7], "3: collected 0 easy, 1 missed, 2.75 s", "3: score 1 1"),
                step(3.0, [3, 7]),
                step(3.25, [], "3: sphere 1 hard"),
                step(3.375, [3], "3: selected 3"),
                # A late user receives everything, has no seat, and so does not conduct, even with the lowest number.
                step(3.5, [3], "3: trial 1", "3: sphere 1 hard", "3: told [3]", comes=2),
                # A user who leaves has missed nothing, and one of two does not collect alone.
                step(3.75, [2, 7], "7: told [], 0 missed", "7: selected 7", goes=3),
                step(4.875, [2, 7]),
                step(5.0, [7], "7: over 1", "7: score 1 1"),
                step(5.75, []),
                step(6.0, [], "7: trial 2", "7: score 0 0", "2: sphere 0 easy"),
                step(6.5, [2, 7], "2: selected 2", "2: selected 7, held 0"),
                step(7.5, [2, 7], "2: collected 0 easy, 0 missed, 1.5 s", "2: score 1 0"),
                step(11.0, [], "2: over 2", "2: score 1 0"),
                step(20.0, [2, 7]),
            ],
        }
    ]


# state derived by a user ------------------------------------------------------------------------------------------
def hearings() -> list[dict[str, Any]]:
    """Messages that a user receives, whether each changes the state, and the user's own messages at the end."""
    seats = [{"user": user, "position": [0.0, 1.75, 0.0]} for user in (3, 7, 9)]
    nothing = [[0, 0, 0.0]] * 3
    rules = {**RULES, "elapsed": 0.0, "users": 1, "hold": 0.0, "radius": 1000.0, "tallies": nothing}

    def playing(**changed: Any) -> dict[str, Any]:
        return {"kind": "trial", **STAGE, **rules, "seats": seats, **changed}

    def appears(number: int) -> dict[str, Any]:
        return {"kind": "sphere", **STAGE, "number": number, "level": "easy", **MOVING, "age": 0.0}

    def step(now: float, sender: int, message: dict[str, Any], *, taken: bool, returns: bool = False) -> Any:
        return {"now": now, "returns": returns, "sender": sender, "message": message, "taken": taken}

    def case(region: str, user: int, others: list[int], end: float, said: list[str], *steps: Any) -> dict[str, Any]:
        return {"region": region, "group": 5, "user": user, "others": others, "steps": steps, "now": end, "said": said}

    own = {"seats": seats[:1]}
    aiming: dict[str, Any] = {
        "kind": "aims", **STAGE, "number": 0, "event": "lost", "user": 3, "misses": 9, "held": None, "users": [],
    }  # fmt: skip
    found = {"kind": "collected", **STAGE, "number": 0, "level": "easy", "misses": 0, "seconds": 0.5}
    counted = [[4, 0, 8.0], *nothing[1:]]
    return [
        case(
            "a sphere that could not be collected", 3, [7], 0.5,
            ["3: sphere 0 easy", "3: selected 3, held 0", "3: collected 0 easy, 0 missed, 0 s", "3: score 1 0"],
            step(0.0, 7, playing(**own), taken=True),
            step(0.0, 7, appears(65535), taken=False),
            step(0.0, 7, appears(1), taken=False),
        ),
        case(
            "as many spheres as can be counted", 3, [7], 0.5, [],
            step(0.0, 7, playing(**own), taken=True),
            step(0.0, 7, appears(0), taken=True),
            step(0.0, 7, playing(**own, tallies=[[65535, 0, 1.0], *nothing[1:]]), taken=True),
            step(0.0, 7, appears(65535), taken=False),
        ),
        case(
            "a user who does not conduct speaks as if it did", 7, [3, 9], 8.0, [],
            step(0.0, 3, playing(), taken=True),
            step(6.0, 9, appears(0), taken=False),
            step(6.0, 3, appears(0), taken=True),
            step(6.0, 9, aiming, taken=False),
            step(6.0, 9, found, taken=False),
            step(6.0, 9, playing(run=3), taken=False),
            step(6.0, 3, found, taken=True),
            step(6.0, 3, playing(run=3), taken=True),
        ),
        case(
            "the conductor returns in the pause after its sphere", 3, [7, 9], 24.0,
            ["3: trial 1", "3: sphere 4 hard"],
            step(0.0, 7, playing(radius=RULES["radius"], tallies=[[3, 0, 6.0], *nothing[1:]]), taken=True),
            step(0.0, 7, appears(3), taken=True),
            step(20.0, 7, playing(radius=RULES["radius"], elapsed=20.0, tallies=counted), taken=True, returns=True),
        ),
        case(
            "after the greatest number of a run comes 0", 7, [3], 8.0, [],
            step(0.0, 3, playing(run=65535), taken=True),
            step(0.0, 3, playing(run=65534), taken=False),
            step(0.0, 3, playing(run=0), taken=True),
            step(0.0, 3, playing(run=65535), taken=False),
        ),
    ]  # fmt: skip


def files() -> dict[str, str]:
    """The file's text by its name."""
    text = document(
        holds="The sphere collection, version 1: messages, places, what a conductor says and what a user believes.",
        units="metres, seconds; bytes hexadecimal. Places follow from the rules of the first message.",
        source="docs/collect.md.",
        tolerance={
            "messages": "None: what is read has these fields, and what is written has these bytes.",
            "places": "1e-12, which sines and cosines may be off by.",
            "plays": "None; times are sums of powers of two.",
            "hearings": "None.",
        },
        messages=[
            {"region": name, "message": fields, "bytes": WRITE[fields["kind"]](fields).hex()}
            for name, fields in MESSAGES.items()
        ],
        refused=[{"region": name, "bytes": data.hex()} for name, data in malformed_messages().items()],
        places=places(),
        plays=plays(),
        hearings=hearings(),
    )
    return {"collect.json": text}
