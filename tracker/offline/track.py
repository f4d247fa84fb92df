"""``glovetrack track``: a recorded session through the pipeline again."""

from __future__ import annotations

import heapq
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from tracker import CONTINUED, __version__
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import check_target, sha256
from tracker.base.notices import Notice, notice, warning
from tracker.base.toml_reader import parse_toml, read_text
from tracker.base.urgency import usable_cores
from tracker.engine.hands import Sided
from tracker.engine.kinds import (
    ENGINES,
    WITHOUT_CAMERA,
    capabilities_of,
    settings_text,
)
from tracker.engine.settings import Settings, recorded_settings_from, settings_from
from tracker.fusion.chain.guided.events import guided_of
from tracker.glove import library
from tracker.messages import (
    EYES,
    BlobFrame,
    CameraImuSample,
    EngineState,
    Estimate,
    Event,
    ImuSample,
    StereoFrame,
    WristPose,
)
from tracker.offline import by_side
from tracker.offline.detection import detected
from tracker.offline.maker import Maker
from tracker.offline.options import USUAL, TrackOptions
from tracker.offline.own_colours import OwnColours
from tracker.offline.repeats import Repeats
from tracker.offline.runs import Fed, LiveRun, NoOutput, Output, SessionRun, TrueHands, arrival
from tracker.offline.track_report import TrackReport, TruthCheck
from tracker.online.camera_tilt import CameraTilt
from tracker.session.arithmetic import arithmetic
from tracker.session.description import COLOURS, SETTINGS, SessionInfo
from tracker.session.reader import SessionReader
from tracker.session.ros import topics
from tracker.session.writer import new_session
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector, DetectorParams
from tracker.vision.rig import StereoRig

MOST_NAMED = 8
"""Settings in a notice."""


def track(
    source: Path,
    out: Path,
    options: TrackOptions | None = None,
    progress: Callable[[float], None] = lambda share: None,
    threads: int | None = None,
    force: bool = False,
) -> TrackReport:
    """Tracks ``source`` again into the new file ``out``, which is complete or absent.

    ``threads`` search images (default: one per core); the result does not depend on them.
    ``force`` replaces an existing file, but never ``source``. Raises FileError for a session that
    lacks data for tracking.
    """
    options = options or TrackOptions()
    check_target(out, force, [source])
    started = time.perf_counter()
    with SessionReader(source) as plain:
        both = by_side.is_of_both(plain.sides, options)
    profiles = by_side.profile_paths(options.keep_wearer, both)
    for path in set(profiles.values()):
        check_target(path, force, [source, out])
    instead = by_side.replacements(options, both)
    texts = {name: replacement.text for name, replacement in instead.items()}
    origins = {name: replacement.origin for name, replacement in instead.items()}
    with SessionReader(source, texts, origins=origins) as reader:
        report = _track_session(
            reader, out, options, profiles, progress, threads or usable_cores(), force
        )
    report.wall_s = time.perf_counter() - started
    return report


def _track_session(
    reader: SessionReader,
    out: Path,
    options: TrackOptions,
    profiles: Mapping[str, Path],
    progress: Callable[[float], None],
    threads: int,
    force: bool,
) -> TrackReport:
    """Tracks an open session; ``profiles``: by side, the paths for the wearers' profiles."""
    settings = _settings(reader, options)
    info = replace(reader.info, rig=_rig(reader, settings))
    colours = _own_colours(reader, info, options)
    repeats = Repeats()
    messages = repeats.without(_messages(reader, info, options, threads, colours))
    described = _output_info(info, settings, reader, options)
    unused = (*_unused_edits(reader), *_unused_of_version(reader, options))
    start, span = reader.anchor.monotonic(reader.span_ns[0]), max(reader.duration, 1e-9)
    with new_session(out, described, force, [reader.path]) as recorder:
        checks = {hand.side: _truth_check(reader, hand) for hand in info.hands}
        true_hands = TrueHands(reader, recorder)
        outputs = {
            side: Output(recorder, options.with_sensors, check, side, true_hands)
            for side, check in checks.items()
        }
        run = _run(reader, info, settings, outputs, options, colours)
        for what in unused:
            outputs[info.side].write_event(Event.of(start, "tracking", what))
        forward = 0.5 if options.smooth else 1.0  # smoothing goes back over everything
        for message in messages:
            run.feed(message)
            progress(forward * min(max((arrival(message) - start) / span, 0.0), 1.0))
        run.finish(lambda share: progress(forward + (1 - forward) * share))
        true_hands.until(start + span + 1.0)
        _report_repeats(repeats, outputs, start + span)
        by_side.save_profiles(run.engines, profiles)
    _compare_with_truth(reader, checks, outputs)
    report = TrackReport.of_hands({side: output.report for side, output in outputs.items()})
    report.unused = unused
    report.left_out = reader.source.left_out.by_topic()
    return report


def _compare_with_truth(
    reader: SessionReader,
    checks: Mapping[str, TruthCheck | None],
    outputs: Mapping[str, Output],
) -> None:
    """Enters the errors of a simulated session into the reports of its hands."""
    for side, check in checks.items():
        if check is not None:
            report = outputs[side].report
            report.error_mm, report.error_deg = check.against(_truth(reader, side))


def _report_repeats(repeats: Repeats, outputs: Mapping[str, Output], t: float) -> None:
    """Report, at ``t`` s, how many packets of each glove were left out."""
    for side, n in sorted(repeats.counts.items()):
        outputs[side].report.losses["imu_repeated"] = n
        repeated = warning("track.packets_repeated", count=n, side=side)
        outputs[side].write_event(Event.of(t, "tracking", repeated))


def state_at(
    reader: SessionReader, t: float, progress: Callable[[float], None] = lambda share: None
) -> EngineState | None:
    """Returns the state of tracking this session again up to the messages before ``t`` s.

    None if there are none. Raises GlovetrackError for a session that cannot be tracked.
    """
    options = TrackOptions()
    settings = _settings(reader, options)
    info = replace(reader.info, rig=_rig(reader, settings))
    outputs: dict[str, Output] = {hand.side: NoOutput() for hand in info.hands}
    colours = _own_colours(reader, info, options)
    run = _run(reader, info, settings, outputs, options, colours)
    assert isinstance(run, LiveRun)
    begin, fed = reader.anchor.monotonic(reader.span_ns[0]), False
    messages = _messages(reader, info, options, usable_cores(), colours)
    for message in Repeats().without(messages):
        if arrival(message) >= t:
            break
        run.feed(message)
        fed = True
        progress(min(max((arrival(message) - begin) / max(t - begin, 1e-9), 0.0), 1.0))
    return run.state(t) if fed else None


def _run(
    reader: SessionReader,
    info: SessionInfo,
    settings: Settings,
    outputs: Mapping[str, Output],
    options: TrackOptions,
    colours: OwnColours | None,
) -> SessionRun:
    changes: list[tuple[float, EngineState | StereoRig]] = []
    if info.rig is not None:
        changes += reader.rig_changes()
    maker = Maker(info, settings, options)
    if options.smooth:
        if settings.lenses != "both" or (info.rig is not None and info.rig.one_camera):
            raise ConfigError(notice("track.smooth_lenses"))
        if changes:
            raise FileError(notice("track.smooth_calibration", path=reader.path))
        return maker.smooth_run(outputs, CameraTilt(reader.rig().pose), colours)
    if _goes_on(reader, options):
        changes += [(state.t, state) for state in reader.engine_states()]
    changes.sort(key=lambda change: change[0])
    return maker.live_run(outputs, changes, colours)


def _goes_on(reader: SessionReader, options: TrackOptions) -> bool:
    """Returns whether tracking continues from the recorded states: nothing is replaced."""
    others = (options.hand, options.glove, options.colours, options.wearer, options.hand_length)
    if any(others) or options.settings or not options.guided:
        return False
    if reader.info.version not in (__version__, *CONTINUED) or _unusable_settings(reader):
        return False
    return _settings(reader, options) == _settings(reader, TrackOptions())


def _truth(reader: SessionReader, side: str) -> Iterator[Estimate]:
    """The true motion of a simulated hand, of the session's only hand or of both."""
    if side == reader.info.side:
        yield from reader.truth()
        return
    with SessionReader(reader.path, side=side) as other:
        yield from other.truth()


def _rig(reader: SessionReader, settings: Settings) -> StereoRig | None:
    """Returns the session's camera; None if there is none and the engine needs none."""
    return reader.rig() if capabilities_of(settings.engine).images else reader.info.rig


def _truth_check(reader: SessionReader, info: SessionInfo) -> TruthCheck | None:
    """None where the session does not know the truth."""
    known = topics.truth(info.side, "keypoints") in reader.topic_names
    return TruthCheck(info.keypoint_names) if known else None


def _settings(reader: SessionReader, options: TrackOptions) -> Settings:
    """The recorded settings or those asked for, with another engine where one is asked for."""
    if options.settings and options.settings != USUAL:
        settings = _settings_of_file(Path(options.settings))
    else:
        settings = _recorded_settings(reader, options.settings == USUAL)
    blind = reader.info.rig is None and not any(_camera_topics(reader))
    engine = options.engine or (WITHOUT_CAMERA if blind else "")
    changes: dict[str, Any] = {"engine": engine, "lenses": options.lenses}
    return replace(settings, **{name: value for name, value in changes.items() if value})


def _settings_of_file(path: Path) -> Settings:
    """Raises FileError, and ConfigError naming the first unknown key or wrong value."""

    def on_problem(key: str, why: Notice) -> None:
        raise ConfigError(notice("config.key", file=path, key=key, why=why))

    return settings_from(parse_toml(read_text(path), str(path)), on_problem)


def _camera_topics(reader: SessionReader) -> Iterator[str]:
    """Yields the topics of cameras; none in a session of a glove alone."""
    return (name for name in reader.topic_names if name.startswith("/camera/"))


def _recorded_settings(reader: SessionReader, engine_alone: bool) -> Settings:
    """Those of this version; where another version wrote them, without what this one cannot use."""
    text, engine = reader.info.settings_text, reader.info.engine
    if engine_alone or not text:
        return replace(Settings(), engine=engine) if engine in ENGINES.names() else Settings()
    return _usable_settings(text)[0]


def _usable_settings(text: str) -> tuple[Settings, list[str]]:
    """Returns the settings of a TOML text, and the keys in it that this version cannot use.

    Raises ConfigError for a text that is not TOML.
    """
    unusable: list[str] = []
    try:
        data = parse_toml(text, SETTINGS)
    except FileError as error:
        raise ConfigError(notice("track.settings_not_usable", why=error)) from error
    found = recorded_settings_from(data, lambda path, why: unusable.append(path))
    if found.engine not in ENGINES.names():
        unusable.append("engine")
        found = replace(found, engine=Settings().engine)
    return found, unusable


def _unusable_settings(reader: SessionReader) -> list[str]:
    """Keys of the recorded settings that this version cannot use."""
    text = reader.info.settings_text
    return _usable_settings(text)[1] if text else []


def _unused_edits(reader: SessionReader) -> list[Notice]:
    """Reports interpolated gaps, which are not copied: estimates are of the sensors alone."""
    count = sum(len(edit.filled) for edit in reader.edits)
    return [notice("track.gaps_dropped", count=count, file=reader.path.name)] if count else []


def _unused_of_version(reader: SessionReader, options: TrackOptions) -> list[Notice]:
    """What of an older session is not used."""
    if options.settings:
        return []
    name, by, unused = reader.path.name, reader.info.version[:20], []
    left_out = _unusable_settings(reader)
    if left_out:
        named, more = [key[:60] for key in left_out[:MOST_NAMED]], len(left_out) - MOST_NAMED
        if more > 0:
            many = {"settings": named, "more": more}
            unused.append(warning("track.settings_unused_more", file=name, **many))
        else:
            unused.append(warning("track.settings_unused", file=name, settings=named))
    if reader.has_start_state and (left_out or by not in (__version__, *CONTINUED)):
        unused.append(warning("track.state_unused", file=name, version=by or "unknown"))
    elif reader.has_start_state and by != __version__:
        unused.append(notice("track.state_of_version", file=name, version=by))
    return unused


def _output_info(
    info: SessionInfo, settings: Settings, reader: SessionReader, options: TrackOptions
) -> SessionInfo:
    """The description of the new session. Where the camera's IMU is not copied, its poses are."""
    extra = {k: v for k, v in info.extra.items() if k != "smoothed"}
    extra |= {"source": reader.path.name, "source_sha256": sha256(reader.path)}
    if options.smooth:
        extra["smoothed"] = "true"
    by_imu = topics.CAMERA_IMU in reader.topic_names and not options.with_sensors
    return replace(
        info,
        moving_camera=info.moving_camera or by_imu,
        engine=settings.engine,
        settings_text=settings_text(settings),
        arithmetic=arithmetic(),
        extra=extra,
    )


def recorded_messages(reader: SessionReader) -> Iterator[Fed]:
    """Yields packets, events and blobs of the reader's hand in the order of the live run; images
    without blobs are searched with the recorded colours."""
    return _of_reader(reader, reader.info, TrackOptions(), usable_cores(), None)


def _messages(
    reader: SessionReader,
    info: SessionInfo,
    options: TrackOptions,
    threads: int,
    colours: OwnColours | None,
) -> Iterator[Fed | Sided]:
    """Packets of all hands, events and blobs in the order of the live run."""
    messages = _of_reader(reader, info, options, threads, colours)
    if not options.guided:
        messages = (m for m in messages if not isinstance(m, Event) or guided_of(m) is None)
    return with_sides(reader, messages)


def with_sides(reader: SessionReader, messages: Iterator[Fed]) -> Iterator[Fed | Sided]:
    """``messages`` of the hand that ``reader`` reads with the packets of the session's other hands,
    each packet with its side; in the order of the live run."""
    side = reader.info.side
    with ExitStack() as stack:
        streams = [_sided(messages, side)]
        for hand in reader.info.hands:
            if hand.side != side:
                other = stack.enter_context(SessionReader(reader.path, side=hand.side))
                streams.append(_sided(_packets(other), hand.side))
        yield from heapq.merge(*streams, key=_order)


def _packets(reader: SessionReader) -> Iterator[Fed]:
    """Yields what belongs to one hand alone."""
    kinds = (ImuSample, WristPose)
    return (m for m in reader.messages(kinds) if isinstance(m, kinds))


def _sided(messages: Iterable[Fed], side: str) -> Iterator[Fed | Sided]:
    return (Sided(m, side) if isinstance(m, ImuSample) else m for m in messages)


def _order(message: Fed | Sided) -> tuple[float, bool]:
    return arrival(message), not isinstance(message, Sided)


def _of_reader(
    reader: SessionReader,
    info: SessionInfo,
    options: TrackOptions,
    threads: int,
    colours: OwnColours | None,
) -> Iterator[Fed]:
    """`_messages` of the hand that ``reader`` reads.

    Recorded blobs are used unless the colours are replaced; otherwise, and without blobs, the
    images are searched.
    """
    if info.rig is None:
        return reader.packed_messages((ImuSample, WristPose, Event, BlobFrame))  # type: ignore[return-value]
    keep = options.with_sensors
    if not _is_searched(reader, options):
        fed = (ImuSample, CameraImuSample, WristPose, Event, BlobFrame)
        kinds = (*fed, *((StereoFrame,) if keep else ()))
        return reader.packed_messages(kinds)  # type: ignore[return-value]
    if not any(topics.image(c) in reader.topic_names for c in EYES):
        code = notice("track.no_images" if options.colours else "track.no_blobs", path=reader.path)
        raise FileError(code)
    packed = reader.packed_messages((ImuSample, CameraImuSample, WristPose, Event, StereoFrame))
    if colours is not None:
        return colours.searched(packed, threads, keep)
    detector = make_detector(profile_of(info), info)
    return detected(packed, lambda: detector, threads, keep)


def _is_searched(reader: SessionReader, options: TrackOptions) -> bool:
    """Whether the images are searched: there are no blobs, or other colours are asked for.

    Of a live recording that is tracked as it was live, images without blobs are those that the
    computer had no time to search.
    """
    if options.colours:
        return True
    if any(topics.blobs(c) in reader.topic_names for c in EYES):
        return False
    return options.smooth or not (reader.has_start_state and _goes_on(reader, options))


def _own_colours(
    reader: SessionReader, info: SessionInfo, options: TrackOptions
) -> OwnColours | None:
    """Colours that follow the session's light; None where its images are not searched."""
    if info.rig is None or not _is_searched(reader, options):
        return None
    return OwnColours(info, profile_of(info))


def profile_of(info: SessionInfo) -> ColourProfile:
    """Returns the session's colour profile, or the default one."""
    text = info.colours_text or library.text("colours", library.DEFAULT_COLOURS)
    return parse_profile(text, COLOURS)


def make_detector(profile: ColourProfile, info: SessionInfo) -> Detector:
    """A detector for the session's glove and camera."""
    assert info.rig is not None
    size = float(np.median(info.glove.marker_size)) if info.glove.markers else 0.012
    return Detector(profile, marker_size=size, fx=info.rig.fx, params=DetectorParams())
