"""The adapters and a city, shared by tests of graphics adapters."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

import nearfar as nf
from tests.support.gpu_cases import ADAPTERS, adapter


@pytest.fixture(params=ADAPTERS)
def backend(request: pytest.FixtureRequest) -> Iterator[str]:
    """Select each adapter in turn."""
    with adapter(request.param):
        yield request.param


@pytest.fixture(scope="session")
def city() -> nf.Scene:
    """A city whose first five cars may move."""
    return nf.datasets.city(blocks=3, detail=1).with_dynamic([f"car_{number}" for number in range(5)])
