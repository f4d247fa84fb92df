"""``glovetrack fit-glove``: the glove file of a recording, fitted to the glove."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tracker.base.command import UsageError
from tracker.base.errors import FileError
from tracker.base.files import check_target, make_folder, name_part, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.calibration.glove_fit import COLLECT, GloveFit, fit_glove
from tracker.fusion.chain.engine import ChainSavedState
from tracker.fusion.chain.layout import ChainLayout
from tracker.glove.files import parse_glove
from tracker.glove.fitted import Fitted, with_fit
from tracker.glove.library import user_folder
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, CameraImuSample, ImuSample
from tracker.offline.commands import FitGloveArguments
from tracker.offline.runs import arrival
from tracker.offline.track import recorded_messages
from tracker.session.reader import SessionReader

FEW = 3
"""Postures below which a marker's position in the file is kept."""


class FittedGlove(NamedTuple):
    """The fit, the number of postures, and the fitted glove file with the glove that it replaces
    and the hand it is for."""

    fit: GloveFit
    postures: int
    text: str
    glove: GloveModel
    hand: HandModel


def fit_session(
    source: Path, progress: Callable[[float], None] = lambda share: None
) -> FittedGlove:
    """Fits the glove file of the recording ``source`` of one hand.

    Raises FileError without a stereo camera or with two hands, ConfigError if the recording does
    not show the glove well enough.
    """
    with SessionReader(source) as reader:
        info = reader.info
        if info.others:
            raise FileError(notice("fit_glove.two_hands", path=source))
        if info.rig is None or info.rig.one_camera:
            raise FileError(notice("fit_glove.no_camera", path=source))
        rig, state = reader.rig(), _tracked(reader, progress)
    frames = state.tracker.wearer.work.keyframes.stored
    layout = ChainLayout(info.hand, info.glove)
    fit = fit_glove(layout, rig, frames, state.tracker.filter.state)
    text = with_fit(info.glove_text, fitted(info.glove, fit))
    parse_glove(text, info.hand, source.name)
    return FittedGlove(fit, len(frames), text, info.glove, info.hand)


def _tracked(reader: SessionReader, progress: Callable[[float], None]) -> ChainSavedState:
    """The state of the engine after all messages, with the postures that it stored."""
    info, usual = reader.info, Settings()
    settings = replace(usual, engine="chain", chain=replace(usual.chain, bundle=COLLECT))
    pipeline = Pipeline(info.hand, info.glove, reader.rig(), settings)
    start, span = reader.anchor.monotonic(reader.span_ns[0]), max(reader.duration, 1e-9)
    for message in recorded_messages(reader):
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
        elif isinstance(message, CameraImuSample):
            pipeline.feed_camera_imu(message)
        elif isinstance(message, BlobFrame):
            pipeline.feed_frame(message)
        pipeline.take_results()
        progress(min(max((arrival(message) - start) / span, 0.0), 1.0))
    state: ChainSavedState = pipeline.engine.get_state()
    return state


def fitted(glove: GloveModel, fit: GloveFit) -> Fitted:
    """What changes in the file; markers that were hardly seen keep their positions."""
    return Fitted(
        {m.id: fit.position[k] for k, m in enumerate(glove.markers) if fit.seen[k] >= FEW},
        {imu.name: fit.R_BI[j] for j, imu in enumerate(glove.imus)},
    )


def _rows(found: FittedGlove) -> Iterator[tuple[int, float, float, int]]:
    """Of each marker: id, offset and standard deviation in mm, postures in which it was seen."""
    fit = found.fit
    offset = 1e3 * np.linalg.norm(fit.offset, axis=1)
    sd = 1e3 * np.sqrt(np.mean(fit.offset_sd**2, axis=1))
    for k, marker in enumerate(found.glove.markers):
        yield marker.id, float(offset[k]), float(sd[k]), int(fit.seen[k])


def fit_lines(found: FittedGlove) -> list[str]:
    """A table for people."""
    out = [f"{found.postures} postures. Offsets of the markers from the glove file:"]
    out.append(f"{'marker':>6}{'mm':>7}{'± (per axis)':>14}{'seen':>7}")
    for marker, offset, sd, seen in _rows(found):
        kept = "" if seen >= FEW else "  not changed"
        out.append(f"{marker:6}{offset:7.1f}{sd:14.1f}{seen:7}{kept}")
    out.append("Rotations of the IMUs from their mountings in the file:")
    for j, name in enumerate(found.glove.imu_names):
        angle = float(np.rad2deg(np.linalg.norm(found.fit.turn[j])))
        spread = float(np.rad2deg(np.sqrt(np.mean(found.fit.turn_sd[j] ** 2))))
        out.append(f"{name:20}{angle:6.1f}° ± {spread:.1f}° per axis")
    return out


def fit_json(found: FittedGlove) -> Mapping[str, Any]:
    """For ``--json``: offsets in m, rotations in rad, with standard deviations."""
    fit = found.fit
    return {
        "postures": found.postures,
        "markers": [
            {
                "id": marker.id,
                "offset": fit.offset[k].tolist(),
                "sd": fit.offset_sd[k].tolist(),
                "seen": int(fit.seen[k]),
            }
            for k, marker in enumerate(found.glove.markers)
        ],
        "imus": {
            name: {"rotation": fit.turn[j].tolist(), "sd": fit.turn_sd[j].tolist()}
            for j, name in enumerate(found.glove.imu_names)
        },
    }


def _target(args: FitGloveArguments) -> Path | None:
    if args.target is not None and args.name is not None:
        raise UsageError(notice("fit_glove.both_targets"))
    if args.name is None:
        return args.target
    return user_folder("gloves") / f"{name_part(args.name)}.toml"


def run(args: FitGloveArguments) -> int:
    target, inputs = _target(args), [args.session]
    check_json(args, inputs)
    if target is not None:
        if args.name is not None:
            make_folder(target.parent)
        check_target(target, args.force, inputs)
    found = fit_session(args.session, progress_line("tracking the glove"))
    lines = fit_lines(found)
    if target is not None:
        write_whole(target, found.text, args.force, inputs)
        lines.append(f"{target}: the glove file, fitted")
    finish(args, dict(fit_json(found)), lines, inputs)
    return 0
