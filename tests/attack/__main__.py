"""Runs the attack for a time, or repeats files of findings: `python -m tests.attack --minutes 60`."""

from __future__ import annotations

import argparse
import os
import sys
import time
from contextlib import suppress
from pathlib import Path

from tests.attack.case import from_json
from tests.attack.engine import Engine, attack
from tests.attack.report import Report
from tests.attack.worker import all_kinds


def main() -> int:
    """Return 1 if there are findings."""
    parse = argparse.ArgumentParser(prog="python -m tests.attack", description=__doc__)
    parse.add_argument("--minutes", type=float, default=60.0)
    parse.add_argument("--seed", type=int, default=int(time.time()), help="by default of the clock")
    parse.add_argument("--workers", type=int, default=os.cpu_count())
    parse.add_argument("--only", default="", help="beginning of the names of kinds")
    parse.add_argument("--out", type=Path, default=Path("out/attack"))
    parse.add_argument("--replay", type=Path, nargs="+", help="files of findings to run again, one by one")
    given = parse.parse_args()
    kinds = {name: kind for name, kind in all_kinds(own_only=False).items() if name.startswith(given.only)}
    engine, report, start = Engine(kinds, limits=True), Report(given.out / "findings"), time.monotonic()
    if given.replay:
        for path in given.replay:
            (result,) = engine.run([from_json(path.read_text(encoding="utf-8"))])
            report.add(result)
            print(f"{path.name}: {result.outcome}, {result.seconds:.2f} s, {result.memory >> 20} MB")
    else:
        print(f"seed {given.seed}: {len(kinds)} kinds of cases, {given.workers} workers", flush=True)
        with suppress(KeyboardInterrupt):
            attack(engine, given.seed, report.add, workers=given.workers, until=start + 60 * given.minutes)
        head = f"Seed {given.seed}, {report.count():,} cases in {(time.monotonic() - start) / 60:.1f} minutes.\n\n"
        given.out.mkdir(parents=True, exist_ok=True)
        (given.out / "report.md").write_text(head + report.table(), encoding="utf-8")
        print(head + report.table())
    return 1 if report.causes else 0


if __name__ == "__main__":
    sys.exit(main())
