"""``glovetrack simulate``: a session with truth from the simulator."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

import numpy as np

from tracker.base.clock import ClockAnchor
from tracker.base.errors import ConfigError
from tracker.base.files import check_target
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.glove import library
from tracker.hand.names import SIDES
from tracker.messages import Estimate, ImuSample, StereoFrame, Tracking, Validity
from tracker.offline.options import SimulateOptions
from tracker.session.description import SessionInfo, describe
from tracker.session.writer import RecorderParams, new_session
from tracker.simulation.camera_errors import CameraErrors, errors_named
from tracker.simulation.guided import HELD_BADLY, GuidedPoses, HoldParams, with_events
from tracker.simulation.head import MOVING, HeadParams
from tracker.simulation.motion import SimulatedMotion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.recorded.load import load_motion
from tracker.simulation.rooms import SCENES, Room, room_of
from tracker.simulation.scenario import Message, Simulation, SimulationParams, Truth
from tracker.simulation.scripted import show
from tracker.simulation.shows import WORD
from tracker.simulation.two_hands import GlovedHand, TwoHandsSimulation
from tracker.simulation.wearer import Wearer
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import LONGEST_READOUT, StereoRig, ideal_rig

EPOCH_NS = 1_735_689_600 * 10**9  # 2025-01-01: a simulated session has no clock of its own
MONOTONIC_NS = 0
MOST_LATE = 0.05  # s
STATUS_S = 1.0
"""Interval at which a glove reports its temperatures."""
M = TypeVar("M")
GLOVES = {"left": "vist-small-left", "right": library.DEFAULT_GLOVE}
"""The default glove of a simulated hand of each side."""


def build(options: SimulateOptions) -> tuple[Simulation, SessionInfo]:
    """The simulation and what its session is about.

    Raises ConfigError for impossible numbers, FileError for missing files.
    """
    _check_numbers(options)
    if options.hands not in GLOVES:
        known = (*GLOVES, "both")
        raise ConfigError(
            notice("option.choice", option="--hands", known=known, value=options.hands)
        )
    glove = options.glove or GLOVES[options.hands]
    info = _info(options, library.texts(glove, options.hand or None))
    seed, rig = options.seed, _rig(options)
    room = _room(options, rig)
    head = _head(options.camera)
    if options.camera != "stand" and options.scene not in SCENES:
        raise ConfigError(notice("simulate.fixed_camera", scene=options.scene))
    params = SimulationParams(
        head=head, render=room.render, person=options.person, right_late=options.right_late
    )
    params = _errors(options).params(params)
    motion = _led(options, info, _motion(options, info))
    sim = Simulation(info.hand, info.glove, motion, seed, params, options.fps, rig, room.extras)
    if options.images and rig is not None:
        sim.renderer  # noqa: B018  raises what cannot be drawn before a file is created
    return sim, replace(info, rig=rig, moving_camera=options.camera == "head")


def _rig(options: SimulateOptions) -> StereoRig | None:
    """What looks on, if anything."""
    known = {"both": ideal_rig(), "one": with_one_camera(ideal_rig()), "none": None}
    if options.lenses not in known:
        raise ConfigError(
            notice("option.choice", option="--lenses", known=tuple(known), value=options.lenses)
        )
    rig = known[options.lenses]
    return None if rig is None else _errors(options).rig(rig, options.seed)


def _room(options: SimulateOptions, rig: StereoRig | None) -> Room:
    """What surrounds the hand, as the true camera sees it."""
    seen_by = None if rig is None else _errors(options).true_rig(rig, options.seed)
    return room_of(options.scene, options.light, options.photo, options.seed, seen_by)


def _errors(options: SimulateOptions) -> CameraErrors:
    errors = errors_named(options.camera_errors, one_camera=options.lenses == "one")
    return errors if options.readout is None else replace(errors, readout=options.readout)


def _check_numbers(options: SimulateOptions) -> None:
    if not 1.0 <= options.duration <= 36_000:
        raise ConfigError(notice("option.range", option="--duration", low="1 s", high="10 h"))
    if not 5 <= options.fps <= 240:
        raise ConfigError(notice("option.range", option="--fps", low=5, high=240))
    if not 0 <= options.right_late <= MOST_LATE:
        raise ConfigError(notice("option.range", option="--right-late", low=0, high="50 ms"))
    if not 0 <= (options.readout or 0.0) <= LONGEST_READOUT:
        raise ConfigError(notice("option.range", option="--readout", low=0, high="100 ms"))


def _info(options: SimulateOptions, texts: tuple[str, str]) -> SessionInfo:
    """``texts`` are those of the hand and of the glove."""
    return describe(
        *texts,
        ClockAnchor(EPOCH_NS, MONOTONIC_NS),
        colours_text=library.text("colours", library.DEFAULT_COLOURS),
        simulated=True,
        notes=f"seed {options.seed}, motion {Path(options.motion).name or 'random postures'}",
    )


def _head(camera: str) -> HeadParams:
    known = {"stand": HeadParams(), "head": MOVING, "head-imu": replace(MOVING, tells="imu")}
    if camera not in known:
        raise ConfigError(
            notice("option.choice", option="--camera", known=tuple(known), value=camera)
        )
    return known[camera]


def _motion(options: SimulateOptions, info: SessionInfo) -> SimulatedMotion:
    if not options.motion:
        return RandomPostures(info.hand, options.seed, duration=options.duration)
    if options.motion.startswith(WORD):
        wearer = Wearer.random(info.hand, info.glove, options.seed)
        return show(options.motion, info.hand, wearer)

    return load_motion(Path(options.motion), info.hand)


def _led(options: SimulateOptions, info: SessionInfo, then: SimulatedMotion) -> SimulatedMotion:
    """``then``, after guided poses where these are asked for."""
    if not options.guided:
        return then
    known = {"well": HoldParams(), "badly": HELD_BADLY}
    if options.guided not in known:
        raise ConfigError(
            notice("option.choice", option="--guided", known=tuple(known), value=options.guided)
        )
    person = options.seed if options.person is None else options.person
    wearer = Wearer.random(info.hand, info.glove, person)
    return GuidedPoses(wearer, then, options.seed, known[options.guided])


def simulate(
    out: Path,
    options: SimulateOptions,
    progress: Callable[[float], None] = lambda share: None,
    force: bool = False,
) -> SessionInfo:
    """Write a simulated session with its truth; ``progress`` hears the share that is done.

    The file is there whole or not at all; ``force`` replaces one.
    """
    check_target(out, force)
    if options.hands == "both":
        return _simulate_both(out, options, progress, force)
    sim, info = build(options)
    images = "jpeg" if options.images else "none"
    params = RecorderParams(images=images, jpeg_quality=options.jpeg_quality)
    led = sim.motion if isinstance(sim.motion, GuidedPoses) else None
    end = min(sim.duration, options.duration + (led.free_from if led else 0.0))
    events = led.events if led else []
    with new_session(out, info, force, params=params) as recorder:
        temperature, truths = SimulatedTemperatures(sim), TruthsAhead(sim)
        for message in with_events(_sensed(sim, info, options.images), events):
            if message.t > end:
                break
            recorder.write(temperature.with_(message))
            if isinstance(message, ImuSample):
                recorder.write_truth(truth_message(message.t, truths.at(message), info))
            if isinstance(message, StereoFrame) or message.t % 1.0 < 0.01:
                progress(message.t / end)
    return info


def _sensed(sim: Simulation, info: SessionInfo, images: bool) -> Iterator[Message]:
    """Yields the sensor messages; only the glove's without a camera."""
    return sim.messages(images) if info.rig is not None else sim.imu_samples()


class TruthsAhead:
    """The true hand at each packet, computed for a second of them together: this takes a tenth of
    the time."""

    AHEAD = 100  # packets

    def __init__(self, sim: Simulation) -> None:
        self._sim = sim
        self._known: dict[float, Truth] = {}

    def at(self, packet: ImuSample) -> Truth:
        """The true hand when ``packet`` was sampled."""
        if packet.t not in self._known:
            t = self._sim.imus.times(packet.seq, self.AHEAD)
            self._known = dict(zip(map(float, t), self._sim.truths(t), strict=True))
        return self._known[packet.t]


class SimulatedTemperatures:
    """Adds the temperatures of the IMUs to a packet once a second, as a glove reports them."""

    def __init__(self, sim: Simulation) -> None:
        self._imus, self._next = sim.imus, 0.0

    def with_(self, message: M) -> M | ImuSample:
        """The message, with temperatures if it is a packet and they are due."""
        if not isinstance(message, ImuSample) or message.t < self._next:
            return message
        self._next = message.t + STATUS_S
        celsius = np.round(self._imus.temperature(np.array([message.t]))[0], 2)
        return replace(message, temperature=celsius)


def build_both(options: SimulateOptions) -> tuple[TwoHandsSimulation, SessionInfo]:
    """`build` for two hands that meet in front of a fixed camera."""
    asked = options.motion or options.guided or options.hand
    if asked or options.camera != "stand" or options.lenses == "none":
        raise ConfigError(notice("simulate.two_hands"))
    _check_numbers(options)
    infos = {side: _info(options, library.texts(glove)) for side, glove in GLOVES.items()}
    dressed = {side: GlovedHand(info.hand, info.glove) for side, info in infos.items()}
    seed, rig = options.seed, _rig(options)
    room = _room(options, rig)
    params = _errors(options).params(SimulationParams(render=room.render))
    sim = TwoHandsSimulation(dressed, seed, options.duration, options.fps, params, rig)
    hues = tuple(dict.fromkeys(h for info in infos.values() for h in info.glove.hues))
    left, right = (replace(infos[side], rig=sim.rig, hues=hues) for side in SIDES)
    return sim, replace(right, others=(left,))


def _simulate_both(
    out: Path, options: SimulateOptions, progress: Callable[[float], None], force: bool
) -> SessionInfo:
    sim, info = build_both(options)
    infos = {hand.side: hand for hand in info.hands}
    images = "jpeg" if options.images else "none"
    params = RecorderParams(images=images, jpeg_quality=options.jpeg_quality)
    temperature = {side: SimulatedTemperatures(hand) for side, hand in sim.hands.items()}
    truths = {side: TruthsAhead(hand) for side, hand in sim.hands.items()}
    with new_session(out, info, force, params=params) as recorder:
        for side, message in sim.messages(options.images):
            if isinstance(message, ImuSample):
                message = temperature[side].with_(message)
            recorder.write(message, side=side)
            if isinstance(message, ImuSample):
                true = truths[side].at(message)
                recorder.write_truth(truth_message(message.t, true, infos[side]), side)
            else:
                progress(message.t / sim.duration)
    return info


def truth_message(t: float, truth: Truth, info: SessionInfo) -> Estimate:
    """The true hand in the form of an estimate: everything measured."""
    k, j = len(truth.keypoints), len(truth.angles)
    q = so3.quat_from_matrix(truth.R_GB)[info.glove.keypoint_segments(info.hand)]
    return Estimate(
        t=t,
        tracking=Tracking.TRACKING,
        keypoints=truth.keypoints.copy(),
        keypoint_q=q,
        keypoint_state=np.full(k, int(Validity.MEASURED), np.int64),
        keypoint_sd=np.zeros(k),
        angles=truth.angles.copy(),
        angle_state=np.full(j, int(Validity.MEASURED), np.int64),
        segment_R=truth.R_GB.copy(),
        segment_p=truth.p_GB.copy(),
    )
