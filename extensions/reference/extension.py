"""Descriptors of the reference extension."""

from __future__ import annotations

from extensions.reference.command import (
    accuracy_command,
    add_accuracy,
    add_import,
    import_reference_command,
)
from tracker.base.command import Command

IMPORT = Command(
    "import-reference",
    "add a motion-capture recording to a session as a reference",
    import_reference_command,
    add=add_import,
)
ACCURACY = Command(
    "accuracy",
    "report the accuracy of sessions against their references",
    accuracy_command,
    add=add_accuracy,
)
