"""Published lenses of viewers without a profile, one of which is the generic lens."""

from __future__ import annotations

from nearfar._lens.lens import RadialLens

CARDBOARD_LENSES = {"Cardboard I/O 2014 (V1)": (0.441, 0.156), "Cardboard I/O 2015 (V2)": (0.34, 0.55)}
"""Lens coefficients of viewers that have no profile, in the form of `Hmd.lens` with a `lens_radius` of 1, so that r is
the tangent itself. Source: immersive-web/cardboard-vr-display src/device-info.js."""

GENERIC_VIEWER = "Cardboard I/O 2015 (V2)"
GENERIC_LENS = RadialLens(CARDBOARD_LENSES[GENERIC_VIEWER])
"""Lens for headsets whose own is unpublished, with a `lens_radius` of 1; it is that of the second Cardboard viewer."""
GENERIC_RADIUS = 1.0
"""Tangent at which the generic lens has r = 1."""
GENERIC_SOURCE = f"generic, that of {GENERIC_VIEWER}: immersive-web/cardboard-vr-display src/device-info.js"
"""Source of the generic lens, as `Hmd.sources` names it."""
