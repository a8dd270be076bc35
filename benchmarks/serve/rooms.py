"""Rooms: round trips, residence, CPU, memory and bytes of users, also over a slow link, during attacks, and for hours.

Builds the examples `rooms_load` and `link` of rust/serve. Users and server share the machine's cores. `link` needs
Linux and root: it creates two network namespaces and carries packets between them with a delay and losses.
"""

from __future__ import annotations

import itertools
import json
import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from benchmarks.harness.report import start, table
from benchmarks.harness.timing import ahead_of_others

ROOT = Path(__file__).parents[2]
EXAMPLES = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release" / "examples"
GROUP, HERTZ = 4, 72
USERS = (8, 32, 200, 1000)
LINK_USERS = (8, 32)
DELAY_MS, MBIT, LOSSES = 10, 100, (0, 1, 2)
"""Delay, rate and losses of the link in each direction; losses in per cent."""
NEAR, FAR = ("nf-near", "10.77.0.1"), ("nf-far", "10.77.0.2")
ATTACKS = ("garbage", "flood-pose", "flood-say", "flood-signal", "churn", "mute", "vanish", "slow")
ATTACKED_USERS = 32
HOUR_RATE, HOUR_SECONDS, STAY_SECONDS = 10, 360, 6
"""An hour simulated in a tenth of its time: ten times the rate of poses; users come and go each simulated minute."""

Figures = dict[str, Any]
HEADER = (
    "round trip, median ms {:.2f} | 99 % {:.2f} | user to user, median ms {:.2f} | 99 % {:.2f}"
    " | residence, 99 % within ms {:.3f} | share within 1.02 ms {:.4f}"
)
COSTS = (
    "cores {:.2f} | µs a pose {:.0f} | kB a user {:.0f} | B up a pose {:.1f} | closed form | B down a pose {:.1f}"
    " | closed form"
)


def load(users: int, hertz: float, seconds: float, *options: str, inside: str | None = None) -> Figures:
    """Measure users on a server; return the figures of both."""
    prefix = ["ip", "netns", "exec", inside] if inside else []
    command = [*prefix, str(EXAMPLES / "rooms_load"), *map(str, (users, GROUP, hertz, seconds)), *options]
    with ahead_of_others():
        return dict(json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout))


def times(figures: Figures) -> list[float]:
    """Columns of HEADER."""
    trips = [figures[name][part] or float("nan") for name in ("round_trip", "way") for part in ("median", "99")]
    return [*trips, figures["residence"]["99"], figures["residence"]["share_within_1.02"]]


def costs(figures: Figures) -> list[float]:
    """Columns of COSTS."""
    names = ("cores", "microseconds_per_pose", "kilobytes_per_user")
    sides = (f"{name}_{side}" for side in ("up", "down") for name in ("bytes", "closed_form"))
    return [figures[name] for name in (*names, *sides)]


@contextmanager
def link(loss: float) -> Iterator[list[str]]:
    """Carry packets between two namespaces; yield the options that make the server run in one of them."""
    command = [str(EXAMPLES / "link"), *NEAR, *FAR, str(DELAY_MS), str(MBIT), str(loss)]
    with ahead_of_others():
        process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    with process:
        assert process.stdout
        assert process.stdin
        if process.stdout.readline().strip() != "ready":
            raise SystemExit("link: it needs Linux, root, `ip` and /dev/net/tun")
        yield ["--in", NEAR[0], "--serve", f"{NEAR[1]}:0"]
        process.stdin.close()


def measure_users(seconds: float, protocol: list[str]) -> None:
    rows = []
    for users in USERS:
        figures = load(users, HERTZ, seconds, *protocol)
        rows.append([users, figures["poses_per_second"], *times(figures), *costs(figures)])
    print(table("Users", f"users | poses/s each {{:.1f}} | {HEADER} | {COSTS}", rows))


def measure_losses(seconds: float, protocol: list[str]) -> None:
    rows = []
    for users, loss in itertools.product(LINK_USERS, LOSSES):
        with link(loss) as options:
            figures = load(users, HERTZ, seconds, *options, *protocol, inside=FAR[0])
        rows.append([users, loss, *times(figures), figures["unsettled"]])
    title = f"A link of {DELAY_MS} ms and {MBIT} Mb/s in each direction"
    print(table(title, f"users | loss % | {HEADER} | unsettled {{:.0f}}", rows))


def measure_attacks(seconds: float, protocol: list[str]) -> None:
    """Measure users while eight others misbehave in the group of the first four."""
    rows = []
    for attack in ("nobody", *ATTACKS, "nobody"):
        options = [] if attack == "nobody" else ["--attack", attack]
        figures = load(ATTACKED_USERS, HERTZ, seconds, *options, *protocol)
        rows.append([attack, *times(figures), figures["unsettled"]])
    print(table("Attacks", f"meanwhile | {HEADER} | unsettled {{:.0f}}", rows))


def measure_hour(protocol: list[str]) -> None:
    """Measure the server's memory over an hour of eight users."""
    figures = load(8, HOUR_RATE * HERTZ, HOUR_SECONDS, "--stay", str(STAY_SECONDS), *protocol)
    print(f"{figures['poses_per_second'] * 8 * HOUR_SECONDS:.0f} poses; MB after each tenth of an hour:")
    print(", ".join(f"{kilobytes / 1e3:.2f}" for kilobytes in figures["kilobytes"]), "\n")


def main() -> None:
    arguments = start(
        __doc__,
        parts={"nargs": "*", "choices": ["users", "link", "attacks", "hour", []]},
        seconds=8.0,
        by={"choices": ["websocket", "datagrams"], "default": "websocket"},
    )
    command = ["cargo", "build", "--release", "--quiet", "-p", "nearfar-serve", "--examples"]
    subprocess.run(command, cwd=ROOT, check=True)
    parts, protocol = arguments.parts or ["users", "link", "attacks", "hour"], ["--by", arguments.by]
    for name, measure in {"users": measure_users, "link": measure_losses, "attacks": measure_attacks}.items():
        if name in parts:
            measure(arguments.seconds, protocol)
    if "hour" in parts:
        measure_hour(protocol)


if __name__ == "__main__":
    main()
