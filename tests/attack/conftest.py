"""Fixtures of the tests with hostile arguments."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.support.valid_calls.objects import Valid


@pytest.fixture(scope="session")
def valid_objects(tmp_path_factory: pytest.TempPathFactory) -> Valid:
    return Valid(tmp_path_factory.mktemp("files"))


@pytest.fixture(scope="module")
def valid(valid_objects: Valid, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Valid]:
    """Return valid arguments; the working folder is empty, because some texts are valid file names."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("working"))
        patch.setenv("MPLBACKEND", "agg")
        yield valid_objects
