"""CloVR's (2024) sphere collection by simulated users, compared with the printed figures.

--real also runs the users in real time on a server of this machine, which takes as long as the trials.
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
from nearfar.serve._limits import Rooms
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
    """Means by level, per sphere and per trial; the paper does not state which of the two it prints."""
    trial_misses: tuple[float, ...]
    r: float
    """Pearson's correlation of seconds and misses per sphere."""
    round_trip: tuple[float, float, float] | None = None
    """Mean, standard deviation and maximum, milliseconds."""


PRINTED_MISSES = (3.56, 3.73, 14.9)
PRINTED_SECONDS = ((4.07, 1.45), (4.37, 1.38), (7.13, 5.14))
PRINTED = Figures("printed", (26.3, 10.9), PRINTED_SECONDS, PRINTED_MISSES, PRINTED_MISSES, 0.927, (58.0, 14.0, 195.0))


def figures(name: str, outcomes: Sequence[Outcome], trips: np.ndarray | None = None) -> Figures:
    """Compute the figures of trials, and of round trips in seconds."""
    spheres = [sphere for outcome in outcomes for sphere in outcome.spheres]
    levels = [[sphere for sphere in spheres if sphere.level == level] for level in LEVELS]
    return Figures(
        name,
        _moments([len(outcome.spheres) for outcome in outcomes]),
        tuple(_moments([sphere.seconds for sphere in level]) for level in levels),
        tuple(statistics.mean(sphere.misses for sphere in level) for level in levels),
        tuple(sum(sphere.misses for sphere in level) / len(outcomes) for level in levels),
        float(np.corrcoef([sphere.seconds for sphere in spheres], [sphere.misses for sphere in spheres])[0, 1]),
        None if trips is None else (1e3 * trips.mean(), 1e3 * trips.std(ddof=1), 1e3 * trips.max()),
    )


def simulate_groups(name: str, settings: Settings, person: Person, pairs: int) -> Figures:
    """Simulate pairs of groups, each with its own clock, spheres and people."""
    each = (simulate(replace(settings, seed=n), person=person, groups=GROUPS, seed=n) for n in range(pairs))
    return figures(name, [outcome for outcomes in each for outcome in outcomes])


Played = tuple[list[Outcome], np.ndarray]
"""A user's outcomes, and its round trips in seconds."""


def play_group(url: str, group: int, settings: Settings, person: Person) -> list[Played]:
    """Let a group's users play in real time, in this process."""

    async def play_user(seed: int) -> Played:
        async with nf.stream.client.join(url, room="collect", name=f"simulated {seed}", group=group) as room:
            return await play(room, settings, person=person, seed=seed), room.round_trips

    async def play_users() -> list[Played]:
        return await asyncio.gather(*(play_user(100 * group + user) for user in range(settings.users)))

    return asyncio.run(play_users())


def real(settings: Settings, person: Person) -> Figures:
    """Let two groups play in a room of a server, with a process for each group."""
    site = Site({"a.txt": b"a"}, has_page=False)
    context = multiprocessing.get_context("spawn")
    with Server({"": site}, rooms=Rooms()) as server, ProcessPoolExecutor(GROUPS, mp_context=context) as pool:
        futures = [pool.submit(play_group, server.url, group, settings, person) for group in range(1, GROUPS + 1)]
        groups = [future.result() for future in futures]
    trips = np.concatenate([user_trips for users in groups for _, user_trips in users])
    return figures("real server", [outcome for users in groups for outcome in users[0][0]], trips)


def show(columns: Sequence[Figures]) -> None:
    rows: list[list[object]] = [["spheres of a trial", *("{:.1f} ± {:.1f}".format(*each.spheres) for each in columns)]]
    for number, level in enumerate(LEVELS):
        rows.append([f"seconds, {level}", *("{:.2f} ± {:.2f}".format(*each.seconds[number]) for each in columns)])
    for number, level in enumerate(LEVELS):
        misses = (f"{each.misses[number]:.2f} / {each.trial_misses[number]:.1f}" for each in columns[1:])
        rows.append([f"misses, {level}: of a sphere / of a trial", f"{PRINTED.misses[number]}", *misses])
    rows.append(["r of seconds and misses", *(f"{each.r:.3f}" for each in columns)])
    trips = (each.round_trip and "{:.1f} ± {:.1f}, at most {:.0f}".format(*each.round_trip) for each in columns)
    rows.append(["round trip, ms", *trips])
    print(table("Sphere collection", ["", *(each.name for each in columns)], rows))


def _moments(values: Sequence[float]) -> tuple[float, float]:
    return statistics.mean(values), statistics.stdev(values)


COLORS = ("0.35", "C0", "C1", "C2")


def draw(path: Path, rows: Sequence[Figures]) -> None:
    """Seconds with their deviations, and misses, by level; the first row is the paper's."""
    figure, (left, right) = subplots(1, 2, figsize=(9, 3.6))
    width = 0.8 / len(rows)
    for number, (row, color) in enumerate(zip(rows, COLORS, strict=False)):
        x = np.arange(len(LEVELS)) + (number - 0.5 * (len(rows) - 1)) * width
        means, deviations = zip(*row.seconds, strict=True)
        # Error bars are cut at 0, because times are not negative.
        bars = (np.minimum(deviations, means), deviations)
        left.bar(x, means, width, yerr=bars, color=color, capsize=3, label=row.name)
        right.bar(x, row.misses, width, color=color)
    for axes, label in ((left, "seconds of a sphere, ± one deviation"), (right, "misses of a sphere")):
        axes.set_xticks(range(len(LEVELS)), LEVELS)
        axes.set(ylabel=label)
    right.set(title="of a sphere or a trial: the paper does not say", ylim=(0.0, None))
    right.title.set_fontsize("small")
    left.set(ylim=(0.0, None))
    left.legend(fontsize="small", loc="upper left")
    save_figure(figure, path, dpi=70)


def main() -> None:
    pairs, on_server = (8, "pairs of groups of the model"), (bool, "also on a server, in real time")
    options = start(__doc__, "--quick", "--plots", pairs=pairs, real=on_server)
    settings = Settings(duration=30.0, rest=1.0) if options.quick else Settings()
    plain = simulate_groups("model, literature alone", settings, Person(), options.pairs)
    # The search time is fitted so that easy spheres take the printed time; nothing else is fitted.
    person = Person(search=max(PRINTED.seconds[0][0] - plain.seconds[0][0], 0.0))
    calibrated = simulate_groups(f"model, {person.search:.2f} s of search", settings, person, options.pairs)
    columns = [PRINTED, plain, calibrated]
    if options.real:
        columns.append(real(settings, person))
    show(columns)
    if options.plots is not None:
        draw(options.plots / "collect.png", columns)


if __name__ == "__main__":
    main()
