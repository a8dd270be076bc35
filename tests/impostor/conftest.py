"""The yard and its impostors, shared by several tests."""

from __future__ import annotations

import pytest

import nearfar as nf
from tests.support.impostor_cases import SETTINGS, yard


@pytest.fixture(scope="session")
def scene() -> nf.Scene:
    return yard()


@pytest.fixture(scope="session")
def impostors(scene: nf.Scene) -> nf.Impostors:
    return nf.reduce(scene, far="impostors", **SETTINGS)
