"""Vectors of the four-parameter logistic curve in exact arithmetic: y = d + (a−d) / (1 + (x/c)^b), b > 0, c > 0."""

from __future__ import annotations

from typing import Any

from tests.vectors.exact import STEP_64, above, document, exact, rounded

Parameters = tuple[float, float, float, float]


def curve(parameters: Parameters, x: float) -> Any:
    """y at x ≥ 0."""
    a, b, c, d = (exact.mpf(value) for value in parameters)
    return d + (a - d) / (1 + (exact.mpf(x) / c) ** b)


CURVES: tuple[tuple[str, Parameters], ...] = (
    ("falling", (0.95, 1.5, 0.03, 0.4)),
    ("rising", (0.2, 2.25, 0.7, 0.99)),
    ("b = 1", (1.0, 1.0, 0.01, 0.5)),
    ("b below 1", (0.9, 0.6, 0.2, 0.1)),
    ("steep", (0.97, 9.0, 0.125, 0.35)),
    ("plateaus of both signs", (-3.0, 2.0, 40.0, 5.0)),
    ("a plateau at 0", (1.0, 1.75, 1e-4, 0.0)),
)

SHARES = (0.0, 1e-6, 0.01, 0.3, 0.75, 1.0, 1.25, 3.0, 100.0, 1e6)
"""Values of x as shares of c: the first plateau, the bend, the second plateau."""


def values() -> list[dict[str, Any]]:
    """Values of curves at x."""
    found = []
    for region, parameters in CURVES:
        a, b, c, d = parameters
        x = [share * c for share in SHARES]
        # ln(x/c) and its product with b round the exponent, of up to 14 b; by which y moves by up to |a−d|/4 of that.
        bound = 4 * STEP_64 * (max(abs(a), abs(d)) + 14 * b * abs(a - d) / 4)
        found.append(
            {
                "region": region,
                **dict(zip("abcd", parameters, strict=True)),
                "tolerance": {"float64": above(bound)},
                "x": x,
                "y": [rounded(curve(parameters, value)) for value in x],
            }
        )
    return found


def fits() -> list[dict[str, Any]]:
    """Samples of curves that show both plateaus."""
    found = []
    for region, parameters in CURVES:
        _, b, c, _ = parameters
        # Both ends lie within 1e-4 of their plateaus.
        reach = 4.0 / b
        x = [float(f"{c * 10 ** (reach * (2 * n / 20 - 1)):.6g}") for n in range(21)]
        found.append(
            {
                "region": region,
                **dict(zip("abcd", parameters, strict=True)),
                "tolerance": {"float64": 1e-9},
                "x": x,
                "y": [rounded(curve(parameters, value)) for value in x],
            }
        )
    return found


def files() -> dict[str, str]:
    """Texts of the files by name."""
    text = document(
        holds="Values y of curves at x for parameters a, b, c, d; and samples from which a fit of least squares must "
        "find the parameters again.",
        units="any: x is a size such as a solid angle in steradians, y a quality such as SSIM.",
        source="y = d + (a-d) / (1 + (x/c)^b): Liebisch (2021); b is above 0, so a is y at 0 and d at infinity.",
        tolerance={
            "float64": "Values: 4 roundings of the plateaus and of the exponent b ln(x/c), by which y moves by (a-d)/4 "
            "of it. Fits: share of b, c and of the plateaus' greater size for a and d, as nearfar.lod.fit_4pl states "
            "for samples without noise that show both plateaus.",
        },
        values=values(),
        fits=fits(),
    )
    return {"fit_4pl.json": text}
