"""A blinking light is found, with the delay that it has."""

from __future__ import annotations

import json
import threading
import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from extensions.loopback import measure as measuring
from extensions.loopback.command_runs import figures, lines
from extensions.loopback.measure import DelayedLight, LoopBack, find_light, measure
from tracker.base.errors import DeviceError
from tracker.cli import main
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


class Camera:
    """100 images a second of the glove; images of a past exposure show what was then."""

    def __init__(self, glove: LitGlove) -> None:
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
    found = measure(glove, Camera(glove), 4.0, channel=2)
    assert found.place == (56, 24)
    assert found.light.delay == pytest.approx(LitGlove.LATE, abs=0.003)
    result = figures(found)
    assert result["exposure_to_arrival_median_ms"] == pytest.approx(20.0)
    assert json.loads(json.dumps(result)) == result
    with pytest.raises(DeviceError) as refused:
        measure(LitGlove(accepts=False), Camera(glove), 0.4, channel=2)
    assert refused.value.notice.code == "loopback.no_commands"


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
