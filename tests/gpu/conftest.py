"""The adapters, shared by tests of graphics adapters."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.support.gpu_cases import ADAPTERS, adapter


@pytest.fixture(params=ADAPTERS)
def backend(request: pytest.FixtureRequest) -> Iterator[str]:
    """Select each adapter in turn."""
    with adapter(request.param):
        yield request.param
