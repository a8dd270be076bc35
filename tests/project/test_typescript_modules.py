"""Tests of the parser of TypeScript imports, on made-up files with every kind of cycle."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support.graphs import cycles
from tests.support.typescript_modules import file_graph


def folder(root: Path, **files: str) -> Path:
    for name, text in files.items():
        path = root / f"{name.replace('__in__', '/')}.ts"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return root


@pytest.mark.parametrize(
    "back",
    [
        "import { f } from './a';",
        "import type { F } from './a';",
        "import f, { type F } from './a';",
        'import * as a from "./a";',
        "import {\n  f,\n  type F,\n} from './a';",
        "const one = 1; import './a';",
        "export { f } from './a';",
        "export type { F } from './a';",
        "export * from './a';",
        "export * as a from './a';",
        "async function g() {\n  const { f } = await import('./a');\n}",
        "let f: typeof import('./a');",
        "const worker = new Worker(new URL('a.js', import.meta.url));",
        "import TEXT from 'a-text';",
    ],
)
def test_every_kind_of_import_counts(tmp_path: Path, back: str) -> None:
    root = folder(tmp_path, a="import { x } from './b';\nexport const f = x;\n", b=f"{back}\nexport const x = 1;\n")
    assert cycles(file_graph(root, {"a.js": "a.ts", "a-text": "a.ts"})) == [["a.ts", "b.ts"]]


def test_paths_lead_through_folders_and_their_index(tmp_path: Path) -> None:
    root = folder(
        tmp_path,
        inner__in__index="export { f } from './deep';\n",
        inner__in__deep="import type { X } from '../user';\nexport const f = 1;\n",
        user="import { f } from './inner';\nexport type X = typeof f;\n",
    )
    assert cycles(file_graph(root)) == [["inner/deep.ts", "inner/index.ts", "user.ts"]]


@pytest.mark.parametrize(
    "text",
    [
        "// import { f } from './a';\n",
        "/** Like import('./a').\n import { f } from './a'; */\n",
        "import { f } from 'a';\nconst url = 'https://example.org/'; // import('./a')\n",
        "import { f } from '../elsewhere';\n",
        "import data from './data.json';\n",
        "const text = \"from './a'\";\n",
    ],
)
def test_comments_packages_and_other_folders_make_no_cycle(tmp_path: Path, text: str) -> None:
    folder(tmp_path, elsewhere="export const f = 1;\n")
    root = folder(tmp_path / "source", a="import { x } from './b';\n", b=text)
    (root / "data.json").write_text("{}", encoding="utf-8")
    assert file_graph(root) == {"a.ts": {"b.ts"}, "b.ts": set()}


def test_a_path_without_a_file_and_an_unknown_script_fail(tmp_path: Path) -> None:
    with pytest.raises(AssertionError, match="no file"):
        file_graph(folder(tmp_path / "path", a="import { f } from './b';\n"))
    with pytest.raises(KeyError, match="worker"):
        file_graph(folder(tmp_path / "script", a="new URL('worker.js', import.meta.url);\n"))
