"""Engines by name: their capabilities, settings and states."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from tests.base.test_registry import install
from tests.notices import raises
from tracker.base.config import from_toml, to_toml
from tracker.base.errors import ConfigError
from tracker.base.records import RECORDS, record_of
from tracker.engine.kinds import (
    WITHOUT_CAMERA,
    build_engine,
    capabilities_of,
    engine_kinds,
    params_of,
    settings_text,
)
from tracker.engine.settings import Settings
from tracker.fusion.wearer_learning import learner_of
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import ideal_rig

EXAMPLE = Path(__file__).parents[2] / "docs" / "examples" / "glovetrack-tilt-engine"
OURS = ["chain", "vist", "switching", "madgwick", "inertial"]


@pytest.fixture
def tilt(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """The example of the documentation, as installed by pip."""
    install(tmp_path, "tilt", {"tilt": "glovetrack_tilt_engine:TILT"}, "engines")
    for folder in (tmp_path, EXAMPLE):
        monkeypatch.syspath_prepend(str(folder))
    yield "tilt"
    sys.modules.pop("glovetrack_tilt_engine", None)
    RECORDS.pop("tilt", None)


def test_menus_list_our_engines_in_this_order() -> None:
    assert [name for name in engine_kinds() if name in OURS] == OURS
    assert not capabilities_of(WITHOUT_CAMERA).images


@pytest.mark.parametrize("name", OURS)
def test_an_engine_has_the_capabilities_of_its_descriptor(name: str, hand, glove) -> None:
    kind = engine_kinds()[name]
    engine = build_engine(hand, glove, ideal_rig(), Settings(engine=name))
    assert (learner_of(engine) is not None) == kind.capabilities.wearer
    assert isinstance(engine.get_state(), kind.state()) and record_of(kind.state()) is not None


@pytest.mark.parametrize("name", OURS)
def test_a_missing_camera_or_lens_is_an_error(name: str, hand, glove) -> None:
    can, settings = capabilities_of(name), Settings(engine=name)
    one = with_one_camera(ideal_rig())
    for have, allowed in ((None, not can.images), (one, can.one_lens)):
        if allowed:
            build_engine(hand, glove, have, settings)
        else:
            with pytest.raises(ConfigError):
                build_engine(hand, glove, have, settings)


def test_recorded_settings_contain_no_table_of_engines_without_other_packages() -> None:
    assert "engines" not in settings_text(Settings())
    assert from_toml(Settings, settings_text(Settings())) == Settings()


def test_settings_of_another_packages_engine_are_recorded_completely(
    tilt: str, hand, glove
) -> None:
    kind = engine_kinds()[tilt]
    assert list(engine_kinds())[-1] == tilt
    usual = params_of(kind, Settings())
    changed = Settings(engine=tilt, engines={tilt: {"gain": 2.0}})
    assert params_of(kind, changed) == replace(usual, gain=2.0)
    again = from_toml(Settings, settings_text(replace(changed, engine="chain")))
    assert again.engines == {tilt: {"gain": 2.0}}
    assert from_toml(Settings, settings_text(Settings())).engines == {tilt: {"gain": 0.5}}
    with raises(ConfigError, "config.invalid_setting"):
        build_engine(hand, glove, None, replace(changed, engines={tilt: {"gian": 2.0}}))


def test_a_recording_opens_without_the_package_of_its_engine() -> None:
    missing = Settings(engine="tilt", engines={"tilt": {"gain": 2.0}})
    assert from_toml(Settings, to_toml(missing)) == missing
