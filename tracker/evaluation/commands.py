"""`glovetrack evaluate`: the papers' protocols."""

from __future__ import annotations

import argparse

from tracker.evaluation.inertial_commands import add_evaluate_inertial
from tracker.evaluation.vist_command import add_evaluate_vist


def add_commands(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Adds ``evaluate`` with ``vist`` and ``inertial``."""
    evaluate = subparsers.add_parser("evaluate", help="the papers' protocols, tables and figures")
    protocols = evaluate.add_subparsers(title="protocols", metavar="PROTOCOL", required=True)
    add_evaluate_vist(protocols)
    add_evaluate_inertial(protocols)
