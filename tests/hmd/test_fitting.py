"""Tests of headsets fitted to a user and to a lens: distances between eyes, lenses and their sources."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import nearfar as nf


def test_every_profile_has_a_realistic_eye_distance() -> None:
    for name in nf.hmd.names():
        hmd = nf.hmd.get(name)
        assert math.isclose(hmd.with_ipd(hmd.ipd).ipd, hmd.ipd, rel_tol=1e-12)


def test_the_vive_pros_lens_equals_the_thesis() -> None:
    hmd = nf.hmd.VIVE_PRO
    assert hmd.lens == nf.RadialLens((0.2063, 0.0576))
    assert hmd.lens_radius == math.tan(math.radians(47.5))
    assert hmd.lens_source.startswith("Liebisch (2021)")


def test_a_headset_accepts_another_lens(tmp_path: Path) -> None:
    assert nf.hmd.QUEST_2.lens_source == ""
    generic = nf.hmd.QUEST_2.with_lens()
    assert (generic.lens, generic.lens_radius) == (nf.hmd.GENERIC_LENS, 1.0)
    assert generic.lens_source.startswith("generic, that of Cardboard I/O 2015 (V2): immersive-web/")
    assert generic.sources[:-1] == nf.hmd.QUEST_2.sources
    given = nf.hmd.RIFT_S.with_lens(nf.RadialLens((0.1,)), lens_radius=0.9, source="measured by us")
    assert (given.lens_source, given.lens_radius) == ("measured by us", 0.9)
    assert not any("Liebisch" in source for source in given.sources)
    assert given.with_lens(nf.RadialLens((0.2,))).lens_source == "given by the caller"
    generic.save(tmp_path / "generic.json")
    assert nf.Hmd.load(tmp_path / "generic.json") == generic
    one = nf.Hmd(
        name="one", left=nf.hmd.VIVE.left, right=nf.hmd.VIVE.right, render_size=(2, 2), lens=nf.RadialLens((0.1,))
    )
    assert one.lens_source == "not stated"
    with pytest.raises(ValueError, match="lens: expected a lens without tangential"):
        nf.hmd.QUEST_2.with_lens(nf.RadialLens((0.1,), (0.1, 0.0)))
