"""The engine's state as an attachment: tracking resumes identically, and damage is reported."""

import json
import struct
import tracemalloc
import zlib
from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import pytest
import zstandard

from tests.notices import raises
from tests.session.engine_state_samples import (
    DATA,
    SAMPLES,
    listed,
    registered,
    simulation,
    untouched,
)
from tracker.base.errors import FileError
from tracker.base.records import RECORDS
from tracker.engine.kinds import ENGINES
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, CameraPose, Estimate, ImuSample
from tracker.session.engine_state import MOST_BYTES, MOST_TEXT, VERSION, pack, unpack
from tracker.session.mcap_session import register_states
from tracker.session.state_check import mismatch
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


@pytest.fixture(autouse=True)
def _registered() -> None:
    """As a reader of sessions does before it reads a state."""
    register_states()


@pytest.mark.parametrize("engine", ENGINES.names())
def test_every_engine_resumes_from_its_bytes(
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
    assert name == engine and mismatch(state, again.get_state()) is None
    again.set_state(state)
    a, b = feed(live, messages[180:]), feed(again, messages[180:])
    assert len(a) > 50 and np.isfinite(a[-1].angles).all()
    for x, y in zip(a, b, strict=True):
        assert np.array_equal(x.keypoints, y.keypoints, equal_nan=True)
        assert np.array_equal(x.angles, y.angles)


def test_a_state_of_another_glove_does_not_fit(
    simulated: tuple[Simulation, Messages], distal_glove: GloveModel
) -> None:
    sim, _ = simulated
    one = Pipeline(sim.hand, sim.glove, sim.rig).get_state()
    other = Pipeline(sim.hand, distal_glove, sim.rig).get_state()
    assert mismatch(one, one) is None
    found = mismatch(other, one)
    assert found is not None and "has the shape" in found


def test_a_state_fits_while_the_calibration_is_being_solved() -> None:
    _, state = unpack((DATA / "engine_state_chain.bin").read_bytes())
    assert state.engine.tracker.wearer.work.calibration is not None
    assert mismatch(state, untouched(simulation(), "chain").get_state()) is None


def test_every_flipped_bit_is_detected(simulated: tuple[Simulation, Messages]) -> None:
    sim, _ = simulated
    data = pack("chain", Pipeline(sim.hand, sim.glove, sim.rig).get_state())
    rng = np.random.default_rng(2)
    for at in [*range(18), *rng.integers(0, len(data), 60)]:
        spoilt = bytearray(data)
        spoilt[at] ^= 1 << int(rng.integers(8))
        with raises(FileError, "session.state_damaged", "session.state_version"):
            unpack(bytes(spoilt))


def forged(header: object, blob: bytes = b"", size: int | None = None) -> bytes:
    """Bytes of arbitrary content with a correct checksum."""
    text = json.dumps(header).encode()
    raw = struct.pack("<I", len(text)) + text + blob
    packed = struct.pack("<Q", len(raw) if size is None else size)
    packed += zstandard.ZstdCompressor().compress(raw)
    return b"GTES" + struct.pack("<HI", VERSION, zlib.crc32(packed)) + packed


@pytest.mark.parametrize(
    "state",
    [
        {"record": "os", "has": {}},
        {"record": "tracker.fusion.chain.state:ChainState", "has": {}},
        {"record": "chain.state", "has": {"t": 1}},
        {"record": "camera_pose", "has": {"R_GC": 1, "p_GC": 2, "__class__": 3}},
        {"record": "tracking", "has": {}},
        {"enum": "tracking", "value": 99},
        {"enum": "chain.state", "value": 1},
        {"array": 1},
        {"array": -1},
        {"number": 1, "type": "object"},
        {"number": "1e5000", "type": "int64"},
        {"surprise": [1]},
    ],
)
def test_forged_states_are_rejected(state: object) -> None:
    header = {"engine": "chain", "arrays": [["float64", [1]]], "state": state}
    with raises(FileError, "session.state_invalid"):
        unpack(forged(header, bytes(8)))


@pytest.mark.parametrize(
    "array",
    [["float64", [10**9, 10**9]], ["object", [1]], ["float64", [-1]], ["float64", [2.0]], [1]],
)
def test_forged_arrays_are_rejected(array: object) -> None:
    with raises(FileError, "session.state_invalid"):
        unpack(forged({"engine": "chain", "arrays": [array], "state": None}, bytes(8)))


def peak_of_unpacking(data: bytes) -> int:
    """Maximum bytes allocated while reading, whether it succeeds or not."""
    tracemalloc.start()
    try:
        unpack(data)
    except FileError:
        pass
    finally:
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    return peak


def test_an_array_referenced_often_is_stored_once() -> None:
    many = {"engine": "chain", "arrays": [["float64", [2**22]]], "state": [{"array": 0}] * 400}
    data = forged(many, bytes(2**25))
    _, state = unpack(data)
    assert len(state) == 400 and all(a is state[0] for a in state)
    assert peak_of_unpacking(data) < 4 * 2**25  # packed, unpacked, a slice of it and the array


def test_a_long_text_is_not_read() -> None:
    nested = {"engine": "chain", "arrays": [], "state": [[]] * (MOST_TEXT // 4)}
    data = forged(nested)
    with raises(FileError, "session.state_invalid"):
        unpack(data)
    assert peak_of_unpacking(data) < 6 * MOST_TEXT


def test_shared_arrays_are_shared_again() -> None:
    R = np.eye(3)
    one, other = CameraPose(R, np.zeros(3)), CameraPose(R, np.zeros(3))
    _, (a, b) = unpack(pack("chain", [one, other]))
    assert a.R_GC is b.R_GC and a.p_GC is not b.p_GC


def test_a_filter_without_images_resumes_from_its_bytes(
    simulated: tuple[Simulation, Messages],
) -> None:
    """The output then shares arrays with the delayed filter."""
    sim, messages = simulated
    messages = [m for m in messages if isinstance(m, ImuSample) or m.t < 1.0]
    live, again = (Pipeline(sim.hand, sim.glove, sim.rig) for _ in range(2))
    middle = next(i for i, m in enumerate(messages) if m.t > 1.3)
    feed(live, messages[:middle])
    again.set_state(unpack(pack("chain", live.get_state()))[1])
    a, b = feed(live, messages[middle:]), feed(again, messages[middle:])
    assert len(a) > 50 and np.isfinite(a[0].keypoints).all()
    for x, y in zip(a, b, strict=True):
        assert np.array_equal(x.keypoints, y.keypoints)


# ---- old recordings


@pytest.mark.parametrize("sample", SAMPLES)
def test_an_old_state_can_still_be_read(sample: str) -> None:
    """If this fails, a record or a field has lost its name: see `tracker.base.records`."""
    path = DATA / f"engine_state_{sample}.bin"
    header = json.loads(path.with_suffix(".json").read_text())
    engine, state = unpack(path.read_bytes())
    pipeline = untouched(simulation(), sample)
    assert engine == pipeline.settings.engine and mismatch(state, pipeline.get_state()) is None
    pipeline.set_state(state)
    shown = pipeline.predict(header["t"])
    away = 1000 * shown.keypoints - np.array(header["keypoints_mm"])
    assert np.abs(away).max() < 0.01, "mm, for other machines' last digits and rounding"


@pytest.mark.parametrize("sample", ["chain", "chain_aligned"])
def test_tracking_continues_from_an_old_state(sample: str) -> None:
    """From before the values of fixed axes were estimated, while a calibration is solved or
    frozen."""
    _, state = unpack((DATA / f"engine_state_{sample}.bin").read_bytes())
    t, axes = state.engine.tracker.filter.state.t, state.engine.tracker.filter.state.axis
    pipeline = untouched(simulation(), sample)
    pipeline.set_state(state)
    later = [m for m in simulation().feed() if m.t > t]
    shown = feed(pipeline, later)
    now = pipeline.get_state().engine.tracker.filter.state
    assert not len(axes) and len(now.axis) and len(now.P) == pipeline.engine.layout.blocks.size
    assert len(shown) > 20 and np.isfinite(shown[-1].keypoints).all()


def test_no_written_name_is_lost() -> None:
    """Names are only added. A new one is listed by running `engine_state_samples`."""
    for name, fields in listed().items():
        assert name in RECORDS, f"recordings name a record {name!r}"
        known = RECORDS[name]
        lost = fields - set(known.names.values()) - set(known.gone)
        assert not lost, f"recordings have {lost} in the record {name!r}"
    ever = listed()
    for name, fields in registered().items():
        assert fields <= ever.get(name, set()), f"the record {name!r} is not on the list"


def test_a_decompression_bomb_is_rejected() -> None:
    with raises(FileError, "session.state_version"):
        unpack(forged({}, size=MOST_BYTES + 1))
    with raises(FileError, "session.state_invalid"):
        unpack(forged({}, bytes(2**20), size=100))


def test_only_an_engines_own_objects_are_packed() -> None:
    with pytest.raises(TypeError, match="dict"):
        pack("chain", {"x": struct.Struct("<I")})
