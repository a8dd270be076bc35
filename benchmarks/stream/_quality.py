"""Pictures of encoded near geometry and maps compared with those of uncompressed ones, and with the truth."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.stream._near import Place

FOV, SIZE = nf.Fov.symmetric(90, 1.6), (640, 400)
"""Field of view and size of the views."""
TURNS = (0.4, 2.0, 3.5, 5.1)
"""Viewing directions of a user, radians."""


def cameras(place: Place) -> Iterator[nf.Camera]:
    """Views of users beside the centre."""
    for user in place.users:
        eye = np.add(place.center, user)
        for turn in TURNS:
            target = np.add(eye, (np.cos(turn), 0.03, np.sin(turn)))
            yield nf.Camera.look_at(eye, target, fov=FOV, size=SIZE)


HEADER = " | PSNR {:.2f} | SSIM {:.4f} | least PSNR {:.1f} | least SSIM {:.4f} | PSNR to the truth {:.2f} | SSIM {:.4f}"


def rows(
    place: Place, truth: nf.Scene, base: nf.ReducedScene, others: Mapping[str, nf.ReducedScene]
) -> list[list[object]]:
    """PSNR and SSIM of all pictures, in sRGB codes: mean and least against the base, mean against the truth."""
    sources = {"without loss": base, **others}
    against_base: dict[str, list[tuple[float, float]]] = {name: [] for name in sources}
    against_truth: dict[str, list[tuple[float, float]]] = {name: [] for name in sources}
    for camera in cameras(place):
        true = nf.render(truth, camera).to_image()
        pictures = {name: nf.render(source, camera).to_image() for name, source in sources.items()}
        for name, picture in pictures.items():
            against_truth[name].append(similarity(true, picture))
            if name != "without loss":
                against_base[name].append(similarity(pictures["without loss"], picture))
    found: list[list[object]] = []
    for name, own in against_base.items():
        known = [*np.mean(own, axis=0), *np.min(own, axis=0)] if own else [None] * 4
        found.append([name, *known, *np.mean(against_truth[name], axis=0)])
    return found


def similarity(reference: NDArray[np.uint8], test: NDArray[np.uint8]) -> tuple[float, float]:
    """PSNR in dB and SSIM."""
    return nf.psnr(reference, test, data_range=255), nf.ssim(reference, test, data_range=255)
