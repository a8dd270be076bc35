"""Settings of a measurement, and the keywords that stand for them."""

from __future__ import annotations

import pickle
from typing import Any

import pytest

import nearfar as nf
from nearfar.lod._measure.settings import MeasureKeywords
from tests.support.lod_cases import SMALL, assert_same, levels


def test_keywords_are_the_fields_of_the_settings() -> None:
    assert MeasureKeywords.__annotations__.keys() == nf.lod.MeasureSettings.__annotations__.keys()
    for name, kind in MeasureKeywords.__annotations__.items():
        assert kind.__forward_arg__ == nf.lod.MeasureSettings.__annotations__[name]


def test_settings_measure_as_keywords_do() -> None:
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
        ({"settings": nf.lod.MeasureSettings(**SMALL), "views": 8}, ValueError, "views: expected it in settings alone"),
        ({"settings": 3}, TypeError, "settings: expected MeasureSettings, got int"),
        ({"sides": 8}, TypeError, "unexpected keyword argument 'sides'"),
        ({}, ValueError, "hmd: expected a headset such as nearfar.hmd.RIFT_S, or else both fov and size"),
    ],
)
def test_bad_arguments(options: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        nf.lod.measure(levels(4), **options)
