"""Runs the attack for a time, or a case of it again: `python -m tests.attack --minutes 60`."""

from __future__ import annotations

import argparse
import os
import signal
import sys
import time
from pathlib import Path

from tests.attack.attack import Attack
from tests.attack.case import Kind, from_json, make, to_json
from tests.attack.kinds import all_kinds
from tests.attack.report import Report
from tests.attack.runner import Runner


def main() -> int:
    """Return 1 if there are findings."""
    parse = argparse.ArgumentParser(prog="python -m tests.attack", description=__doc__)
    parse.add_argument("--minutes", type=float, default=60.0)
    parse.add_argument("--seed", type=int, default=None, help="by default of the clock")
    parse.add_argument("--workers", type=int, default=os.cpu_count())
    parse.add_argument("--only", default="", help="beginning of the names of kinds")
    parse.add_argument("--out", type=Path, default=Path("out/attack"))
    parse.add_argument("--replay", type=Path, nargs="+", help="files of findings to run again, one by one")
    parse.add_argument("--case", type=int, help="number of a case of --only and --seed to run again")
    given = parse.parse_args()
    kinds = {name: kind for name, kind in all_kinds(own_only=False).items() if name.startswith(given.only)}
    if given.case is not None and (given.seed is None or given.only not in kinds):
        parse.error(f"--case needs --seed and --only with one of {', '.join(sorted(kinds))}")
    if given.replay or given.case is not None:
        return _again(given, kinds)
    seed = int(time.time()) if given.seed is None else given.seed
    print(f"seed {seed}: {len(kinds)} kinds of cases, {given.workers} workers, {given.minutes:g} minutes", flush=True)
    report, start = Report(given.out / "findings", lambda line: print(line, flush=True)), time.monotonic()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    attack = Attack(kinds, seed, report, limits=True, own_only=False)
    try:
        attack.run(given.workers, until=start + 60 * given.minutes)
    except KeyboardInterrupt:
        print("stopped early", flush=True)
    report.write(given.out, seed, time.monotonic() - start)
    print((given.out / "report.md").read_text(encoding="utf-8"))
    return 1 if report.causes else 0


def _again(given: argparse.Namespace, kinds: dict[str, Kind]) -> int:
    every = all_kinds(own_only=False)
    if given.replay:
        cases = [from_json(path.read_text(encoding="utf-8")) for path in given.replay]
    else:
        cases = [make(every[given.only], given.seed, given.case)]
        print(to_json(cases[0]))
    count = 0
    with Runner(every, limits=True, own_only=False) as runner:
        for case in cases:
            result = runner.alone(case)
            count += bool(result.finding)
            print(f"{case.kind}, {case.origin}: {result.outcome} {result.finding}\n  {result.trace}")
            print(f"  {result.seconds:.2f} s, {result.memory >> 20} MB")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
