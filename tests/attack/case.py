"""A case of the attack, made from a seed, and the verdict on it."""

from __future__ import annotations

import base64
import json
import random
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

Plan = dict[str, Any]
"""Random choices of a case as JSON values."""

FOREIGN_WORDS = (
    "bug report", "panicked", "charset_normalizer", "chardet", "UnboundLocalError", "AttributeError", "cannot access",
    "cannot reshape",
)  # fmt: skip
"""Words of other programs' messages."""

MAX_LETTERS = 1000
"""Maximum length of a message, beyond the name of its file."""


@dataclass(frozen=True)
class Case:
    """A case's input; `files` lie in an empty folder before it runs."""

    kind: str
    plan: Plan
    files: dict[str, bytes] = field(default_factory=dict)
    origin: str = ""
    """The seed and number that made it."""

    @property
    def size(self) -> int:
        """Bytes of the files."""
        return sum(map(len, self.files.values()))

    def write(self, folder: Path) -> None:
        """Write the files into a folder."""
        for name, data in self.files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(data)


@dataclass(frozen=True)
class Kind:
    """A kind of cases: how one is made from random numbers, and how it runs."""

    name: str
    make: Callable[[random.Random], tuple[Plan, dict[str, bytes]]]
    run: Callable[[Case, Path], str]
    """Returns `ACCEPTED`, or `refused` for a correct refusal; raises `Finding`, or whatever exception the package
    wrongly raises."""
    share: float = 1.0
    """Number of cases of this kind for each case of a kind with share 1."""
    has_limits: bool = True
    """Whether a refusal must be quick and small; not for kinds that work on purpose."""


ACCEPTED = "accepted"


def refused(error: BaseException) -> str:
    """Return the outcome of a correct refusal."""
    return f"refused: {type(error).__name__}"


class Finding(Exception):  # noqa: N818  # it is no error of this program
    """A defect that a case reveals; the text is one line."""


def check_sentence(error: Exception, name: str | Path) -> None:
    """Raise `Finding` unless the message is one printable line of limited length that contains a file's name."""
    text, kind = str(error), type(error).__name__
    if any("\ud800" <= letter <= "\udfff" for letter in text):
        raise Finding(f"the message of {kind} cannot be printed: {text!a:.200}") from error
    if "\n" in text.strip("\n") or not 5 < len(text) < MAX_LETTERS + len(str(name)):
        raise Finding(f"the message of {kind} is no short line: {text[:200]!r}") from error
    if str(name) not in text:
        raise Finding(f"the message of {kind} does not name the file: {text[:200]!r}") from error
    if any(word in text for word in FOREIGN_WORDS):
        raise Finding(f"an error from inside reached the user: {text[:200]!r}") from error


def make(kind: Kind, seed: int, number: int) -> Case:
    """Make a case; equal arguments give equal cases while its kind and its seed files stay unchanged."""
    plan, files = kind.make(random.Random(f"{kind.name} {seed} {number}"))
    return Case(kind.name, plan, files, f"seed {seed}, case {number}")


def to_json(case: Case) -> str:
    """Return a case as text, with its bytes, so that later changes of kinds do not affect it."""
    files = {name: base64.b64encode(data).decode() for name, data in case.files.items()}
    document = {"kind": case.kind, "origin": case.origin, "plan": case.plan, "files": files}
    return json.dumps(document, indent=1, sort_keys=True) + "\n"


def from_json(text: str) -> Case:
    """Read what `to_json` wrote."""
    document = json.loads(text)
    files = {name: base64.b64decode(data) for name, data in document["files"].items()}
    return Case(document["kind"], document["plan"], files, document["origin"])
