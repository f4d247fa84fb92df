"""States of all engines during tracking, and recorded ones (``data``).

The recorded states are never regenerated, since neither are old recordings. When a record gets a
new field, a sample is added: put its name into `SAMPLES` and run

    PYTHONPATH=. python tests/session/engine_state_samples.py

which writes the missing samples, and adds new names to ``engine_state_names.txt``.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from tracker import GRAVITY
from tracker.base.records import RECORDS
from tracker.engine.hands import TwoHandsSavedState
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.params import BundleParams
from tracker.glove import library
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, CameraImuSample, ImuSample
from tracker.session.engine_state import pack
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

DATA = Path(__file__).parent / "data"
NAMES = DATA / "engine_state_names.txt"
LATER = 0.02  # s after the last packet, time of the requested hand
EARLY = BundleParams(first_after=1.0, least_keyframes=4, least_blobs=6, apart=0.05, keyframes=4)

SAMPLES: dict[str, Callable[[Settings], Settings]] = {
    "chain": lambda s: replace(s, engine="chain", chain=replace(s.chain, bundle=EARLY)),
    "chain_aligned": lambda s: replace(s, engine="chain"),
    "chain_axes": lambda s: replace(s, engine="chain", chain=replace(s.chain, bundle=EARLY)),
    "chain_people": lambda s: replace(s, engine="chain"),
    "chain_previous": lambda s: replace(
        s, engine="chain", chain=replace(s.chain, guide="previous")
    ),
    "vist_previous": lambda s: replace(
        s, engine="vist", vist=replace(s.vist, match=replace(s.vist.match, guide="previous"))
    ),
    "switching": lambda s: replace(s, engine="switching"),
    "madgwick": lambda s: replace(s, engine="madgwick"),
}


NOT_OF_A_PIPELINE = (TwoHandsSavedState,)
"""Records stored in addition to those of pipelines; loading them registers them."""


def small_glove() -> tuple[HandModel, GloveModel]:
    """The part of the default glove on the back of the hand and on one finger."""
    hand, glove = library.load()
    on = ("dorsum", "index_proximal", "index_intermediate")
    markers = [m for m in glove.markers if m.segment in on]
    imus = tuple(i for i in glove.imus if i.segment in on)
    renumbered = tuple(replace(m, id=k) for k, m in enumerate(markers))
    return hand, replace(glove, imus=imus, markers=renumbered)


def simulation() -> Simulation:
    hand, glove = small_glove()
    return Simulation(hand, glove, RandomPostures(hand, 1, duration=2.0), 1, fps=30)


def untouched(sim: Simulation, sample: str) -> Pipeline:
    """A new pipeline with the sample's engine and settings."""
    return Pipeline(sim.hand, sim.glove, sim.rig, SAMPLES[sample](Settings()))


def tracked(sim: Simulation, sample: str) -> tuple[Pipeline, float]:
    """The same during tracking, with an image waiting, and the time of the last packet."""
    pipeline, t = untouched(sim, sample), 0.0
    force_C = sim.rig.pose.R_GC.T @ [0.0, 0.0, GRAVITY]
    for message in sim.feed():
        if t > 1.5 and isinstance(message, BlobFrame):
            pipeline.feed_frame(replace(message, t=t + 0.1))
            break
        if isinstance(message, BlobFrame):
            pipeline.feed_frame(message)
            pipeline.feed_camera_imu(CameraImuSample(t, message.t_arrival, np.zeros(3), force_C))
        elif isinstance(message, ImuSample):
            t = message.t
            pipeline.feed_imu(message)
    if sample == "chain_previous":
        assert isinstance(pipeline.engine, ChainEngine)
        pipeline.engine.apply_profile(pipeline.engine.profile())
        pipeline.engine.wearer.freeze(True)
    return pipeline, t


def registered() -> dict[str, set[str]]:
    """Each record's name, and the names of its fields."""
    return {name: set(record.names.values()) for name, record in RECORDS.items()}


def listed() -> dict[str, set[str]]:
    """The same for everything that was ever written."""
    lines = NAMES.read_text().splitlines() if NAMES.exists() else []
    pairs = (line.partition(":") for line in lines)
    return {name: set(fields.split()) for name, _, fields in pairs}


def main() -> None:
    ever = listed()
    for name, fields in registered().items():
        ever[name] = ever.get(name, set()) | fields
    DATA.mkdir(exist_ok=True)
    lines = [f"{name}: {' '.join(sorted(ever[name]))}".rstrip() for name in sorted(ever)]
    NAMES.write_text("\n".join(lines) + "\n")
    sim = simulation()
    for sample in SAMPLES:
        path = DATA / f"engine_state_{sample}.bin"
        if path.exists():
            continue
        pipeline, t = tracked(sim, sample)
        path.write_bytes(pack(pipeline.settings.engine, pipeline.get_state()))
        shown = pipeline.predict(t + LATER)
        data = {"t": shown.t, "keypoints_mm": (1000 * shown.keypoints).round(4).tolist()}
        path.with_suffix(".json").write_text(json.dumps(data) + "\n")


if __name__ == "__main__":
    main()
