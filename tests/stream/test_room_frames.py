"""Frames of rooms: bytes and fields equal the vectors of all languages."""

from __future__ import annotations

import dataclasses
from contextlib import suppress
from typing import Any

import numpy as np
import pytest

from nearfar.stream import _room_frames as frames
from nearfar.stream.client import Joined, Left, Placed, Pointer, Pose, Posed, RoomError, Said, Signalled
from tests.support.vectors import cases


def parse_placed(fields: dict[str, Any] | None) -> Placed | None:
    if fields is None:
        return None
    return Placed(np.array(fields["position"], np.float32), np.array(fields["rotation"]) / 32767)


def pose(fields: dict[str, Any]) -> Pose:
    head, left, right = (parse_placed(fields[name]) for name in ("head", "left", "right"))
    assert head is not None
    pointer = None if fields["pointer"] is None else Pointer(**fields["pointer"])
    return Pose(
        fields["sequence"], fields["clock"], fields["acknowledged"], fields["stops"], head, left, right, pointer
    )


def of_user(fields: dict[str, Any]) -> bytes:
    match fields:
        case {"kind": "hello"}:
            return frames.hello(fields["group"], fields["name"], bytes.fromhex(fields["ticket"]))
        case {"kind": "pose"}:
            return frames.pose(pose(fields["pose"]))
        case {"kind": "ack"}:
            return frames.ack(fields["user"], fields["sequence"])
        case {"kind": "say"}:
            return frames.say(fields["to"], bytes.fromhex(fields["data"]))
        case {"kind": "signal"}:
            return frames.signal(fields["user"], bytes.fromhex(fields["data"]))
        case _:
            return frames.bye()


def of_server(fields: dict[str, Any]) -> frames.Frame:
    match fields:
        case {"kind": "welcome"}:
            return frames.Welcome(fields["user"], fields["others"], bytes.fromhex(fields["ticket"]))
        case {"kind": "pose"}:
            return Posed(fields["user"], pose(fields["pose"]))
        case {"kind": "settled"}:
            return frames.SettledUpTo(fields["sequence"])
        case {"kind": "say"}:
            return Said(fields["user"], bytes.fromhex(fields["data"]), fields["to"])
        case {"kind": "signal"}:
            return Signalled(fields["user"], bytes.fromhex(fields["data"]))
        case {"kind": "joined"}:
            return Joined(fields["user"], fields["name"], fields["group"])
        case {"kind": "left"}:
            return Left(fields["user"])
        case _:
            return frames.Refused(frames.REASONS[fields["reason"]], fields["sentence"])


@pytest.mark.parametrize("case", cases("rooms", "users"))
def test_frames_of_users_equal_their_bytes(case: dict[str, Any]) -> None:
    assert of_user(case["frame"]).hex() == case["bytes"]


@pytest.mark.parametrize("case", cases("rooms", "servers"))
def test_frames_of_the_server_are_parsed(case: dict[str, Any]) -> None:
    data, expected = bytes.fromhex(case["bytes"]), of_server(case["frame"])
    assert list(frames.read(data)) == [expected]
    assert list(frames.read(data * 3)) == [expected] * 3


@pytest.mark.parametrize("case", cases("rooms", "refused"))
def test_malformed_frames_are_refused(case: dict[str, Any]) -> None:
    with pytest.raises(RoomError, match="expected valid frames from the server"):
        list(frames.read(bytes.fromhex(case["server"])))


@pytest.mark.parametrize("case", cases("rooms", "servers"))
def test_truncated_and_corrupted_frames_are_parsed_or_refused(case: dict[str, Any]) -> None:
    data = bytes.fromhex(case["bytes"])
    for length in range(1, len(data)):
        with pytest.raises(RoomError):
            list(frames.read(data[:length]))
    for bit in range(8 * len(data)):
        changed = bytearray(data)
        changed[bit // 8] ^= 1 << bit % 8
        with suppress(RoomError):
            list(frames.read(bytes(changed)))


def test_poses_are_equal_only_with_equal_positions() -> None:
    fields = next(iter(cases("rooms", "servers")[1].values))["frame"]["pose"]
    one = pose(fields)
    assert (one, hash(one)) == (pose(fields), hash(pose(fields)))
    moved = dataclasses.replace(one.head, position=one.head.position + np.float32(1))
    assert dataclasses.replace(one, head=moved) != one
    assert one.head != "a place"
