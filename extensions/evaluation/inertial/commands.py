"""`glovetrack evaluate inertial`: the experiment of Lemak et al. 2020 and orientation on BROAD."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.terminal import add_json


def add_inertial(p: argparse.ArgumentParser) -> None:
    """Its arguments."""
    add_json(p)
    p.add_argument(
        "--broad", type=Path, metavar="DIR", help="folder with recordings of the BROAD data set"
    )
    p.add_argument("--seeds", type=_count, metavar="N", help="runs per case (default: 5)")
    p.add_argument(
        "--rates", type=_rate, nargs="+", metavar="HZ", help="sampling rates (default: 100 1000)"
    )
    p.add_argument("--out", type=Path, metavar="DIR", help="folder for figures (PNG)")
    p.add_argument("--quick", action="store_true", help="fewer durations and seeds, 100 Hz only")


def evaluate_inertial_command(args: argparse.Namespace) -> int:
    """Run the evaluation; imports numba and matplotlib only now."""
    from extensions.evaluation.inertial.report import evaluate_inertial

    return evaluate_inertial(args)


def _count(text: str) -> int:
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError("must be at least 1")
    return value


def _rate(text: str) -> float:
    value = float(text)
    if not 20 <= value <= 10000:
        raise argparse.ArgumentTypeError("must be between 20 and 10000 Hz")
    return value


INERTIAL = Command(
    "evaluate inertial",
    "estimate finger angles from IMUs, following the protocol of Lemak et al. 2020",
    evaluate_inertial_command,
    add=add_inertial,
)
