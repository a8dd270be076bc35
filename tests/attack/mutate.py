"""Damage to bytes and text."""

from __future__ import annotations

import random
import re
import struct
from collections.abc import Sequence

NUMBERS = (
    "0", "-1", "1", "2147483647", "2147483648", "4294967295", "4294967296", "9223372036854775807",
    "18446744073709551616", "-9223372036854775809", "1" + "0" * 400, "nan", "inf", "-inf", "1e308", "1e400", "-1e400",
    "1e-320", "1e-45", "3.5e38", "0x10", "1_0", "٣", "", "1.2.3", "--1", "+1", "1e", ".", "NaN", "Infinity", "1,5", "∞",
)  # fmt: skip
"""Numbers in text, and texts that resemble numbers."""

_WORDS = [(form, value) for form, bits in (("B", 8), ("H", 16), ("I", 32), ("Q", 64)) for value in (
    0, 1, 2 ** (bits - 1) - 1, 2 ** (bits - 1), 2**bits - 1, 2**bits - 2,
)]  # fmt: skip
_FLOATS = (float("nan"), float("inf"), -float("inf"), 0.0, -0.0, 1e-45, 3.4e38, -3.4e38, 1e30, 1e38, 1e-38, 1e16)
_NUMBER = re.compile(rb"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_TOKEN = re.compile(rb"[^\s]+")


def damaged(data: bytes, dice: random.Random, others: Sequence[bytes] = ()) -> bytes:
    """Damage a file one or more times; `others` are files to copy pieces from."""
    for _ in range(dice.choice((1, 1, 1, 2, 3, 8))):
        is_text = b"\0" not in data[:4096] and dice.random() < 0.9
        data = (_damaged_text if is_text else _damaged_bytes)(data, dice, others)
    return data


def _damaged_bytes(data: bytes, dice: random.Random, others: Sequence[bytes]) -> bytes:
    if not data:
        return bytes(dice.randrange(256) for _ in range(dice.randrange(64)))
    # Headers are short and decide more than the rest.
    place = dice.randrange(min(len(data), 256) if dice.random() < 0.4 else len(data))
    span = min(len(data) - place, dice.choice((1, 2, 4, 8, 32, 256, 4096)))
    content = bytearray(data)
    match dice.randrange(9):
        case 0:
            content[place] ^= 1 << dice.randrange(8)
        case 1:
            content[place] = dice.choice((0, 1, 127, 128, 255, dice.randrange(256)))
        case 2:
            return data[: place if dice.random() < 0.7 else len(data) - min(len(data), dice.randrange(1, 17))]
        case 3:
            del content[place : place + span]
        case 4:
            content[place:place] = content[place : place + span] * dice.choice((1, 2, 100))
        case 5:
            form, value = dice.choice(_WORDS)
            word = struct.pack(dice.choice("<>") + form, value)
            content[place : place + len(word)] = word
        case 6:
            word = struct.pack(dice.choice(("<f", "<d", ">f")), dice.choice(_FLOATS))
            content[place : place + len(word)] = word
        case 7:
            # Sizes and offsets lie at multiples of four; a small change passes more checks than a large one.
            start = place & ~3
            if len(data) >= start + 4:
                (word32,) = struct.unpack_from("<I", data, start)
                struct.pack_into("<I", content, start, (word32 + dice.choice((-4, -1, 1, 4, 1000))) % 2**32)
        case _:
            donor = dice.choice(others) if others else data
            start = dice.randrange(max(1, len(donor)))
            content[place : place + (span if dice.random() < 0.5 else 0)] = donor[start : start + span]
    return bytes(content)


def _damaged_text(data: bytes, dice: random.Random, others: Sequence[bytes]) -> bytes:
    match dice.randrange(10):
        case 0 | 1 | 2:
            return _replaced(data, dice, _NUMBER, [number.encode() for number in NUMBERS])
        case 3:
            tokens = [match[0] for match in _TOKEN.finditer(data[:65536])]
            return _replaced(data, dice, _TOKEN, tokens or [b"x"])
        case 4:
            return _replaced(
                data, dice, _TOKEN, [b"", b"/", b"//", b"-", b"#", b"\\", b"\xff", b"\0", b'"', b"a" * 999]
            )
        case 5:
            return _lines(data, dice, others)
        case 6:
            return data.replace(
                *dice.choice(((b"\n", b"\r"), (b"\n", b"\r\n"), (b" ", b"\t"), (b" ", b"  "), (b"\n", b"\\\n")))
            )
        case 7:
            text = data.decode("utf-8", "replace")
            return text.encode(dice.choice(("utf-16", "utf-16-le", "utf-8-sig", "utf-32", "cp037")), "replace")
        case _:
            return _damaged_bytes(data, dice, others)


def _replaced(data: bytes, dice: random.Random, pattern: re.Pattern[bytes], by: Sequence[bytes]) -> bytes:
    found = list(pattern.finditer(data))
    if not found:
        return data + dice.choice(by)
    place = dice.choice(found[:40] if dice.random() < 0.4 else found)
    return data[: place.start()] + dice.choice(by) + data[place.end() :]


def _lines(data: bytes, dice: random.Random, others: Sequence[bytes]) -> bytes:
    lines = data.split(b"\n")
    one, two = dice.randrange(len(lines)), dice.randrange(len(lines))
    match dice.randrange(5):
        case 0:
            del lines[one]
        case 1:
            lines.insert(two, lines[one])
        case 2:
            lines[one], lines[two] = lines[two], lines[one]
        case 3:
            lines[one:one] = lines[min(one, two) : max(one, two)] * dice.choice((1, 1, 50))
        case _:
            lines.insert(one, dice.choice((dice.choice(others) if others else data).split(b"\n")))
    return b"\n".join(lines)
