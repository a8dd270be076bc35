"""The table of an attack, and its findings as files."""

from __future__ import annotations

import hashlib
import re
from collections import Counter
from pathlib import Path

from tests.attack.case import ACCEPTED, to_json
from tests.attack.engine import Result


class Report:
    """Results so far; findings of the same cause are counted together, and the first case of each is kept as a file."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._counts: dict[str, Counter[str]] = {}
        self._slowest: dict[str, float] = {}
        self.causes: dict[str, list[Result]] = {}

    def add(self, result: Result) -> None:
        """Count a result, print a new finding and keep its case."""
        kind, is_refused = result.case.kind, result.outcome.startswith("refused")
        found = {
            "cases": 1,
            "accepted": result.outcome == ACCEPTED,
            "refused": is_refused,
            "findings": bool(result.finding),
        }
        self._counts.setdefault(kind, Counter()).update({name: int(value) for name, value in found.items()})
        self._slowest[kind] = max(self._slowest.get(kind, 0.0), result.seconds if is_refused else 0.0)
        if not result.finding:
            return
        alike = self.causes.setdefault(cause(result), [])
        alike.append(result)
        if len(alike) == 1:
            self._folder.mkdir(parents=True, exist_ok=True)
            (self._folder / name_of(result)).write_text(to_json(result.case), encoding="utf-8")
            print(f"{kind}, {result.case.origin}: {result.finding}\n  {result.trace}", flush=True)

    def count(self, name: str = "cases") -> int:
        """Return the sum of a column."""
        return sum(counts[name] for counts in self._counts.values())

    def table(self) -> str:
        """Return the table and the findings as Markdown."""
        columns = ("cases", "accepted", "refused", "findings")
        lines = [f"| kind | {' | '.join(columns)} | slowest refusal, s |", "| --- | ---: | ---: | ---: | ---: | ---: |"]
        for kind, counts in sorted(self._counts.items()):
            cells = " | ".join(f"{counts[name]:,}" for name in columns)
            lines.append(f"| {kind} | {cells} | {self._slowest[kind]:.2f} |")
        for text, alike in sorted(self.causes.items(), key=lambda item: -len(item[1])):
            first = alike[0]
            lines.append(f"\n- {len(alike)} × {text}: {first.finding} ({name_of(first)})\n  {first.trace}")
        return "\n".join(lines) + "\n"


def cause(result: Result) -> str:
    """Return the key by which findings share a cause: the kind of defect and the innermost location in the package."""
    place = re.sub(r":\d+", "", result.trace.partition(" < ")[0])
    words = re.sub(r"\(.*?\) raised", " raised", result.finding)
    words = re.sub(r"'[^']*'|\"[^\"]*\"|\.[0-9a-f]{12}|\d[\d.]*|/\S+", "…", words)[:100]
    return f"{result.case.kind}: {words} at {place}"


def name_of(result: Result) -> str:
    """Return the name of a finding's file."""
    digest = hashlib.sha256(cause(result).encode()).hexdigest()[:10]
    return f"{result.case.kind.replace(' ', '-')}-{digest}.json"
