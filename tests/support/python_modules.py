"""Finds which file of a Python package uses which other one, from the imports alone."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

Graph = dict[str, set[str]]
"""Modules by dotted name, and the modules that each uses."""


def uses(package: Path) -> Graph:
    """Return the graph of a package's files.

    An import counts to the file that defines the name, through any number of re-exports. Imports inside functions and
    under TYPE_CHECKING count. An `__init__.py` that defines nothing only documents and re-exports: it is left out.
    """
    return _Package(package).graph()


class _Package:
    def __init__(self, folder: Path) -> None:
        self.name = folder.name
        paths = {_dotted(path, folder.parent): path for path in sorted(folder.rglob("*.py"))}
        self.trees = {module: ast.parse(_read(path)) for module, path in paths.items()}
        self.folders = {module for module, path in paths.items() if path.name == "__init__.py"}
        self.defined = {module: set(_definitions(tree)) for module, tree in self.trees.items()}
        self.imported = {module: dict(_names(tree, module)) for module, tree in self.trees.items()}

    def graph(self) -> Graph:
        counted = [module for module in self.trees if module not in self.folders or self.defined[module]]
        return {module: set(self._used(module)) & set(counted) - {module} for module in counted}

    def _used(self, module: str) -> Iterator[str]:
        tree = self.trees[module]
        aliases: set[str] = set()
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module and self._is_ours(node.module):
                yield from (self.definer(node.module, alias.name) for alias in node.names)
            elif isinstance(node, ast.Import):
                aliases |= {a.asname or a.name for a in node.names if a.name == self.name}
                yield from (alias.name for alias in node.names if alias.name in self.trees)
        # `import package as p` and then `p.name`.
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in aliases:
                yield self.definer(self.name, node.attr)

    def _is_ours(self, module: str) -> bool:
        return module.partition(".")[0] == self.name

    def definer(self, module: str, name: str) -> str:
        """Return the module that defines a name offered by another module."""
        if module not in self.trees or name in self.defined[module]:
            return module
        if name in self.imported[module] and self.imported[module][name] != (module, name):
            return self.definer(*self.imported[module][name])
        # Other names of a folder are its files, including the compiled module.
        return f"{module}.{name}" if module in self.folders else module


def _dotted(path: Path, root: Path) -> str:
    parts = path.relative_to(root).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _read(path: Path) -> str:
    """Text of a file; of a package that imports its names on first use, the text of its stub, which lists them."""
    stub = path.with_suffix(".pyi")
    return (stub if path.name == "__init__.py" and stub.is_file() else path).read_text(encoding="utf-8")


def _definitions(tree: ast.Module) -> Iterator[str]:
    for node in tree.body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef | ast.AsyncFunctionDef):
            yield node.name
        elif isinstance(node, ast.Assign | ast.AnnAssign | ast.AugAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            names = (n.id for target in targets for n in ast.walk(target) if isinstance(n, ast.Name))
            yield from (name for name in names if name != "__all__")


def _names(tree: ast.Module, module: str) -> Iterator[tuple[str, tuple[str, str]]]:
    """Names that the module's `from` imports bind, with their origins; relative imports are those of a package."""
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and (node.module or node.level):
            origin = ".".join([module] * (node.level > 0) + ([node.module] if node.module else []))
            yield from ((alias.asname or alias.name, (origin, alias.name)) for alias in node.names)
