"""All parts of a state are checked against the declarations of its records."""

import dataclasses
import enum
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from tests.notices import raises
from tests.session.engine_state_samples import simulation, small_glove, tracked, untouched
from tracker.base.errors import FileError
from tracker.base.records import RECORDS, Record
from tracker.engine.pipeline import PipelineSavedState
from tracker.fusion.chain.tip_bends import TipBendsSavedState
from tracker.messages import Blobs
from tracker.session.engine_state import pack, unpack
from tracker.session.state_check import mismatch, require_match


@pytest.fixture
def fresh() -> PipelineSavedState:
    return untouched(simulation(), "chain").get_state()


@pytest.fixture
def state() -> PipelineSavedState:
    return tracked(simulation(), "chain")[0].get_state()


def annotations(known: Record) -> Iterator[tuple[str, str]]:
    """Each attribute's name in recordings and the text of its annotation."""
    every: dict[str, Any] = {}
    for kind in reversed(known.kind.__mro__):
        every |= getattr(kind, "__annotations__", {})
    return ((written, str(every[name])) for name, written in known.names.items())


def test_every_array_of_a_record_has_a_declared_shape() -> None:
    assert small_glove()
    kinds = ("Array", "Vector", "Matrix", "Stack")
    for known in RECORDS.values():
        if issubclass(known.kind, enum.Enum) or known.name == "chain.guided.told":
            continue  # in a guided pose's list `calibration` each array has another shape
        arrays = {name for name, text in annotations(known) if any(k in text for k in kinds)}
        assert arrays == known.shapes.keys(), f"shapes of the record {known.name!r}"


def test_arrays_empty_at_rest_may_have_grown(
    state: PipelineSavedState, fresh: PipelineSavedState
) -> None:
    """Fingertips that were seen once: the first recording that was rejected."""
    bends = TipBendsSavedState(np.zeros((5, 2)), np.zeros(5), np.zeros((5, 2, 2)), 1.0)
    state.engine.tracker.tips = bends
    assert mismatch(state, fresh) is None
    bends.drive = np.zeros(4)
    assert "state.engine.tracker.tips.drive has the shape (4,)" in str(mismatch(state, fresh))


def test_parts_in_lists_and_optional_parts_are_checked(
    state: PipelineSavedState, fresh: PipelineSavedState
) -> None:
    assert fresh.engine.timeline.waiting == [] and len(state.engine.timeline.waiting) == 1
    frame = state.engine.timeline.waiting[0]
    left = frame.left
    short = Blobs(left.uv, left.size, left.hue[:-1], left.score, left.cloth)
    state.engine.timeline.waiting[0] = dataclasses.replace(frame, left=short)
    assert "timeline.waiting[0].left.hue" in str(mismatch(state, fresh))
    state.engine.timeline.waiting.clear()
    stored = state.engine.tracker.wearer.work.keyframes.stored
    stored[0] = dataclasses.replace(stored[0], uv=stored[0].uv[:, :-1])  # a marker fewer
    assert "keyframes.kept[0].uv" in str(mismatch(state, fresh))


@pytest.mark.long
@pytest.mark.parametrize(
    ("part", "value", "why"),
    [
        ("timing", None, "not a FrameTimingSavedState"),
        ("timing", np.zeros(3), "not a FrameTimingSavedState"),
        ("pair", [], "not a PairOffsetSavedState"),
    ],
)
def test_a_part_of_another_type_is_rejected(
    state: PipelineSavedState, fresh: PipelineSavedState, part: str, value: object, why: str
) -> None:
    changed = dataclasses.replace(state, **{part: value})
    assert why in str(mismatch(changed, fresh))


def test_the_message_names_the_engine(state: PipelineSavedState, fresh: PipelineSavedState) -> None:
    _, again = unpack(pack("chain", state))
    require_match(again, fresh, "chain")
    again.engine.tracker.filter.state.bg = np.zeros((9, 3))
    with raises(FileError, "session.state_misfit"):
        require_match(again, fresh, "chain")
