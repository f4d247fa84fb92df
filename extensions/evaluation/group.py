"""The command ``evaluate``, separate from its sub-commands so that ``glovetrack --help`` is
fast."""

from __future__ import annotations

import argparse

from tracker.base.command import Command

EVALUATE = Command[argparse.Namespace](
    "evaluate", "run the papers' evaluation protocols, or simulate device faults"
)
