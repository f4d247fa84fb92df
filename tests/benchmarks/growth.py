"""``python -m tests.benchmarks.growth``: how cost grows with the glove, camera and session.

Each curve changes one size and keeps the rest: the default glove (3 fingers, 7 IMUs, 37 markers),
60 exposures a second. Costs are the processor's, medians of rounds in which all sizes take turns.
The exponent is the slope of the straight line through the points on logarithmic axes.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from tests.benchmarks.growth_gloves import with_fingers, with_imus, with_markers
from tests.benchmarks.growth_time import tracked_for
from tests.benchmarks.rows import Call, interleaved
from tests.benchmarks.schedule import feed
from tracker.engine.pipeline import Pipeline
from tracker.glove import library
from tracker.glove.model import GloveModel
from tracker.messages import Array, BlobFrame, ImuSample, Message
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, SessionRecorder
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

SEED, WARM, SPAN = 1, 2.0, 2.0  # s tracked before, and s that are timed
PIECE = 20.0  # s of data that long sessions repeat


@dataclass(frozen=True)
class Curve:
    """Costs ``values`` (``unit``) at ``sizes`` of what ``name`` says."""

    name: str
    sizes: tuple[float, ...]
    unit: str
    values: tuple[float, ...]

    @property
    def exponent(self) -> float:
        """p of cost ~ size^p, by least squares of the logarithms."""
        return float(np.polyfit(np.log(self.sizes), np.log(self.values), 1)[0])


def tracking_call(glove: GloveModel, fps: float = 60.0) -> Call:
    """A call that tracks ``SPAN`` s of a simulated hand from the same state each time."""
    hand, _ = library.load()
    motion = RandomPostures(hand, SEED, duration=WARM + SPAN + 0.1)
    sim = Simulation(hand, glove, motion, SEED, fps=fps)
    messages = [m for m in sim.feed() if isinstance(m, ImuSample | BlobFrame)]
    pipeline = Pipeline(hand, glove, sim.rig)
    feed(pipeline, [m for m in messages if m.t_arrival < WARM])
    state = pipeline.get_state()
    rest = [m for m in messages if WARM <= m.t_arrival < WARM + SPAN]

    def call() -> None:
        pipeline.set_state(state)
        feed(pipeline, rest)

    return call


def tracking_curves(rounds: int) -> list[Curve]:
    """Core seconds a second of data against fingers, IMUs, markers and exposures a second."""
    hand, glove = library.load()
    gloves: dict[str, dict[float, GloveModel]] = {
        "fingers": {n: with_fingers(hand, glove, n) for n in (3, 4, 5)},
        "IMUs": {n: with_imus(hand, glove, n) for n in (7, 10, 13, 16)},
        "markers": {n: with_markers(glove, n) for n in (37, 50, 75, 100)},
    }
    cases = {
        name: {n: tracking_call(model) for n, model in models.items()}
        for name, models in gloves.items()
    }
    cases["exposures a second"] = {n: tracking_call(glove, fps=n) for n in (30, 60, 120)}
    out = []
    for name, sizes in cases.items():
        seconds = interleaved(list(sizes.values()), rounds) / SPAN
        out.append(_curve(name, list(sizes), "ms per s", 1e3 * seconds))
    return out


def _curve(name: str, sizes: Sequence[float], unit: str, values: Array) -> Curve:
    return Curve(name, tuple(sizes), unit, tuple(float(v) for v in values))


# ---- sessions


def session_curves(minutes: Sequence[float], rounds: int) -> list[Curve]:
    """Reading sessions of so many minutes whole, and opening one and seeking its middle."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / f"{k}.mcap" for k in range(len(minutes))]
        for path, length in zip(paths, minutes, strict=True):
            write_session(path, 60.0 * length)
        whole = interleaved([partial(_read, p) for p in paths], rounds)
        seek = interleaved([partial(_seek, p) for p in paths], rounds)
    return [
        _curve("minutes of a session, read whole", minutes, "s", whole),
        _curve("minutes of a session, opened at its middle", minutes, "ms", 1e3 * seek),
    ]


def write_session(path: Path, duration: float) -> None:
    """Packets and blobs for ``duration`` s: one simulated piece over and over, stamps moved on."""
    piece = path.with_suffix(".piece.mcap")
    simulate(piece, SimulateOptions(duration=min(PIECE, duration), fps=60.0, images=False))
    with SessionReader(piece) as reader:
        messages = list(reader.messages((ImuSample, BlobFrame)))
        info = replace(reader.info, rig=reader.rig())
    recorder = SessionRecorder(path, info, RecorderParams(sync=False))
    for k in range(max(1, round(duration / PIECE))):
        for message in messages:
            recorder.write(_later(message, k * PIECE))
    recorder.close()
    piece.unlink()


def _later(message: Message, dt: float) -> Message:
    assert isinstance(message, ImuSample | BlobFrame)
    return replace(message, t=message.t + dt, t_arrival=message.t_arrival + dt)


def _read(path: Path) -> int:
    with SessionReader(path) as reader:
        return sum(1 for _ in reader.messages((ImuSample, BlobFrame)))


def _seek(path: Path) -> Message:
    """The first packet after the session's middle."""
    with SessionReader(path) as reader:
        middle = reader.anchor.monotonic(sum(reader.span_ns) // 2)
        return next(iter(reader.messages((ImuSample,), start=middle)))


def time_curves(minutes: Sequence[float]) -> list[Curve]:
    """Whether the time or memory of tracking grows with its duration."""
    costs, memory = tracked_for(minutes)
    return [
        _curve("minutes tracked: a second's cost", minutes, "ms per s", np.array(costs)),
        _curve("minutes tracked: memory", minutes, "MB", np.array(memory)),
    ]


# ---- output


def markdown(curves: Sequence[Curve]) -> str:
    """A row a curve: sizes, costs, exponent."""
    lines = ["| size | from … to | cost | exponent |", "|---|---|---|--:|"]
    for c in curves:
        sizes = ", ".join(f"{s:g}" for s in c.sizes)
        values = ", ".join(f"{v:.3g}" for v in c.values)
        lines.append(f"| {c.name} | {sizes} | {values} {c.unit} | {c.exponent:.2f} |")
    return "\n".join(lines)


def plot(curves: Sequence[Curve], path: Path) -> None:
    """Cost over that of the smallest size, against size over the smallest."""
    figure = Figure(figsize=(7.0, 4.5), layout="constrained")
    FigureCanvasAgg(figure)
    ax = figure.add_subplot()
    for c, mark in zip(curves, "osv^Dx*P", strict=False):
        x, y = np.array(c.sizes), np.array(c.values)
        ax.loglog(x / x[0], y / y[0], f"{mark}-", label=f"{c.name}: {c.exponent:.2f}")
    end = max(c.sizes[-1] / c.sizes[0] for c in curves)
    ax.loglog([1, end], [1, end], "k:", lw=1, label="in proportion: 1")
    ax.set_xlabel("size / smallest size")
    ax.set_ylabel("cost / cost at the smallest size")
    ax.legend(fontsize=8)
    ax.grid(which="both", alpha=0.25)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=120)


def main(arguments: Sequence[str] | None = None) -> int:
    """The command; returns the exit code."""
    p = argparse.ArgumentParser(prog="python -m tests.benchmarks.growth")
    p.add_argument("--rounds", type=int, default=9)
    p.add_argument("--minutes", type=float, nargs="+", default=[1, 4, 16], help="of sessions")
    p.add_argument("--out", type=Path, default=Path("bench"), help="folder of JSON and plot")
    args = p.parse_args(arguments)
    curves = time_curves(args.minutes) + tracking_curves(args.rounds)
    curves += session_curves(args.minutes, min(args.rounds, 3))
    print(markdown(curves))
    plot(curves, args.out / "growth.png")
    rows = [{**asdict(c), "exponent": c.exponent} for c in curves]
    (args.out / "growth.json").write_text(json.dumps(rows, indent=1) + "\n", "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
