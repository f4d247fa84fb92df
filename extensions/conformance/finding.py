"""Findings of the rules."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from extensions.conformance.take import RecordTake, ScriptStep
from tracker.messages import Array

PASS, FAIL, UNKNOWN = "pass", "fail", "not enough data"


@dataclass(frozen=True, eq=False)
class Plot:
    """Values (N,) over t (N,) s, with lines at ``limits``."""

    t: Array
    values: Array
    unit: str
    limits: tuple[float, ...] = ()


@dataclass(frozen=True, eq=False)
class RuleFinding:
    """Result of one rule on one hand: figure and limit. ``advice``: does not affect the verdict."""

    layer: str
    rule: str
    side: str
    status: str
    figure: str
    limit: str
    plot: Plot | None = None
    advice: bool = False


Rule = Callable[[RecordTake, Sequence[ScriptStep]], RuleFinding]


class LayerJudge:
    """Collects the findings of one layer on one hand."""

    def __init__(self, layer: str, take: RecordTake) -> None:
        self._layer, self._take = layer, take
        self.found: list[RuleFinding] = []

    def say(
        self,
        rule: str,
        ok: bool | None,
        figure: str,
        limit: str,
        plot: tuple[Array, str, tuple[float, ...]] | None = None,
        advice: bool = False,
    ) -> None:
        """Add a finding. ``ok`` is None without enough data; ``plot``: values, unit, limits."""
        status = UNKNOWN if ok is None else PASS if ok else FAIL
        drawn = None
        if plot is not None:
            values = np.asarray(plot[0], float)
            drawn = Plot(self._take.t[: len(values)], values, plot[1], plot[2])
        self.found.append(
            RuleFinding(self._layer, rule, self._take.side, status, figure, limit, drawn, advice)
        )
