"""Scripted hands whose truth is known, as estimates."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from extensions.applications.runner import ApplicationRunner, Outcome
from extensions.evaluation.gestures.command import as_estimate
from tracker.glove import library
from tracker.messages import Estimate
from tracker.simulation.scenario import Truth
from tracker.simulation.scripted import Key, ScriptedHand

HAND, GLOVE = library.load()


def estimates(keys: Sequence[Key], rate: float = 100.0) -> list[Estimate]:
    """The hand of the file, moved from key to key, as if measured without error."""
    motion = ScriptedHand(HAND, keys)
    t = np.arange(0.0, keys[-1].t, 1 / rate)
    poses = motion.poses(t)
    out = []
    for s, angles, R_GB, p_GB in zip(t, poses.angles, poses.R_GB, poses.p_GB, strict=True):
        R, p = HAND.forward(angles, R_GB, p_GB)
        true = Truth(GLOVE.keypoint_positions(HAND, R, p), angles, R, p)
        out.append(as_estimate(round(float(s), 9), true, HAND, GLOVE))
    return out


def outcomes(name: str, keys: Sequence[Key], **settings: Any) -> list[Outcome]:
    """Runs an application on a scripted hand."""
    runner = ApplicationRunner(name, HAND, GLOVE, settings)
    return [outcome for e in estimates(keys) for outcome in runner.feed(e)]


def words(found: Sequence[Outcome]) -> list[str]:
    """The kinds of events, in order, without the start."""
    reported = [str(e.data["what"]) for outcome in found for e in outcome.events]
    return [word for word in reported if word != "begins"]


def datas(found: Sequence[Outcome], what: str) -> list[dict[str, Any]]:
    """The data of all events of one kind."""
    return [dict(e.data) for outcome in found for e in outcome.events if e.data["what"] == what]
