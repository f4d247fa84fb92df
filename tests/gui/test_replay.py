"""Replay of a recorded session: what is shown when, and the transport controls."""

import time
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from app.engines.replay.engine import ReplayEngine, marked, open_replay
from app.engines.replay.hands import LATE, OfFile, ReplayMoment
from app.engines.replay.marker_matches import MarkerMatcher
from app.engines.replay.references import ReferenceTrack
from app.engines.replay.sights import pairs
from app.engines.snapshot import HandSnapshots, Snapshot
from app.panels.library.transport import TransportBar
from app.viewmodels.hand_scene import HandSceneModel
from app.viewmodels.log import KINDS, EventLog, words_of
from tests.damaged_sessions import cut_message, spoilt
from tests.gui.gui_fakes import ScriptedEngine, frame_and_blobs, models, scripted_setup, simulation
from tracker.geometry import so3
from tracker.messages import (
    BlobFrame,
    Estimate,
    Event,
    ImuSample,
    StereoFrame,
    Tracking,
    Validity,
)
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.session.holes import LONGEST_FILLED
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, SessionRecorder

SECONDS = 3.0


@pytest.fixture(scope="session")
def sessions(simulated_sessions) -> dict[str, Path]:
    """One movement: as simulated (with truth), tracked by `chain` and tracked by `vist`."""
    return {
        "simulated": simulated_sessions.simulated(),
        "chain": simulated_sessions.tracked(),
        "vist": simulated_sessions.tracked(by=TrackOptions("vist")),
    }


@pytest.fixture
def replay(sessions, qtbot):
    """A paused replay of the `chain` session, its first image shown."""
    engine = ReplayEngine(sessions["chain"])
    engine.player.play(False)
    engine.start()
    qtbot.waitUntil(lambda: moment(engine).latest_frame() is not None)
    yield engine
    engine.close()


@pytest.fixture(scope="session")
def frames(sessions) -> list[BlobFrame]:
    with SessionReader(sessions["chain"]) as reader:
        return list(reader.messages((BlobFrame,)))


def moment(engine: ReplayEngine) -> ReplayMoment:
    """For its only hand."""
    return engine.hands.moments["right"]


def shown(engine: ReplayEngine) -> float:
    frame = moment(engine).latest_frame()
    return np.nan if frame is None else frame[1].t


def test_steps_visit_every_image_and_back(replay, frames, qtbot):
    assert shown(replay) == frames[0].t
    for i in (1, 2, 3):
        replay.player.step(1)
        qtbot.waitUntil(lambda i=i: shown(replay) == frames[i].t)
    replay.player.step(5)
    qtbot.waitUntil(lambda: shown(replay) == frames[8].t)
    replay.player.step(-1)
    qtbot.waitUntil(lambda: shown(replay) == frames[7].t)
    replay.player.step(-6)
    qtbot.waitUntil(lambda: shown(replay) == frames[1].t)
    replay.player.step(-20)
    qtbot.waitUntil(lambda: shown(replay) == frames[0].t)


def test_a_paused_replay_seeks_exactly(replay, frames, qtbot):
    """Its time is exact to the microsecond, with the last image up to then."""
    replay.player.seek(2.0)
    due = [f for f in frames if f.t_arrival - replay.start_t <= 2.0][-1]
    qtbot.waitUntil(lambda: shown(replay) == due.t)
    qtbot.waitUntil(lambda: replay.player.images_due == 0)
    assert replay.player.position == 2.0
    estimate = replay.hands.moments["right"].latest_estimate()
    assert estimate is not None and abs(estimate.t - due.t) < 0.1
    assert not replay.player.playing


HOLE = (1.0, 2.0)  # s without packets and estimates, while images continue


@pytest.fixture(scope="session")
def holed(sessions, tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("holed") / "holed.mcap"
    with SessionReader(sessions["chain"]) as reader:
        start = reader.anchor.monotonic(reader.span_ns[0])
        with SessionRecorder(path, reader.info) as recorder:
            for m in reader.messages():
                inside = HOLE[0] < m.t - start < HOLE[1]
                if not (inside and isinstance(m, Estimate | ImuSample)):
                    recorder.write(m)
    return path


@pytest.fixture
def holed_replay(holed, qtbot):
    setup = open_replay(holed, lambda *_: None)
    setup.engine.player.play(False)
    setup.engine.start()
    qtbot.waitUntil(lambda: moment(setup.engine).latest_estimate() is not None)
    yield setup
    setup.close()


def arrives(qtbot, engine, position):
    """Seek a paused replay and wait until it shows that time."""
    engine.player.seek(position)
    qtbot.waitUntil(
        lambda: (
            engine.player.seek_to is None
            and engine.player.images_due == 0
            and engine.player.position == pytest.approx(position, abs=0.05)
        ),
    )


@pytest.mark.parametrize(("position", "is_lost"), [(0.9, False), (1.5, True), (2.5, False)])
def test_a_hole_in_the_recording_is_shown_as_lost(holed_replay, position, is_lost, qtbot):
    """From any earlier position; and never in the colour of measured points."""
    engine, seen = holed_replay.engine, moment(holed_replay.engine)
    model = HandSceneModel(holed_replay)
    for before in (0.8, 2.7):
        arrives(qtbot, engine, before)
        qtbot.waitUntil(lambda: not seen.is_in_hole)
        assert model.scene(HandSnapshots().take(holed_replay, True)) is not None
        arrives(qtbot, engine, position)
        qtbot.waitUntil(lambda: seen.is_in_hole == is_lost)
        estimate, status = seen.latest_estimate(), seen.status()
        assert (estimate.tracking == Tracking.LOST) == is_lost == (status.tracking == Tracking.LOST)
        assert (estimate.keypoint_state == Validity.LOST).all() == is_lost
        scene = model.scene(HandSnapshots().take(holed_replay, True))
        assert (scene.segment_state == Validity.LOST).all() == is_lost
        assert ("No estimates" in scene.caption) == is_lost


def test_a_replay_that_plays_into_a_hole_loses_the_hand_and_finds_it_again(holed_replay, qtbot):
    engine, seen = holed_replay.engine, moment(holed_replay.engine)
    engine.player.set_range(0.8, 2.4)
    found: list[tuple[float, bool]] = []
    engine.player.play(True)

    def ended() -> bool:
        found.append((engine.player.position, seen.is_in_hole))
        return not engine.player.playing

    qtbot.waitUntil(ended)
    lost = [at for at, is_lost in found if is_lost]
    assert min(lost) == pytest.approx(HOLE[0] + LONGEST_FILLED, abs=0.15)
    assert max(lost) == pytest.approx(HOLE[1], abs=0.15)
    assert not seen.is_in_hole


def in_bursts(estimates: list[Estimate], hole: tuple[float, float] | None) -> list[OfFile]:
    """Every 0.3 s those before, as on an overloaded computer, with events in between."""
    out = []
    for t in np.arange(0.3, 3.0, 0.3):
        events = [OfFile("", Event(u, "note", "")) for u in (t - 0.2, t - 0.1)]
        burst = [OfFile("right", e) for e in estimates if t - 0.3 <= e.t < t]
        out += events + [r for r in burst if hole is None or not hole[0] < r.message.t < hole[1]]
    return out


@pytest.mark.parametrize(("hole", "found"), [(None, []), ((0.95, 1.15), [0.95]), ((1.2, 9), [1.2])])
def test_late_estimates_are_not_a_hole(estimates, hole, found):
    read = in_bursts(estimates, hole)
    ends = [r.message.t for r, before_hole in marked(read) if before_hole]
    assert ends == pytest.approx(found, abs=0.011)
    assert [r for r, _ in marked(read)] == read


@pytest.fixture
def estimates(sessions) -> list[Estimate]:
    """One every 10 ms for 3 s."""
    with SessionReader(sessions["chain"]) as reader:
        one = next(m for m in reader.messages((Estimate,)) if isinstance(m, Estimate))
    return [replace(one, t=float(t)) for t in np.arange(0.0, 3.0, 0.01)]


def test_playing_stops_at_the_out_point_and_restarts_at_the_in_point(replay, qtbot):
    replay.player.set_range(1.6, 1.2)
    assert replay.player.range == (1.2, 1.6)
    replay.player.play(True)
    qtbot.waitUntil(lambda: not replay.player.playing)
    assert replay.player.position == pytest.approx(1.6, abs=0.02)
    replay.player.play(True)
    qtbot.waitUntil(lambda: replay.player.position < 1.5)
    assert replay.player.position >= 1.2 - 1e-9


def test_a_loop_repeats(replay, qtbot):
    replay.player.set_range(1.0, 1.3)
    replay.player.set_loop(True)
    replay.player.set_speed(4.0)
    positions = []
    replay.player.play(True)
    qtbot.waitUntil(
        lambda: positions.append(replay.player.position) or bool((np.diff(positions) < -0.1).any())
    )
    assert replay.player.playing
    assert max(positions) <= 1.3 + 1e-6


def test_speed_is_accurate(replay, qtbot):
    """Never faster than half of the time that has passed, whenever the computer shows it."""
    replay.player.play(False)
    replay.player.set_speed(0.5)
    replay.player.seek(0.5)
    qtbot.waitUntil(lambda: abs(replay.player.position - 0.5) < 0.05)
    start, began = replay.player.position, time.monotonic()
    replay.player.play(True)
    ahead = []

    def has_played() -> bool:
        position = replay.player.position
        ahead.append(position - start - 0.5 * (time.monotonic() - began))
        return position > 0.8

    qtbot.waitUntil(has_played)
    assert max(ahead) < 0.05  # an image and a half


def test_a_replay_skips_damaged_messages_and_reports_their_number(
    sessions, frames, tmp_path, qtbot
):
    topics = ["/camera/left/blobs", "/camera/right/blobs", "/hand/right/keypoints"]
    engine = ReplayEngine(spoilt(sessions["chain"], tmp_path / "a.mcap", topics, cut_message))
    try:
        engine.start()
        engine.player.set_speed(4.0)
        engine.player.play(True)
        qtbot.waitUntil(lambda: shown(engine) == frames[-1].t)
        errors: list[str] = []

        def has_reported_all() -> bool:
            errors.extend(e.text for e in engine.drain_events() if e.kind == "error")
            return bool(errors) and all(f"1 on {topic}" in errors[-1] for topic in topics)

        qtbot.waitUntil(has_reported_all)
        assert len(errors) <= 3
    finally:
        engine.close()


def test_a_session_of_a_glove_alone_reports_that_there_was_no_camera(sessions, tmp_path):
    alone = tmp_path / "alone.mcap"
    simulate(alone, SimulateOptions(seed=3, duration=1.0, lenses="none"))
    for path, has_camera in ((alone, False), (sessions["vist"], True)):
        setup = open_replay(path, lambda *_: None)
        setup.close()
        assert setup.camera.present == has_camera


def test_a_session_without_blobs_steps_by_estimates(sessions, qtbot):
    with SessionReader(sessions["vist"]) as reader:
        instants = [m.t for m in reader.messages((Estimate,))]
    engine = ReplayEngine(sessions["vist"])
    engine.player.play(False)
    engine.start()
    try:
        qtbot.waitUntil(lambda: moment(engine).latest_estimate() is not None)
        engine.player.step(1)
        qtbot.waitUntil(lambda: moment(engine).latest_estimate().t == instants[1])
        assert not engine.player.playing
    finally:
        engine.close()


def test_the_other_tracking_is_shown_next_to_this_one(replay, sessions, frames, qtbot):
    with SessionReader(sessions["vist"]) as reader:
        other = {round(m.t, 6): m for m in reader.messages((Estimate,))}
    assert replay.player.reference("right") is None
    replay.player.set_reference(sessions["vist"])
    replay.player.seek(2.5)
    due = [f for f in frames if f.t_arrival - replay.start_t <= 2.5][-1]
    player = replay.player  # it is still when the image is shown and no other is due
    qtbot.waitUntil(lambda: shown(replay) == due.t and player.images_due == 0)
    qtbot.waitUntil(lambda: replay.player.reference("right") is not None)
    reference = replay.player.reference("right")
    mine = other[round(moment(replay).latest_estimate().t, 6)]
    assert reference.keypoints == pytest.approx(mine.keypoints, abs=1e-9)
    assert reference.p_GB == pytest.approx(mine.segment_p, abs=1e-6)
    assert np.allclose(reference.R_GB, mine.segment_R, atol=1e-6)
    replay.player.set_reference(None)
    qtbot.waitUntil(lambda: replay.player.reference("right") is None)


@pytest.mark.parametrize(("compared", "shown"), [(True, None), (False, "the truth")])
def test_the_truth_does_not_replace_a_missing_hand_of_the_other_tracking(compared, shown):
    player = SimpleNamespace(is_compared=compared, reference=lambda side: None)
    truth = SimpleNamespace(at=lambda t: "the truth")
    setup = replace(scripted_setup(ScriptedEngine()), player=player, live=None, truth=truth)
    view = Snapshot(setup=setup, running=True, estimate=SimpleNamespace(t=1.0))
    assert view.reference() == shown


def test_the_truth_of_a_simulated_session_is_the_simulators(sessions):
    with SessionReader(sessions["simulated"]) as reader:
        true = next(e for e in reader.truth(1.0) if e.t >= 1.5)
    track_ = ReferenceTrack(sessions["simulated"], root="truth")
    track_.seek(1.4)
    track_.advance(true.t)
    pose = track_.pose(true.t)
    track_.close()
    assert pose is not None
    assert pose.keypoints == pytest.approx(true.keypoints, nan_ok=True)


def test_notes_and_events_are_on_the_timeline(tmp_path, sessions):
    from dataclasses import replace

    from tracker.session.notes import numbered
    from tracker.session.writer import RecorderParams, SessionRecorder

    with SessionReader(sessions["simulated"]) as reader:
        info = replace(reader.info, rig=reader.rig())
        messages = list(reader.messages())
    path = tmp_path / "noted.mcap"
    start = messages[0].t_arrival
    with SessionRecorder(path, info, RecorderParams(sync=False)) as recorder:
        for message in messages:
            recorder.write(message)
        recorder.write(Event(start + 1.25, "note", "griped the cup", numbered(0, 0)))
        recorder.write(Event(start + 2.0, "note", "a mistake", numbered(1, 0)))
        recorder.write(Event(start + 1.25, "note", "gripped the cup", numbered(0, 1)))
        recorder.write(Event(start + 2.0, "note", "", numbered(1, 1)))
    setup = open_replay(path, lambda *_: None)
    try:
        [(place, event)] = [e for e in setup.player.events if e[1].kind == "note"]
        assert event.text == "gripped the cup"
        assert place == pytest.approx(1.25, abs=0.02)
    finally:
        setup.close()


def test_replayed_events_affect_neither_the_log_nor_live_commands(
    window, tmp_path, sessions, qtbot
):
    path = tmp_path / "noted.mcap"
    with SessionReader(sessions["simulated"]) as reader:
        info = replace(reader.info, rig=reader.rig())
        messages = list(reader.messages())
    start = messages[0].t_arrival
    with SessionRecorder(path, info, RecorderParams(sync=False)) as recorder:
        for message in messages:
            recorder.write(message)
        recorder.write(Event(start + 0.2, "note", "gripped the cup"))
        recorder.write(Event(start + 0.3, "error", "The disk is full."))
    window.host.adopt(open_replay(path, lambda *_: None))
    player = window.host.setup.player
    player.seek(0.0)
    player.play(True)
    qtbot.waitUntil(lambda: player.position > 0.6)
    lines = " ".join(entry.line for entry in window.log.model.entries())
    assert "gripped the cup" not in lines and "disk" not in lines
    assert not window.messages.isVisible()
    assert window.windowTitle() == "Replay of noted.mcap – Glovetrack"
    qtbot.waitUntil(lambda: window.bar.tracking.text().startswith("Replay: "))
    for key in ("start", "stop", "record", "note"):
        assert not window.commands.actions[key].isEnabled(), key


def test_a_session_opens_paused_at_an_instant_and_goes_to_another(window, sessions, frames, qtbot):
    """The hand and the image are those of the instant: estimates come every 5 to 10 ms."""

    def shows(position: float) -> bool:
        setup = window.host.setup
        if setup is None or setup.player.images_due or setup.player.seek_to is not None:
            return False
        hand, frame = setup.tracked.latest_estimate(), setup.tracked.latest_frame()
        at = setup.engine.start_t + position
        due = [f for f in frames if f.t_arrival <= at][-1]
        return frame is not None and frame[1].t == due.t and at - 0.02 < hand.t <= at + 1e-6

    window.sources.open_session(sessions["chain"], 1.5)
    qtbot.waitUntil(lambda: shows(1.5))
    setup = window.host.setup
    assert setup.player.position == 1.5 and not setup.player.playing
    setup.player.play(True)
    window.sources.open_session(sessions["chain"], 0.75)
    qtbot.waitUntil(lambda: shows(0.75))
    assert window.host.setup is setup, "it was opened again"
    assert setup.player.position == 0.75 and not setup.player.playing


class Held:
    """A player at the requested time, with these notes (s)."""

    duration, range, playing = 10.0, (0.0, 10.0), False

    def __init__(self, notes) -> None:
        self.position = 0.0
        self.events = tuple((at, Event(at, "note", "x")) for at in notes)

    def seek(self, position: float) -> None:
        self.position = position

    def set_speed(self, speed: float) -> None:
        pass


def test_jumping_from_note_to_note(qtbot):
    bar = TransportBar()
    qtbot.addWidget(bar)
    player = Held([2.0, 5.0, 5.3, 8.0])
    bar.set_player(player)
    visited = []
    for by in (1, 1, 1, 1, 1, -1, -1, -1):
        bar.jump(by)
        visited.append(player.position)
    assert visited == [2.0, 5.0, 5.3, 8.0, 8.0, 5.3, 2.0, 2.0]  # back, what lies 0.6 s before


def test_a_gesture_is_neither_on_the_timeline_nor_in_the_log(qtbot):
    bar = TransportBar()
    qtbot.addWidget(bar)
    player = Held([2.0])
    gesture = Event(1.0, "gesture", "", {"gesture": "fist", "phase": "begin"})
    pulse = Event(3.0, "pulse", "Pulse 1 on the glove")
    player.events = ((1.0, gesture), *player.events, (3.0, pulse))
    bar.set_player(player)
    assert bar.timeline.mark_at(bar.timeline.x_of(1.0)) is None
    assert bar.timeline.mark_at(bar.timeline.x_of(2.0)).sign == KINDS["note"].sign
    assert bar.timeline.mark_at(bar.timeline.x_of(3.0)).sign == KINDS["device"].sign
    log = EventLog()
    log.add(pulse)
    assert len(log.entries("device")) == 1 and words_of(gesture) == ""


class TestImagesAndBlobs:
    """The display for images and blobs in either order, or with one of them missing."""

    @staticmethod
    def image(t: float) -> StereoFrame:
        return StereoFrame(t, t, np.zeros((2, 2, 3), np.uint8), None)

    @staticmethod
    def blobs(t: float) -> BlobFrame:
        return BlobFrame(t, t, (), None, None)

    def test_blobs_before_their_image_are_shown_with_it(self):
        moment = ReplayMoment(3, has_images=True)
        for t in (1.0, 1.1):
            moment.take(self.blobs(t))
            moment.take(self.image(t))
            assert moment.latest_frame() is not None
            assert moment.latest_frame()[0].left is not None
            assert moment.latest_frame()[0].t == moment.latest_frame()[1].t == t

    def test_blobs_of_a_dropped_image_do_not_blank_the_display(self):
        moment = ReplayMoment(3, has_images=True)
        moment.take(self.image(1.0))
        moment.take(self.blobs(1.0))
        moment.take(self.blobs(1.1))
        assert moment.latest_frame() is not None and moment.latest_frame()[0].t == 1.0
        moment.take(self.blobs(1.0 + 2 * LATE))  # no image for so long: it is not to be expected
        image, blobs, _ = moment.latest_frame()
        assert image.left is None and blobs.t == 1.0 + 2 * LATE

    def test_without_images_in_the_file_blobs_are_shown_at_once(self):
        moment = ReplayMoment(3, has_images=False)
        moment.take(self.blobs(1.0))
        assert moment.latest_frame() is not None and moment.latest_frame()[1].t == 1.0

    def test_pairs_are_found_in_either_order_and_halves_are_not(self):
        def packed(t: float) -> PackedFrame:
            return PackedFrame(t, t + 0.01, {}, None, 0)

        messages = [self.blobs(1.0), packed(1.0), packed(1.1), self.blobs(1.1), self.blobs(1.2)]
        assert list(pairs(messages)) == pytest.approx([1.01, 1.1])


def test_a_replay_labels_patches_with_their_markers():
    """With a hand that is 4 mm and 3 degrees off the simulated one, like a tracked one."""
    hand, glove, _ = models()
    scene = simulation().scene
    matcher, matched, right = MarkerMatcher(hand, glove, scene.rig), 0, 0
    turn = so3.exp(np.deg2rad(3.0) * np.array([0.0, 0.6, 0.8]))
    for k in range(10, 160, 15):
        _, blobs = frame_and_blobs(k)
        true = ScriptedEngine(k).latest_estimate()
        off = replace(
            true,
            segment_R=turn @ true.segment_R,
            segment_p=(true.segment_p - true.segment_p[0]) @ turn.T + true.segment_p[0] + 0.0023,
        )
        uv = scene.markers_seen(scene.instant(blobs.t), right=False).uv
        for marker, blob in enumerate(matcher.match(blobs, [off]).match_left.tolist()):
            if blob >= 0:
                matched += 1
                right += np.linalg.norm(blobs.left.uv[blob] - uv[marker]) < 3.0  # px
    assert matched > 10 * 10  # of 37 markers at least ten are seen in an image
    assert right / matched > 0.95


def test_nothing_is_labelled_in_an_image_without_a_tracked_hand(sessions):
    with SessionReader(sessions["chain"]) as reader:
        info = reader.info
        frame = next(iter(reader.messages((BlobFrame,))))
    result = MarkerMatcher(info.hand, info.glove, info.rig).match(frame, [])
    assert (result.match_left < 0).all() and np.isnan(result.predicted_left).all()
