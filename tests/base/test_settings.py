"""Groups of settings: keywords replace fields, and typed keywords agree with the fields of their dataclass."""

from __future__ import annotations

import dataclasses
import importlib
import typing
from dataclasses import dataclass
from pathlib import Path

import pytest

import nearfar
import nearfar as nf
from nearfar._base.settings import gather

PACKAGE = Path(nearfar.__file__).parent
SUFFIX = "Keywords"


@dataclass(frozen=True)
class Exposure:
    stops: float = 0.0
    gamma: float = 2.2

    def __post_init__(self) -> None:
        if self.gamma <= 0.0:
            raise ValueError(f"gamma: expected a number above 0, got {self.gamma}")


def test_keywords_replace_fields() -> None:
    assert gather(Exposure, None, {}) == Exposure()
    assert gather(Exposure, None, {"stops": 1.0}) == Exposure(1.0)
    assert gather(Exposure, Exposure(1.0, 1.8), {"stops": 2.0}) == Exposure(2.0, 1.8)
    with pytest.raises(ValueError, match=r"^gamma: expected a number above 0"):
        gather(Exposure, Exposure(), {"gamma": 0.0})
    with pytest.raises(
        TypeError,
        match=r"^stop: expected a parameter .* such as Exposure \(stops, gamma\)",
    ):
        gather(Exposure, None, {"stop": 1.0})
    with pytest.raises(TypeError, match=r"^settings: expected Exposure"):
        gather(Exposure, 1.0, {})


def test_keywords_replace_fields_that_exclude_them() -> None:
    within = nf.RadiusSettings(budget=1000, reach=5.0)
    assert gather(nf.RadiusSettings, within, {"r2": 50.0}) == nf.RadiusSettings(r2=50.0, reach=5.0)
    assert gather(nf.RadiusSettings, nf.RadiusSettings(reach=5.0), {"budget": 9}).budget == 9
    assert gather(nf.RadiusSettings, within, {"r2": None}) == within
    with pytest.raises(ValueError, match=r"^r2: expected either r2 or budget, got both"):
        gather(nf.RadiusSettings, within, {"r2": 50.0, "budget": 9})
    assert gather(nf.LoadOptions, nf.LoadOptions(triangles=5), {"error": 2.0}) == nf.LoadOptions(error=2.0)
    fov = nf.Fov.symmetric(90.0)
    screen = nf.lod.MeasureSettings(hmd=nf.hmd.RIFT_S)
    assert gather(nf.lod.MeasureSettings, screen, {"fov": fov, "size": (64, 64)}).hmd is None
    threshold = nf.lod.LodThreshold(0.3, 0.8)
    rules = nf.lod.LodRules(k=2.0, d=0.1)
    assert gather(nf.lod.LodRules, rules, {"threshold": threshold}) == nf.lod.LodRules(threshold=threshold)
    assert gather(nf.lod.LodRules, nf.lod.LodRules(threshold=threshold), {"k": 2.0}) == nf.lod.LodRules(k=2.0, d=0.8)
    assert gather(nf.lod.LodRules, rules, {"threshold": "literal"}).k == 2.0


def test_typed_keywords_are_the_fields_of_their_settings() -> None:
    """`XKeywords` types the keywords of the dataclass `XSettings` (or `XOptions`, …) of the same module."""
    compared = 0
    for path in PACKAGE.rglob("*.py"):
        if f"{SUFFIX}(TypedDict" not in path.read_text(encoding="utf-8"):
            continue
        module = importlib.import_module(".".join(["nearfar", *path.relative_to(PACKAGE).with_suffix("").parts]))
        own = [kind for kind in vars(module).values() if getattr(kind, "__module__", None) == module.__name__]
        for typed in (kind for kind in own if typing.is_typeddict(kind) and kind.__name__.endswith(SUFFIX)):
            stem = typed.__name__.removesuffix(SUFFIX)
            kinds = (kind for kind in own if isinstance(kind, type) and dataclasses.is_dataclass(kind))
            (settings,) = (kind for kind in kinds if kind.__name__.startswith(stem))
            expected = {field.name: typing.ForwardRef(str(field.type)) for field in dataclasses.fields(settings)}
            found = {name: typing.ForwardRef(kind.__forward_arg__) for name, kind in typed.__annotations__.items()}
            assert list(found.items()) == list(expected.items()), typed
            compared += 1
    assert compared > 0
