"""Tests of headsets fitted to a user and to a lens: distances between eyes, lenses and their sources."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import nearfar as nf


@pytest.mark.parametrize("ipd", [64, 64.0, 0.64, 6.4, 0.039, 0.091, 0, -0.064, 1e-9])
def test_distances_that_no_eyes_have_are_refused(ipd: float) -> None:
    message = r"ipd: expected 0.04 to 0.09, in metres: 0.064, not 64; got "
    with pytest.raises(ValueError, match=message):
        nf.hmd.QUEST_2.with_ipd(ipd)
    with pytest.raises(ValueError, match="ipd: expected a finite number"):
        nf.hmd.QUEST_2.with_ipd(math.nan)
    with pytest.raises(TypeError, match="ipd: expected a number, got str"):
        nf.hmd.QUEST_2.with_ipd("64 mm")  # type: ignore[arg-type]


def test_every_profile_has_a_distance_that_eyes_have() -> None:
    for name in nf.hmd.names():
        hmd = nf.hmd.get(name)
        assert math.isclose(hmd.with_ipd(hmd.ipd).ipd, hmd.ipd, rel_tol=1e-12)


def test_the_vive_pros_lens_is_that_of_the_thesis() -> None:
    hmd = nf.hmd.VIVE_PRO
    assert hmd.lens == nf.RadialLens((0.2063, 0.0576))
    assert hmd.lens_radius == math.tan(math.radians(47.5))
    assert hmd.lens_source.startswith("Liebisch (2021)")


def test_a_headset_takes_another_lens(tmp_path: Path) -> None:
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
    for arguments, words in (
        ({"lens_radius": 1.0}, "lens_radius: expected None with the generic lens"),
        ({"source": "me"}, "source: expected None with the generic lens"),
        ({"lens": nf.RadialLens((0.1,)), "lens_radius": 0.0}, "lens_radius: expected a number above 0"),
        ({"lens": nf.RadialLens((0.1,), (0.1, 0.0))}, "lens: expected one without tangential"),
    ):
        with pytest.raises(ValueError, match=words):
            nf.hmd.QUEST_2.with_lens(**arguments)
    with pytest.raises(TypeError, match="source: expected a string, got int"):
        nf.hmd.QUEST_2.with_lens(nf.RadialLens((0.1,)), source=5)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="lens: expected a RadialLens, got tuple"):
        nf.hmd.QUEST_2.with_lens((0.1,))  # type: ignore[arg-type]
