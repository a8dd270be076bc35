"""Finds which file of a folder of TypeScript uses which, from the imports alone."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path

COMMENT = re.compile(r"/\*.*?\*/|(?<!\S)//[^\n]*", re.DOTALL)
NAMES = r"(?:[\w$]+\s*,?\s*)?(?:\{[^}]*\}|\*(?:\s*as\s+[\w$]+)?)?"
"""A default import, then names in braces, or all."""
IMPORT = re.compile(
    rf"""(?:^|(?<=;))\s*(?:(?:import|export)\s+(?:type\s+)?{NAMES}\s*from|import)\s*(?P<mark>['"])(?P<path>[^'"]+)(?P=mark)
    | \bimport\s*\(\s*(?P<quote>['"`])(?P<later>[^'"`]+)(?P=quote)
    | \bnew\s+URL\(\s*(?P<sign>['"])(?P<script>[\w-]+\.js)(?P=sign)""",
    re.MULTILINE | re.VERBOSE,
)
"""Imports of a file, static or dynamic, by path; scripts by the name of their built file."""


def file_graph(source: Path, scripts: Mapping[str, str] | None = None) -> dict[str, set[str]]:
    """The files that each file of a folder uses, by their paths below it; types count like values.

    Parameters
    ----------
    source
        The folder. Files outside and packages are no files of the graph.
    scripts
        Files by the names of the scripts that are built from them, by which pages and other scripts load them.
    """
    paths = {path.relative_to(source).as_posix(): path for path in sorted(source.rglob("*.ts"))}
    return {name: set(_used(path, source, scripts or {})) & set(paths) - {name} for name, path in paths.items()}


def _used(path: Path, source: Path, scripts: Mapping[str, str]) -> Iterator[str]:
    for found in IMPORT.finditer(COMMENT.sub(" ", path.read_text(encoding="utf-8"))):
        name = found["path"] or found["later"] or found["script"]
        if name in scripts or found["script"]:
            yield scripts[name]
        elif name.startswith("."):
            target = (path.parent / name).resolve()
            ways = [target, target.with_name(f"{target.name}.ts"), target / "index.ts"]
            file = next((way for way in ways if way.is_file()), None)
            assert file, f"{path}: no file at {name}"
            if file.is_relative_to(source):
                yield file.relative_to(source).as_posix()
