"""A blinking light is found, with the delay that it has."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Protocol

import numpy as np
import pytest
from PySide6.QtCore import Qt

from extensions.loopback import measure as measuring
from extensions.loopback.command_runs import figures, lines
from extensions.loopback.light import DelayedLight, find_light
from extensions.loopback.measure import ON, TAP, CommandedPulses, LoopBack, Taps, measure
from extensions.loopback.window.flash import FlashWindow, flash_while
from tracker.base.errors import DeviceError
from tracker.cli import main
from tracker.messages import ImuSample
from tracker.sensors.glove_link import GloveLink

EXPOSURE = 0.006  # s
GAIN = 60.0


def pulses_until(end: float, seed: int = 1) -> np.ndarray:
    rng = np.random.default_rng(seed)
    begins = np.cumsum(0.12 + rng.uniform(0.2, 0.5, int(end)))
    return np.column_stack([begins, begins + 0.12])


def share_on(t: float, pulses: np.ndarray) -> float:
    """Of the exposure around ``t``, counted in 60 instants."""
    instants = t + EXPOSURE * (np.arange(60) - 29.5) / 60
    lit = (instants[:, None] >= pulses[:, 0]) & (instants[:, None] < pulses[:, 1])
    return float(lit.any(axis=1).mean())


def seen(delay: float, fps: float, seconds: float, seed: int = 2) -> tuple[np.ndarray, np.ndarray]:
    """Times and cells of images: the light in cell 3, a lamp that flickers and a hand that moves in
    the others; the light's cell has these, too."""
    rng = np.random.default_rng(seed)
    times = np.arange(0.0, seconds, 1 / fps) + rng.normal(0, 2e-4, round(seconds * fps))
    pulses = pulses_until(seconds)
    lit = np.array([share_on(t - delay, pulses) for t in times])
    lamp = 10 * np.sin(2 * np.pi * 100 * times)[:, None]
    hand = 40 * np.sin(2 * np.pi * rng.uniform(0.1, 0.6, 8) * times[:, None])
    cells = 90 + lamp + hand + rng.normal(0, 3, (len(times), 8))
    cells[:, 3] += GAIN * lit
    return times, cells


@pytest.mark.parametrize(("delay", "fps"), [(0.0043, 60.0), (0.055, 30.0), (-0.020, 60.0)])
def test_the_delay_is_found_within_its_uncertainty(delay: float, fps: float) -> None:
    times, cells = seen(delay, fps, 30.0)
    light = find_light(times, cells, pulses_until(30.0))
    assert light.cell == 3
    assert light.sd < 0.002  # a tenth of the interval of 60 images a second
    assert light.delay == pytest.approx(delay, abs=max(3 * light.sd, 0.0005))


def test_the_uncertainty_is_true() -> None:
    """Of eight recordings, most are within two standard deviations, and none beyond five."""
    off = []
    for seed in range(8):
        light = find_light(*seen(0.01, 60.0, 12.0, seed), pulses_until(12.0))
        off.append(abs(light.delay - 0.01) / max(light.sd, 2e-4))
    assert np.mean(np.array(off) < 2) > 0.7 and max(off) < 5


def test_without_the_light_nothing_is_claimed() -> None:
    times, cells = seen(0.01, 60.0, 20.0)
    with pytest.raises(DeviceError) as refused:
        find_light(times, np.delete(cells, 3, axis=1), pulses_until(20.0))
    assert refused.value.notice.code == "loopback.no_light"
    with pytest.raises(DeviceError) as short:
        find_light(times[:200], cells[:200], pulses_until(20.0))
    assert short.value.notice.code == "loopback.too_short"


class LitGlove:
    """Its light is on 8 ms after a command, for as long as that says."""

    LATE = 0.008

    def __init__(self, accepts: bool = True) -> None:
        self.accepts, self.runs, self.lock = accepts, [(0.0, 0.0)], threading.Lock()

    def poll(self, timeout: float) -> tuple[()]:
        time.sleep(timeout)
        return ()

    def vibrate(self, channel: int, amplitude: int, duration_ms: int) -> bool:
        assert channel == 2 and amplitude == 255
        begin = time.monotonic() + self.LATE
        with self.lock:
            self.runs.append((begin, begin + duration_ms / 1000))
        return self.accepts


class Lights(Protocol):
    """``runs``: begin and end of each light so far, s."""

    runs: list[tuple[float, float]]
    lock: threading.Lock


class Camera:
    """100 images a second of a light; images of a past exposure show what was then."""

    def __init__(self, glove: Lights) -> None:
        self.glove = glove

    def read(self, timeout: float) -> SimpleNamespace:
        time.sleep(0.01)
        t = time.monotonic() - 0.02
        with self.glove.lock:
            lit = share_on(t, np.array(self.glove.runs))
        image = np.full((64, 96, 3), 40, np.uint8)
        image[20:30, 52:62, 1] = 40 + round(200 * lit)
        return SimpleNamespace(t=t, t_arrival=t + 0.02, left=image)


def test_devices_are_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measuring, "SETTLE", 0.05)
    # With shorter pauses the pulses are almost periodic, and in reverse they look alike.
    monkeypatch.setattr(measuring, "PAUSE", (0.05, 0.3))
    glove = LitGlove()
    found = measure(CommandedPulses(glove, 2), Camera(glove), 4.0)
    assert found.place == (56, 24)
    assert found.light.delay == pytest.approx(LitGlove.LATE, abs=0.003)
    result = figures(found)
    assert result["exposure_to_arrival_median_ms"] == pytest.approx(20.0)
    assert json.loads(json.dumps(result)) == result
    with pytest.raises(DeviceError) as refused:
        measure(CommandedPulses(LitGlove(accepts=False), 2), Camera(glove), 0.4)
    assert refused.value.notice.code == "loopback.no_commands"


class TappedGlove:
    """100 packets a second, which arrive 4 ms after their instant; taps at irregular times, each of
    which rebounds."""

    WAY = 0.004

    def __init__(self, force: float) -> None:
        rng = np.random.default_rng(3)
        self.taps = time.monotonic() + 0.1 + np.cumsum(rng.uniform(0.16, 0.4, 60))
        self.force, self.t, self.seq = force, time.monotonic(), 0

    def poll(self, timeout: float) -> list[ImuSample]:
        time.sleep(timeout)
        out = []
        while self.t + 0.01 + self.WAY < time.monotonic():
            before, self.t, self.seq = self.t, self.t + 0.01, self.seq + 1
            accel = np.tile([0.0, 0.0, 9.8], (7, 1))
            accel[5] = np.nan  # does not answer
            if ((self.taps > before) & (self.taps <= self.t)).any():
                accel[3, 0] += self.force
            still = np.zeros((7, 3))
            sample = ImuSample(self.t, self.t + self.WAY, self.t, self.seq, accel, still, still > 0)
            out.append(sample)
        return out


class SlowScreen:
    """Shows what it is asked to 30 ms later."""

    LATE = 0.030

    def __init__(self) -> None:
        self.runs, self.lock = [(0.0, 0.0)], threading.Lock()

    def show(self, lit: bool) -> None:
        t = time.monotonic() + self.LATE
        with self.lock:
            self.runs.append((t, np.inf) if lit else (self.runs.pop()[0], t))


def test_the_delay_from_taps_to_a_screen_is_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measuring, "APART", 0.15)
    screen = SlowScreen()
    found = measure(Taps(TappedGlove(2 * TAP), screen.show), Camera(screen), 5.0)
    assert found.pulses >= 10
    # the packets' way, up to 5 ms until the glove is asked again, the screen
    assert 0.032 < found.light.delay < 0.045
    result = figures(found, "tap")
    assert any(line.startswith("Tap to light") for line in lines(result))
    with pytest.raises(DeviceError) as refused:
        measure(Taps(TappedGlove(TAP / 2), screen.show), Camera(screen), 0.4)
    assert refused.value.notice.code == "loopback.no_taps"
    with pytest.raises(DeviceError) as silent:
        measure(Taps(LitGlove(), screen.show), Camera(screen), 0.1)
    assert silent.value.notice.code == "loopback.no_packets"


def test_the_screen_is_lit_for_a_while_after_a_tap_and_not_again_by_its_rebound() -> None:
    shown: list[bool] = []
    twice = threading.Event()

    def show(lit: bool) -> None:
        shown.append(lit)
        if len(shown) == 4:
            twice.set()

    taps = Taps(TappedGlove(2 * TAP), show)
    taps.start()
    assert twice.wait(20.0)
    pulses = taps.stop()
    assert len(pulses) >= 2 and (np.diff(pulses[:, 0]) > measuring.APART).all()
    assert shown[:4] == [True, False, True, False]
    assert (np.diff(pulses, axis=1) >= ON).all()


def test_a_window_flashes_until_the_end_of_the_measurement(qtbot) -> None:
    seen: list[str] = []

    def colour(window: FlashWindow) -> str:
        return window.grab().toImage().pixelColor(3, 3).name()

    window = FlashWindow()
    qtbot.addWidget(window)
    window.show()
    for lit in (False, True, False):
        window.changed.emit(lit)
        seen.append(colour(window))
    assert seen == ["#000000", "#ffffff", "#000000"]
    qtbot.keyClick(window, Qt.Key.Key_Escape)
    assert window.ended.is_set() and window.isHidden()


def test_the_measurement_runs_beside_the_window(qapp) -> None:
    def measuring(screen: Callable[[bool], None], is_ended: Callable[[], bool]) -> int:
        screen(True)
        assert not is_ended() and threading.current_thread() is not threading.main_thread()
        return 7

    assert flash_while(measuring) == 7
    with pytest.raises(ZeroDivisionError):
        flash_while(lambda screen, is_ended: 1 // 0)


def test_a_light_before_its_command_is_reported_as_wrong_times() -> None:
    found = LoopBack(DelayedLight(0, -0.012, 0.001, 0.9), np.full(9, 0.03), (8, 8), 30, 900)
    assert "too early by at least 12.0 ms" in lines(figures(found))[-1]
    assert len(lines(figures(found._replace(light=DelayedLight(0, 0.004, 0.001, 0.9))))) == 4


def test_the_command_writes_json_and_keeps_a_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    found = LoopBack(DelayedLight(0, 0.004, 0.001, 0.9), np.full(9, 0.03), (8, 8), 30, 900)
    link = GloveLink(lambda: pytest.fail("not opened"), 7)
    opened = SimpleNamespace(gloves=[SimpleNamespace(source=link)], camera=link)
    monkeypatch.setattr("extensions.loopback.command_runs.glove_devices", lambda port: opened)
    monkeypatch.setattr("extensions.loopback.command_runs.with_camera", lambda devices, *_: devices)
    monkeypatch.setattr("extensions.loopback.command_runs.measure", lambda *_: found)
    out = tmp_path / "a.json"
    command = ["loop-back", "--camera", "0", "--calibration", "c.yml", "--json", str(out)]
    assert main(command) == 0
    assert json.loads(out.read_text("utf-8"))["command_to_light_ms"] == pytest.approx(4.0)
    assert "Command to light, by the images' times: 4.0 ms (sd 1.0)." in capsys.readouterr().out
    assert main(command) == 1 and main([*command, "--force"]) == 0
