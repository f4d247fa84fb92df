"""Descriptors of the touch test."""

from __future__ import annotations

from extensions.touch.command import add_touch_test, touch_test
from extensions.touch.simulated.command import add_touch, evaluate_touch
from tracker.base.command import Command

TOUCH_TEST = Command(
    "touch-test",
    "report how accurate the fingertips of a recorded touch test are",
    touch_test,
    add=add_touch_test,
)
EVALUATE = Command(
    "evaluate touch",
    "let simulated wearers take the touch test; compare its figures with the true error",
    evaluate_touch,
    add=add_touch,
)
