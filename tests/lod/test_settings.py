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
def test_bad_combinations(options: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        nf.lod.measure(levels(4), **options)


BAD: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"fov": None}, ValueError, "hmd: expected a headset"),
    ({"size": None}, ValueError, "hmd: expected a headset"),
    ({"hmd": nf.hmd.RIFT_S}, ValueError, "hmd: expected None beside fov and size"),
    ({"hmd": "Rift", "fov": None, "size": None}, TypeError, "hmd: expected an Hmd"),
    ({"fov": 90}, TypeError, "fov: expected Fov"),
    ({"fov": nf.Fov.symmetric(152)}, ValueError, "fov: expected less than 151.9 degrees"),
    ({"size": (0, 10)}, ValueError, "size"),
    ({"views": 3}, ValueError, "views: expected a whole number from 4"),
    ({"views": 10, "directions": "published"}, ValueError, "views: expected a multiple of 4 for published directions"),
    ({"directions": "all"}, ValueError, "directions: expected one of 'even', 'published', got 'all'"),
    ({"directions": 3}, TypeError, "directions: expected a string"),
    ({"views": 8.0}, TypeError, "views"),
    ({"distances": 0}, ValueError, "distances"),
    ({"percentile": 101}, ValueError, "percentile: expected a number from 0 to 100"),
    ({"percentile": float("nan")}, ValueError, "percentile"),
    ({"step": 0}, ValueError, "step"),
    ({"saturated": 1.5}, ValueError, "saturated"),
    ({"samples": 0}, ValueError, "samples"),
    ({"backend": "tpu"}, ValueError, "backend"),
    ({"cache": "yes"}, TypeError, "cache: expected True or False"),
    ({"workers": 0}, ValueError, "workers"),
    ({"client": 3}, TypeError, "client: expected a distributed.Client"),
]


@pytest.mark.parametrize(("change", "error", "message"), BAD, ids=[message for *_, message in BAD])
def test_bad_arguments_are_named(change: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        nf.lod.measure(levels(4), **SMALL | change)


def test_bad_levels_are_named() -> None:
    own = levels(4)
    wrongs: list[tuple[Any, str]] = [
        (3, "levels: expected Levels"),
        ("ball", "levels: expected Levels"),
        ([own, 3], r"levels\[1\]: expected Levels, got int"),
        ({"a": own[0]}, r"levels\['a'\]: expected Levels, got Level"),
    ]
    for wrong, message in wrongs:
        with pytest.raises(TypeError, match=message):
            nf.lod.measure(wrong, **SMALL)
    with pytest.raises(ValueError, match="workers: expected None beside a client"):
        nf.lod.measure([own], **SMALL, workers=2, client=object())
