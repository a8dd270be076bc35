"""Every public callable refuses unusable arguments with messages that name them, whatever is passed."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.support.argument_cases import cases
from tests.support.public_callables import public_callables
from tests.support.valid_calls import Valid, valid_arguments


@pytest.fixture(scope="module")
def valid(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Valid]:
    """Valid arguments; the working folder is empty, because some texts are valid names of files."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("working"))
        yield Valid(tmp_path_factory.mktemp("files"))


def test_every_public_callable_has_a_valid_call(valid: Valid) -> None:
    assert {name.partition(" @")[0] for name in valid_arguments(valid)} == public_callables().keys()
    failed = {name: error for name, case in cases(valid).items() if (error := case.attempt()) is not None}
    assert failed == {}
