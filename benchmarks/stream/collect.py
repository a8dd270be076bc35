"""CloVR's (2024) sphere collection by simulated users, compared with the printed figures.

--real also lets them play on a server of this machine, which takes as long as the trials do.
"""

from __future__ import annotations

import asyncio
import multiprocessing
import statistics
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table
from nearfar.serve._rooms import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from nearfar.stream.collect import Outcome, Person, Settings, play, simulate

LEVELS = ("easy", "intermediate", "hard")
GROUPS = 2
"""Number of groups at the same time."""


@dataclass(frozen=True)
class Figures:
    """Figures of several trials, in the paper's form."""

    name: str
    spheres: tuple[float, float]
    """Mean and standard deviation of the spheres per trial."""
    seconds: tuple[tuple[float, float], ...]
    """Mean and standard deviation of the seconds per sphere, by level."""
    misses: tuple[float, ...]
    """Means by level, per sphere and per trial; the paper does not state which it prints."""
    trial_misses: tuple[float, ...]
    r: float
    """Pearson's correlation of seconds and misses per sphere."""
    round_trip: tuple[float, float, float] | None = None
    """Mean, standard deviation and maximum, milliseconds."""


PRINTED = Figures(
    "printed",
    (26.3, 10.9),
    ((4.07, 1.45), (4.37, 1.38), (7.13, 5.14)),
    (3.56, 3.73, 14.9),
    (3.56, 3.73, 14.9),
    0.927,
    (58.0, 14.0, 195.0),
)


def figures(name: str, outcomes: Sequence[Outcome], trips: np.ndarray | None = None) -> Figures:
    """Compute the figures of trials, and of round trips in seconds."""
    spheres = [sphere for outcome in outcomes for sphere in outcome.spheres]
    levels = [[sphere for sphere in spheres if sphere.level == level] for level in LEVELS]
    r = np.corrcoef([sphere.seconds for sphere in spheres], [sphere.misses for sphere in spheres])[0, 1]
    return Figures(
        name,
        _moments([len(outcome.spheres) for outcome in outcomes]),
        tuple(_moments([sphere.seconds for sphere in level]) for level in levels),
        tuple(statistics.mean(sphere.misses for sphere in level) for level in levels),
        tuple(sum(sphere.misses for sphere in level) / len(outcomes) for level in levels),
        float(r),
        None if trips is None else (1e3 * trips.mean(), 1e3 * trips.std(ddof=1), 1e3 * trips.max()),
    )


def simulate_groups(name: str, settings: Settings, person: Person, pairs: int) -> Figures:
    """Simulate pairs of groups, each with its own clock, spheres and people."""
    each = (simulate(replace(settings, seed=n), person=person, groups=GROUPS, seed=n) for n in range(pairs))
    return figures(name, [outcome for outcomes in each for outcome in outcomes])


def calibrate(uncalibrated: Figures) -> Person:
    """People whose search times make easy spheres take the printed time; nothing else is fitted."""
    return Person(search=max(PRINTED.seconds[0][0] - uncalibrated.seconds[0][0], 0.0))


async def _play(
    url: str, group: int, seed: int, settings: Settings, person: Person
) -> tuple[list[Outcome], np.ndarray]:
    async with nf.stream.client.join(url, room="collect", name=f"simulated {seed}", group=group) as room:
        return await play(room, settings, person=person, seed=seed), room.round_trips


def play_group(url: str, group: int, settings: Settings, person: Person) -> list[tuple[list[Outcome], np.ndarray]]:
    """Let a group's users play in real time, in this process."""

    async def all_of_them() -> list[tuple[list[Outcome], np.ndarray]]:
        seeds = (100 * group + user for user in range(settings.users))
        return await asyncio.gather(*(_play(url, group, seed, settings, person) for seed in seeds))

    return asyncio.run(all_of_them())


def real(settings: Settings, person: Person) -> Figures:
    """Let two groups play in a room of a server, with a process for each group."""
    site = Site({"a.txt": b"a"}, has_page=False)
    context = multiprocessing.get_context("spawn")
    with Server({"": site}, rooms=Rooms()) as server, ProcessPoolExecutor(GROUPS, mp_context=context) as pool:
        playing = [pool.submit(play_group, server.url, group, settings, person) for group in range(1, GROUPS + 1)]
        users = [each.result() for each in playing]
    trips = np.concatenate([found for group in users for _, found in group])
    return figures("real server", [outcome for group in users for outcome in group[0][0]], trips)


def show(found: Sequence[Figures]) -> None:
    """Print the table of the paper's figures."""
    rows: list[list[object]] = [["spheres of a trial", *("{:.1f} ± {:.1f}".format(*each.spheres) for each in found)]]
    for number, level in enumerate(LEVELS):
        rows.append([f"seconds, {level}", *("{:.2f} ± {:.2f}".format(*each.seconds[number]) for each in found)])
    for number, level in enumerate(LEVELS):
        both = (f"{each.misses[number]:.2f} / {each.trial_misses[number]:.1f}" for each in found[1:])
        rows.append([f"misses, {level}: of a sphere / of a trial", f"{PRINTED.misses[number]}", *both])
    rows.append(["r of seconds and misses", *(f"{each.r:.3f}" for each in found)])
    trips = (each.round_trip and "{:.1f} ± {:.1f}, at most {:.0f}".format(*each.round_trip) for each in found)
    rows.append(["round trip, ms", *trips])
    print(table("Sphere collection", ["", *(each.name for each in found)], rows))


def _moments(values: Sequence[float]) -> tuple[float, float]:
    return statistics.mean(values), statistics.stdev(values)


COLORS = ("0.35", "C0", "C1", "C2")


def draw(path: Path, names: Sequence[str], rows: Sequence[Figures]) -> None:
    """Seconds with their deviations, and misses, by level; the first row is the paper's."""
    figure, (left, right) = subplots(1, 2, figsize=(9, 3.6))
    width = 0.8 / len(rows)
    for number, (row, color) in enumerate(zip(rows, COLORS, strict=False)):
        at = np.arange(len(names)) + (number - 0.5 * (len(rows) - 1)) * width
        means, deviations = zip(*row.seconds, strict=True)
        # Bars of deviations end at 0, as times do.
        below = np.minimum(deviations, means)
        left.bar(at, means, width, yerr=(below, deviations), color=color, capsize=3, label=row.name)
        right.bar(at, row.misses, width, color=color)
    for axes, label in ((left, "seconds of a sphere, ± one deviation"), (right, "misses of a sphere")):
        axes.set_xticks(range(len(names)), names)
        axes.set(ylabel=label)
    right.set(title="of a sphere or a trial: the paper does not say", ylim=(0.0, None))
    right.title.set_fontsize("small")
    left.set(ylim=(0.0, None))
    left.legend(fontsize="small", loc="upper left")
    save_figure(figure, path, dpi=70)


def main() -> None:
    chosen = start(
        __doc__,
        "--quick",
        "--plots",
        pairs=(8, "pairs of groups of the model"),
        real=(bool, "also on a server, in real time"),
    )
    settings = Settings(duration=30.0, rest=1.0) if chosen.quick else Settings()
    plain = simulate_groups("model, literature alone", settings, Person(), chosen.pairs)
    person = calibrate(plain)
    found = [PRINTED, plain, simulate_groups(f"model, {person.search:.2f} s of search", settings, person, chosen.pairs)]
    if chosen.real:
        found.append(real(settings, person))
    show(found)
    if chosen.plots is not None:
        draw(chosen.plots / "collect.png", LEVELS, found)


if __name__ == "__main__":
    main()
