"""Kernels for images are compiled twice, and capable processors use the wide ones: with identical
results, or detections would depend on the computer."""

from __future__ import annotations

import copy
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tracker.fusion.chain import finger_grid
from tracker.glove.library import texts
from tracker.kernels import library, parts
from tracker.simulation import flicker, render
from tracker.simulation.demo import DemoSpec, build
from tracker.vision import cloth_depth, finger_cloth, search
from tracker.vision.cloth import ClothMap
from tracker.vision.colours import ColourProfile, HueRange
from tracker.vision.detector import Detector
from tracker.vision.rig import ideal_rig

dispatch = pytest.importorskip(
    "tracker.kernels._dispatch", reason="the library was not built: no C++ compiler here"
)

DRAWN = (
    (render, "draw"),
    (render, "shade"),
    (render, "develop"),
    (flicker, "brightened"),
    (search, "find_regions"),
)
FAST = ("tracker.simulation.raster.draw", "tracker.simulation.shading.shade")
"""Those with fast-math: images of the simulator."""
CLOSE = 1e-5
SELDOM = 1e-3  # share of the numbers
PROFILE = ColourProfile("two", (HueRange("red", (169, 11)), HueRange("blue", (99, 121))))


def entries(part: str) -> dict[str, Callable[..., Any]]:
    """Compiled functions of a part by their kernels' names."""
    module, table = library._part(part)
    lines = [line.split(" ") for line in table.splitlines()[1:]]
    return {name: getattr(module, symbol) for symbol, _, name, *_ in lines}


def test_wide_parts_are_used_only_on_capable_processors(monkeypatch) -> None:
    built = ["app_widgets", "app_widgets_wide", "tracker_vision", "tracker_vision_wide"]
    monkeypatch.setattr(parts, "built", lambda: built)
    plain = SimpleNamespace(runs_wide=lambda: False)
    assert library._for_this_processor(plain) == ["app_widgets", "tracker_vision"]
    able = library._for_this_processor(SimpleNamespace(runs_wide=lambda: True))
    assert sorted(able) == built
    assert [parts.is_wide(part) for part in able] == [False, False, True, True]


def test_a_wide_kernel_has_the_same_source() -> None:
    """Both are compiled from the same source."""
    for part in filter(parts.is_wide, parts.built()):
        names = part, part.removesuffix(parts.WIDE)
        tables = [parts.table_of(name).read_text("utf-8").splitlines()[1:] for name in names]
        wide, plain = ({row.split(" ", 1)[1] for row in table} for table in tables)
        assert wide
        assert wide <= plain


@pytest.fixture(scope="module")
def calls() -> dict[str, tuple[Any, ...]]:
    """Arguments of wide kernels recorded while an image is drawn and searched, before
    modification."""
    found: dict[str, tuple[Any, ...]] = {}

    def noting(kernel: Any) -> Callable[..., Any]:
        def noted(*args: Any) -> Any:
            found[f"{kernel.__module__}.{kernel.__qualname__}"] = copy.deepcopy(args)
            return kernel(*args)

        return noted

    scene = build(DemoSpec(*texts(), duration=4.0, exposures=2))
    with pytest.MonkeyPatch.context() as patched:
        for module, name in DRAWN:
            patched.setattr(module, name, noting(getattr(module, name)))
        left, _ = scene.renderer.pair(1.0)
        Detector(PROFILE).detect(left)
    return found | of_cloth()


def of_cloth() -> dict[str, tuple[Any, ...]]:
    """Arguments of those that look for a finger in the cloth: any cloth, fingers and window."""
    rng = np.random.default_rng(5)
    bits, bright = rng.integers(0, 2**62, (2, 60, 80))
    cloth = ClothMap(bits, rng.integers(0, 2, (60, 80)).astype(np.uint8), bright)
    rig = ideal_rig()
    window = np.array([0.0, rig.cx - 60.0, rig.cy - 100.0, 2.0])
    seen = cloth, window, rig.left.optics, True
    ends = rng.normal((0.0, 0.0, 0.3), 0.04, (9, 2, 3))
    capsules = ends, rng.uniform(0.003, 0.009, 9), rig.intrinsics, window
    (classes, texture), known = finger_cloth.cloth_window(*seen), finger_cloth.covered(*capsules)
    explained = classes, known, 0.5 * known, 5.0, 2.5
    evidence = finger_cloth.finger_evidence(*explained)
    finger = finger_cloth.Finger(
        np.array([0.0, 0.0, 0.3]), np.eye(3), np.eye(3), np.full(3, 0.03), np.full(3, 0.008), 0.67
    )
    image = rng.integers(0, 256, (960, 1280, 3)).astype(np.uint8)
    tiles = image, np.arange(4800), bits.reshape(-1), (60, 80)
    found, disparity = cloth_depth.matches(texture, texture), np.array([60.0, 200.0])
    level = finger_cloth.surface_levels(*capsules, disparity)
    depths = found, classes, known[::2, ::2].copy(), level
    depth = cloth_depth.depth_evidence(*depths)
    images = finger_cloth.FingerImages(
        finger, rig.intrinsics, window[None], evidence[None], depth, disparity
    )
    postures = rng.normal(0, (0.003, 0.003, 0.5, 0.2, 0.5), (60, 5))
    before = finger_grid.prior(postures[0], finger_grid.INDEPENDENT)
    return {
        "tracker.vision.finger_cloth.cloth_window": seen,
        "tracker.vision.cloth.brightness_tiles": tiles,
        "tracker.vision.finger_cloth.surface_levels": (*capsules, disparity),
        "tracker.vision.cloth_depth.matches": (texture, texture),
        "tracker.vision.cloth_depth.depth_evidence": depths,
        "tracker.vision.finger_cloth.covered": capsules,
        "tracker.vision.finger_cloth.covered_part": (*capsules, (40, 31)),
        "tracker.vision.finger_cloth.finger_evidence": explained,
        "tracker.vision.finger_cloth.finger_likelihoods": (postures, images),
        "tracker.fusion.chain.finger_grid.prior": (postures[0], finger_grid.INDEPENDENT),
        "tracker.fusion.chain.finger_grid.aged": (before, before[::-1].copy(), 0.1),
        "tracker.fusion.chain.finger_grid.fitted": (before, postures[0], images, 1.0),
    }


@pytest.mark.parametrize("part", ["tracker_fusion_chain", "tracker_simulation", "tracker_vision"])
def test_wide_kernels_give_the_same_results(calls: dict[str, tuple[Any, ...]], part: str) -> None:
    if part + parts.WIDE not in parts.built() or not dispatch.runs_wide():
        pytest.skip("this processor runs no wide parts")
    plain, wide = entries(part), entries(part + parts.WIDE)
    assert wide.keys() & calls.keys() == wide.keys()
    for name in wide:
        of_plain, of_wide = copy.deepcopy(calls[name]), copy.deepcopy(calls[name])
        results = plain[name](*of_plain), wide[name](*of_wide)
        for one, other in (results, *zip(of_plain, of_wide, strict=True)):
            assert_same(one, other, name not in FAST)


def assert_same(one: Any, other: Any, is_exact: bool) -> None:
    """``is_exact``: without fast-math, bit-identical. With it sums may be rounded differently:
    single precision has 6e-8, about ten terms are summed, and of two solids at the same depth the
    other may be visible."""
    if isinstance(one, tuple):
        for a, b in zip(one, other, strict=True):
            assert_same(a, b, is_exact)
    elif is_exact and isinstance(one, np.ndarray):
        assert one.tobytes() == other.tobytes()
    elif isinstance(one, np.ndarray):
        away = np.abs(one.astype(float) - other) > CLOSE * np.maximum(np.abs(one), 1.0)
        assert np.mean(away) < SELDOM if away.size else True
    else:
        assert one == other
