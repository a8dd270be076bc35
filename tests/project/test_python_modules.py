"""Tests of the graph of imports, on a made-up package with every way to hide a circle."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support.graphs import circles
from tests.support.python_modules import uses


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
    ],
)
def test_every_kind_of_import_counts(tmp_path: Path, back: str) -> None:
    root = package(tmp_path, __init__="from made.a import f\n", a="from made.b import x\ndef f(): ...\n", b=back + "\n")
    assert circles(uses(root)) == [["made.a", "made.b"]]


def test_a_longer_way_round_is_found(tmp_path: Path) -> None:
    root = package(tmp_path, a="from made.b import y\n", b="from made.c import z\ny = 1\n", c="from made import a\n")
    assert circles(uses(root)) == [["made.a", "made.b", "made.c"]]


def test_re_exports_lead_to_the_file_that_defines_the_name(tmp_path: Path) -> None:
    root = package(
        tmp_path,
        __init__="from made.inner import f\n__all__ = ['f']\n",
        inner__in____init__="from made.inner.deep import f\n",
        inner__in__deep="def f(): ...\n",
        user="from made import f\n",
    )
    assert uses(root) == {"made.inner.deep": set(), "made.user": {"made.inner.deep"}}


def test_names_of_a_stub_lead_to_the_file_that_defines_them(tmp_path: Path) -> None:
    root = package(tmp_path, a="from made import g\ndef f(): ...\n", b="from made import f\ndef g(): ...\n")
    (root / "__init__.py").write_text("import lazy_loader\n__getattr__ = lazy_loader.attach_stub(__name__, __file__)\n")
    (root / "__init__.pyi").write_text("from .a import f\nfrom .b import g\nfrom . import b\n")
    assert circles(uses(root)) == [["made.a", "made.b"]]


def test_a_folder_that_computes_is_a_file_like_others(tmp_path: Path) -> None:
    root = package(
        tmp_path,
        inner__in____init__="from made.inner.deep import f\nLIMIT = 3\n",
        inner__in__deep="from made.inner import LIMIT\ndef f(): ...\n",
    )
    assert circles(uses(root)) == [["made.inner", "made.inner.deep"]]
