"""The street and its reduced scene, shared by several tests."""

from __future__ import annotations

import pytest

import nearfar as nf
from tests.support.reduce_cases import CENTER, R1, R2, street


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return street()


@pytest.fixture(scope="module")
def blend(scene: nf.Scene) -> nf.ReducedScene:
    return nf.reduce(
        scene, center=CENTER, r1=R1, r2=R2, face_size=512, samples=1, channels=("color", "range", "object_id")
    )
