"""Finds cycles in graphs of files, and uses of parts that are not allowed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

Graph = Mapping[str, set[str]]
"""Files, and the files that each uses."""


def cycles(graph: Graph) -> list[list[str]]:
    """Files that use each other, directly or by way of others: the strongly connected components of more than one."""
    reached = {name: reachable(graph, name) for name in graph}
    found = {frozenset({name} | {other for other in reached[name] if name in reached[other]}) for name in graph}
    return sorted(sorted(cycle) for cycle in found if len(cycle) > 1)


def reachable(graph: Graph, start: str) -> set[str]:
    """Files that one uses, directly or by way of others."""
    visited: set[str] = set()
    pending = [start]
    while pending:
        for name in graph.get(pending.pop(), set()) - visited:
            visited.add(name)
            pending.append(name)
    return visited


def part_of(file: str, parts: Iterable[str]) -> str | None:
    """The smallest part that a file belongs to: a folder, or the file itself; None for a file of no part."""
    stem = file.rpartition(".")[0]
    within = [part for part in parts if stem == part or stem.startswith(f"{part}/")]
    return max(within, key=len, default=None)


def forbidden(graph: Graph, table: Mapping[str, set[str]]) -> Iterator[str]:
    """Sentences about uses that a table of parts does not allow, and about files of no part."""
    for file, used in graph.items():
        part = part_of(file, table)
        if part is None:
            yield f"{file} is a new part: say in the table what it may use"
            continue
        allowed = table[part] | {part}
        yield from (f"{file} uses {name}" for name in sorted(used) if part_of(name, table) not in allowed)
