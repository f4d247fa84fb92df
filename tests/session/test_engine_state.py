"""The engine's state as an attachment: it goes on identically, and damage is told in words."""

import json
import struct
import zlib
from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import pytest
import zstandard

from tracker.errors import FileError
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Estimate, ImuSample
from tracker.pipeline import Pipeline
from tracker.session.engine_state import MOST_BYTES, fits, pack, unpack
from tracker.settings import ENGINES, Settings
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

Messages = list[ImuSample | BlobFrame]


@pytest.fixture(scope="module")
def simulated(hand: HandModel, glove: GloveModel) -> tuple[Simulation, Messages]:
    sim = Simulation(hand, glove, RandomPostures(hand, 1, duration=2.0), 1, fps=30)
    return sim, [m for m in sim.feed() if isinstance(m, ImuSample | BlobFrame)]


def feed(pipeline: Pipeline, messages: Iterable[ImuSample | BlobFrame]) -> list[Estimate]:
    out = []
    for m in messages:
        if isinstance(m, ImuSample):
            out.append(pipeline.feed_imu(m))
        else:
            pipeline.feed_frame(m)
    return out


@pytest.mark.parametrize("engine", ENGINES)
def test_every_engine_goes_on_from_its_bytes(
    simulated: tuple[Simulation, Messages], engine: str
) -> None:
    sim, messages = simulated
    settings = replace(Settings(), engine=engine)
    live = Pipeline(sim.hand, sim.glove, sim.rig, settings)
    feed(live, messages[:180])
    data = pack(engine, live.get_state())
    assert len(data) < 400_000
    name, state = unpack(data)
    again = Pipeline(sim.hand, sim.glove, sim.rig, settings)
    assert name == engine and fits(state, again.get_state())
    again.set_state(state)
    a, b = feed(live, messages[180:]), feed(again, messages[180:])
    assert len(a) > 50 and np.isfinite(a[-1].angles).all()
    for x, y in zip(a, b, strict=True):
        assert np.array_equal(x.keypoints, y.keypoints, equal_nan=True)
        assert np.array_equal(x.angles, y.angles)


def test_another_gloves_state_does_not_fit(
    simulated: tuple[Simulation, Messages], distal_glove: GloveModel
) -> None:
    sim, _ = simulated
    one = Pipeline(sim.hand, sim.glove, sim.rig).get_state()
    other = Pipeline(sim.hand, distal_glove, sim.rig).get_state()
    assert fits(one, one) and not fits(other, one)


def test_every_flipped_bit_is_noticed(simulated: tuple[Simulation, Messages]) -> None:
    sim, _ = simulated
    data = pack("chain", Pipeline(sim.hand, sim.glove, sim.rig).get_state())
    rng = np.random.default_rng(2)
    for at in [*range(18), *rng.integers(0, len(data), 60)]:
        spoilt = bytearray(data)
        spoilt[at] ^= 1 << int(rng.integers(8))
        with pytest.raises(FileError, match="state of tracking"):
            unpack(bytes(spoilt))


def forged(said: object, blob: bytes = b"", size: int | None = None) -> bytes:
    """Bytes with a correct checksum around anything."""
    text = json.dumps(said).encode()
    raw = struct.pack("<I", len(text)) + text + blob
    packed = struct.pack("<Q", len(raw) if size is None else size)
    packed += zstandard.ZstdCompressor().compress(raw)
    return b"GTES" + struct.pack("<HI", 1, zlib.crc32(packed)) + packed


@pytest.mark.parametrize(
    "state",
    [
        {"class": "os:system", "has": {}},
        {"class": "tracker.fusion.chain.engine:np", "has": {}},
        {"class": "tracker.fusion.chain.state:ChainState", "has": {"t": 1}},
        {"enum": "tracker.messages:Tracking", "value": 99},
        {"row": "tracker.messages:Blobs", "has": []},
        {"array": 0, "type": "float64", "shape": [10**9, 10**9], "scalar": False},
        {"array": 0, "type": "object", "shape": [1], "scalar": False},
        {"array": -8, "type": "float64", "shape": [1], "scalar": False},
        {"surprise": [1]},
    ],
)
def test_forged_states_are_refused(state: object) -> None:
    with pytest.raises(FileError, match="state of tracking"):
        unpack(forged({"engine": "chain", "state": state}))


def test_a_state_that_swells_is_refused() -> None:
    with pytest.raises(FileError, match="another version"):
        unpack(forged({}, size=MOST_BYTES + 1))
    with pytest.raises(FileError, match="damaged"):
        unpack(forged({}, bytes(2**20), size=100))


def test_only_an_engines_own_things_are_packed() -> None:
    with pytest.raises(TypeError, match="no way to keep"):
        pack("chain", {"x": struct.Struct("<I")})
