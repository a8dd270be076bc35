"""Visual continuity while rings arrive and grow, at 72 Hz, against hard switches and true pictures of a walk."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, save_figure, start, subplots, table
from benchmarks.stream._near import EYE_HEIGHT
from nearfar.stream._radii import PUBLISHED

RATE, WALK = 72.0, 1.4
"""Pictures per second; speed of a walking user in metres per second."""
BESIDE = 1.0
"""Distance of the user from the centre, metres."""
FINEST = 1e-6
"""1 − SSIM below which the plot's logarithmic axis is linear."""
FOV, SIZE = nf.Fov.symmetric(90, 1.6), (640, 400)


@dataclass(frozen=True)
class Case:
    """A gradual or a sudden change of the picture."""

    name: str
    seconds: float
    """Duration; 0 for a switch from one picture to the next."""
    picture: Callable[[float], nf.Frame]
    """Function that returns the picture at a time; a switch has the old picture at 0 and the new one later."""


@dataclass(frozen=True)
class Continuity:
    """Continuity of pairs of consecutive pictures."""

    case: Case
    times: NDArray[np.float64]
    """Time of each pair, as a share of the duration."""
    continuity: NDArray[np.float64]
    """SSIM of the pair in one window over the whole picture."""
    folded: int
    """Number of folded pictures."""


class City:
    """The procedural city as a bundle, and a user beside its centre who looks along the avenue."""

    def __init__(self, folder: Path, quick: bool) -> None:
        self.scene = nf.datasets.city(blocks=3, detail=0 if quick else 2)
        (x, _, z), self.target = nf.datasets.street_view()
        self.center = (x, EYE_HEIGHT, z)
        size, samples = (256, 1) if quick else (1024, 4)
        self.bundle = nf.stream.export(
            self.scene, folder / "city", center=self.center, radii=PUBLISHED, face_size=size, samples=samples
        )
        self.rings = {ring: self.bundle.at(ring) for ring in (0, 1, 4, 5)}
        self.user = (x - BESIDE, EYE_HEIGHT, z)

    def view(self, ahead: float = 0.0) -> nf.Camera:
        """Return the view of the user, or of a user some metres ahead."""
        eye = (self.user[0], self.user[1], self.user[2] - ahead)
        return nf.Camera.look_at(eye, (eye[0], self.target[1], eye[2] + self.target[2]), fov=FOV, size=SIZE)

    def client_picture(self, ring: int, radius: float | None = None, strength: float = 1.0) -> nf.Frame:
        """Return the client's picture, by bent rays, of a ring at a stage of its morph's growth."""
        grown = self.rings[ring].with_growth(radius if ring else 0.0, strength)
        return grown.render(self.view(), method="exact", channels=("color",))

    def ring_5(self, growth: nf.stream.Growth, time: float) -> nf.Frame:
        """Return the client's picture of ring 5 while its radius grows."""
        return self.client_picture(5, growth.radius(5, time))

    def truth(self, ahead: float) -> nf.Frame:
        """Return the picture of the full scene."""
        return nf.render(self.scene, self.view(ahead), channels=("color",))


def by_time(seconds: float, picture: Callable[[float], nf.Frame]) -> Callable[[float], nf.Frame]:
    """Convert a function of the share of a duration, 0 to 1, to a function of the time in seconds."""
    return lambda time: picture(min(time / seconds, 1.0))


def cases(city: City, quick: bool) -> Iterator[Case]:
    """Yield growth of ring 5, of ring 1 by radius from 0 (CloVR, 2024) and by strength, arrivals, switches, a walk."""
    radii = city.bundle.radii
    first = radii[0]
    still = nf.stream.Growth(radii, fade=0.0)
    for seconds in (still.seconds(5), 1.0):
        grown = nf.stream.Growth(radii, fade=0.0, speed=still.speed * still.seconds(5) / seconds)
        name = f"ring 5, {radii[3]:g} to {radii[4]:g} m, in {seconds:.1f} s: {grown.speed:.2g}°/s"
        yield Case(name, seconds, partial(city.ring_5, grown))
    pictures: dict[str, Callable[[float], nf.Frame]] = {
        "radius": lambda share: city.client_picture(1, first * share),
        "strength": lambda share: city.client_picture(1, first, share),
    }
    for seconds in (1.0,) if quick else (still.seconds(1), 4.0, 1.0):
        for kind, picture in pictures.items():
            yield Case(f"ring 1 by {kind}, in {seconds:.1f} s", seconds, by_time(seconds, picture))
    fade = nf.stream.Growth(radii).fade
    old, new = city.client_picture(4, radii[3]), city.client_picture(5, radii[3])
    zero, one = city.client_picture(0), city.client_picture(1, first, 0.0)
    yield Case("ring 1 arrives, cross-fade", fade, by_time(fade, lambda share: nf.stream.blend(zero, one, share)))
    yield Case("ring 5 arrives, cross-fade", fade, by_time(fade, lambda share: nf.stream.blend(old, new, share)))
    yield Case("ring 1 arrives, without", 0.0, lambda time: one if time else zero)
    yield Case("ring 5 arrives, without", 0.0, lambda time: new if time else old)
    yield Case("ring 1 at once, as CloVRd", 0.0, lambda time: city.client_picture(1, first) if time else zero)
    yield Case("ring 5 at once, as CloVRd", 0.0, lambda time: city.client_picture(5, radii[4]) if time else old)
    yield Case(f"truth, user walks {WALK:g} m/s", 4.0, lambda time: city.truth(WALK * time))


def measure(case: Case, pairs: int) -> Continuity:
    """Measure the continuity of pairs of consecutive pictures; the pairs are spread evenly over the duration."""
    step = 1.0 / RATE
    moments = np.linspace(0.0, max(case.seconds - step, 0.0), pairs if case.seconds else 1)
    similarities, folded = [], 0
    for moment in moments:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            pair = [case.picture(moment), case.picture(moment + step)]
        similarities.append(next(nf.metrics.visual_continuity(pair)))
        folded += sum(frame.stats.get("fold_margin", 1.0) < 0.0 for frame in pair)
    return Continuity(case, moments / max(case.seconds, step), np.array(similarities), folded)


def draw(measured: list[Continuity], path: Path) -> None:
    """Draw 1 − SSIM by the share of the duration; for switches, which have no duration, across the whole width."""
    figure, axes = subplots(1, 2, figsize=(11, 6), sharey=True)
    for axis, word in ((axes[0], "ring 1"), (axes[1], "ring 5")):
        of_panel = [one for one in measured if word in one.case.name or "truth" in one.case.name]
        lengths = sorted({one.case.seconds for one in of_panel if "truth" not in one.case.name})
        for one in (one for one in of_panel if one.case.seconds):
            style = ":" if "truth" in one.case.name else "--" if "radius" in one.case.name else "-"
            color = "black" if "truth" in one.case.name else f"C{lengths.index(one.case.seconds)}"
            axis.plot(one.times, 1.0 - one.continuity, style, color=color, marker=".", label=one.case.name)
        for one in (one for one in of_panel if not one.case.seconds):
            style = "--" if "without" in one.case.name else "-"
            axis.axhline(1.0 - one.continuity[0], color="0.5", linestyle=style, lw=1.2, label=one.case.name)
        axis.set_xlabel("share of the duration")
        # Equal pictures have 0, which a logarithmic axis cannot show.
        axis.set_yscale("symlog", linthresh=FINEST)
        axis.set_yticks([0.0, *(10.0**power for power in range(-6, 0))])
        axis.set_ylim(-0.15 * FINEST, 0.15)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)
    axes[0].set_ylabel(f"1 − SSIM of a picture with the next, {RATE:g} Hz")
    save_figure(figure, path)


def main() -> None:
    options = start(__doc__, "--quick", "--plots")
    with folder_or_temporary() as folder:
        city = City(folder, options.quick)
        print(f"{city.scene.triangle_count:,} triangles, user {BESIDE:g} m beside the centre")
        measured = []
        for case in cases(city, options.quick):
            result = measure(case, 3 if options.quick else 8)
            measured.append(result)
            print(f"{case.name}: {result.continuity.min():.5f}", flush=True)
    rows = [(result.case.name, result.continuity.min(), result.continuity.mean(), result.folded) for result in measured]
    print(table("continuity of consecutive pictures", "change | least {:.5f} | mean {:.5f} | folded pictures", rows))
    if options.plots is not None:
        draw(measured, options.plots / "stream_growth.png")


if __name__ == "__main__":
    main()
