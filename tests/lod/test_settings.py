"""Settings of a measurement, and the equivalent keywords."""

from __future__ import annotations

import pickle
from typing import Any

import pytest

import nearfar as nf
from tests.support.lod_cases import SMALL, assert_same, levels


def test_settings_and_keywords_are_equivalent() -> None:
    settings = nf.lod.MeasureSettings(**SMALL)
    one, other = nf.lod.measure(levels(12, 6), settings=settings), nf.lod.measure(levels(12, 6), **SMALL)
    assert_same(one, other)
    assert one.measured["views"] == settings.views == 8
    assert pickle.loads(pickle.dumps(settings)) == settings
    headset = nf.lod.MeasureSettings(hmd=nf.hmd.RIFT_S)
    assert headset.size is None
    assert headset.screen.size == nf.hmd.RIFT_S.render_size


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ({"sides": 8}, TypeError, "sides: expected a parameter .* such as MeasureSettings"),
        ({}, ValueError, "hmd: expected a headset such as nearfar.hmd.RIFT_S, or else both fov and size"),
    ],
)
def test_invalid_combinations_are_refused(options: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        nf.lod.measure(levels(4), **options)


BAD: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"fov": None}, ValueError, "hmd: expected a headset"),
    ({"size": None}, ValueError, "hmd: expected a headset"),
    ({"hmd": nf.hmd.RIFT_S}, ValueError, "hmd: expected None beside fov and size"),
    ({"fov": nf.Fov.symmetric(152)}, ValueError, "fov: expected less than 151.9 degrees"),
    ({"views": 10, "directions": "published"}, ValueError, "views: expected a multiple of 4 for published directions"),
    ({"client": 3}, TypeError, "client: expected a distributed.Client"),
]


@pytest.mark.parametrize(("change", "error", "message"), BAD, ids=[message for *_, message in BAD])
def test_bad_arguments_are_named(change: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        nf.lod.measure(levels(4), **SMALL | change)


def test_workers_and_clients_exclude_each_other() -> None:
    own = levels(4)
    with pytest.raises(ValueError, match="workers: expected None with a client"):
        nf.lod.measure([own], **SMALL, workers=2, client=object())
