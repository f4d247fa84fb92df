"""`glovetrack evaluate vist`: the protocol of Lee et al. 2021 on simulated people."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, TextIO

import numpy as np
from numpy.typing import NDArray

from extensions.evaluation.commands import EvaluateVistArguments
from extensions.evaluation.session_names import SESSIONS
from extensions.evaluation.vist.cases import (
    ABLATIONS,
    DISTAL_GLOVE,
    EXPERIMENTS,
    GUIDED,
    MINUTES,
    PAPERS_GLOVE,
    Case,
)
from extensions.evaluation.vist.metrics import Summary, Trial, summarise
from extensions.evaluation.vist.options import ENGINES_OF, VistOptions
from extensions.evaluation.vist.paper import PAPER
from extensions.evaluation.vist.report import write_report
from extensions.evaluation.vist.run import run_cases
from extensions.evaluation.vist.stored import StoredTrials
from extensions.evaluation.vist.trial import models
from tracker.base.errors import ConfigError
from tracker.base.files import check_folder_target
from tracker.base.notices import notice
from tracker.base.terminal import check_json, write_json
from tracker.engine.kinds import ENGINES, capabilities_of
from tracker.fusion.chain.calibration.profile_file import read_wearer
from tracker.fusion.chain.layout import ChainLayout
from tracker.messages import Array, Validity
from tracker.simulation.desk.lights import LIGHTS

QUICK_PARTICIPANTS = 2


QUICK_MINUTES = 0.35


def run(args: EvaluateVistArguments) -> int:
    """Run the cases, print the table, and write the selected outputs."""
    check_json(args)
    if args.out:
        check_folder_target(args.out, args.force)
    chosen = args.options
    cases = cases_of(chosen)
    participants = QUICK_PARTICIPANTS if chosen.quick else chosen.participants
    stored = StoredTrials(chosen.keep) if chosen.keep else None
    done_of = run_cases(cases, participants, chosen.processes, stored=stored)
    # cases that Ctrl+C prevented have no trials
    results = [(case, trials) for case, trials in zip(cases, done_of, strict=True) if trials]
    table = sys.stderr if args.json == "-" else sys.stdout
    _print_table(results, table, chosen.all_keypoints)
    rows = [row_of(case, trials) for case, trials in results]
    if args.json:
        write_json({"rows": rows}, args.json, args.force)
    if args.out and results:
        page = write_report(args.out, results, rows)
        print(f"Report: {page}", file=table)
    done, wanted = sum(len(trials) for _, trials in results), len(cases) * participants
    if done < wanted:
        print(f"Stopped after {done} of {wanted} trials; the figures cover only these.", file=table)
    return 0 if done == wanted else 1


def _print_table(
    results: Sequence[tuple[Any, Any]], table: TextIO, all_keypoints: bool = False
) -> None:
    """The paper's figures first, then a line per case, and all keypoints where asked for."""
    print(HEAD, file=table)
    for experiment in dict.fromkeys(case.experiment for case, _ in results):
        if experiment in PAPER:
            print(paper_line(experiment), file=table)
    for case, trials in results:
        print(line_of(case, summarise(trials)), file=table)
    for case, trials in results if all_keypoints else ():
        print(f"\n{case.experiment}, {case.engine}: every keypoint", file=table)
        print("\n".join(lines_of(trials)), file=table)


def cases_of(args: VistOptions) -> list[Any]:
    """The selected rows, ablations last. Raises ConfigError for unknown names."""
    engines = args.engines or ENGINES_OF[args.lenses]
    _known(engines, ENGINES.names(), "engine")
    _check_lenses(args.lenses, engines)
    _known(args.experiments, EXPERIMENTS, "experiment")
    missing = [str(f) for f in args.motion if not f.is_file()]
    if missing:
        raise ConfigError(notice("file.missing", path=missing[0]))
    if args.wearer is not None:
        _check_wearer(args.wearer, engines)
    experiments = ("free",) if args.quick or args.motion else args.experiments
    out: list[Case] = []
    for experiment in experiments:
        for engine in engines:
            minutes = args.minutes or MINUTES[experiment]
            case = Case(experiment, engine, args.level, None, minutes, args.fps, args.seed)
            if args.quick and not args.minutes:
                case = replace(case, minutes=QUICK_MINUTES)
            files = tuple(map(str, args.motion))
            case = replace(case, wearer=str(args.wearer or ""), lenses=args.lenses)
            case = replace(case, measured=args.measured and engine != "vist")
            out.append(replace(case, motion_files=files, distractors=max(args.distractors, 0)))
    first = out[: len(engines)]
    guided = _guided(first[0]) if args.guided else []
    out += [*_lit(args, out), *guided, *_other_sessions(args, first)]
    smoothed = [replace(case, smoothed=True) for case in out if args.smoothed and _smooths(case)]
    return [*out, *smoothed, *_ablations(args.ablations, first)]


def _check_lenses(lenses: str, engines: Sequence[str]) -> None:
    """Raises ConfigError if an engine does not support this number of lenses."""
    blind = [e for e in engines if not capabilities_of(e).images]
    if lenses == "none" and len(blind) < len(engines):
        raise ConfigError(notice("vist.needs_camera"))
    if lenses != "none" and blind:
        raise ConfigError(notice("vist.no_images"))
    stereo = [e for e in engines if not capabilities_of(e).one_lens]
    if lenses == "one" and stereo:
        raise ConfigError(notice("vist.both_lenses", engine=stereo[0]))


def _check_wearer(path: Path, engines: Sequence[str]) -> None:
    """Raises ConfigError if an engine does not use a profile, FileError if the file is invalid."""
    if tuple(engines) not in (("chain",), ("inertial",)):
        raise ConfigError(notice("vist.profile_engine"))
    read_wearer(path, ChainLayout(*models()))


def _lit(args: VistOptions, cases: Sequence[Any]) -> list[Any]:
    """The cases repeated over a desk in each light, if images are simulated; not for a camera on
    the head."""
    lights = () if "none" in args.lights or args.level != "images" else args.lights
    _known(lights, LIGHTS, "light")
    return [
        replace(case, light=light)
        for light in lights
        for case in cases
        if case.experiment != "head"
    ]


def _other_sessions(args: VistOptions, cases: Sequence[Any]) -> list[Any]:
    """The cases in sessions that are not usual; only of marker positions."""
    names = tuple(SESSIONS) if "all" in args.sessions else args.sessions
    _known(names, SESSIONS, "session")
    if names and (args.level != "points" or args.lenses == "none"):
        raise ConfigError(notice("vist.sessions_of_points"))
    return [replace(case, session=name) for name in names for case in cases]


def _smooths(case: Any) -> bool:
    """Whether the case can be smoothed: before a stationary camera, without a profile."""
    return bool(
        case.engine == "chain"
        and case.experiment != "head"
        and not case.wearer
        and case.guided != "known"
    )


def _guided(case: Any) -> list[Any]:
    """Cases with guided poses, compared with markers on the fingertips."""
    engine = "inertial" if case.lenses == "none" else "chain"
    case = replace(case, experiment="free", engine=engine)
    rows = [replace(case, guided=how) for how in GUIDED]
    if case.lenses == "none":
        return rows
    return [*rows, replace(case, guided="unannounced", glove=DISTAL_GLOVE, wearer="")]


def _ablations(names: Sequence[str], cases: Sequence[Any]) -> list[Any]:
    """Variants of ``cases``, one per engine, each in its experiment."""
    names = tuple(ABLATIONS) if "all" in names else names
    _known(names, ABLATIONS, "ablation")
    return [
        replace(
            case,
            experiment=ABLATIONS[name].experiment,
            ablation=name,
            minutes=max(case.minutes, ABLATIONS[name].least_minutes),
        )
        for name in names
        for case in cases
        if case.engine in ABLATIONS[name].engines
    ]


def _known(names: Sequence[str], known: Sequence[str] | Mapping[str, Any], what: str) -> None:
    for name in names:
        if name not in known:
            raise ConfigError(notice("vist.unknown", what=what, name=name, known=tuple(known)))


# ---- the table of `glovetrack evaluate vist`: rows for JSON and lines of text


def row_of(case: Case, trials: Sequence[Trial]) -> dict[str, Any]:
    """One row for ``--json``; missing figures are null."""
    summary = summarise(trials)
    row: dict[str, Any] = {
        "experiment": case.experiment,
        "engine": case.engine,
        "ablation": case.ablation,
        "level": case.level,
        "motion": "recorded" if case.motion_files else "postures",
        "minutes": case.minutes,
        "fps": case.fps,
        "seed": case.seed,
        "distractors": case.distractors,
        "light": case.light or None,
        "guided": case.guided,
        "glove": case.glove,
        "wearer": case.wearer,
        "lenses": case.lenses,
        "measured": case.measured,
        "session": case.session,
        "smoothed": case.smoothed,
        "all_keypoints": [asdict(a) for a in agreement(trials)],
    }
    row.update(asdict(summary))
    row["paper"] = PAPER.get(case.experiment)
    return {key: _plain(value) for key, value in row.items()}


def _plain(value: Any) -> Any:
    """The value with NaN replaced by None, since JSON has no NaN."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {k: _plain(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(v) for v in value]
    return value


HEAD = (
    "experiment  engine  variant                            mean ± sd       tips joints  pck20"
    "  pck35  seen  wrong%  nees  3sd%   deg  core"
)


def line_of(case: Case, summary: Summary) -> str:
    """One row as text."""
    return (
        f"{case.experiment:<11} {case.engine:<7} {_variant(case):<32} "
        f"{summary.mean_mm:6.2f} ± {summary.sd_mm:5.2f} mm "
        f"{summary.tips_mm:6.2f} {summary.joints_mm:6.2f} {summary.pck20:6.1f} "
        f"{summary.pck35:6.1f} {summary.matched_mean:5.1f} "
        f"{_known_rows(100 * summary.wrong_match_rate, 7)} {_known_rows(summary.nees_per_dof, 5)} "
        f"{_known_rows(100 * summary.within_3sd, 5)} {_known_rows(summary.angles_deg, 5)} "
        f"{summary.core_s_per_s:5.3f}"
    )


def _known_rows(value: float, width: int) -> str:
    """The value with two decimals, or a dash if it is unknown."""
    return f"{value:{width}.2f}" if math.isfinite(value) else f"{'–':>{width}}"


def _variant(case: Case) -> str:
    parts = [case.ablation] if case.ablation else []
    if case.lenses != "both":
        parts.append("one camera" if case.lenses == "one" else "no camera")
    if case.measured:
        parts.append("hand measured")
    if case.session:
        parts.append(SESSIONS[case.session])
    if case.smoothed:
        parts.append("smoothed")
    if case.guided:
        parts.append(GUIDED[case.guided])
    if case.wearer:
        parts.append(f"profile {Path(case.wearer).stem}")
    if case.glove != PAPERS_GLOVE:
        parts.append(case.glove)
    if case.level == "images":
        parts.append(f"images, {case.light} light" if case.light else "images")
    if case.distractors:
        parts.append(f"{case.distractors} balls")
    return ", ".join(parts) or "-"


def paper_line(experiment: str) -> str:
    """The published figures of an experiment, in the columns of `line_of`."""
    p = PAPER[experiment]
    sd = p.get("sd_mm")
    plus_minus = f"± {sd:5.2f} mm" if isinstance(sd, float) else "          "
    seen = p.get("matched_mean")
    return (
        f"{experiment:<11} {'paper':<7} {'(people)':<32} {p['mean_mm']:6.2f} {plus_minus} "
        f"{'':13} {p['pck20']:6.1f} {p['pck35']:6.1f} {seen if seen is not None else '':>5}"
    )


# ---- whether standard deviations agree with errors, for every keypoint of the hand and each
# state
#
# If errors are normal with the stated standard deviation on every axis, 97.1 % of them are within
# three standard deviations (the distribution of Maxwell), and the normalised squared error (NEES
# per coordinate) is 1 on average.


@dataclass(frozen=True)
class KeypointAgreement:
    """For one keypoint in one state, "all" for both: share of the instants of the trials in it,
    mean error and median sd (mm), NEES per coordinate, and share within 3 sd."""

    keypoint: str
    state: str
    share: float
    mean_mm: float
    sd_mm: float
    nees: float
    within_3sd: float


STATES = {
    "all": (Validity.INFERRED, Validity.MEASURED),
    "measured": (Validity.MEASURED,),
    "inferred": (Validity.INFERRED,),
}


def agreement(trials: Sequence[Trial]) -> list[KeypointAgreement]:
    """For each keypoint and state that occurs, "hand" for all keypoints together last. Empty if the
    trials do not contain the whole hand."""
    whole = [t.whole for t in trials if t.whole is not None]
    if not whole:
        return []
    names = whole[0].names
    error = np.concatenate([w.error for w in whole])
    sd = np.concatenate([w.sd for w in whole])
    state = np.concatenate([w.state for w in whole])
    columns = [(name, [k]) for k, name in enumerate(names)] + [("hand", list(range(len(names))))]
    out: list[KeypointAgreement] = []
    for name, k in columns:
        for label, states in STATES.items():
            chosen = np.isin(state[:, k], [int(s) for s in states]) & np.isfinite(error[:, k])
            if chosen.any():
                out.append(_agreement(name, label, chosen, error[:, k], sd[:, k]))
    return out


def _agreement(
    name: str, label: str, chosen: NDArray[np.bool_], error: Array, sd: Array
) -> KeypointAgreement:
    e, s = error[chosen], sd[chosen]
    return KeypointAgreement(
        keypoint=name,
        state=label,
        share=float(chosen.mean()),
        mean_mm=float(1e3 * e.mean()),
        sd_mm=float(1e3 * np.median(s)),
        nees=float(np.mean(e**2 / (3 * np.maximum(s, 1e-9) ** 2))),
        within_3sd=float(np.mean(e <= 3 * s)),
    )


def lines_of(trials: Sequence[Trial]) -> list[str]:
    """The table as text."""
    out = ["keypoint      state      share %  mean mm   sd mm   nees  within 3 sd % (normal: 97.1)"]
    for a in agreement(trials):
        out.append(
            f"{a.keypoint:<13} {a.state:<10} {100 * a.share:7.1f} {a.mean_mm:8.2f} {a.sd_mm:7.2f} "
            f"{a.nees:6.2f} {100 * a.within_3sd:8.1f}"
        )
    return out
