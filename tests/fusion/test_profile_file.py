"""A wearer profile as a file: identical when read, without the fit of the glove, and rejected for
another hand or glove."""

import dataclasses
import tomllib

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import FileError
from tracker.fusion.chain.calibration.profile_file import WearerFile, read_wearer, write_wearer
from tracker.fusion.chain.distal import DistalSegments
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams, SynergyParams
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation


@pytest.fixture
def engine(hand: HandModel, glove: GloveModel) -> ChainEngine:
    sim = Simulation(hand, glove, RandomPostures(hand, 1, duration=1.0), 1, fps=30.0)
    return ChainEngine(hand, glove, sim.rig, ChainParams())


@pytest.fixture
def wearer(engine: ChainEngine) -> WearerFile:
    """The initial profile of an engine, with every element made distinct."""
    rng = np.random.default_rng(3)
    profile = engine.profile()
    changed = {
        k: getattr(profile, k) + rng.normal(0, 0.01, getattr(profile, k).shape)
        for k in ("bg", "ba", "scale", "joint", "marker")
    }
    own = DistalSegments(engine.layout, SynergyParams()).prior()
    own = own.moved(rng.normal(0, 0.1, own.value.size), own.P / 3)
    profile = dataclasses.replace(profile, P=profile.P / 2, synergies=own, **changed)
    return WearerFile(engine.layout, profile, engine.calibration())


def test_what_belongs_to_the_wearer_reads_back_bit_for_bit(wearer, tmp_path):
    write_wearer(tmp_path / "new" / "anna.toml", wearer)
    read = read_wearer(tmp_path / "new" / "anna.toml", wearer.layout).profile
    for name in ("scale", "joint"):
        np.testing.assert_array_equal(getattr(read, name), getattr(wearer.profile, name), name)
    np.testing.assert_array_equal(read.synergies.value, wearer.profile.synergies.value)
    np.testing.assert_array_equal(read.synergies.P, wearer.profile.synergies.P)
    at, n = wearer.layout.blocks, wearer.layout.n_dynamic
    bones = slice(at.scale - n, at.marker - n)
    np.testing.assert_array_equal(read.P[bones, bones], wearer.profile.P[bones, bones])
    assert not list(tmp_path.rglob("*.tmp"))


def test_parameters_of_one_donning_are_reset_to_the_prior(wearer, engine, tmp_path):
    write_wearer(tmp_path / "anna.toml", wearer)
    read, anybody = read_wearer(tmp_path / "anna.toml", wearer.layout).profile, engine.profile()
    for name in ("bg", "R_IB", "ba", "marker"):
        np.testing.assert_array_equal(getattr(read, name), getattr(anybody, name), name)
    at, n = wearer.layout.blocks, wearer.layout.n_dynamic
    fit = np.r_[: at.scale - n, at.marker - n : at.size - n]
    np.testing.assert_array_equal(read.P[np.ix_(fit, fit)], anybody.P[np.ix_(fit, fit)])


def test_other_programs_can_read_it(wearer, tmp_path):
    write_wearer(tmp_path / "anna.toml", wearer)
    table = tomllib.loads((tmp_path / "anna.toml").read_text())
    assert table["bones"]["dorsum"]["length"] == wearer.profile.scale[0, 0]
    assert set(table["synergies"]) == {
        "thumb_ip_flexion",
        "index_dip_flexion",
        "middle_dip_flexion",
    }


def test_an_engine_continues_with_it(wearer, engine, tmp_path):
    write_wearer(tmp_path / "anna.toml", wearer)
    engine.apply_profile(read_wearer(tmp_path / "anna.toml", engine.layout).profile)
    np.testing.assert_array_equal(engine.profile().scale, wearer.profile.scale)
    np.testing.assert_array_equal(engine.profile().synergies.value, wearer.profile.synergies.value)
    engine.wearer.reset()
    assert engine.profile().synergies is None


def test_the_profile_of_another_glove_is_rejected(wearer, hand, distal_glove, tmp_path):
    write_wearer(tmp_path / "anna.toml", wearer)
    with raises(FileError, "wearer.other_hand"):
        read_wearer(tmp_path / "anna.toml", ChainLayout(hand, distal_glove))


@pytest.mark.parametrize("damage", ["cut", "text", "nan", "missing", "no covariance"])
def test_a_damaged_profile_is_reported(wearer, tmp_path, damage):
    path = tmp_path / "anna.toml"
    write_wearer(path, wearer)
    text = path.read_text()
    changed = {
        "cut": text[: len(text) // 2],
        "text": "nothing of the kind",
        "nan": text.replace("length = ", "length = nan # ", 1),
        "missing": text.replace("[bones.index_proximal]", "[bones.other]"),
        "no covariance": text.replace("[certainty]", "[certainty_of_old]"),
    }
    path.write_text(changed[damage])
    with raises(FileError, "wearer.damaged", "wearer.invalid") as caught:
        read_wearer(path, wearer.layout)
    assert caught.value.notice.values["file"] == "anna.toml"


def test_a_profile_that_cannot_be_written_is_reported(wearer, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(FileError):
        write_wearer(tmp_path / "file" / "anna.toml", wearer)
