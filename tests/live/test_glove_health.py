"""Status messages contain the health data sent by a glove."""

from tests.live.test_runner import Glove, live, profile, sim
from tracker.sensors.glove_link import LinkFigures

__all__ = ["profile", "sim"]  # fixtures

FIGURES = LinkFigures()


class HealthyGlove(Glove):
    figures = FIGURES


def test_battery_and_temperature_are_in_the_status(sim, profile):
    silent, _ = live(sim, profile, None)
    assert "battery_v" not in silent.hand("right").status().values
    silent.stop()
    tracker, _ = live(sim, profile, None, glove=HealthyGlove)
    assert "battery_v" not in tracker.hand("right").status().values, "not known yet"
    FIGURES.battery_mV, FIGURES.temperature_cC = 3712, 2950
    values = tracker.hand("right").status().values
    assert (values["battery_v"], values["temperature_c"]) == (3.712, 29.5)
    FIGURES.temperature_cC = 3000
    assert tracker.hand("right").status().values["temperature_c"] == 30.0
    tracker.stop()
