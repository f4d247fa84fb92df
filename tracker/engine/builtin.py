"""Descriptors of this program's engines, for pyproject.toml; engines are imported when made."""

from __future__ import annotations

from functools import partial

from tracker.base.registry import deferred
from tracker.engine.kinds import Capabilities, EngineKind
from tracker.engine.settings import Settings
from tracker.fusion.chain.params import with_measured_noise
from tracker.fusion.engine import Engine
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.vision.rig import StereoRig


def _chain(hand: HandModel, glove: GloveModel, rig: StereoRig, settings: Settings) -> Engine:
    from tracker.fusion.chain.engine import ChainEngine  # deferred: the module of an engine

    return ChainEngine(hand, glove, rig, with_measured_noise(settings.chain, glove))


def _vist(hand: HandModel, glove: GloveModel, rig: StereoRig, settings: Settings) -> Engine:
    from tracker.fusion.vist.engine import VistEngine  # deferred: the module of an engine

    return VistEngine(hand, glove, rig, settings.vist)


def _hybrid(
    fingers: str, hand: HandModel, glove: GloveModel, rig: StereoRig, settings: Settings
) -> Engine:
    from tracker.fusion.hybrid import HybridEngine  # deferred: the module of an engine

    chain, hybrid = with_measured_noise(settings.chain, glove), settings.hybrid
    return HybridEngine(hand, glove, rig, chain, hybrid, fingers)


def _inertial(hand: HandModel, glove: GloveModel, rig: StereoRig, settings: Settings) -> Engine:
    from tracker.fusion.chain.inertial import InertialEngine  # deferred: the module of an engine

    return InertialEngine(hand, glove, with_measured_noise(settings.chain, glove))


CHAIN = EngineKind(
    "chain",
    "chain (cameras and IMUs, our own)",
    _chain,
    deferred("tracker.fusion.chain.engine:ChainSavedState").load,
    Settings,
    Capabilities(wearer=True, smoothing=True),
    "Chain",
    order=0,
)
VIST = EngineKind(
    "vist",
    "vist (Lee et al. 2021)",
    _vist,
    deferred("tracker.fusion.vist.engine:VistSavedState").load,
    Settings,
    Capabilities(one_lens=False),
    "VIST",
    order=1,
)
SWITCHING = EngineKind(
    "switching",
    "switching (fingers by their IMUs alone)",
    partial(_hybrid, "switching_offset"),
    deferred("tracker.fusion.hybrid:HybridSavedState").load,
    Settings,
    short="Switching",
    order=2,
)
MADGWICK = EngineKind(
    "madgwick",
    "Madgwick (fingers by their IMUs alone)",
    partial(_hybrid, "madgwick_adaptive"),
    deferred("tracker.fusion.hybrid:HybridSavedState").load,
    Settings,
    short="Madgwick",
    order=3,
)
INERTIAL = EngineKind(
    "inertial",
    "inertial (IMUs only, no position)",
    _inertial,
    deferred("tracker.fusion.chain.engine:ChainSavedState").load,
    Settings,
    Capabilities(images=False, wearer=True),
    "IMUs only",
    order=4,
)
