"""Vectors of the frames of rooms: their bytes in hexadecimal digits, and their fields by the names of docs/rooms.md."""

from __future__ import annotations

import struct
from typing import Any

from tests.vectors.exact import document, single

TICKET = bytes(range(26))


def little(value: int, size: int) -> bytes:
    """An unsigned integer of a number of bytes, little-endian."""
    return value.to_bytes(size, "little")


def frame(kind: int, body: bytes) -> bytes:
    """A frame with its header."""
    return little(kind, 1) + little(len(body), 2) + body


def with_length(data: bytes) -> bytes:
    """Bytes preceded by their count."""
    return little(len(data), 1) + data


def encode_placed(place: dict[str, Any]) -> bytes:
    """A position and a rotation."""
    floats = b"".join(struct.pack("<f", value) for value in place["position"])
    return floats + b"".join(value.to_bytes(2, "little", signed=True) for value in place["rotation"])


def pose(fields: dict[str, Any]) -> bytes:
    """A pose without its frame."""
    flags = 1 * fields["acknowledged"] + 2 * fields["stops"]
    flags += 4 * (fields["left"] is not None) + 8 * (fields["right"] is not None)
    pointer = fields["pointer"]
    if pointer is not None:
        flags += 16 * {"head": 1, "left": 2, "right": 3}[pointer["begin"]]
    places = [fields[name] for name in ("head", "left", "right") if fields[name] is not None]
    length = b"" if pointer is None else struct.pack("<f", pointer["length"])
    head = little(fields["sequence"], 4) + little(fields["clock"], 8) + little(flags, 1)
    return head + b"".join(map(encode_placed, places)) + length


def _place(x: float, y: float, z: float, *rotation: int) -> dict[str, Any]:
    return {"position": [single(x), single(y), single(z)], "rotation": list(rotation)}


def _pose(sequence: int, **changes: Any) -> dict[str, Any]:
    return {
        "sequence": sequence,
        "clock": 1_500_000,
        "acknowledged": False,
        "stops": False,
        "head": _place(1.0, 1.7, -2.5, 0, 0, 0, 32767),
        "left": None,
        "right": None,
        "pointer": None,
        **changes,
    }


LEFT, RIGHT = _place(-0.2, 1.1, -2.25, 0, 23170, 0, 23170), _place(0.3, 1.2, -2.0, -23170, 0, 1, 23170)
POSES = {
    "a head alone": _pose(1),
    "to be acknowledged, and the last before a rest": _pose(2, acknowledged=True, stops=True),
    "a left hand, at which a pointer of no length begins": _pose(
        3, left=LEFT, pointer={"begin": "left", "length": 0.0}
    ),
    "a right hand, and a pointer from the head": _pose(4, right=RIGHT, pointer={"begin": "head", "length": 3.25}),
    "all fields at their ends": _pose(
        2**32 - 1,
        clock=2**53 - 1,
        acknowledged=True,
        stops=True,
        head=_place(1e6, -1e6, -0.0, -32768, 0, 0, 0),
        left=LEFT,
        right=RIGHT,
        pointer={"begin": "right", "length": 1e6},
    ),
}


def of_users() -> list[dict[str, Any]]:
    """Frames that users send."""
    found = [
        _hello("hello of a first time", 3, "Ada é", b""),
        _hello("hello with a ticket, without a name", 65535, "", TICKET),
        _hello("hello with the longest name", 0, "é" * 32, b""),
        *(
            _case(f"pose: {region}", {"kind": "pose", "pose": fields}, frame(2, pose(fields)))
            for region, fields in POSES.items()
        ),
        _case("ack", {"kind": "ack", "user": 258, "sequence": 0x01020304}, frame(3, bytes([2, 1, 4, 3, 2, 1]))),
    ]
    for to in ("group", "room"):
        said: dict[str, Any] = {"kind": "say", "to": to, "data": b"hit \x00\xff".hex()}
        found.append(_case(f"say to the {to}", said, frame(4, _to(to) + b"hit \x00\xff")))
    found.append(_case("say nothing", {"kind": "say", "to": "group", "data": ""}, frame(4, _to("group"))))
    signal = {"kind": "signal", "user": 513, "data": b"offer".hex()}
    found.append(_case("signal", signal, frame(5, little(513, 2) + b"offer")))
    found.append(_case("bye", {"kind": "bye"}, frame(6, b"")))
    return found


def of_servers() -> list[dict[str, Any]]:
    """Frames that the server sends."""
    fields: dict[str, Any] = {"kind": "welcome", "user": 1, "others": 300, "ticket": TICKET.hex()}
    found = [_case("welcome", fields, frame(129, little(1, 2) + little(300, 2) + with_length(TICKET)))]
    for region, moved in POSES.items():
        fields = {"kind": "pose", "user": 77, "pose": moved}
        found.append(_case(f"pose: {region}", fields, frame(130, little(77, 2) + pose(moved))))
    fields = {"kind": "settled", "sequence": 2**31}
    found.append(_case("settled", fields, frame(131, little(2**31, 4))))
    for to in ("group", "room"):
        fields = {"kind": "say", "user": 5, "to": to, "data": b"score".hex()}
        found.append(_case(f"say to the {to}", fields, frame(132, little(5, 2) + _to(to) + b"score")))
    fields = {"kind": "signal", "user": 65535, "data": b"\x00answer".hex()}
    found.append(_case("signal", fields, frame(133, little(65535, 2) + b"\x00answer")))
    fields = {"kind": "joined", "user": 2, "group": 4, "name": "Grace Hopper ☃"}
    body = little(2, 2) + little(4, 2) + with_length("Grace Hopper ☃".encode())
    found.append(_case("joined", fields, frame(134, body)))
    found.append(_case("left", {"kind": "left", "user": 2}, frame(135, little(2, 2))))
    fields = {"kind": "refused", "reason": 5, "sentence": "expected a room with fewer than 256 users"}
    found.append(_case("refused", fields, frame(136, little(5, 1) + fields["sentence"].encode())))
    return found


def malformed() -> list[dict[str, Any]]:
    """Bytes that are no valid frame of the server; those of a pose are none of a user, either."""
    good = pose(POSES["a head alone"])
    far = pose(_pose(1, head=_place(1.1e6, 0.0, 0.0, 0, 0, 0, 32767)))
    nowhere = good[:13] + struct.pack("<f", float("nan")) + good[17:]
    flat = pose(_pose(1, head=_place(0.0, 0.0, 0.0, 0, 0, 0, 16000)))
    no_hand = good[:12] + bytes([2 * 16]) + good[13:] + struct.pack("<f", 1.0)
    bodies = {
        "a pose that is too short": good[:-1],
        "a pose that is too long": good + b"\x00",
        "a flag without a meaning": good[:12] + bytes([64]) + good[13:],
        "a place that is too far": far,
        "a place that is no number": nowhere,
        "a quaternion of another length": flat,
        "a pointer from a hand that is not there": no_hand,
        "a pointer of a length below 0": pose(_pose(1, pointer={"begin": "head", "length": -1.0})),
    }
    found = [_bytes(region, frame(130, little(77, 2) + body), frame(2, body)) for region, body in bodies.items()]
    for region, server in {
        "a kind that there is not": frame(137, b""),
        "a kind of users": frame(3, bytes(6)),
        "a head that is too short": b"\x87\x02",
        "a body that is too short": b"\x87\x02\x00\x01",
        "left with a body that is too long": frame(135, bytes(3)),
        "a name with a count that is too great": frame(134, bytes(4) + b"\x05Ada"),
        "a name with bytes that are not counted": frame(134, bytes(4) + b"\x02Ada"),
        "a name that is no text": frame(134, bytes(4) + with_length(b"\xff")),
        "said to nobody": frame(132, bytes(2) + b"\x02hit"),
        "said at too great a length": frame(132, bytes(2) + b"\x00" + bytes(4097)),
    }.items():
        found.append(_bytes(region, server, None))
    return found


def _hello(region: str, group: int, name: str, ticket: bytes) -> dict[str, Any]:
    body = b"\x01" + little(group, 2) + with_length(name.encode()) + with_length(ticket)
    return _case(region, {"kind": "hello", "group": group, "name": name, "ticket": ticket.hex()}, frame(1, body))


def _to(to: str) -> bytes:
    return little(("group", "room").index(to), 1)


def _case(region: str, fields: dict[str, Any], data: bytes) -> dict[str, Any]:
    return {"region": region, "frame": fields, "bytes": data.hex()}


def _bytes(region: str, server: bytes, user: bytes | None) -> dict[str, Any]:
    return {"region": region, "server": server.hex(), "user": None if user is None else user.hex()}


def files() -> dict[str, str]:
    """The file's text by its name."""
    text = document(
        holds="Frames of rooms, version 1: their bytes, and their fields by the names of docs/rooms.md.",
        units="metres; rotations (x, y, z, w) in units of 1/32767; clocks in microseconds; bytes and data hexadecimal.",
        source="docs/rooms.md.",
        tolerance={"all": "None: what is read has these fields, and what is written has these bytes."},
        users=of_users(),
        servers=of_servers(),
        refused=malformed(),
    )
    return {"rooms.json": text}
