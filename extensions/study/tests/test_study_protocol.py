"""Protocol files: what they may contain, and that errors name file, line and key."""

from __future__ import annotations

import itertools
from collections import Counter
from pathlib import Path

import pytest

from extensions.study.command_runs import FOLDER, names, protocol_path
from extensions.study.protocol import load_protocol, parse_protocol
from extensions.study.schedule import PRACTICE, REST, TRIAL, condition_order, steps_of, williams
from extensions.study.tests.studies import SHORT, write_protocol
from tracker.base.errors import FileError


def test_a_protocol_has_the_values_of_its_file() -> None:
    protocol = parse_protocol(SHORT)
    assert protocol.participants == ("P01", "P02") and protocol.seed == 3
    assert protocol.tasks["pegs"].is_timed and not protocol.tasks["postures"].is_timed
    assert protocol.conditions["free"].practice == 1 and protocol.limits.tracked == 0.8
    listed = parse_protocol(SHORT.replace("participants = 2", 'participants = ["anna", "X1"]'))
    assert listed.participants == ("anna", "X1")


@pytest.mark.parametrize(
    ("old", "new", "line", "key"),
    [
        ("seed = 3", "seed = 1.5", 5, "study.seed"),
        ("seed = 3", 'order = "x"', 5, "study.order"),
        ("participants = 2", "participants = 0", 6, "study.participants"),
        ("participants = 2", 'participants = ["a b"]', 6, "study.participants"),
        ("participants = 2", 'participants = ["a", "a"]', 6, "study.participants"),
        ("rest = 5.0", "pause = 5.0", 8, "study.pause"),
        ('tasks = ["pegs"]', 'tasks = ["peg"]', 18, "conditions.timed.tasks"),
        ('tasks = ["pegs"]', 'tasks = ["postures"]', 28, "tasks.pegs"),
        ("[conditions.free]", "[conditions.free-hand]", 11, "conditions.free-hand"),
        ("duration = 6.0", "duration = -6.0", 23, "tasks.postures.duration"),
        ("duration = 6.0", 'things = ["cup"]', 23, "tasks.postures.things"),
        ("duration = 6.0", 'kind = "dance"', 23, "tasks.postures.kind"),
        ('cues = ["Fist", ', 'cues = ["fist.png", ', 0, "tasks"),
    ],
)
def test_errors_name_file_line_and_key(
    tmp_path: Path, old: str, new: str, line: int, key: str
) -> None:
    path = write_protocol(tmp_path, SHORT.replace(old, new, 1))
    with pytest.raises(FileError) as caught:
        load_protocol(path)
    where = f"{path}, line {line}: {key}" if line else f"{path}: {key}"
    assert str(caught.value).startswith(where), caught.value


@pytest.mark.parametrize("n", range(1, 9))
def test_a_williams_square_balances_positions_and_successions(n: int) -> None:
    rows = williams(n)
    assert len(rows) == (n if n % 2 == 0 or n == 1 else 2 * n)
    assert all(sorted(row) == list(range(n)) for row in rows)
    positions = Counter((k, row[k]) for row in rows for k in range(n))
    assert set(positions.values()) == {len(rows) // n}
    after = Counter(pair for row in rows for pair in itertools.pairwise(row))
    assert len(after) == n * (n - 1) and len(set(after.values())) <= 1


def test_conditions_are_counterbalanced_over_participants() -> None:
    protocol, _ = load_protocol(FOLDER / "vist.toml")
    rows = [condition_order(protocol, p) for p in protocol.participants]
    assert len(set(rows[:6])) == 6 and len(set(rows[6:12])) == 6
    firsts = Counter(row[0] for row in rows[:12])
    assert set(firsts.values()) == {4}


def test_an_order_depends_on_the_seed_alone() -> None:
    text = (FOLDER / "vist.toml").read_text("utf-8").replace('order = "latin"', 'order = "random"')
    protocol = parse_protocol(text)
    orders = [condition_order(protocol, p) for p in protocol.participants]
    assert len(set(orders)) > 3
    assert steps_of(protocol, "P07") == steps_of(parse_protocol(text), "P07")
    other = parse_protocol(text.replace("seed = 2021", "seed = 2022"))
    assert orders != [condition_order(other, p) for p in other.participants]
    # the same on every computer, with every version: an order that was once used
    assert condition_order(protocol, "P01") == ("free", "object", "device")


def test_steps_have_names_of_bids_and_rests_between_trials() -> None:
    protocol = parse_protocol(SHORT)
    steps = steps_of(protocol, "P01")
    kinds = [step.kind for step in steps]
    assert Counter(kinds) == {TRIAL: 2, PRACTICE: 1, REST: 1}
    assert len({step.name for step in steps}) == len(steps)
    names_of_trials = {step.name for step in steps if step.kind == TRIAL}
    assert names_of_trials == {
        "sub-P01_ses-free_task-postures_run-01",
        "sub-P01_ses-timed_task-pegs_run-01",
    }


def test_cues_are_balanced_and_never_repeated_at_once() -> None:
    protocol, _ = load_protocol(FOLDER / "vist.toml")
    steps = {s.task: s for s in steps_of(protocol, "P03") if s.kind == TRIAL}
    free = [cue.what for cue in steps["postures"].cues]
    assert len(free) == 60  # as in the paper: three minutes, three seconds each
    assert set(Counter(free).values()) == {3} and len(set(free)) == 20
    assert all(a != b for a, b in itertools.pairwise(free))
    objects = steps["objects"].cues
    taken = [cue for cue in objects if cue.what in protocol.tasks["objects"].things]
    assert [cue.t for cue in taken] == [0.0, 40.0, 80.0] and len({c.what for c in taken}) == 3
    assert len(objects) == 3 + 3 * 10 and objects[1].t == 10.0
    others = [s.cues for s in steps_of(protocol, "P04") if s.task == "postures"]
    assert steps["postures"].cues not in others


@pytest.mark.parametrize("name", names())
def test_each_example_is_a_valid_protocol(name: str) -> None:
    protocol, _ = load_protocol(protocol_path(name))
    assert protocol.name == name
    assert all(steps_of(protocol, p) for p in protocol.participants)


def test_a_picture_is_a_cue_and_must_be_in_the_protocols_folder(tmp_path: Path) -> None:
    text = SHORT.replace('"Fist"', '"hands/fist.png"')
    path = write_protocol(tmp_path, text)
    (tmp_path / "hands").mkdir()
    (tmp_path / "hands" / "fist.png").write_bytes(b"\x89PNG")
    assert load_protocol(path)[0].pictures == ("hands/fist.png",)
    path = write_protocol(tmp_path, SHORT.replace('"Fist"', '"../fist.png"'))
    with pytest.raises(FileError):
        load_protocol(path)
