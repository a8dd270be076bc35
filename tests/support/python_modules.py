"""Finds which file of a Python package uses which other one, from the imports alone."""

from __future__ import annotations

import ast
import gc
from collections.abc import Iterator, Mapping
from pathlib import Path


def file_graph(package: Path, entries: Mapping[str, str] | None = None) -> dict[str, set[str]]:
    """The files that each file of a package uses, by their paths below its folder.

    An import counts for the file that defines the name, through any number of re-exports. Imports inside functions,
    under TYPE_CHECKING and by a string count. An `__init__.py` that defines nothing only documents and re-exports: it
    is left out.

    Parameters
    ----------
    package
        Its folder.
    entries
        Modules by the names of their entry points, by which other packages import them.
    """
    # Trees of all files are millions of objects, which the collector would scan again and again.
    gc.disable()
    try:
        return _Package(package, entries or {}).graph()
    finally:
        gc.enable()


class _Package:
    def __init__(self, folder: Path, entries: Mapping[str, str]) -> None:
        self.name, self.entries, self.folder = folder.name, entries, folder
        self.paths = {_dotted(path, folder.parent): path for path in sorted(folder.rglob("*.py"))}
        self.trees = {module: ast.parse(_read(path)) for module, path in self.paths.items()}
        self.nodes = {module: list(ast.walk(tree)) for module, tree in self.trees.items()}
        self.folders = {module for module, path in self.paths.items() if path.name == "__init__.py"}
        self.defined = {module: set(_definitions(tree)) for module, tree in self.trees.items()}
        self.imported = {module: dict(_names(tree, module)) for module, tree in self.trees.items()}

    def graph(self) -> dict[str, set[str]]:
        files = {
            module: path.relative_to(self.folder).as_posix()
            for module, path in self.paths.items()
            if module not in self.folders or self.defined[module]
        }
        return {
            file: {files[name] for name in self._used(module) if name in files} - {file}
            for module, file in files.items()
        }

    def _used(self, module: str) -> Iterator[str]:
        """Modules to which a module refers, by imports, by names in imported modules, and by strings."""
        modules: dict[str, str] = {}
        for node in self.nodes[module]:
            if isinstance(node, ast.ImportFrom) and node.module and self._is_ours(node.module):
                for alias in node.names:
                    found = self.definer(node.module, alias.name)
                    yield found
                    if found.endswith(f".{alias.name}") and alias.name not in self.defined.get(found, ()):
                        modules[alias.asname or alias.name] = found
            elif isinstance(node, ast.Import):
                for alias in filter(lambda alias: self._is_ours(alias.name), node.names):
                    modules[alias.asname or self.name] = alias.name if alias.asname else self.name
                    # A use of the whole package counts by the names that follow.
                    if alias.name != self.name:
                        yield alias.name
        for node in self.nodes[module]:
            if isinstance(node, ast.Attribute):
                yield self._referred(node, modules)
            elif isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value != self.name:
                yield self.entries.get(node.value, node.value)
                if node.value.startswith("."):
                    # As in `import_module(".name", __package__)`.
                    yield (module if module in self.folders else module.rpartition(".")[0]) + node.value

    def _referred(self, node: ast.expr, modules: Mapping[str, str]) -> str:
        """The module that an expression such as `package.folder.name` names or reaches into; empty for others."""
        if isinstance(node, ast.Name):
            return modules.get(node.id, "")
        if not isinstance(node, ast.Attribute):
            return ""
        within = self._referred(node.value, modules)
        return self.definer(within, node.attr) if within in self.trees else ""

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
    """Text of a file; for a package with lazy imports, together with that of its stub, which lists them."""
    stub = path.with_suffix(".pyi")
    listed = stub.read_text(encoding="utf-8") if path.name == "__init__.py" and stub.is_file() else ""
    return path.read_text(encoding="utf-8") + listed


def _definitions(tree: ast.Module) -> Iterator[str]:
    for node in tree.body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef | ast.AsyncFunctionDef):
            yield node.name
        elif isinstance(node, ast.Assign | ast.AnnAssign | ast.AugAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            names = (n.id for target in targets for n in ast.walk(target) if isinstance(n, ast.Name))
            yield from (name for name in names if not name.startswith("__"))


def _names(tree: ast.Module, module: str) -> Iterator[tuple[str, tuple[str, str]]]:
    """Names that the module's `from` imports bind, with their origins; relative imports are those of a package."""
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and (node.module or node.level):
            origin = ".".join([module] * (node.level > 0) + ([node.module] if node.module else []))
            yield from ((alias.asname or alias.name, (origin, alias.name)) for alias in node.names)
