"""The table of an attack, and its findings as files."""

from __future__ import annotations

import hashlib
import json
import re
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

from tests.attack.case import ACCEPTED, to_json
from tests.attack.runner import Result


@dataclass
class Row:
    """Results of one kind."""

    cases: int = 0
    accepted: int = 0
    refusals: Counter[str] = field(default_factory=Counter)
    """By the exception's type."""
    slowest: float = 0.0
    """Seconds of the slowest refusal."""
    largest: int = 0
    """Greatest memory of a refusal, bytes."""
    findings: int = 0

    def add(self, result: Result) -> None:
        self.cases += result.number >= 0
        self.accepted += result.outcome == ACCEPTED
        self.findings += bool(result.finding)
        if result.outcome.startswith("refused"):
            self.refusals[result.outcome.removeprefix("refused: ")] += 1
            self.slowest = max(self.slowest, result.seconds)
            self.largest = max(self.largest, result.memory)


class Report:
    """Results so far; findings of one cause are counted together, and their first case is kept as a file."""

    def __init__(self, folder: Path | None = None, tell: Callable[[str], None] = lambda line: None) -> None:
        self._folder, self._tell = folder, tell
        self.rows: dict[str, Row] = {}
        self.causes: dict[str, list[Result]] = {}

    def add(self, results: Iterable[Result]) -> None:
        """Count results, and keep cases of new findings."""
        for result in results:
            self.rows.setdefault(result.kind, Row()).add(result)
            if result.finding:
                alike = self.causes.setdefault(cause(result), [])
                alike.append(result)
                if len(alike) > 1:
                    continue
                self._tell(f"{result.kind}, case {result.number}: {result.finding}\n  {result.trace}")
                if self._folder is not None and result.case is not None:
                    self._folder.mkdir(parents=True, exist_ok=True)
                    (self._folder / name_of(result)).write_text(to_json(result.case), encoding="utf-8")

    @property
    def cases(self) -> int:
        """Number of all cases."""
        return sum(row.cases for row in self.rows.values())

    def table(self) -> str:
        """Return the table and the findings as Markdown."""
        lines = [
            "| kind | cases | accepted | refused | by exception | slowest refusal, s | largest, MB | findings |",
            "| --- | ---: | ---: | ---: | --- | ---: | ---: | ---: |",
        ]
        total = Row()
        for kind, row in sorted(self.rows.items()):
            lines.append(_line(kind, row))
            total.cases += row.cases
            total.accepted += row.accepted
            total.refusals += row.refusals
            total.slowest, total.largest = max(total.slowest, row.slowest), max(total.largest, row.largest)
            total.findings += row.findings
        lines.append(_line("all", total))
        for text, alike in sorted(self.causes.items(), key=lambda item: -len(item[1])):
            first = alike[0]
            file = f" ({self._folder / name_of(first)})" if first.case and self._folder is not None else ""
            lines.append(f"\n- {len(alike)} × {text}: {first.finding}{file}\n  {first.trace}")
        return "\n".join(lines) + "\n"

    def write(self, folder: Path, seed: int, seconds: float) -> None:
        """Write table and figures."""
        folder.mkdir(parents=True, exist_ok=True)
        head = f"Seed {seed}, {self.cases:,} cases in {seconds / 60:.1f} minutes.\n\n"
        (folder / "report.md").write_text(head + self.table(), encoding="utf-8")
        rows = {kind: vars(row) for kind, row in self.rows.items()}
        causes = {text: [result.finding for result in alike[:5]] for text, alike in self.causes.items()}
        document = {"seed": seed, "seconds": seconds, "cases": self.cases, "kinds": rows, "findings": causes}
        (folder / "report.json").write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")


def _line(kind: str, row: Row) -> str:
    kinds = ", ".join(f"{name} {count:,}" for name, count in row.refusals.most_common())
    refused = sum(row.refusals.values())
    return (
        f"| {kind} | {row.cases:,} | {row.accepted:,} | {refused:,} | {kinds} | {row.slowest:.2f} "
        f"| {row.largest / 1e6:.0f} | {row.findings} |"
    )


def cause(result: Result) -> str:
    """Return what findings of one cause have in common: the kind of defect and the innermost place of the package."""
    place = re.sub(r":\d+", "", result.trace.partition(" < ")[0])
    words = re.sub(r"\(.*?\) raised", " raised", result.finding)
    words = re.sub(r"'[^']*'|\"[^\"]*\"|\.[0-9a-f]{12}|\d[\d.]*|/\S+", "…", words)[:100]
    return f"{result.kind}: {words} at {place}"


def name_of(result: Result) -> str:
    """Return the name of a finding's file."""
    digest = hashlib.sha256(cause(result).encode()).hexdigest()[:10]
    return f"{result.kind.replace(' ', '-')}-{digest}.json"
