"""`glovetrack evaluate`: the papers' protocols, and devices that fail."""

from __future__ import annotations

import argparse

from extensions.evaluation.faults.command import add_evaluate_faults
from extensions.evaluation.gestures.command import add_evaluate_gestures
from extensions.evaluation.hands.command import add_evaluate_hands
from extensions.evaluation.inertial.commands import add_evaluate_inertial
from extensions.evaluation.robot.command import add_evaluate_robot
from extensions.evaluation.vist.command import add_evaluate_vist


def add_commands(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Adds ``evaluate`` with a sub-command for each protocol."""
    evaluate = subparsers.add_parser(
        "evaluate", help="run the papers' evaluation protocols, or simulate device faults"
    )
    protocols = evaluate.add_subparsers(title="protocols", metavar="PROTOCOL", required=True)
    add_evaluate_vist(protocols)
    add_evaluate_inertial(protocols)
    add_evaluate_faults(protocols)
    add_evaluate_gestures(protocols)
    add_evaluate_hands(protocols)
    add_evaluate_robot(protocols)
