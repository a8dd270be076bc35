"""Tables 5.12 to 5.17 of Liebisch (2021): savings of chosen levels in a turn of the camera."""

from __future__ import annotations

from dataclasses import dataclass

SIZES = (10, 15, 20, 30)
"""Radii of the balls, metres."""
COUNTS = (100, 500, 1000)
"""Numbers of objects in a sphere around the user."""

Row = tuple[float, float, float]
"""A value for each of `COUNTS`."""


@dataclass(frozen=True)
class PrintedTurn:
    """Printed results of the thesis for a headset and a sphere."""

    depth: Row
    """Percentage of full detail's triangles saved by depth."""
    lens: Row
    """Percentage of depth's triangles saved by the lens."""
    millions_off: Row
    """Millions of triangles of a mean frame at full detail, by depth, and through the lens."""
    millions_depth: Row
    millions_lens: Row
    time_depth: Row
    """Percentage of full detail's time saved by depth."""
    time_lens: Row | None
    """Percentage of depth's time saved by the lens; None if below 1.5."""


RIFT_S = {
    10: PrintedTurn(
        (92.2, 91.7, 91.9), (29.5, 29.5, 29.0), (35.8, 175, 334), (2.78, 14.5, 27.0), (1.96, 10.2, 19.2),
        (91.0, 90.8, 91.2), (20.3, 20.9, 19.9),
    ),
    15: PrintedTurn(
        (96.8, 97.4, 97.4), (23.6, 24.7, 24.0), (19.5, 94.9, 179), (0.62, 2.52, 4.71), (0.47, 1.90, 3.58),
        (93.8, 95.8, 96.1), (9.5, 9.7, 10.6),
    ),
    20: PrintedTurn(
        (97.5, 98.6, 98.4), (14.8, 13.2, 14.4), (14.3, 64.7, 132), (0.36, 0.91, 2.10), (0.31, 0.79, 1.79),
        (93.5, 97.0, 96.5), (4.6, 4.6, 4.9),
    ),
    30: PrintedTurn(
        (99.1, 98.8, 98.6), (8.7, 9.1, 9.1), (10.3, 50.5, 96.2), (0.09, 0.62, 1.01), (0.08, 0.57, 0.91),
        (95.7, 95.3, 96.3), None,
    ),
}  # fmt: skip
"""By the radius in metres of the sphere around the user."""

VIVE_PRO = {
    10: PrintedTurn(
        (92.7, 92.5, 92.7), (22.7, 21.6, 21.4), (35.6, 178, 339), (2.61, 13.4, 24.9), (2.02, 10.49, 19.6),
        (91.9, 91.5, 91.8), (14.4, 14.8, 14.7),
    ),
    15: PrintedTurn(
        (97.4, 97.7, 97.6), (19.1, 18.7, 18.1), (20.8, 101, 189), (0.55, 2.37, 4.60), (0.45, 1.93, 3.77),
        (94.5, 96.1, 96.5), (7.4, 7.2, 7.3),
    ),
    20: PrintedTurn(
        (97.4, 98.7, 98.5), (10.4, 10.1, 11.8), (13.8, 69.2, 142), (0.36, 0.92, 2.12), (0.32, 0.83, 1.87),
        (96.7, 97.3, 96.7), (4.2, 4.0, 3.8),
    ),
    30: PrintedTurn(
        (99.0, 99.0, 99.0), (8.6, 9.1, 8.7), (9.29, 56.2, 104), (0.10, 0.56, 1.02), (0.09, 0.51, 0.94),
        (97.5, 96.8, 96.3), None,
    ),
}  # fmt: skip
"""By the radius in metres of the sphere around the user."""
