"""The sphere collection: its messages and state, by the vectors of all languages; its model and its geometry."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable
from contextlib import suppress
from typing import Any

import numpy as np
import pytest

from nearfar._base.errors import FormatError
from nearfar._camera.camera import orientation_of, viewing_direction
from nearfar.stream.collect import Outcome, Person, Settings, _spheres as spheres, simulate
from nearfar.stream.collect._messages import (
    LEVELS,
    Aims,
    Collected,
    Message,
    Score,
    Seat,
    Sphere,
    Stage,
    Tally,
    Trial,
    audience,
    read,
    write,
)
from nearfar.stream.collect._person import Pointing, Target
from nearfar.stream.collect._spheres import Ray
from nearfar.stream.collect._task import Task
from tests.support.vectors import cases

UP = (0.0, 1.0, 0.0)


def message_of(fields: dict[str, Any]) -> Message:
    stage, number = Stage(fields["run"], fields["trial"]), fields.get("number", 0)
    level = LEVELS.index(fields.get("level", "easy"))
    match fields["kind"]:
        case "trial":
            named = ("trials", "users", "seed", "elapsed", "duration", "hold", "pause", "rest", "radius")
            rules: dict[str, Any] = {name: fields[name] for name in named}
            rules |= {name: tuple(map(tuple, fields[name])) for name in ("box", "area")}
            rules["speeds"], rules["is_over"] = tuple(fields["speeds"]), fields["over"]
            rules["tallies"] = tuple(Tally(*tally) for tally in fields["tallies"])
            rules["seats"] = tuple(Seat(seat["user"], tuple(seat["position"])) for seat in fields["seats"])
            return Trial(stage, **rules)
        case "sphere":
            return Sphere(stage, number, level, fields["age"], tuple(fields["position"]), tuple(fields["velocity"]))
        case "aims":
            told = {name: fields[name] for name in ("event", "user", "misses", "held")}
            return Aims(stage, number, users=tuple(fields["users"]), **told)
        case "collected":
            return Collected(stage, number, level, fields["misses"], fields["seconds"])
        case _:
            return Score(stage, fields["over"], fields["spheres"], fields["misses"])


@pytest.mark.parametrize("case", cases("collect", "messages"))
def test_messages_equal_their_bytes(case: dict[str, Any]) -> None:
    data, message = bytes.fromhex(case["bytes"]), message_of(case["message"])
    assert write(message).hex() == case["bytes"]
    assert read(data) == message
    assert audience(message) == ("room" if case["message"]["kind"] == "score" else "group")


@pytest.mark.parametrize("case", cases("collect", "refused"))
def test_malformed_messages_are_refused(case: dict[str, Any]) -> None:
    with pytest.raises(FormatError, match="expected a message of the sphere collection"):
        read(bytes.fromhex(case["bytes"]))


@pytest.mark.parametrize("case", cases("collect", "messages"))
def test_truncated_and_corrupted_messages_are_parsed_or_refused(case: dict[str, Any]) -> None:
    data = bytes.fromhex(case["bytes"])
    for length in range(1, len(data)):
        with pytest.raises(FormatError):
            read(data[:length])
    task = Task(3, 0)
    for bit in range(8 * len(data)):
        changed = bytearray(data)
        changed[bit // 8] ^= 1 << bit % 8
        with suppress(FormatError):
            message = read(bytes(changed))
            if message is not None:
                # Every parsed message can be processed, and the answers can be written.
                task.hear(message, 1.0)
                for said in task.conduct(2.0, {3: ((0.0, 1.7, 0.0), (0.0, 0.0, -1.0))}):
                    write(said)


def test_messages_of_other_tasks_are_ignored() -> None:
    assert read(b"") is None
    assert read(b"hello") is None


@pytest.mark.parametrize("case", cases("collect", "places"))
def test_spheres_and_seats_have_the_positions_of_the_vectors(case: dict[str, Any]) -> None:
    trial = message_of(cases("collect", "messages")[0].values[0]["message"])
    assert isinstance(trial, Trial)
    stage = Stage(case["run"], case["trial"])
    sphere = spheres.sphere(trial, stage, case["group"], case["number"])
    assert LEVELS[sphere.level] == case["level"]
    np.testing.assert_allclose(sphere.position, case["position"], rtol=0, atol=1e-12)
    np.testing.assert_allclose(sphere.velocity, case["velocity"], rtol=0, atol=1e-12)
    (seat,) = spheres.seats(trial, stage, case["group"], [9])
    np.testing.assert_allclose(seat.position, case["seat"], rtol=0, atol=1e-12)


def words(speaker: int, message: Message) -> str:
    """A message in the wording of the vectors."""
    match message:
        case Trial(stage, is_over=is_over):
            return f"{speaker}: {'over' if is_over else 'trial'} {stage.trial}"
        case Sphere(_, number, level):
            return f"{speaker}: sphere {number} {LEVELS[level]}"
        case Aims(event="told", users=users, misses=misses):
            return f"{speaker}: told {list(users)}" + ("" if users else f", {misses} missed")
        case Aims(event=event, user=user, misses=misses, held=held):
            missed = f", {misses} missed" if event == "lost" else ""
            return f"{speaker}: {event} {user}" + missed + ("" if held is None else f", held {held:g}")
        case Collected(_, number, level, misses, seconds):
            return f"{speaker}: collected {number} {LEVELS[level]}, {misses} missed, {seconds:g} s"
        case Score(_, _, count, misses):
            return f"{speaker}: score {count} {misses}"


@pytest.mark.parametrize("case", cases("collect", "plays"))
def test_a_game_runs_as_in_the_vectors(case: dict[str, Any]) -> None:
    settings = Settings(**case["rules"])
    tasks = {user: Task(user, case["group"]) for user in case["users"]}
    said: list[str] = []

    def join(user: int) -> None:
        for task in tasks.values():
            task.add_user(user)

    def deliver(speaker: int, messages: list[Message], now: float) -> None:
        for message in messages:
            said.append(words(speaker, message))
            for user, task in tasks.items():
                if user != speaker:
                    task.hear(message, now, sender=speaker, group=case["group"])

    for user in case["users"]:
        join(user)
    for step in case["steps"]:
        now = step["now"]
        if step["comes"] is not None:
            tasks[step["comes"]] = late = Task(step["comes"], case["group"])
            late.present |= set(tasks)
            join(step["comes"])
        if step["goes"] is not None:
            del tasks[step["goes"]]
            for task in tasks.values():
                task.remove_user(step["goes"])
        if now == 0.0:
            deliver(3, tasks[3].start(settings, now), now)
        for user in sorted(tasks, reverse=True):
            task = tasks[user]
            center = task.place(now) or (0.0, 0.0, 0.0)
            rays = {}
            for other in tasks:
                # A ray of zero length to the middle, or straight up from far away.
                begin = (center[0], center[1], center[2] + 4.0)
                rays[other] = (begin, (0.0, 0.0, -1.0) if other in step["aiming"] else UP)
            deliver(user, task.conduct(now, rays), now)
        assert said == step["said"], now
        said.clear()
    assert all(task.is_over for task in tasks.values())


def rays_at_sphere(task: Task, users: Iterable[int], now: float) -> dict[int, Ray]:
    """Rays of users who aim at the middle of the sphere."""
    x, y, z = task.place(now) or (0.0, 0.0, 0.0)
    return dict.fromkeys(users, ((x, y, z + 4.0), (0.0, 0.0, -1.0)))


@pytest.mark.parametrize("case", cases("collect", "hearings"))
def test_the_state_that_a_user_derives_equals_the_vectors(case: dict[str, Any]) -> None:
    task = Task(case["user"], case["group"])
    for step in ({"returns": True}, *case["steps"]):
        if step["returns"]:
            task.forget_users()
            for other in case["others"]:
                task.add_user(other)
        if "message" in step:
            taken = task.hear(message_of(step["message"]), step["now"], sender=step["sender"], group=case["group"])
            assert taken == step["taken"], step
    said = task.conduct(case["now"], rays_at_sphere(task, task.present, case["now"]))
    assert [words(case["user"], message) for message in said] == case["said"]


def start_trial(users: int) -> Task:
    """The task of a conductor whose trial has begun, with a still sphere."""
    task = Task(0, 0)
    for user in range(1, users):
        task.add_user(user)
    task.start(Settings(speeds=(0.0, 0.0, 0.0), duration=1000.0, hold=1000.0, users=users), 0.0)
    assert isinstance(task.conduct(0.0, {})[0], Sphere)
    return task


def test_flickering_pointers_do_not_exceed_the_rate_of_messages() -> None:
    task, end = start_trial(64), 8
    size = 0
    for moment in range(1, 512 * end + 1):
        now = moment / 512.0
        found = rays_at_sphere(task, range(64), now) if moment % 2 else {}
        size += sum(max(len(write(message)) + 5, 64) for message in task.conduct(now, found))
    # At most 16 KiB per second of the trial and 8 KiB at once; half of that shows that it keeps sending.
    assert 8000 * end < size <= 16_384 * end + 8192
    # The last state is sent as soon as the rate allows.
    for moment in range(80):
        task.conduct(end + 1.0 + moment / 80.0, rays_at_sphere(task, range(64), now))
    assert task.aims == tuple(range(64))


def test_the_conductor_judges_at_most_as_often_as_it_receives_poses() -> None:
    task = start_trial(1)
    said = []
    for moment in range(1, 1001):
        now = moment / 1000.0
        said += task.conduct(now, rays_at_sphere(task, [0], now) if moment % 2 else {})
    assert 0 < len(said) <= 80


def test_a_former_conductor_is_processed_to_the_end() -> None:
    task = Task(9, 0)
    task.add_user(7)
    trial = start_trial(1).trial
    assert trial is not None
    seats = tuple(Seat(user, (0.0, 1.7, 0.0)) for user in (3, 7, 9))
    assert task.hear(dataclasses.replace(trial, seats=seats), 0.0, sender=7)
    first = spheres.sphere(trial, trial.stage, 0, 0)
    task.add_user(3)
    assert task.hear(first, 6.0, sender=7)
    assert task.hear(Collected(trial.stage, 0, 0, 0, 1.0), 6.0, sender=3)
    task.remove_user(7)
    assert not task.hear(spheres.sphere(trial, trial.stage, 0, 1), 6.0, sender=7)


def test_scores_of_groups_that_have_left_are_forgotten() -> None:
    task = Task(0, 2)
    for group in range(6):
        task.hear(Score(Stage(1, 1), False, group, 0), 0.0, sender=9, group=group)
    task.forget_scores({2, 4})
    assert sorted(task.scores) == [2, 4]
    task.forget_users()
    assert sorted(task.scores) == [2]


def test_a_pointer_must_meet_the_sphere_ahead_of_it() -> None:
    for offset, is_met in ((0.0, True), (0.299, True), (0.301, False)):
        ray = ((offset, 0.0, 0.0), (0.0, 0.0, -1.0))
        assert spheres.is_aimed(ray, (0.0, 0.0, -8.0), 0.3) == is_met
        assert not spheres.is_aimed(ray, (0.0, 0.0, 8.0), 0.3)
    assert spheres.is_aimed(((0.1, 0.0, 0.0), (0.0, 0.0, -1.0)), (0.0, 0.0, 0.0), 0.3)


def test_spheres_reverse_at_the_faces_of_their_box() -> None:
    ages = np.linspace(-30.0, 30.0, 4001)
    found = np.array([spheres.reflect_into(1.5 * age, -1.0, 2.0) for age in ages])
    assert (found.min(), found.max()) == pytest.approx((-1.0, 2.0), abs=0.02)
    assert np.abs(np.diff(found)).max() <= 1.5 * (ages[1] - ages[0]) + 1e-12
    assert spheres.reflect_into(0.5, -1.0, 2.0) == 0.5
    assert spheres.reflect_into(2.5, -1.0, 2.0) == 1.5
    assert spheres.reflect_into(7.0, 1.0, 1.0) == 1.0


def test_seats_are_separate_and_within_their_rectangle() -> None:
    task = Task(0, 0)
    for user in range(1, 4):
        task.add_user(user)
    for seed in range(40):
        trial = task.start(Settings(seed=seed), 0.0)[0]
        assert isinstance(trial, Trial)
        at = np.array([seat.position for seat in trial.seats])
        assert np.all(np.abs(at - (0.0, 1.7, 0.0)) <= (2.5, 0.0, 1.0))
        apart = np.linalg.norm(at[:, None] - at[None], axis=-1) + 10.0 * np.eye(4)
        assert apart.min() >= spheres.MIN_SEAT_DISTANCE


def test_messages_of_earlier_spheres_trials_and_runs_are_ignored() -> None:
    task = Task(1, 0)
    old = task.start(Settings(users=1, hold=0.0, pause=0.0), 0.0)
    old += task.conduct(0.0, {})
    task.start(Settings(users=1, hold=0.0, pause=0.0), 1.0)
    said = task.conduct(1.0, {1: (task.seat or UP, UP)})
    sphere = task.sphere
    for message in old:
        task.hear(message, 2.0)
    assert (task.trial or old[0]).stage.run == 2
    assert task.sphere is sphere is said[0]
    # Scores of other groups have no effect here.
    task.hear(Score(Stage(1, 1), False, 9, 9), 2.0, group=8)
    task.hear(said[0], 2.0, group=8)
    assert (task.scores[8].spheres, task.scores[0].spheres) == (9, 0)


QUICK = Settings(users=3, trials=1, duration=40.0, hold=1.0, pause=0.25)


@pytest.fixture(scope="module")
def outcomes() -> list[Outcome]:
    return simulate(QUICK, groups=2, seed=4)


def test_simulated_users_are_deterministic(outcomes: list[Outcome]) -> None:
    assert simulate(QUICK, groups=2, seed=4) == outcomes
    assert simulate(QUICK, groups=1, seed=5) != outcomes[:1]
    assert [(outcome.group, outcome.trial) for outcome in outcomes] == [(1, 1), (2, 1)]
    assert outcomes[0].spheres != outcomes[1].spheres


def test_simulated_users_collect_each_level_in_turn(outcomes: list[Outcome]) -> None:
    for outcome in outcomes:
        levels = [sphere.level for sphere in outcome.spheres]
        assert levels == (["easy", "hard", "intermediate"] * 20)[: len(levels)]
        assert len(levels) > 6
        # Nobody can react, move and hold sooner.
        assert min(sphere.seconds for sphere in outcome.spheres) > QUICK.hold + 0.5 * Person().reaction


def test_a_search_delay_lengthens_the_time_by_as_much() -> None:
    still = dataclasses.replace(QUICK, speeds=(0.0, 0.0, 0.0))
    calm = Person(lapses=0.0, spread=0.0, tremor=0.0)
    quick, slow = (
        np.mean([sphere.seconds for sphere in simulate(still, person=person, groups=1)[0].spheres])
        for person in (calm, dataclasses.replace(calm, search=1.0))
    )
    assert slow - quick == pytest.approx(1.0, abs=0.25)


def test_a_hand_without_tremor_comes_to_rest_on_a_still_target() -> None:
    person = Person(tremor=0.0, lapses=0.0, spread=0.0)
    hand, target = Pointing(person, 0, 1), Target(0, (0.5, -0.2), 0.08)
    path = np.array([hand.step(step / 72.0, target) for step in range(72 * 6)])
    away = np.hypot(*(path - target.angles).T)
    begins = int(np.argmax(away < away[0] - 1e-6)) / 72.0
    assert 0.5 * person.reaction <= begins <= person.reaction + 4 * person.reaction_spread
    assert away[-1] < 1e-4


def test_a_hand_lags_behind_a_moving_target_by_the_pursuit_error() -> None:
    person = Person(tremor=0.0, lapses=0.0, spread=0.0)
    hand, speed = Pointing(person, 0, 1), math.radians(10.0)
    for step in range(72 * 12):
        now = step / 72.0
        yaw, _ = hand.step(now, Target(0, (speed * now, 0.0), 0.08))
    # The error e that the loop needs for the remaining speed: gain · e = (1 − pursuit) · speed.
    assert speed * now - yaw == pytest.approx((1.0 - person.pursuit) * speed / person.gain, rel=0.02)


def test_tremor_has_its_deviation_and_correlation_time() -> None:
    person = Person(lapses=0.0, spread=0.0)
    hand = Pointing(person, 3, 1)
    path = np.degrees([hand.step(step / 72.0, None) for step in range(72 * 300)])
    np.testing.assert_allclose(path.std(axis=0), person.tremor, rtol=0.1)
    keeps = np.corrcoef(path[:-1, 0], path[1:, 0])[0, 1]
    assert keeps == pytest.approx(math.exp(-1.0 / 72.0 / person.tremor_time), abs=0.02)


def test_rotations_point_along_their_angles() -> None:
    for yaw, pitch in ((0.0, 0.0), (0.7, 0.3), (-2.0, -1.0)):
        expected = (-math.sin(yaw) * math.cos(pitch), math.sin(pitch), -math.cos(yaw) * math.cos(pitch))
        assert viewing_direction(orientation_of(yaw, pitch)) == pytest.approx(expected, abs=1e-12)
