"""Alternatives that are tried where an image does not clearly support the predicted pose.

Four kinds of doubt, each resolved by trial: correct a copy of the state, match the image again from
there, and accept it only if the image then supports it. The state itself is not changed before.
"""

from __future__ import annotations

from typing import NamedTuple

from tracker.fusion.chain.digits import DigitSearch
from tracker.fusion.chain.filter import ChainFilter
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import MatchParams
from tracker.fusion.chain.recognition import Recognised, Recognition, SeenImage
from tracker.fusion.chain.start.start import Starter
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.support import Evidence
from tracker.messages import Array
from tracker.vision.stereo import StereoMatches

SHIFT_SD = 0.008  # m, of a shift for which all markers have voted
FITTED = 2  # corrections of a copy before it is evaluated
CLOSER = 0.8  # markers, gain in stereo support required of a posture with as many matches as before


class ImageFit(NamedTuple):
    """A state corrected by an image, and the matches of that image."""

    state: ChainState
    found: Recognised

    @property
    def matched(self) -> int:
        """Number of matched markers."""
        return self.found.tally.matched


class SecondLook:
    """For the filter and the recognition of one hand."""

    def __init__(
        self,
        layout: ChainLayout,
        chain: ChainFilter,
        recognition: Recognition,
        starter: Starter,
        params: MatchParams,
    ) -> None:
        self._filter, self._recognition = chain, recognition
        self._starter, self._params = starter, params
        self._digits = DigitSearch(layout)

    @property
    def digit_count(self) -> int:
        """Number of digits that can be moved."""
        return self._digits.count

    def likeliest(self, image: SeenImage, candidates: list[ChainState]) -> ChainState | None:
        """For the states that a search proposes, the one that most markers support; None where a
        chance match would reach as many."""
        best, most = None, 0
        for state in candidates:
            _, seen = self._fitted(image, state)
            if seen.is_start and seen.matched > most:
                best, most = state, seen.matched
        return best

    def match_in_crowd(self, image: SeenImage, found: Recognised) -> tuple[Recognised, Evidence]:
        """The matched blobs, and how credible they are.

        Where chance matches fill the gates as well as the hand would, all markers together vote for
        the shift of the hand, and near the shifted prediction few blobs remain as candidates.
        """
        seen = self._recognition.evidence(image, found)
        if image.is_mono:
            return self._by_one_camera(image, found, seen)
        if seen.is_credible:
            return self._jointly(image, found, seen)
        shift = self._starter.shift(self._filter.state, image.unturned, image.pose)
        if shift is None:
            return found, seen
        moved = self._filter.moved.shifted(self._filter.state, shift, SHIFT_SD)
        there, fitted = self._fitted(image, moved)
        if not (fitted.is_credible and fitted.is_start):
            return found, seen
        self._filter.move(moved)
        expected = self._recognition.look(moved, image)
        return Recognised(expected.prediction, there.match), fitted

    def _jointly(
        self, image: SeenImage, found: Recognised, seen: Evidence
    ) -> tuple[Recognised, Evidence]:
        """Where gates are wide, matches the markers again after all of them have voted for a shift.

        After a gap each marker alone finds a blob of its hue, often that of a neighbour. The rows
        are linearised at the shifted hand: pixels are not linear over centimetres.
        """
        if not found.is_unsure(image):
            return found, seen
        state = self._filter.state
        shift = self._starter.shift(state, image.unturned, image.pose)
        if shift is None:
            return found, seen
        fit = self._fit(image, self._filter.moved.shifted(self._filter.state, shift, SHIFT_SD))
        fitted = self._recognition.evidence(image, fit.found)
        if not fitted.is_start:
            return found, seen
        moved = state.copy()
        moved.p = fit.state.p
        there = self._recognition.look(moved, image).prediction
        return Recognised(there, fit.found.match, moved.p - state.p), fitted

    def _by_one_camera(
        self, image: SeenImage, found: Recognised, seen: Evidence
    ) -> tuple[Recognised, Evidence]:
        """Where gates are wide, matches the markers again after all of them have voted for a shift.

        A hand just found may have moved far by the next image: each marker alone then matches its
        neighbour's blob equally well, and a finger that appears longer is mistaken for a nearer
        hand.
        """
        if not found.is_unsure(image):
            return found, seen
        there, fitted = self._fitted(image, self._filter.state)
        return Recognised(found.prediction, there.match), fitted

    def fitted_to(self, moved: ChainState, image: SeenImage) -> Recognised:
        """The blobs matched with a hand that a search has found, once it is corrected by them."""
        match = self._fit(image, moved).found.match
        return Recognised(self._recognition.look(moved, image).prediction, match)

    def fits_after_gap(self, image: SeenImage, found: Recognised) -> bool:
        """Whether a hand corrected by the blobs fits them: after some time out of view gates are
        wide, and a few blobs within them may be anything."""
        trial = self._filter.corrected(self._recognition.rows(self._filter.state, image, found))
        there = self._recognition.look(trial, image)
        still = there.tally.matched >= found.tally.matched - 1
        return still and there.misfit_px(image) <= self._params.misfit_px

    def with_digits(self, image: SeenImage, found: Recognised) -> Recognised:
        """Moves all misplaced digits to where their markers are; see `with_next_digit`."""
        digit = 0
        while digit < self._digits.count:
            found, digit = self.with_next_digit(image, found, digit)
        return found

    def with_next_digit(
        self, image: SeenImage, found: Recognised, first: int
    ) -> tuple[Recognised, int]:
        """Moves the next digit, ``first`` or a later one, that may be misplaced to where its
        markers are; returns the digit to continue with, their number if none is left.

        All digits are checked: one that has matched its neighbour's markers keeps the remaining
        ones from itself, and lacks none. Only unmatched blobs can reveal that: where there are
        none, no digit is checked. A trial costs as much as the rest of an image, and packets wait
        for it, so that one image tries one digit at most.
        """
        if self._recognition.is_all_known(image, found):
            return found, self._digits.count
        pairs = self._recognition.pairs(self._filter.state, image)
        for digit in range(first, self._digits.count):
            points = self._recognition.free_points(image, pairs, found, digit)
            R = self._digits.other(self._filter.state, digit, points)
            if R is not None:
                return self._tried(image, pairs, found, digit, R), digit + 1
        return found, self._digits.count

    def _tried(
        self, image: SeenImage, pairs: StereoMatches, found: Recognised, digit: int, R: Array
    ) -> Recognised:
        """Moves a digit to the posture R_GB (A, 3, 3) if the image supports that better."""
        state = self._filter.state
        moved = state.copy()
        moved.R_GB = R
        self._digits.doubtful(moved.P, digit)
        there = self._fit(image, moved)
        if there.matched < found.tally.matched:
            return found
        stays = self._fit(image, state)
        if there.matched < stays.matched:
            return found
        if there.matched == max(stays.matched, found.tally.matched):
            closer = [self._support(image, pairs, fit, digit) for fit in (there, stays)]
            if closer[0] - closer[1] < CLOSER:
                return found
        self._filter.move(moved)
        return Recognised(self._recognition.look(moved, image).prediction, there.found.match)

    def _support(self, image: SeenImage, pairs: StereoMatches, fit: ImageFit, digit: int) -> float:
        """Number of a digit's markers that stereo points support."""
        points = self._recognition.free_points(image, pairs, fit.found, digit)
        return self._digits.support(fit.state, digit, points)

    def _fitted(self, image: SeenImage, state: ChainState) -> tuple[Recognised, Evidence]:
        """The matches for a state corrected by the image, and the evidence for it."""
        there = self._fit(image, state).found
        return there, self._recognition.evidence(image, there)

    def _fit(self, image: SeenImage, state: ChainState) -> ImageFit:
        """A copy of ``state`` corrected by the image, and its matches."""
        trial = state
        for _ in range(FITTED):
            there = self._recognition.look(trial, image)
            trial = self._filter.corrected(self._recognition.rows(trial, image, there), trial)
        return ImageFit(trial, self._recognition.look(trial, image))
