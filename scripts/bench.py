"""Runs all benchmarks; saves the output of each as Markdown, its plots, and a report of all in a folder.

They run one after the other, because they measure time: `python scripts/bench.py [FOLDER] [NAME ...]`, where a name is
a stage, such as `trace`, or one benchmark of it, such as `lod.fit`.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parent.parent


def main() -> None:
    """Run all benchmarks, or those named; exit with status 1 if one fails."""
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "out/bench")
    folder.mkdir(parents=True, exist_ok=True)
    requested = set(sys.argv[2:])
    selected = [name for name in names() if not requested or requested & {name, name.partition(".")[0]}]
    failed = [name for name in selected if not run(name, folder)]
    parts = [(folder / f"{name}.md").read_text(encoding="utf-8") for name in selected if name not in failed]
    (folder / "report.md").write_text("# Run time against error\n\n" + "\n".join(parts), encoding="utf-8")
    if failed:
        sys.exit(f"benchmarks failed: {', '.join(failed)}")


def names() -> list[str]:
    """Names of the benchmarks, stage.name, without `harness` and files whose names begin with an underscore."""
    files = sorted((CHECKOUT / "benchmarks").glob("*/*.py"))
    runs = [path for path in files if '__name__ == "__main__"' in path.read_text(encoding="utf-8")]
    return [f"{path.parent.name}.{path.stem}" for path in runs]


def run(name: str, folder: Path) -> bool:
    """Run one benchmark; its output goes to the terminal and to a file with its name."""
    print(f"## {name}", flush=True)
    started = time.perf_counter()
    command = [sys.executable, "-m", f"benchmarks.{name}"]
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
        (folder / f"{name}.md").write_text(f"## {name}\n\n{''.join(lines)}", encoding="utf-8")
    return process.returncode == 0


if __name__ == "__main__":
    main()
