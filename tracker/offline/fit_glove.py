"""``glovetrack fit-glove``: the glove file of a recording, fitted to the glove."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tracker.base.command import UsageError
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import check_target, make_folder, name_part, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.bundle.keyframes import Keyframe, Keyframes
from tracker.fusion.chain.bundle.solver import Bundle, BundleWork
from tracker.fusion.chain.engine import ChainSavedState
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import BundleParams, ChainParams
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.glove.files import parse_glove
from tracker.glove.library import user_folder
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, BlobFrame, CameraImuSample, ImuSample, IntArray
from tracker.offline.commands import FitGloveArguments
from tracker.offline.runs import arrival
from tracker.offline.track import recorded_messages
from tracker.session.reader import SessionReader
from tracker.vision.rig import StereoRig

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


# ---- writes marker positions and IMU mountings into the text of a glove file
#
# The remaining text is unchanged.

_TABLE = re.compile(r"^[ \t]*\[", re.MULTILINE)
_KIND = re.compile(r"\s*\[\[\s*(imu|marker)\s*\]\]")
_NAME = re.compile(r"""^[ \t]*name\s*=\s*["'](.*?)["']""", re.MULTILINE)
_ID = re.compile(r"^[ \t]*id\s*=\s*(\d+)", re.MULTILINE)
_POSITION = re.compile(r"^([ \t]*position\s*=\s*)\[[^\]]*\]", re.MULTILINE)
_MOUNTING = re.compile(r"^([ \t]*orientation_xyzw\s*=\s*)\[[^\]]*\]", re.MULTILINE)


class Fitted(NamedTuple):
    """Positions (3,) m of markers by their ids, and R_BI (3, 3) of IMUs by their names."""

    positions: Mapping[int, Array]
    mountings: Mapping[str, Array]


def with_fit(text: str, fitted: Fitted) -> str:
    """The text of a glove file with other marker positions and mountings.

    Raises FileError if the file does not have one of the markers or IMUs as a table of its own.
    """
    positions, mountings, out = dict(fitted.positions), dict(fitted.mountings), []
    for table in _tables(text):
        kind = _KIND.match(table)
        if kind and kind[1] == "marker" and (found := _ID.search(table)):
            if (marker := int(found[1])) in positions:
                table = _put(table, _POSITION, positions.pop(marker), 5)
        elif kind and (found := _NAME.search(table)) and found[1] in mountings:
            quat = so3.quat_from_matrix(mountings.pop(found[1]))
            table = _put(table, _MOUNTING, quat, 6)
        out.append(table)
    if positions or mountings:
        raise FileError(notice("fit_glove.no_table", names=[*map(str, positions), *mountings]))
    return "".join(out)


def _tables(text: str) -> Iterable[str]:
    """The text, divided before the header of each table."""
    starts = [0, *(m.start() for m in _TABLE.finditer(text)), len(text)]
    return (text[a:b] for a, b in pairwise(starts))


def _put(table: str, key: re.Pattern[str], values: Array, digits: int) -> str:
    row = ", ".join(f"{x:.{digits}f}" for x in np.ravel(values))
    return key.sub(lambda found: f"{found[1]}[{row}]", table, count=1)


# ---- fits a glove file to a glove: marker positions and IMU mountings, from many postures
#
# It is the keyframe calibration (docs/chain.md, eqs. 45 to 47) with the priors of a glove that
# was measured roughly. Hand size, joints and axes are those of the wearer and remain outside the
# file.

MARKER, MARKER_NORMAL = 0.003, 0.001  # m, prior sd along the cloth and normal to it
MOUNTING = 0.2  # rad about each axis
MOST_SHIFT = 0.02  # m of a marker along an axis
LEAST_POSTURES = 20
SWEEPS = 8
COLLECT = BundleParams(first_after=np.inf, keyframes=120, apart=0.2, least_blobs=12)
"""Settings that collect postures without a solution while tracking."""


class GloveFit(NamedTuple):
    """Of M markers and n IMUs: marker positions (M, 3) m in B as in a glove file, their offsets
    from the file (M, 3) m with standard deviations (M, 3), in how many postures each marker was
    ``seen`` (M,); mountings R_BI (n, 3, 3), their rotation from the file (n, 3) rad about the axes
    of I, and its standard deviations (n, 3)."""

    position: Array
    offset: Array
    offset_sd: Array
    seen: IntArray
    R_BI: Array
    turn: Array
    turn_sd: Array


def fit_glove(
    layout: ChainLayout, rig: StereoRig, frames: Sequence[Keyframe], state: ChainState
) -> GloveFit:
    """The fit to postures ``frames``, from the calibration of ``state`` on.

    Raises ConfigError if there are too few postures, or if none of them agrees with the glove.
    """
    if len(frames) < LEAST_POSTURES:
        raise ConfigError(
            notice("fit_glove.few_postures", postures=len(frames), least=LEAST_POSTURES)
        )
    params = _rough(ChainParams())
    bundle = Bundle(layout, rig, params, MOST_SHIFT)
    work = BundleWork(next_at=-np.inf, pause=1.0, keyframes=Keyframes(list(frames)))
    solved: WearerProfile | None = None
    for _ in range(1 + SWEEPS * len(frames)):
        solved = bundle.step(work, state)
    if solved is None:
        raise ConfigError(notice("fit_glove.not_fitted", most_mm=1e3 * MOST_SHIFT))
    return _fit(layout, solved, frames)


def _rough(params: ChainParams) -> ChainParams:
    prior = replace(params.prior, marker=MARKER, marker_normal=MARKER_NORMAL, mounting=MOUNTING)
    bundle = replace(params.bundle, sweeps=SWEEPS, least_keyframes=LEAST_POSTURES)
    return replace(params, prior=prior, bundle=bundle)


def _fit(layout: ChainLayout, solved: WearerProfile, frames: Sequence[Keyframe]) -> GloveFit:
    at, n = layout.blocks, layout.n_dynamic
    sd = np.sqrt(np.diag(solved.P))
    scale = solved.scale[layout.marker_segment][:, [0, 1, 1]]
    offset = solved.marker / scale  # a file's positions grow with the segment
    seen = np.sum([np.isfinite(f.uv[..., 0]).any(axis=0) for f in frames], axis=0)
    return GloveFit(
        position=layout.glove.marker_position + offset,
        offset=offset,
        offset_sd=sd[at.marker - n : at.axis - n].reshape(-1, 3) / scale,
        seen=np.asarray(seen, np.int64),
        R_BI=solved.R_IB.swapaxes(1, 2),
        turn=so3.log(layout.R_IB @ solved.R_IB.swapaxes(1, 2)),
        turn_sd=sd[at.phi - n : at.ba - n].reshape(-1, 3),
    )
