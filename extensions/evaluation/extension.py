"""Descriptors of the sub-commands of ``evaluate``; `group.py` has the command itself."""

from __future__ import annotations

from extensions.evaluation.effects.command import add_effects, evaluate_effects
from extensions.evaluation.faults.command import add_faults, evaluate_faults
from extensions.evaluation.fingers.command import add_fingers, evaluate_fingers
from extensions.evaluation.gaps.command import add_gaps, evaluate_gaps
from extensions.evaluation.gestures.command import add_gestures, evaluate_gestures
from extensions.evaluation.hands.command import add_hands, evaluate_hands
from extensions.evaluation.inertial.commands import add_inertial, evaluate_inertial_command
from extensions.evaluation.robot.command import add_robot, evaluate_robot
from extensions.evaluation.shutter.command import add_shutter, evaluate_shutter
from extensions.evaluation.vist.command import add_vist
from extensions.evaluation.vist.command import run as evaluate_vist
from tracker.base.command import Command

VIST = Command(
    "evaluate vist",
    "track simulated hands in the three experiments of Lee et al. 2021",
    evaluate_vist,
    add=add_vist,
)
INERTIAL = Command(
    "evaluate inertial",
    "estimate finger angles from IMUs, following the protocol of Lemak et al. 2020",
    evaluate_inertial_command,
    add=add_inertial,
)
FAULTS = Command(
    "evaluate faults",
    "inject random faults into a simulated glove and camera and check the tracking",
    evaluate_faults,
    add=add_faults,
)
GESTURES = Command(
    "evaluate gestures",
    "score gesture recognition on simulated or recorded hands",
    evaluate_gestures,
    add=add_gestures,
)
HANDS = Command(
    "evaluate hands",
    "track two simulated hands that cross and occlude each other; compare with each hand alone, "
    "and with each hand occluded by a hand without markers",
    evaluate_hands,
    add=add_hands,
)
SHUTTER = Command(
    "evaluate shutter",
    "track fast hands, and hands in front of a turning camera, with a rolling shutter",
    evaluate_shutter,
    add=add_shutter,
)
EFFECTS = Command(
    "evaluate effects",
    "track hands with the errors of real cameras and IMUs, each alone and all at once",
    evaluate_effects,
    add=add_effects,
)
FINGERS = Command(
    "evaluate fingers",
    "track sessions with and without the glove's cloth; compare each fingertip with the true hand",
    evaluate_fingers,
    add=add_fingers,
)
GAPS = Command(
    "evaluate gaps",
    "track hands that leave the view for a while and return",
    evaluate_gaps,
    add=add_gaps,
)
ROBOT = Command(
    "evaluate robot",
    "evaluate a robot hand that follows a wearer and picks up a cube",
    evaluate_robot,
    add=add_robot,
    extra="robot",
)
