"""Rooms: round trips, residence, CPU, memory and bytes of users, also over a slow link, during attacks, and for hours.

python -m benchmarks.serve.rooms [users] [link] [attacks] [hour] [--seconds N] [--by WAY]

Builds the examples `rooms_load` and `link` of rust/serve. Users and server share the machine's cores. `link` needs
Linux and root: it creates two network namespaces and carries packets between them with a delay and losses.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from benchmarks.harness.timing import ahead_of_others, machine, table

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
"""An hour in a tenth of its time: poses ten times as often, and users who come and go each minute of that hour."""

Figures = dict[str, Any]
HEADER = [
    "round trip, median ms",
    "99 %",
    "user to user, median ms",
    "99 %",
    "residence, 99 % within ms",
    "share within 1.02 ms",
]
COSTS = ["cores", "µs a pose", "kB a user", "B up a pose", "closed form", "B down a pose", "closed form"]


def load(users: int, hertz: float, seconds: float, *options: str, inside: str | None = None) -> Figures:
    """Measure users on a server; return the figures of both."""
    within = ["ip", "netns", "exec", inside] if inside else []
    arguments = [str(users), str(GROUP), str(hertz), str(seconds), *options]
    command = [*within, str(EXAMPLES / "rooms_load"), *arguments]
    with ahead_of_others():
        told: Figures = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)
    return told


def times(figures: Figures) -> list[str]:
    """Format the columns of HEADER."""
    shown = [
        f"{figures[name][part] or float('nan'):.2f}" for name in ("round_trip", "way") for part in ("median", "99")
    ]
    residence = figures["residence"]
    return [*shown, f"{residence['99']:.3f}", f"{residence['share_within_1.02']:.4f}"]


def costs(figures: Figures) -> list[str]:
    """Format the columns of COSTS."""
    counts = (
        f"{figures['cores']:.2f}",
        f"{figures['microseconds_per_pose']:.0f}",
        f"{figures['kilobytes_per_user']:.0f}",
    )
    sides = [(f"{figures[f'bytes_{side}']:.1f}", f"{figures[f'closed_form_{side}']}") for side in ("up", "down")]
    return [*counts, *sides[0], *sides[1]]


@contextmanager
def link(loss: float) -> Iterator[list[str]]:
    """Carry packets between two namespaces; yield the options that make the server run in one of them."""
    command = [str(EXAMPLES / "link"), *NEAR, *FAR, str(DELAY_MS), str(MBIT), str(loss)]
    with ahead_of_others():
        running = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    with running:
        assert running.stdout
        assert running.stdin
        if running.stdout.readline().strip() != "ready":
            raise SystemExit("link: it needs Linux, root, `ip` and /dev/net/tun")
        yield ["--in", NEAR[0], "--serve", f"{NEAR[1]}:0"]
        running.stdin.close()


def by_users(seconds: float, way: list[str]) -> None:
    """Measure users on loopback."""
    rows = []
    for users in USERS:
        figures = load(users, HERTZ, seconds, *way)
        rows.append([str(users), f"{figures['poses_per_second']:.1f}", *times(figures), *costs(figures)])
    print(table("Users", ["users", "poses/s each", *HEADER, *COSTS], rows))


def by_loss(seconds: float, way: list[str]) -> None:
    """Measure users behind a link that loses packets."""
    rows = []
    for users in LINK_USERS:
        for loss in LOSSES:
            with link(loss) as options:
                figures = load(users, HERTZ, seconds, *options, *way, inside=FAR[0])
            rows.append([str(users), str(loss), *times(figures), f"{figures['unsettled']:.0f}"])
    title = f"A link of {DELAY_MS} ms and {MBIT} Mb/s in each direction"
    print(table(title, ["users", "loss %", *HEADER, "unsettled"], rows))


def by_attack(seconds: float, way: list[str]) -> None:
    """Measure users while eight others misbehave in the group of the first four."""
    rows = []
    for attack in ("nobody", *ATTACKS, "nobody"):
        options = [] if attack == "nobody" else ["--attack", attack]
        figures = load(ATTACKED_USERS, HERTZ, seconds, *options, *way)
        rows.append([attack, *times(figures), f"{figures['unsettled']:.0f}"])
    print(table("Attacks", ["meanwhile", *HEADER, "unsettled"], rows))


def by_hour(way: list[str]) -> None:
    """Measure the server's memory over an hour of eight users."""
    options = ["--stay", str(STAY_SECONDS), *way]
    figures = load(8, HOUR_RATE * HERTZ, HOUR_SECONDS, *options)
    print(f"{figures['poses_per_second'] * 8 * HOUR_SECONDS:.0f} poses; MB after each tenth of an hour:")
    print(", ".join(f"{kilobytes / 1e3:.2f}" for kilobytes in figures["kilobytes"]), "\n")


def main() -> None:
    """Print the requested tables."""
    parser = argparse.ArgumentParser()
    parser.add_argument("parts", nargs="*", choices=["users", "link", "attacks", "hour", []])
    parser.add_argument("--seconds", type=float, default=8.0)
    parser.add_argument("--by", choices=["websocket", "datagrams"], default="websocket")
    arguments = parser.parse_args()
    command = ["cargo", "build", "--release", "--quiet", "-p", "nearfar-serve", "--examples"]
    subprocess.run(command, cwd=ROOT, check=True)
    print(machine(), "\n")
    parts = arguments.parts or ["users", "link", "attacks", "hour"]
    for name, measure in {"users": by_users, "link": by_loss, "attacks": by_attack}.items():
        if name in parts:
            measure(arguments.seconds, ["--by", arguments.by])
    if "hour" in parts:
        by_hour(["--by", arguments.by])


if __name__ == "__main__":
    main()
