"""Rules of ARCHITECTURE.md for dependencies, in all languages: no cycles of files, and one direction between parts."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path

import pytest

from tests.support import python_modules, rust_modules, typescript_modules
from tests.support.graphs import Graph, cycles, forbidden, part_of
from tests.support.stages import TABLES

CHECKOUT = Path(__file__).resolve().parents[2]

SCRIPTS = {
    "worker.js": "decode/worker.ts",
    "orthoview-cut.js": "orthoview/cut/worker.ts",
    "orthoview-read.js": "orthoview/decode/worker.ts",
    "orthoview-webgpu.js": "orthoview/draw/webgpu/start.ts",
}
"""Source files of the page by the names of the scripts that web/build.mjs makes of them."""


def entries() -> dict[str, str]:
    """Modules of the package by the names of the entry points through which other packages import them."""
    project = tomllib.loads((CHECKOUT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    points = [*project["entry-points"].values(), project["scripts"]]
    return {name: place.partition(":")[0] for group in points for name, place in group.items()}


READERS: dict[str, Callable[[Path], Graph]] = {
    "rust/core/src": rust_modules.file_graph,
    "rust/gpu/src": rust_modules.file_graph,
    "rust/serve/src": rust_modules.file_graph,
    "rust/serve/examples/link": rust_modules.file_graph,
    "rust/serve/examples/rooms_load": rust_modules.file_graph,
    "rust/py/src": rust_modules.file_graph,
    "fuzz/src": rust_modules.file_graph,
    "python/nearfar": partial(python_modules.file_graph, entries=entries()),
    "tests": python_modules.file_graph,
    "benchmarks": python_modules.file_graph,
    "scripts": python_modules.file_graph,
    "web/src": partial(typescript_modules.file_graph, scripts=SCRIPTS),
    "web/tests": typescript_modules.file_graph,
}
"""Readers of the import graph of each folder."""


@cache
def graph_of(source: str) -> Graph:
    return READERS[source](CHECKOUT / source)


@pytest.mark.parametrize("source", READERS)
def test_files_have_no_import_cycles(source: str) -> None:
    assert cycles(graph_of(source)) == []


def test_no_test_imports_a_test() -> None:
    wrong = {file: {name for name in used if "/test_" in name} for file, used in graph_of("tests").items()}
    assert {file: names for file, names in wrong.items() if names} == {}


@pytest.mark.parametrize("source", TABLES)
def test_parts_use_what_their_rows_list(source: str) -> None:
    graph, table = graph_of(source), TABLES[source]
    assert list(forbidden(graph, table)) == []
    pairs = {(part_of(file, table), part_of(name, table)) for file, used in graph.items() for name in used}
    assert {(part, used) for part, row in table.items() for used in row} - pairs == set(), "rows that nobody needs"


@pytest.mark.parametrize("source", TABLES)
def test_parts_use_only_earlier_ones(source: str) -> None:
    order = list(TABLES[source])
    later = {part: set(order[place:]) for place, part in enumerate(order)}
    assert {part: uses & later[part] for part, uses in TABLES[source].items() if uses & later[part]} == {}


@pytest.mark.parametrize("source", ["rust/core/src", "rust/gpu/src", "rust/serve/src"])
def test_crates_list_their_modules_in_this_order(source: str) -> None:
    text = (CHECKOUT / source / "lib.rs").read_text(encoding="utf-8")
    assert re.findall(r"^(?:pub )?mod (?!tests;)(\w+);", text, re.MULTILINE) == list(TABLES[source])
