"""Tests of the import graph, on a made-up package with every way to hide a cycle."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support.graphs import cycles
from tests.support.python_modules import file_graph


def package(folder: Path, **files: str) -> Path:
    root = folder / "made"
    for name, text in {"__init__": "", **files}.items():
        path = root / f"{name.replace('__in__', '/')}.py"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return root


@pytest.mark.parametrize(
    "back",
    [
        "from made.a import f",
        "def g():\n    from made.a import f",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from made.a import f",
        "from made import a",
        "import made.a",
        "import made\nx = made.f",
        "import made as m\ndef g():\n    return m.f",
        "from made import f",
        "import made.sub\ndef g():\n    return made.sub.f()",
        "from made import sub\ndef g():\n    return sub.f()",
        "from importlib import import_module\ndef g():\n    return import_module('made.a').f()",
        "from importlib import import_module\ndef g():\n    return import_module('.a', __package__).f()",
        "def g():\n    return __import__('made.a')",
        "def g(codecs):\n    return codecs.get('made_a')",
    ],
)
def test_every_kind_of_import_counts(tmp_path: Path, back: str) -> None:
    folders = {"__init__": "from made.a import f\n", "sub__in____init__": "from made.a import f\n"}
    root = package(tmp_path, **folders, a="from made.b import x\ndef f(): ...\n", b=back + "\n")
    assert cycles(file_graph(root, {"made_a": "made.a"})) == [["a.py", "b.py"]]


def test_longer_cycles_are_found(tmp_path: Path) -> None:
    root = package(tmp_path, a="from made.b import y\n", b="from made.c import z\ny = 1\n", c="from made import a\n")
    assert cycles(file_graph(root)) == [["a.py", "b.py", "c.py"]]


def test_re_exports_lead_to_the_file_that_defines_the_name(tmp_path: Path) -> None:
    root = package(
        tmp_path,
        __init__="from made.inner import f\n__all__ = ['f']\n",
        inner__in____init__="from made.inner.deep import f\n",
        inner__in__deep="def f(): ...\n",
        user="from made import f\n",
    )
    assert file_graph(root) == {"inner/deep.py": set(), "user.py": {"inner/deep.py"}}


def test_names_in_a_stub_lead_to_the_file_that_defines_them(tmp_path: Path) -> None:
    root = package(tmp_path, a="from made import g\ndef f(): ...\n", b="from made import f\ndef g(): ...\n")
    (root / "__init__.py").write_text("import lazy_loader\n__getattr__ = lazy_loader.attach_stub(__name__, __file__)\n")
    (root / "__init__.pyi").write_text("from .a import f\nfrom .b import g\nfrom . import b\n")
    assert cycles(file_graph(root)) == [["a.py", "b.py"]]


def test_a_package_that_re_exports_depends_on_its_files(tmp_path: Path) -> None:
    joined = "from made import a, b\nNAME = 'made'\ndef make(): return b.g()\na.set_maker(make)\n"
    root = package(tmp_path, __init__=joined, a="import made\ndef set_maker(make): ...\n", b="def g(): ...\n")
    assert file_graph(root)["__init__.py"] == {"a.py", "b.py"}
    assert cycles(file_graph(root)) == []
    (root / "a.py").write_text("import made\ndef set_maker(make): return made.NAME\n")
    assert cycles(file_graph(root)) == [["__init__.py", "a.py"]]


def test_a_package_file_with_code_is_a_node_of_the_graph(tmp_path: Path) -> None:
    root = package(
        tmp_path,
        inner__in____init__="from made.inner.deep import f\nLIMIT = 3\n",
        inner__in__deep="from made.inner import LIMIT\ndef f(): ...\n",
    )
    assert cycles(file_graph(root)) == [["inner/__init__.py", "inner/deep.py"]]
