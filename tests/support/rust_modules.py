"""Finds which file of a Rust crate uses which: a parser of imports and paths, sufficient to find cycles.

An import counts as one of the file that defines the name, through any number of `pub use`. A `mod.rs` or `lib.rs` that
only declares, documents and re-exports is no file of the graph; one that defines an item is. Tests are excluded.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

TYPES = {"struct", "enum", "union", "trait", "type"}
"""Kinds of items that a path may continue after."""

NOISE = re.compile(
    r"""//[^\n]* | /\*.*?\*/ | b?r(?P<hashes>\#*)".*?"(?P=hashes) | b?"(?:\\.|[^"\\])*" | b?'(?:\\[^']+|[^\\'\n])'""",
    re.DOTALL | re.VERBOSE,
)
ATTRIBUTE = re.compile(r"\s*#!?\[(?:[^\[\]]|\[[^\[\]]*\])*\]")
TEST_ONLY = re.compile(r"#\[\s*(?:test\b|cfg\s*\(\s*(?:(?:all|any)\s*\(\s*)?(?:test|fuzzing)\b)")
VISIBILITY = re.compile(r"\s*(?:pub\b\s*(?:\([^)]*\))?\s*)?")
FUNCTION = re.compile(r"(?:(?:const|async|unsafe|extern)\s+)*fn\s+(\w+)")
ITEM = re.compile(r"(?:unsafe\s+)?(struct|enum|union|trait|type|const|static)\s+(?:mut\s+)?(\w+)")
PATH = re.compile(r"(?<![\w.:])(?:[A-Za-z_]\w*)(?:\s*::\s*[A-Za-z_]\w*)+")


@dataclass(eq=False)
class Module:
    """A file, or a module within braces in one."""

    file: str
    parent: Module | None
    children: dict[str, Module] = field(default_factory=dict)
    items: dict[str, set[str]] = field(default_factory=dict)
    """Names that the module defines, each with its kinds: a function and a type may share a name."""
    imports: list[tuple[str, list[str]]] = field(default_factory=list)
    """Name (`*` for all) and path of each import."""
    code: str = ""
    """Code without imports and declarations."""

    def share_macros(self) -> None:
        """Mark the module's macros as known to other files without an import."""
        for kinds in self.items.values():
            if "macro" in kinds:
                kinds.add("shared")

    def walk(self) -> Iterator[Module]:
        """Yield the module and the modules within braces in it."""
        yield self
        for child in self.children.values():
            if child.file == self.file:
                yield from child.walk()


# reading -------------------------------------------------------------------------------------------------------------
def bare(text: str) -> str:
    """Remove comments and strings from code."""
    return NOISE.sub(" ", text).replace("$crate", "crate")


def statements(text: str) -> Iterator[str]:
    """Yield the items of a module, each with its attributes."""
    start = depth = 0
    for found in re.finditer(r"[(){}\[\];]", text):
        depth += {"(": 1, "[": 1, "{": 1, ";": 0}.get(found[0], -1)
        if depth or found[0] not in ";}" or (found[0] == "}" and ends_with_semicolon(text[start : found.start()])):
            continue
        yield text[start : found.end()]
        start = found.end()


def ends_with_semicolon(statement: str) -> bool:
    head = VISIBILITY.sub("", without_attributes(statement), count=1)
    return bool(re.match(r"(?:use|const(?!\s+fn)|static|type)\b", head))


def without_attributes(statement: str) -> str:
    while found := ATTRIBUTE.match(statement):
        statement = statement[found.end() :]
    return statement


def leaves(tree: str, before: list[str]) -> Iterator[tuple[str, list[str]]]:
    """Yield name and path of everything that the tree of a `use` imports."""
    tree = tree.strip()
    if found := re.match(r"([\w\s:]*?)(?:::)?\s*\{(.*)\}$", tree, re.DOTALL):
        path = before + re.findall(r"\w+", found[1])
        for part in split_at_commas(found[2]):
            yield from leaves(part, path)
        return
    path_text, _, alias = re.sub(r"\s+as\s+", "=", tree).partition("=")
    path = before + re.findall(r"\w+|\*", path_text)
    if path and path[-1] == "self" and len(path) > 1:
        path = path[:-1]
    if path:
        yield (alias.strip() or path[-1]), (path[:-1] if path[-1] == "*" else path)


def split_at_commas(text: str) -> Iterator[str]:
    start = depth = 0
    for at, character in enumerate(text):
        depth += {"{": 1, "}": -1}.get(character, 0)
        if character == "," and depth == 0:
            yield text[start:at]
            start = at + 1
    yield text[start:]


def read(module: Module, text: str, folder: Path, root: Path) -> None:
    """Fill a module from its text; `folder` has the files of the modules that it declares."""
    for statement in statements(text):
        head = VISIBILITY.sub("", without_attributes(statement), count=1)
        attributes = statement[: len(statement) - len(head)]
        if TEST_ONLY.search(attributes):
            continue
        if found := re.match(r"use\b(.*);", head, re.DOTALL):
            module.imports += leaves(found[1], [])
        elif found := re.match(r"mod\s+(\w+)\s*;", head):
            child = module.children[found[1]] = file_module(folder, found[1], module, root)
            if "macro_use" in attributes:
                child.share_macros()
        elif found := re.match(r"mod\s+(\w+)\s*\{(.*)\}", head, re.DOTALL):
            child = module.children[found[1]] = Module(module.file, module)
            read(child, found[2], folder / found[1], root)
        else:
            module.code += head
            note_items(module, head)
            if "macro_export" in attributes:
                module.share_macros()


def note_items(module: Module, head: str) -> None:
    def note(name: str, kind: str) -> None:
        module.items.setdefault(name, set()).add(kind)

    if found := FUNCTION.match(head):
        note(found[1], "fn")
    elif found := ITEM.match(head):
        note(found[2], found[1])
    elif found := re.match(r"macro_rules!\s*(\w+)", head):
        note(found[1], "macro")
    elif re.match(r"[\w:]+!", head):
        # A macro that receives functions or types usually defines items of these names.
        for name in re.findall(r"\bfn\s+(\w+)", head):
            note(name, "fn")
        for kind, name in re.findall(r"\b(struct|enum|trait|static|const)\s+(\w+)", head):
            note(name, kind)
    # Imports within functions, and those of modules that a macro creates, count as the module's.
    for opening, inner in re.findall(r"(mod\s+\$\w+\s*\{|[{;])\s*use\b([^;]*);", head):
        for alias, path in leaves(inner, []):
            made = opening.startswith("mod") and path[0] == "super"
            module.imports.append((alias, ["self", *path[1:]] if made else path))


def file_module(folder: Path, name: str, parent: Module, root: Path) -> Module:
    path = folder / f"{name}.rs"
    if not path.is_file():
        path = folder / name / "mod.rs"
    module = Module(path.relative_to(root).as_posix(), parent)
    read(module, bare(path.read_text(encoding="utf-8")), folder / name, root)
    return module


# resolving -----------------------------------------------------------------------------------------------------------
Found = tuple[set[Module], set[tuple[str, str]]]
"""Modules found, and items found as file and kind."""


def look_up(module: Module, name: str, visited: set[tuple[int, str]]) -> Found:
    """Find all items of a name in a module: its definitions and its imports."""
    modules: set[Module] = set()
    items: set[tuple[str, str]] = set()
    if (id(module), name) in visited:
        return modules, items
    visited.add((id(module), name))
    if name in module.children:
        modules.add(module.children[name])
    items |= {(module.file, kind) for kind in module.items.get(name, ())}
    for alias, path in module.imports:
        if alias == name:
            found = resolve(module, path, visited)
        elif alias == "*":
            sources = resolve(module, path, visited)[0]
            each = [look_up(source, name, visited) for source in sources]
            found = set().union(*(one[0] for one in each)), set().union(*(one[1] for one in each))
        else:
            continue
        modules |= found[0]
        items |= found[1]
    return modules, items


def resolve(module: Module, path: list[str], visited: set[tuple[int, str]] | None = None) -> Found:
    """Find the items that a path in a module refers to; none for names of other crates."""
    visited = set() if visited is None else visited
    at = module
    rest = list(path)
    anchored = False
    while rest and rest[0] in ("crate", "self", "super"):
        anchored = True
        step = rest.pop(0)
        while step == "crate" and at.parent:
            at = at.parent
        if step == "super" and at.parent:
            at = at.parent
    if not rest:
        return ({at} if anchored else set()), set()
    modules: set[Module] = {at}
    items: set[tuple[str, str]] = set()
    for number, name in enumerate(rest):
        # A lookup by a longer path differs from one by a name on its way.
        fresh = visited if number == 0 else set(visited)
        each = [look_up(one, name, fresh) for one in modules]
        inner = set().union(*(one[0] for one in each))
        found = set().union(*(one[1] for one in each))
        if not inner and not found and (number > 0 or anchored):
            # A name that cannot be resolved counts as one of the module that should have it.
            return modules, items
        modules = inner
        is_last = number == len(rest) - 1
        items |= {(file, kind) for file, kind in found if is_last or kind in TYPES}
    return modules, items


def names_of(module: Module, visited: set[int] | None = None) -> set[str]:
    """Names that a module offers to a glob import."""
    visited = set() if visited is None else visited
    if id(module) in visited:
        return set()
    visited.add(id(module))
    names = set(module.items) | set(module.children)
    for alias, path in module.imports:
        if alias == "*":
            names = names.union(*(names_of(source, visited) for source in resolve(module, path)[0]))
        else:
            names.add(alias)
    return names


# the graph -----------------------------------------------------------------------------------------------------------
def is_declaring(module: Module) -> bool:
    """True for a `mod.rs` or `lib.rs` that defines nothing."""
    return Path(module.file).name in ("mod.rs", "lib.rs") and not any(one.code.strip() for one in module.walk())


def all_files(module: Module) -> Iterator[Module]:
    yield module
    for child in module.children.values():
        for one in all_files(child):
            if one.file != module.file:
                yield one


def file_graph(source: Path) -> dict[str, set[str]]:
    """The files that each file of a crate uses, by their paths below the folder of its `lib.rs` or `main.rs`."""
    first = "lib.rs" if (source / "lib.rs").is_file() else "main.rs"
    root = Module(first, None)
    read(root, bare((source / first).read_text(encoding="utf-8")), source, source)
    files = {module.file: module for module in all_files(root)}
    silent = {name for name, module in files.items() if is_declaring(module)}
    macros = {
        name: file
        for file, module in files.items()
        for one in module.walk()
        for name, kinds in one.items.items()
        if "shared" in kinds
    }
    graph: dict[str, set[str]] = {}
    for name, module in files.items():
        if name not in silent:
            used = set().union(*(used_by(one, macros) for one in module.walk()))
            graph[name] = used - silent - {name}
    return graph


def used_by(module: Module, macros: dict[str, str]) -> set[str]:
    """Files that a module's imports and paths refer to."""
    words = set(re.findall(r"\w+", module.code))
    paths = [re.findall(r"\w+", found) for found in PATH.findall(module.code)]
    imported = {alias for alias, _ in module.imports}
    for alias, path in module.imports:
        if alias == "*":
            for source in resolve(module, path)[0]:
                paths += [[*path, name] for name in names_of(source) & words - set(module.items)]
        else:
            paths.append(path)
    files = set()
    for path in paths:
        modules, items = resolve(module, path)
        files |= {file for file, _ in items} | {one.file for one in modules}
    called = set(re.findall(r"\b(\w+)!", module.code)) - imported - set(module.items)
    return files | {macros[name] for name in called & set(macros)}
