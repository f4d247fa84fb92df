"""What a check of ``glovetrack doctor`` is made of: a plug-in under ``glovetrack.checks``.

A `Check` names a function from the `Machine` to `Finding`s. Each finding has a notice, whose
severity is the verdict, and a remedy. `plain` makes a notice of a finished text.
"""

from tracker.base.notices import Notice, Severity, plain
from tracker.doctor.finding import Check, Finding, Verdict, examine
from tracker.doctor.machine import Machine

__all__ = ["Check", "Finding", "Machine", "Notice", "Severity", "Verdict", "examine", "plain"]
