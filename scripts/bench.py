"""Runs every benchmark and keeps what each prints, as Markdown, and its plots in a folder, with a report of all.

One after the other, because they measure time: `python scripts/bench.py [FOLDER] [NAME ...]`.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parent.parent


def main() -> None:
    """Run benchmarks/*.py, or those named; leave with status 1 if one fails."""
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "out/bench")
    folder.mkdir(parents=True, exist_ok=True)
    every = sorted(path for path in (CHECKOUT / "benchmarks").glob("*.py") if not path.name.startswith("_"))
    chosen = [path for path in every if path.stem in sys.argv[2:]] or every
    failed = [path.stem for path in chosen if not run(path, folder)]
    parts = [(folder / f"{path.stem}.md").read_text(encoding="utf-8") for path in chosen if path.stem not in failed]
    (folder / "report.md").write_text("# Run time against error\n\n" + "\n".join(parts), encoding="utf-8")
    if failed:
        sys.exit(f"benchmarks failed: {', '.join(failed)}")


def run(path: Path, folder: Path) -> bool:
    """Run one benchmark; what it prints goes to the terminal and to a file of its name."""
    print(f"## {path.stem}", flush=True)
    started = time.perf_counter()
    command = [sys.executable, str(path)]
    environment = os.environ | {
        "PYTHONUNBUFFERED": "1",
        "NEARFAR_PROGRESS": "0",
        "NEARFAR_BENCH_OUT": str(folder.resolve()),
    }
    lines = []
    with subprocess.Popen(command, cwd=CHECKOUT, env=environment, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        for line in process.stdout:
            print(line, end="", flush=True)
            lines.append(line)
    print(f"({time.perf_counter() - started:.0f} s)\n", flush=True)
    if process.returncode == 0:
        (folder / f"{path.stem}.md").write_text(f"## {path.stem}\n\n{''.join(lines)}", encoding="utf-8")
    return process.returncode == 0


if __name__ == "__main__":
    main()
