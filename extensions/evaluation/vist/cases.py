"""The evaluated cases: experiments, participants, and variants of an engine (ablations)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.engine.settings import Settings
from tracker.messages import BlobFrame, Event, ImuSample, StereoFrame
from tracker.simulation.scenario import Message

PAPERS = ("free", "object", "device")
"""The experiments of Lee et al. 2021."""
EXPERIMENTS = (*PAPERS, "head")
"""All experiments; "head" is free motion before a camera on the wearer's head, evaluated in its
frame."""
MINUTES = {"free": 3.0, "object": 2.0, "device": 2.0, "head": 3.0}
LEVELS = ("points", "images")
SETTLING = 5.0
"""Seconds at the beginning of a trial that are not evaluated, while tracking starts."""

Feed = Iterator[Message | Event]
PAPERS_GLOVE, DISTAL_GLOVE = "vist-small", "vist-small-distal"
GUIDED = {
    "unannounced": "poses held, but not announced to the tracker",
    "guided": "guided poses",
    "badly": "guided poses held badly",
    "known": "known from another session",
}
"""Guided poses before free motion, and whether the tracker uses them. With ``known``, the poses
were held in another session, in which the glove was put on separately, and none are held in this
one."""


@dataclass(frozen=True)
class Case:
    """One row of the table: an experiment with an engine, or a variant of one."""

    experiment: str
    engine: str
    level: str = "points"
    ablation: str | None = None
    minutes: float = 3.0
    fps: float = 60.0
    seed: int = 0
    motion_files: tuple[str, ...] = ()
    distractors: int = 0  # stationary balls with the markers' hues in the room
    light: str = ""  # of images: over a desk with things on it; a plain wall if empty
    guided: str = ""  # one of `GUIDED`: poses are held first, and free motion after them judged
    glove: str = PAPERS_GLOVE
    wearer: str = ""  # path of a profile that every participant begins with
    lenses: str = "both"  # or one, or none: a glove without a camera
    measured: bool = False  # the length of each participant's hand is known, by a ruler
    session: str = ""  # one of `SESSIONS`, in place of a usual one
    smoothed: bool = False  # estimates of the whole recording, in place of live ones

    @property
    def has_camera(self) -> bool:
        return self.lenses != "none"

    @property
    def is_led(self) -> bool:
        """Whether poses are held before the evaluated part."""
        return self.guided not in ("", "known")


@dataclass(frozen=True)
class Ablation:
    """A variant with other settings, messages, motion or evaluated instants.

    ``outage`` (s): images are withheld repeatedly for this long, and errors are evaluated in the
    last second of each outage, in the dorsum's frame, since the hand's position is then unknown.
    ``camera``: data of a camera on the head, see `tracker.simulation.head.HeadParams`.
    """

    name: str
    text: str
    engines: tuple[str, ...]
    settings: Callable[[Settings], Settings] = lambda s: s
    feed: Callable[[Feed], Feed] = lambda feed: feed
    fps: float | None = None
    speed: float = 1.0
    outage: float = 0.0
    experiment: str = "free"
    camera: str = "pose"

    @property
    def least_minutes(self) -> float:
        """Shortest trial, in minutes, with at least one outage."""
        return (PAUSE + self.outage + 1.0) / 60 if self.outage else 0.0


BLIND_FROM = 4.0  # s: the start requires gravity, so the IMUs stop after the hand is found
PAUSE = 10.0  # s of images between two outages


def in_outage(t: float, outage: float) -> bool:
    """Whether images are withheld at ``t``; outages are `PAUSE` seconds apart."""
    return outage > 0 and t % (PAUSE + outage) >= PAUSE


def judged_in_outage(t: float, outage: float) -> bool:
    """Whether ``t`` is in the last second of an outage."""
    return t % (PAUSE + outage) >= PAUSE + outage - 1.0


def without_images(outage: float) -> Callable[[Feed], Feed]:
    """Drop exposures during outages."""

    def keep(feed: Feed) -> Feed:
        for m in feed:
            if not isinstance(m, BlobFrame | StereoFrame) or not in_outage(m.t, outage):
                yield m

    return keep


def without_imus(feed: Feed) -> Feed:
    """Stop all IMUs after the hand has been found."""
    for m in feed:
        if isinstance(m, ImuSample) and m.t > BLIND_FROM:
            yield replace(m, valid=m.valid & False)
        else:
            yield m


NOTHING = 1e-6  # a standard deviation that keeps a state constant


def _no_autocalibration(s: Settings) -> Settings:
    still = dict.fromkeys(
        ("mounting", "common_length", "common_girth", "own_length", "own_girth"), NOTHING
    )
    chain = replace(
        s.chain,
        prior=replace(s.chain.prior, joint=NOTHING, marker=NOTHING, marker_normal=NOTHING, **still),
        noise=replace(s.chain.noise, scale=0.0, mounting=0.0, slip=0.0),
    )
    vist = replace(
        s.vist,
        prior=replace(s.vist.prior, **still),
        noise=replace(s.vist.noise, scale=0.0, mounting=0.0),
    )
    return replace(s, chain=chain, vist=vist)


def _previous_pose(s: Settings) -> Settings:
    chain = replace(s.chain, guide="previous")
    vist = replace(s.vist, match=replace(s.vist.match, guide="previous"))
    return replace(s, chain=chain, vist=vist)


def _loose(s: Settings) -> Settings:
    return replace(
        s, chain=replace(s.chain, coupling="loose"), vist=replace(s.vist, coupling="loose")
    )


def _no_finger_accelerometers(s: Settings) -> Settings:
    return replace(s, chain=replace(s.chain, constraint=replace(s.chain.constraint, tilt=1e6)))


def _outage(seconds: float) -> Ablation:
    return Ablation(
        f"imu-only-{seconds:.0f}s",
        f"articulation in the dorsum's frame after {seconds:.0f} s without images",
        ("chain", "vist"),
        feed=without_images(seconds),
        outage=seconds,
    )


ABLATIONS: dict[str, Ablation] = {
    a.name: a
    for a in (
        Ablation(
            "no-autocalibration",
            "hand and fitting taken as the files say",
            ("chain", "vist"),
            settings=_no_autocalibration,
        ),
        Ablation(
            "no-finger-accelerometers",
            "relative tilt not used",
            ("chain",),
            settings=_no_finger_accelerometers,
        ),
        Ablation(
            "loose",
            "segment poses from vision alone, where three markers of a segment are seen",
            ("chain", "vist"),
            settings=_loose,
        ),
        Ablation(
            "vision-only", "IMUs silent after the start", ("chain", "vist"), feed=without_imus
        ),
        Ablation(
            "previous-pose",
            "correspondence from the previous image's pose instead of the IMU prediction",
            ("chain", "vist"),
            settings=_previous_pose,
        ),
        Ablation(
            "10fps-double-speed",
            "ten images a second, motion twice as fast",
            ("chain", "vist"),
            fps=10.0,
            speed=2.0,
        ),
        Ablation(
            "previous-pose-10fps-double-speed",
            "both: where the paper's movie S1 shows vision alone to fail",
            ("chain", "vist"),
            settings=_previous_pose,
            fps=10.0,
            speed=2.0,
        ),
        Ablation(
            "camera-imu",
            "no camera pose is given; the camera's IMU measures its tilt",
            ("chain", "vist"),
            experiment="head",
            camera="imu",
        ),
        Ablation(
            "camera-unknown",
            "no camera pose is given: the camera is assumed to be stationary",
            ("chain", "vist"),
            experiment="head",
            camera="nothing",
        ),
        _outage(5.0),
        _outage(10.0),
        _outage(30.0),
        _outage(60.0),
    )
}


def ablation_of(case: Case) -> Ablation | None:
    """The variant of a case. Raises ConfigError for an unknown name."""
    if case.ablation is None:
        return None
    found = ABLATIONS.get(case.ablation)
    if found is None:
        raise ConfigError(
            notice("vist.unknown", what="ablation", name=case.ablation, known=tuple(ABLATIONS))
        )
    return found
