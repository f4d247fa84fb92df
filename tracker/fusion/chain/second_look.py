"""What is tried where an image does not speak clearly for the pose that was expected.

Four doubts, each settled by trying: correct the hand on a copy, look at the image again from
there, and believe it only if the image then supports it. Nothing moves before.
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
from tracker.vision.stereo import StereoMatches

SHIFT_SD = 0.008  # m, of a shift that all markers have voted for
FITTED = 2  # corrections of a copy before it is judged
CLOSER = 0.8  # markers, of support by stereo points, for a posture that finds as many as before


class ImageFit(NamedTuple):
    """A state that an image has corrected, and what the image shows of it."""

    state: ChainState
    found: Recognised

    @property
    def matched(self) -> int:
        """Markers."""
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

    def likeliest(self, image: SeenImage, candidates: list[ChainState]) -> ChainState | None:
        """Of the states that a search proposes the one that most markers support; None where that
        is what chance would find, too."""
        best, most = None, 0
        for state in candidates:
            _, seen = self._fitted(image, state)
            if seen.is_start and seen.matched > most:
                best, most = state, seen.matched
        return best

    def through_the_crowd(self, image: SeenImage, found: Recognised) -> tuple[Recognised, Evidence]:
        """Blobs of markers, and how far they can be believed.

        Where chance fills the gates as well as the hand would, all markers together say how it has
        moved, and near where that puts them few blobs are left to choose from.
        """
        seen = self._recognition.evidence(image, found)
        if image.is_mono:
            return self._by_one_camera(image, found, seen)
        if seen.is_credible:
            return found, seen
        shift = self._starter.shift(self._filter.state, image.blobs, image.pose)
        if shift is None:
            return found, seen
        moved = self._filter.shifted_by(shift, SHIFT_SD)
        there, fitted = self._fitted(image, moved)
        if not (fitted.is_credible and fitted.is_start):
            return found, seen
        self._filter.move(moved)
        expected = self._recognition.look(moved, image)
        return Recognised(expected.prediction, there.match), fitted

    def _by_one_camera(
        self, image: SeenImage, found: Recognised, seen: Evidence
    ) -> tuple[Recognised, Evidence]:
        """Where gates are wide, markers once more from where all of them together put the hand.

        Just found, the hand may have moved far by the next image: each marker by itself then takes
        its neighbour's blob for its own as gladly, and a finger that seems longer is a hand nearer.
        """
        if not self._recognition.is_unsure(image, found):
            return found, seen
        there, fitted = self._fitted(image, self._filter.state)
        return Recognised(found.prediction, there.match), fitted

    def after_a_while(self, image: SeenImage, found: Recognised) -> bool:
        """Whether the hand that the blobs correct fits them: after a while out of sight gates are
        wide, and a few blobs within them may be anything."""
        trial = self._filter.corrected(self._recognition.rows(self._filter.state, image, found))
        there = self._recognition.look(trial, image)
        still = there.tally.matched >= found.tally.matched - 1
        return still and self._recognition.misfit_px(image, there) <= self._params.misfit_px

    def with_digits(self, image: SeenImage, found: Recognised) -> Recognised:
        """Put digits whose markers are not where they should be where they are.

        Each is asked: one that has taken its neighbour's markers for its own hides the rest from
        itself, and lacks none. Only unassigned blobs can show that it does: where there are
        none nothing is asked.
        """
        if self._recognition.is_all_known(image, found):
            return found
        pairs = self._recognition.pairs(image)
        for digit in range(self._digits.count):
            found = self._with_digit(image, pairs, found, digit)
        return found

    def _with_digit(
        self, image: SeenImage, pairs: StereoMatches, found: Recognised, digit: int
    ) -> Recognised:
        """Move a digit to where the image supports it better, if it does anywhere."""
        state = self._filter.state
        points = self._recognition.free_points(image, pairs, found, digit)
        R = self._digits.other(state, digit, points)
        if R is None:
            return found
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
        """Markers of a digit that stereo points support."""
        points = self._recognition.free_points(image, pairs, fit.found, digit)
        return self._digits.support(fit.state, digit, points)

    def _fitted(self, image: SeenImage, state: ChainState) -> tuple[Recognised, Evidence]:
        """What the image shows of a state that it has corrected, and how far that speaks for it."""
        there = self._fit(image, state).found
        return there, self._recognition.evidence(image, there)

    def _fit(self, image: SeenImage, state: ChainState) -> ImageFit:
        """A copy of ``state`` that the image has corrected, and what it shows of it."""
        trial = state
        for _ in range(FITTED):
            there = self._recognition.look(trial, image)
            trial = self._filter.corrected(self._recognition.rows(trial, image, there), trial)
        return ImageFit(trial, self._recognition.look(trial, image))
