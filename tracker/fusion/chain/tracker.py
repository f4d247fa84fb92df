"""The chain filter in operation: processing of packets, of images, and of missing images."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from tracker.base.records import record
from tracker.fusion.chain.calibration.size_by_motion import place_in_image
from tracker.fusion.chain.calibration.wearer import WearerSavedState
from tracker.fusion.chain.cloth_fingers import ClothFingers, ClothFingersSavedState
from tracker.fusion.chain.confidence import ConfidenceSavedState
from tracker.fusion.chain.distal import DistalSegments
from tracker.fusion.chain.filter import ChainFilter, FilterSavedState, Rows
from tracker.fusion.chain.guided.learning import GuidedSavedState
from tracker.fusion.chain.known import KnownWearer, ReportedWearer, Shows
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.chain.recognition import (
    Recognised,
    Recognition,
    RecognitionSavedState,
    SeenImage,
)
from tracker.fusion.chain.second_look import SecondLook
from tracker.fusion.chain.shown import ShownHand
from tracker.fusion.chain.start.mono_start import release_size
from tracker.fusion.chain.start.start import Starter
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.tape import Tape
from tracker.fusion.chain.tip_bends import TipBends, TipBendsSavedState
from tracker.fusion.chain.tracking import (
    MANY_MARKERS,
    TrackingJudge,
    TrackingSavedState,
    is_believable,
)
from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals
from tracker.messages import Array, BlobFrame, FrameResult, ImuSample, Search, Tracking
from tracker.vision.rig import StereoRig


@record("chain.tracker")
@dataclass(eq=False)
class TrackerSavedState:
    """The complete state of a tracker, by part."""

    filter: FilterSavedState
    tracking: TrackingSavedState
    recognition: RecognitionSavedState
    wearer: WearerSavedState
    shown: ConfidenceSavedState
    guided: GuidedSavedState = field(default_factory=GuidedSavedState)
    tips: TipBendsSavedState = field(default_factory=TipBendsSavedState)
    fingers: ClothFingersSavedState = field(default_factory=ClothFingersSavedState)


class ChainTracker:
    """Connects the parts of the chain engine; a `Filter` that a `Timeline` drives."""

    def __init__(
        self,
        layout: ChainLayout,
        rig: StereoRig,
        params: ChainParams,
        buffer: ImuBuffer,
        tape: Tape | None = None,
    ) -> None:
        self._layout, self._params, self._buffer, self._tape = layout, params, buffer, tape
        self.filter = ChainFilter(layout, params, buffer, tape)
        self._judge = TrackingJudge(params.match)
        self._recognition = Recognition(layout, rig, params, buffer)
        self._starter = Starter(layout, rig, params)
        distal = DistalSegments(layout, params.synergy)
        self.shown = ShownHand(layout, params.noise, distal)
        self.confidence = self.shown.confidence
        self._tips = TipBends(layout, rig, distal, self.shown)
        self._fingers = ClothFingers(layout, rig, self.shown)
        shows = Shows(self.shown, self._recognition, self._tips)
        self.wearer = KnownWearer(layout, rig, params, self.filter, distal, shows)
        self.reported = ReportedWearer(layout, self.wearer, self.confidence)
        self._second = SecondLook(
            layout, self.filter, self._recognition, self._starter, params.match
        )
        self.wearer.show()

    @property
    def state(self) -> ChainState:
        return self.filter.state

    @property
    def tracking(self) -> Tracking:
        return self._judge.tracking

    # ---- packets

    def packet(self, sample: ImuSample) -> None:
        returned = self.confidence.returned(sample)
        self.filter.doubt(returned)
        if self._layout.imu_of[0] in returned:
            self.confidence.moved_unsensed(sample.t)
        self.confidence.packet(sample)

    def step(self, way: Intervals, first: int) -> int:
        last_good = self._judge.saved.last_good
        end = self.filter.step(way, first, last_good, held=self.wearer.calibration.is_frozen)
        if self._tape is not None and self._buffer.is_packet(self.state.t):
            sensed = self.confidence.sensed(self.state.t, self.tracking)
            self._tape.shown(self.state, sensed, self.confidence.tip_sd)
        return end

    def carry(self, state: ChainState, t: float) -> None:
        self.filter.carry(state, t, self._judge.is_coasting(self.state.t))

    def no_image(self) -> bool:
        """Applies anatomy alone."""
        self._judge.judge(self.state.t, enough=False)
        self.filter.constrain(self.state.t)
        learned = self.wearer.learn()
        self.confidence.drifted(self.state)
        self.confidence.aged(self.state)
        self._fingers.no_image(self.state.t)
        return learned

    # ---- images

    def image(self, frame: BlobFrame) -> FrameResult | None:
        # 1. A hand lost while markers are in view is searched for as at the start.
        begun = self._restart(frame)
        if begun is not None:
            return begun
        # 2. Match blobs and markers: near the prediction, else anywhere.
        image = self._recognition.image(frame)
        found = self._recognition.follow(self.state, image)
        found, seen = self._second.match_in_crowd(image, found)
        found = self._if_back(image, found)
        if self._judge.should_search(frame.t, found.tally) and frame.search >= Search.AGAIN:
            moved = self._search_again(image, found)
            if moved is not found:
                found = self._if_back(image, moved)
            seen = self._recognition.evidence(image, found)
        if not seen.is_credible:
            found = found.nothing()
        elif not image.is_mono and found.shift is None:  # in depth, close to the filter's state
            found = self._with_digits(image, found)
        # 3. The matches correct the state, together with anatomy.
        rows, dx = self._correct(image, found)
        self.wearer.learn()
        enough = self._judge.is_enough(found.tally)
        if self.confidence.saved.one_camera:
            self._measure_size(image, place_in_image(self.state, rows, dx) if enough else None)
        if enough:
            self.confidence.held(frame.t)
            self.measure_cloth(image)
        self._judge.judge(frame.t, enough)
        followed = image.is_mono or self._recognition.is_followed(image, found)
        likely = followed and self._recognition.is_likely(image, found, seen, self._judge.is_sure)
        sure = self._judge.support(frame.t, enough and likely)
        self.confidence.supported(frame.t, seen, sure)
        another = self._judge.is_another(frame.t, followed or not enough)
        result = self._finish(image, found)
        if another:
            return replace(result, another=True)
        self._judge.looked(frame.t, image.most_blobs)
        # 4. Occasionally the calibration is solved for again.
        still = self._recognition.at_once(self.state, image, found)
        calibration, one_camera = self.wearer.calibration, self.confidence.saved.one_camera
        side = calibration.side_information(self.wearer.guided, one_camera)
        calibration.refine(self.state, still, found, self._buffer, side)
        return result

    def _if_back(self, image: SeenImage, found: Recognised) -> Recognised:
        """The matches, or nothing if the hand was out of view, or is in an unsure position for
        another reason, and does not fit the blobs."""
        sure = image.is_mono or not found.is_unsure(image)
        if sure and not self._judge.is_coasting(image.frame.t):
            return found
        there = is_believable(found.tally, self._params.match.min_markers)
        return found if there and self._second.fits_after_gap(image, found) else found.nothing()

    def _with_digits(self, image: SeenImage, found: Recognised) -> Recognised:
        """Moves a misplaced digit, if a search for one is due."""
        digit, count = self._judge.next_digit(image.frame.t), self._second.digit_count
        if digit is None or count == 0:
            return found
        found, end = self._second.with_next_digit(image, found, digit)
        self._judge.saved.next_digit = end % count
        return found

    def _correct(self, image: SeenImage, found: Recognised) -> tuple[Rows, Array]:
        """Corrects the state; returns the rows, and (N,) the correction."""
        rows = self._recognition.rows(self.state, image, found)
        return rows, self.filter.correct(rows)

    def _measure_size(self, image: SeenImage, place: Array | None) -> None:
        """With one camera: the size by motion, of a hand at ``place`` (3,) m."""
        self.wearer.calibration.measure_size(self.state, image.pose, place, self._buffer)

    def measure_cloth(self, image: SeenImage) -> None:
        """Measure the end joints, and fingers without sensors, in the outline of the glove. Where
        images are dense, each image measures what has waited longest, so that packets wait less."""
        own, t, seen = self.wearer.guided.synergies, self.state.t, (image.frame, image.pose)
        alone = self._fingers.is_alone(t)
        turn = not alone or self._tips.saved.t <= self._fingers.wait_since
        if turn and self._tips.image(self.state, *seen, own, image.exposure):
            self.wearer.show()
            if alone:
                self._fingers.skip(t)
                return
        if self._params.cloth.fingers:
            self._fingers.image(self.state, *seen)

    def _search_again(self, image: SeenImage, found: Recognised) -> Recognised:
        """Move to a better pose where the images show one; otherwise change nothing."""
        count = found.tally.matched
        pose = self._starter.again(self.state, image.unturned, image.pose, count)
        if pose is None:
            return found
        moved = self.filter.moved.at_pose(self.state, pose)
        there = self._second.fitted_to(moved, image)
        if there.tally.matched <= 1.2 * count:
            return found
        if not self._recognition.evidence(image, there).is_start:
            return found
        v = self._judge.found(image.frame.t, moved.p)
        if v is not None:
            self.filter.moved.moving(moved, v)
            # rows of a rolling shutter depend on the velocity and its covariance
            there = self._second.fitted_to(moved, image)
        self.filter.move(moved)
        return there

    def _restart(self, frame: BlobFrame) -> FrameResult | None:
        """Search for the lost hand as at the start: by now its pose may be arbitrary.

        The wearer's calibration is used, unless the hand has been lost for so long that it may be
        the cause.
        """
        if not self._judge.is_in_vain(frame.t):
            return None
        recent = self._judge.was_recent(frame.t)
        return self._start(frame, self.wearer.calibration.start_with(self.state, recent))

    def start(self, frame: BlobFrame) -> FrameResult | None:
        return self._start(frame, self.wearer.calibration.saved.known)

    def _start(self, frame: BlobFrame, known: WearerProfile | None) -> FrameResult | None:
        # 1. Postures that agree with gravity, voted for in the image.
        if frame.search < Search.FULL or not self._judge.should_start(frame.t):
            return None
        image = self._recognition.image(frame)
        if image.most_blobs < MANY_MARKERS:
            self._judge.saw_nothing()
        t = frame.t
        candidates = self._starter.candidates(self._buffer, image.unturned, image.pose, t, known)
        started = self._second.likeliest(image, candidates)
        if started is None:
            return None
        # 2. Continue from there, with the frozen calibration if any.
        self.filter.adopt(started)
        self._tips.forget()
        self._fingers.forget()
        self.wearer.begun(known)
        self.wearer.calibration.saved.by_motion.interrupt()
        self.wearer.show()
        self._judge.started(frame.t)
        self._judge.found(frame.t, started.p)
        self.confidence.started()
        self.confidence.saved.one_camera = image.is_mono
        self.confidence.held(frame.t)
        # 3. Correct it twice: the second pass matches and linearises at a better state.
        for _ in range(2):
            found = self._recognition.look(self.state, image)
            self._correct(image, found)
        # 4. Move misplaced digits.
        there = self._recognition.look(self.state, image)
        seen = self._recognition.evidence(image, there)
        if not image.is_mono:
            self._second.with_digits(image, there)
        self._judge.support(frame.t, seen.is_likely)
        self.confidence.supported(frame.t, seen, sure=False)
        return self._finish(image, found)

    def _finish(self, image: SeenImage, found: Recognised) -> FrameResult:
        """Update the output with the corrected state."""
        self.confidence.image(image.frame.t, found.match)
        second_camera = self.confidence.saved.one_camera and found.in_both
        if second_camera:
            self.confidence.saved.one_camera = False
        self.confidence.unsure(self.state, image.pose, self.wearer.calibration.distance_sd)
        if second_camera:
            release_size(self.state.P, self._layout, self._params.prior)
        return self._recognition.finish(self.state, image, found, self.tracking)

    # ---- saving

    @property
    def saved(self) -> TrackerSavedState:
        """The complete state, not copied."""
        return TrackerSavedState(
            self.filter.saved,
            self._judge.saved,
            self._recognition.saved,
            self.wearer.calibration.saved,
            self.confidence.saved,
            self.wearer.guided.saved,
            self._tips.saved,
            self._fingers.saved,
        )

    def restore(self, saved: TrackerSavedState) -> None:
        """Restore a `saved` state, which is not copied."""
        self.filter.saved, self._judge.saved = saved.filter, saved.tracking
        self._recognition.saved = saved.recognition
        self.wearer.calibration.saved, self.wearer.guided.saved = saved.wearer, saved.guided
        self._tips.saved = saved.tips
        self._fingers.restore(saved.fingers)
        self.wearer.show()
        self.confidence.restore(saved.shown, self.state)
