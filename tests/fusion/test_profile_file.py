"""A wearer's profile on disk: the same when read, refused in words when it is another's."""

import dataclasses

import numpy as np
import pytest

from tracker.errors import FileError
from tracker.fusion.chain.calibration.profile_file import WearerFile, read_wearer, write_wearer
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation


@pytest.fixture
def wearer(hand: HandModel, glove: GloveModel) -> WearerFile:
    """What an engine knows before it has seen anything, with every array made distinct."""
    sim = Simulation(hand, glove, RandomPostures(hand, 1, duration=1.0), 1, fps=30.0)
    engine = ChainEngine(hand, glove, sim.rig, ChainParams())
    rng = np.random.default_rng(3)
    profile = engine.profile()
    changed = {k: v + rng.normal(0, 0.1, v.shape) for k, v in vars(profile).items()}
    profile = dataclasses.replace(profile, **changed)
    return WearerFile(hand.name, glove.name, profile, engine.calibration())


def test_a_profile_reads_back_bit_for_bit(wearer, hand, glove, tmp_path):
    write_wearer(tmp_path / "new" / "anna.npz", wearer)
    read = read_wearer(tmp_path / "new" / "anna.npz", ChainLayout(hand, glove))
    for name, value in vars(wearer.profile).items():
        np.testing.assert_array_equal(getattr(read.profile, name), value, name)
    for field in dataclasses.fields(wearer.calibration):
        ours, theirs = (getattr(w.calibration, field.name) for w in (wearer, read))
        np.testing.assert_array_equal(ours, theirs, field.name)
    assert not list(tmp_path.rglob("*.tmp"))


def test_foreign_tools_read_it(wearer, tmp_path):
    write_wearer(tmp_path / "anna.npz", wearer)
    with np.load(tmp_path / "anna.npz", allow_pickle=False) as archive:
        np.testing.assert_array_equal(archive["profile_scale"], wearer.profile.scale)


def test_the_profile_of_another_glove_is_refused(wearer, hand, glove, tmp_path):
    write_wearer(tmp_path / "anna.npz", dataclasses.replace(wearer, glove="big"))
    with pytest.raises(FileError, match="with glove big"):
        read_wearer(tmp_path / "anna.npz", ChainLayout(hand, glove))


@pytest.mark.parametrize("damage", ["cut", "text", "nan", "missing"])
def test_a_damaged_profile_is_said(wearer, hand, glove, tmp_path, damage):
    path = tmp_path / "anna.npz"
    if damage == "nan":
        wearer.profile.scale[0, 0] = np.nan
    write_wearer(path, wearer)
    if damage == "cut":
        path.write_bytes(path.read_bytes()[:500])
    if damage == "text":
        path.write_text("no profile")
    if damage == "missing":
        path.unlink()
    with pytest.raises(FileError, match=r"anna\.npz is no profile"):
        read_wearer(path, ChainLayout(hand, glove))


def test_a_full_disk_is_told_in_words(wearer, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(FileError, match="cannot be written"):
        write_wearer(tmp_path / "file" / "anna.npz", wearer)
