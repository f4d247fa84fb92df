"""`glovetrack evaluate inertial`: the experiment of Lemak et al. 2020 and orientation on BROAD."""

from __future__ import annotations

from extensions.evaluation.commands import EvaluateInertialArguments
from extensions.evaluation.inertial.report import evaluate_inertial


def evaluate_inertial_command(args: EvaluateInertialArguments) -> int:
    """Run the evaluation; imports numba and matplotlib only now."""
    return evaluate_inertial(args)
