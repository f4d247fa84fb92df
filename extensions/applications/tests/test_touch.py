"""Touching: the contact of each fingertip agrees with geometry; commands for motors."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh

from extensions.applications.drawing import Line, Mesh
from extensions.applications.hand import HandReader
from extensions.applications.interface import MotorCommand
from extensions.applications.runner import ApplicationRunner
from extensions.applications.sinks import LASTS_MS, PULLS, THREE, MotorSink, pulls
from extensions.applications.tests.hands import GLOVE, HAND, datas, estimates, outcomes, words
from extensions.applications.touch.touch import PlacedMesh, contacts, load_mesh, pads, solid
from tests.notices import raises
from tracker.base.errors import ConfigError, FileError
from tracker.geometry.triangles import triangles_of
from tracker.messages import Event
from tracker.simulation.scripted import Key

UP, DOWN = (0.17, 0.0, 0.14), (0.17, 0.0, 0.08)
PRESS = [
    Key(0.0, "open_palm", UP),
    Key(1.0, "open_palm", DOWN),
    Key(1.5, "open_palm", DOWN),
    Key(2.5, "open_palm", UP),
    Key(3.0, "open_palm", UP),
]
"""A flat hand goes 6 cm down and comes back."""


@pytest.fixture(scope="module")
def table(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A block of 0.6 by 0.6 by 0.1 m, whose middle is its origin."""
    path = tmp_path_factory.mktemp("meshes") / "table.stl"
    trimesh.creation.box((0.6, 0.6, 0.1)).export(path)
    return str(path)


def test_each_fingertip_touches_a_table_as_deep_as_it_is_below_its_top(table: str) -> None:
    mesh = triangles_of(*load_mesh(table))
    top = 0.1
    thing = PlacedMesh(mesh, np.eye(3), 0.6, np.array([0.25, 0.0, top - 0.05]))
    reader = HandReader(HAND, GLOVE)
    for estimate in estimates(PRESS)[::40]:
        hand = reader.read(estimate)
        fingers = pads(hand)
        assert len(fingers.tips) == 5
        for i, contact in enumerate(contacts(fingers, thing)):
            pad = fingers.centre[i]
            if pad[2] < top - 0.04:  # the table's underside would be nearer
                continue
            assert contact.depth == pytest.approx(fingers.radius[i] - (pad[2] - top), abs=1e-7)
            if abs(pad[2] - top) > 1e-6:
                assert contact.normal == pytest.approx([0.0, 0.0, 1.0])
                assert fingers.R_GB[i] @ contact.push == pytest.approx([0.0, 0.0, 1.0])


def test_a_hand_that_presses_feels_more_the_deeper_it_is(table: str) -> None:
    found = outcomes("touch", PRESS, mesh=table, size=0.6, place=[0.25, 0.0, 0.03])
    tips = {d["tip"] for d in datas(found, "touch")}
    assert tips >= {"index_tip", "middle_tip", "ring_tip", "little_tip"}
    assert words(found).count("touch") == words(found).count("release") == len(tips)
    strength = [
        max((c.strength for c in o.commands if isinstance(c, MotorCommand)), default=0.0)
        for o in found
    ]
    t = np.array([o.t for o in found])
    going = np.array(strength)[(t > 0.2) & (t < 1.0)]
    assert (np.diff(going) >= 0).all()
    assert going.max() == pytest.approx(1.0)
    assert max(np.array(strength)[t > 2.3]) == 0.0


def test_haptic_feedback_is_computed_at_200_hz(table: str) -> None:
    found = outcomes("touch", PRESS, mesh=table, size=0.6, place=[0.25, 0.0, 0.03])
    t = np.array([o.t for o in found])[1:]
    assert np.diff(t) == pytest.approx(0.005, abs=1e-6)


def test_the_object_is_placed_in_front_of_the_hand_and_drawn() -> None:
    found = outcomes("touch", PRESS[:2])
    (placed,) = datas(found, "placed")
    first = HandReader(HAND, GLOVE).read(estimates(PRESS)[0])
    assert first.palm is not None
    assert np.linalg.norm(np.array(placed["at"]) - first.palm[1]) < 0.15
    (mesh,) = [d for d in found[-1].drawing if isinstance(d, Mesh)]
    extent = np.ptp(mesh.points @ mesh.R.T, axis=0)
    assert extent.max() == pytest.approx(0.12, rel=0.05)


def test_arrows_point_out_of_the_surface(table: str) -> None:
    found = outcomes("touch", PRESS, mesh=table, size=0.6, place=[0.25, 0.0, 0.03])
    arrows = [d for o in found for d in o.drawing if isinstance(d, Line)]
    assert arrows
    assert all(a.points[1, 2] > a.points[0, 2] for a in arrows)


def test_motors_receive_changes_and_stop_after_a_release() -> None:
    sent: list[tuple[int, int, int]] = []
    events: list[Event] = []
    now = [5.0]
    sink = MotorSink(lambda *args: sent.append(args) is None, lambda: now[0], events.append)
    command = MotorCommand("middle_tip", 0.5)
    for k in range(5):
        sink.take([command], 0.005 * k)
    assert sent == [(2, 128, LASTS_MS)]
    sink.take([command], 0.04)  # before it stops automatically
    assert sent[1:] == [(2, 128, LASTS_MS)]
    sink.take([command._replace(strength=0.8)], 0.045)
    sink.take([], 0.05)
    sink.take([], 0.055)
    assert sent[2:] == [(2, 204, LASTS_MS), (2, 0, 1)]
    assert [(e.t, e.data["of"]) for e in events] == [(5.0, 0.0), (5.0, 0.045), (5.0, 0.05)]


def test_three_pulls_make_the_push() -> None:
    rng = np.random.default_rng(3)
    for _ in range(50):
        wanted = rng.dirichlet(np.ones(3)) @ PULLS
        strength = float(np.linalg.norm(wanted))
        x, y, z = (wanted / strength).tolist()
        made = pulls(MotorCommand("index_tip", strength, (x, y, z), 3))
        assert made @ PULLS == pytest.approx(wanted)
    sent: list[tuple[int, int, int]] = []
    sink = MotorSink(lambda *args: sent.append(args) is None, lambda: 0.0)
    sink.take([MotorCommand("index_tip", 1.0, (0.0, 0.0, 1.0), 3)], 0.0)
    assert [t[0] for t in sent] == [THREE + 3, THREE + 4, THREE + 5]
    assert len({t[1] for t in sent}) == 1  # a straight pull: all are equal
    sink.close()
    assert [t[1] for t in sent[3:]] == [0, 0, 0]


def test_a_lost_motor_command_is_sent_again_with_the_next_sample_and_no_event_before() -> None:
    room = [False]
    events: list[Event] = []
    sink = MotorSink(lambda *_: room[0], lambda: 5.0, events.append)
    command = MotorCommand("middle_tip", 0.5)
    sink.take([command], 0.0)
    assert not events
    room[0] = True
    sink.take([command], 0.005)
    assert [e.data["of"] for e in events] == [0.005]
    room[0] = False
    sink.take([], 0.01)  # it still runs
    room[0] = True
    sink.take([], 0.015)
    assert [(e.data["of"], e.data["amplitude"]) for e in events[1:]] == [(0.015, 0)]


@pytest.mark.parametrize("kind", ["stl", "obj"])
def test_meshes_written_by_trimesh_are_read(kind: str, tmp_path: Path) -> None:
    solid = trimesh.creation.annulus(0.1, 0.3, 0.2)
    solid.export(tmp_path / f"ring.{kind}")
    points, faces = load_mesh(str(tmp_path / f"ring.{kind}"))
    again = trimesh.Trimesh(points, faces)
    assert again.is_watertight
    assert again.volume * 0.6**3 == pytest.approx(solid.volume, rel=1e-5)


def test_the_shipped_rabbit_is_closed() -> None:
    rabbit = trimesh.Trimesh(*load_mesh("rabbit"))
    assert rabbit.is_watertight
    assert rabbit.volume > 0.05


def test_a_mesh_is_read_from_its_setting_and_a_bad_one_changes_nothing(table: str) -> None:
    runner = ApplicationRunner("touch", HAND, GLOVE, {"mesh": "rabbit"})
    with pytest.raises(ConfigError, match="unicorn"):
        runner.set("mesh", "unicorn")
    runner.set("mesh", table)
    assert solid(table) is solid(table), "it was read once"
    (first, *_) = [o for e in estimates(PRESS)[:2] for o in runner.feed(e)]
    shown = next(d for d in first.drawing if isinstance(d, Mesh))
    assert shown.points is solid(table).file.points and runner.settings.mesh == table


def test_a_file_that_is_not_a_mesh_is_refused(tmp_path: Path) -> None:
    (tmp_path / "x.obj").write_text("v 1 2 zebra\n")
    (tmp_path / "y.stl").write_bytes(b"solid")
    (tmp_path / "z.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + "f 1 2 9\n" * 4)
    for name, code in [
        ("unicorn", "mesh.unknown"),
        (str(tmp_path / "none.obj"), "file.not_readable"),
        (str(tmp_path / "x.obj"), "mesh.not_obj"),
        (str(tmp_path / "y.stl"), "mesh.too_few"),
        (str(tmp_path / "z.obj"), "mesh.bad_points"),
    ]:
        with raises(FileError, code):
            load_mesh(name)
