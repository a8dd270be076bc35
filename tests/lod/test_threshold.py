"""f(σ) by its three definitions, and the keywords that select one."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.lod_oracle import random_spheres, usual

CAMERA = nf.Camera((0.5, 1.5, -2.0), fov=nf.Fov(-1.0, 0.9, -1.1, 1.05), size=(1440, 1600))
REFERENCE = nf.lod.reference_solid_angle(CAMERA)
LITERAL = nf.lod.LodThreshold(0.1, 0.8, "literal")


def test_thresholds_equal_the_formulas() -> None:
    sigma = np.geomspace(1e-4, 0.3, 50)
    k, d = 0.3, 0.85
    expected: dict[Any, Any] = {
        "anchored": d + k * (sigma - 0.209),
        "literal": k * sigma + d,
        "normalized": d + k * (sigma / REFERENCE - 1),
    }
    for kind, values in expected.items():
        threshold = nf.lod.LodThreshold(k, d, kind)
        np.testing.assert_allclose(threshold(sigma, REFERENCE), values, rtol=1e-14)
        start, slope = threshold.line(REFERENCE)
        np.testing.assert_array_equal(threshold(sigma, REFERENCE), start + slope * sigma)
        assert threshold(0.1, REFERENCE).shape == ()


def test_an_object_needs_the_same_level_in_every_headset() -> None:
    # The lens of the Vive Pro shows less than its screen: Table 5.9 has the size of 47.5 degrees.
    assert nf.lod.reference_solid_angle(nf.hmd.VIVE_PRO) == pytest.approx(0.238, abs=5e-4)
    starts = {
        nf.lod.LodThreshold().line(nf.lod.reference_solid_angle(hmd))[0]
        for hmd in (nf.hmd.RIFT_CV1, nf.hmd.QUEST_2, nf.hmd.PSVR2)
    }
    assert starts == {0.90 - 0.27 * 0.209}


def test_defaults_are_defined_once() -> None:
    assert nf.lod.LodThreshold() == nf.lod.LodThreshold(k=0.27, d=0.90, kind="anchored")
    package = Path(nf.__file__).parent
    files = [*package.glob("lod/**/*.py"), package / "cli" / "_lod.py"]
    numbers = re.compile(r"(?<![\d.])0\.(?:27|90?)\b")
    found = [(path.name, number) for path in files for number in numbers.findall(path.read_text(encoding="utf-8"))]
    assert found == [("threshold.py", "0.27"), ("threshold.py", "0.90")]


def test_keywords_and_thresholds_are_equivalent(tmp_path: Path) -> None:
    keywords: dict[str, Any] = {"k": LITERAL.k, "d": LITERAL.d, "threshold": LITERAL.kind}
    centers, radii = random_spheres(500, 5, CAMERA)
    where = ([usual()], np.zeros(500, int), centers, radii)
    plain = nf.lod.select(*where, camera=CAMERA)
    chosen = nf.lod.select(*where, camera=CAMERA, threshold=LITERAL)
    assert not np.array_equal(chosen, plain)
    np.testing.assert_array_equal(chosen, nf.lod.select(*where, camera=CAMERA, **keywords))
    np.testing.assert_array_equal(plain, nf.lod.select(*where, camera=CAMERA, threshold=nf.lod.LodThreshold()))
    selector = nf.lod.Selector(threshold=LITERAL, fade=0.5)
    assert selector == nf.lod.Selector(**keywords, fade=0.5)
    assert selector.rules.score_threshold == LITERAL
    assert nf.lod.Selector(selector.rules, fade=0.0) == nf.lod.Selector(threshold=LITERAL)
    one, other = (nf.lod.switches(usual(), view=CAMERA, **how) for how in (keywords, {"threshold": LITERAL}))
    assert np.array_equal(one.solid_angle, other.solid_angle)
    assert not np.array_equal(one.solid_angle, nf.lod.switches(usual(), view=CAMERA).solid_angle)
    usual().export(tmp_path / "one.json", view=CAMERA, threshold=LITERAL)
    usual().export(tmp_path / "other.json", view=CAMERA, **keywords)
    assert (tmp_path / "one.json").read_bytes() == (tmp_path / "other.json").read_bytes()
    # Omitted parts have their defaults.
    assert nf.lod.LodRules(d=0.5).score_threshold == nf.lod.LodThreshold(d=0.5)
    assert nf.lod.LodRules(threshold="literal").score_threshold == nf.lod.LodThreshold(kind="literal")


def test_a_threshold_excludes_its_keywords() -> None:
    for wrong in ({"k": 0.2}, {"d": 0.2}):
        options: dict[str, Any] = {**wrong, "threshold": LITERAL}
        with pytest.raises(ValueError, match=f"{next(iter(wrong))}: expected None beside a LodThreshold, .* got 0.2"):
            nf.lod.Selector(**options)
