"""Prints the share of equal pixels by exporter and model: python -m tests.support.exporters_table [EXPORTER …]."""

from __future__ import annotations

import itertools
import sys
import tempfile
import time
from pathlib import Path

from tests.support.exporters import FULL, Case, share
from tests.support.exporters_cases import CASES
from tests.support.exporters_run import EXPORTERS


def main() -> None:
    """Export all models, or those of some exporters, and print their similarity to the plain files."""
    print("| exporter | model | settings or format: percentage of pixels |\n| --- | --- | --- |")
    for name in sys.argv[1:] or EXPORTERS:
        with tempfile.TemporaryDirectory() as folder:
            started = time.perf_counter()
            EXPORTERS[name](CASES[name], Path(folder))
            exported = time.perf_counter()
            for source, cases in itertools.groupby(CASES[name], lambda case: case.source):
                shown = "; ".join(_row(case, share(case, Path(folder) / case.file)) for case in cases)
                print(f"| {name} | {source} | {shown} |", flush=True)
        took = exported - started, time.perf_counter() - exported
        print(f"{name}: {took[0]:.1f} s to export, {took[1]:.1f} s to compare", file=sys.stderr)


def _row(case: Case, found: float) -> str:
    kept = "" if case.compared == FULL else f" ({case.compared})"
    return f"{case.settings}{kept}: {100 * found:.3f}"


if __name__ == "__main__":
    main()
