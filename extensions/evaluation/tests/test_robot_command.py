"""A scripted wearer's cube is taken and put down by the robot, on either side."""

from __future__ import annotations

import json
import sys

import pytest

from extensions.robot.pick_and_place import pick_and_place
from extensions.robot.settings import RobotSettings
from extensions.robot.teleop import Teleop
from extensions.robot.tests.hands import shadow
from tests.notices import shows
from tracker.cli import main


@pytest.mark.long
@pytest.mark.parametrize(("side", "seed"), [("right", 1), ("right", 4), ("left", 2)])
def test_a_cube_is_lifted_and_put_down_in_its_place(side: str, seed: int) -> None:
    teleop = Teleop(RobotSettings(side=side), shadow(side))
    trial = pick_and_place(teleop, seed)
    assert trial.placed
    assert trial.lifted_mm > 100


@pytest.mark.long
def test_a_hand_that_stays_open_places_nothing() -> None:
    """The trial can fail: if the fingers cannot move, the cube remains in its place."""
    teleop = Teleop(RobotSettings(joint_speed=1e-3), shadow())
    trial = pick_and_place(teleop, 1)
    assert not trial.placed
    assert trial.lifted_mm < 20


@pytest.mark.long
def test_the_command_reports_the_distances_of_the_tips(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["evaluate", "robot", "--trials", "0", "--people", "1", "--seconds", "3"]
    assert main([*words, "--json", "-"]) == 0
    tips = json.loads(capsys.readouterr().out)["tips"]
    assert tips["reachable_percent"] > 70
    assert tips["within_5_mm_percent"] > 98
    assert tips["error_mm_median"] < 0.5


def test_without_the_robot_extension_this_protocol_alone_is_missing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    # as if the folder were removed, in a program that has not run the command yet
    monkeypatch.delitem(sys.modules, "extensions.evaluation.robot.command", raising=False)
    monkeypatch.setitem(sys.modules, "extensions.robot.library", None)
    assert main(["evaluate", "robot"]) == 1
    assert shows(capsys.readouterr().err, "evaluation.no_robot")
