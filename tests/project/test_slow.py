"""Tests of the selection of slow tests for a change."""

from __future__ import annotations

import pytest

from tests import slow
from tests.support import changes, need
from tests.support.changes import ALL, stages_of

EXPECTED = {
    "python/nearfar/stereo/rig.py": {"stereo", "cli"},
    "python/nearfar/view/_page.py": {"view", "serve", "cli"},
    "python/nearfar/_lens/radial.py": {"lens", "hmd", "lod", "orthoview", "serve", "stereo", "view", "cli"},
    "rust/core/src/stereo/mod.rs": {"stereo", "cli"},
    "rust/core/src/export/mod.rs": {"stream", "orthoview", "view", "serve", "cli"},
    "rust/core/src/base/pool.rs": {ALL},
    "rust/py/src/convert/run.rs": {ALL},
    "rust/py/src/stereo.rs": {"stereo", "cli"},
    "rust/serve/src/server.rs": {"serve", "view"},
    "web/src/page.ts": {"view", "orthoview"},
    "web/src/orthoview/page.ts": {"orthoview"},
    "tests/lod/test_fit.py": {"lod"},
    "tests/support/vectors.py": {ALL},
    "tests/conftest.py": {ALL},
    "python/nearfar/_base/check.py": {ALL},
    "python/nearfar/__init__.py": {ALL},
    "pyproject.toml": {ALL},
    "Cargo.lock": {ALL},
    ".ci/run": {ALL},
    ".ci/landed": set(),
    "a/new/folder.py": {ALL},
    "docs/lod.md": {"project"},
    "benchmarks/lod/fit.py": set(),
}


@pytest.mark.parametrize("path", EXPECTED)
def test_a_change_selects_its_stage_and_dependent_stages(path: str) -> None:
    assert stages_of(path) == EXPECTED[path]


def test_every_selectable_folder_exists() -> None:
    need("git")
    listed = slow.git("ls-files")
    assert listed is not None
    folders = set().union(*(stages_of(path) for path in listed.splitlines()))
    assert {name for name in folders - {ALL} if not (slow.CHECKOUT / "tests" / name).is_dir()} == set()
    assert folders >= changes.ROOMS


def test_three_commits_run_all_slow_tests(monkeypatch: pytest.MonkeyPatch) -> None:
    reasons = {"view": "web/src/page.ts"}
    history = {"rev-parse": "false\n", "rev-list": "7"}
    monkeypatch.setattr(slow, "git", lambda command, *_: history[command])
    parts = []
    for count in (7, 8, 9):
        history["rev-list"] = str(count)
        parts.append(slow.third(reasons))
    assert sorted(sum(parts, slow.files_of(reasons))) == slow.slow_files()
    history |= {"rev-parse": "true\n", "rev-list": "1"}
    assert slow.third(reasons) == parts[2]


def test_without_the_previous_commit_everything_is_selected(monkeypatch: pytest.MonkeyPatch) -> None:
    assert slow.changes(None) == (None, "no commit is given")
    monkeypatch.setattr(slow, "git", lambda *_: None)
    assert slow.changes("0" * 40)[0] is None
    assert slow.files_of({ALL: ""}) == slow.slow_files()
