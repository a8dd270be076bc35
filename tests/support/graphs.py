"""Finds circles in graphs of files."""

from __future__ import annotations


def circles(graph: dict[str, set[str]]) -> list[list[str]]:
    """Files that use each other, directly or by way of others: the strongly connected components of more than one."""
    reached = {name: reachable(graph, name) for name in graph}
    found = {frozenset({name} | {other for other in reached[name] if name in reached[other]}) for name in graph}
    return sorted(sorted(circle) for circle in found if len(circle) > 1)


def reachable(graph: dict[str, set[str]], start: str) -> set[str]:
    visited: set[str] = set()
    pending = [start]
    while pending:
        for name in graph.get(pending.pop(), set()) - visited:
            visited.add(name)
            pending.append(name)
    return visited
