"""``glovetrack loop-back``: from a command, or a tap, to its light in an image."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from extensions.loopback.command import LoopBackArguments
from extensions.loopback.measure import CommandedPulses, LoopBack, Taps, measure
from glovetrack.devices import glove_devices, with_camera
from tracker.base.registry import deferred
from tracker.base.terminal import check_json, finish
from tracker.sensors.glove_link import GloveLink

flash_while = deferred("extensions.loopback.window.flash:flash_while")  # Qt is not needed without


def run_loop_back(args: LoopBackArguments) -> int:
    check_json(args, [])
    devices = with_camera(glove_devices(args.port), args.camera, args.calibration)
    glove, camera = devices.gloves[0].source, devices.camera
    assert isinstance(glove, GloveLink)  # which `glove_devices` finds

    def flashing(screen: Callable[[bool], None], is_ended: Callable[[], bool]) -> LoopBack:
        return measure(Taps(glove, screen), camera, args.seconds, is_ended)

    try:
        if args.screen:
            found: LoopBack = flash_while(flashing)
        else:
            found = measure(CommandedPulses(glove, args.channel), camera, args.seconds)
    finally:
        glove.close()
        camera.close()
    result = figures(found, "tap" if args.screen else "command")
    finish(args, result, lines(result), [])
    return 0


def figures(found: LoopBack, cause: str = "command") -> dict[str, Any]:
    """In ms: from the ``cause``, command or tap, until the light by the images' times, the images'
    way to this computer, and the sum."""
    delay, sd = 1e3 * found.light.delay, 1e3 * found.light.sd
    arrival = 1e3 * found.arrival
    median, late = float(np.median(arrival)), float(np.percentile(arrival, 99))
    return {
        f"{cause}_to_light_ms": delay,
        f"{cause}_to_light_sd_ms": sd,
        "exposure_to_arrival_median_ms": median,
        "exposure_to_arrival_p99_ms": late,
        f"{cause}_to_image_ms": delay + median,
        "correlation": found.light.correlation,
        "light_px": list(found.place),
        "pulses": found.pulses,
        "images": found.images,
    }


def lines(result: dict[str, Any]) -> list[str]:
    """As text, with what a delay means that devices cannot have."""
    cause = "tap" if "tap_to_light_ms" in result else "command"
    delay, sd = result[f"{cause}_to_light_ms"], result[f"{cause}_to_light_sd_ms"]
    text = [
        f"Light at ({result['light_px'][0]}, {result['light_px'][1]}) px of the left image, "
        f"{result['pulses']} pulses in {result['images']} images.",
        f"{cause.capitalize()} to light, by the images' times: {delay:.1f} ms (sd {sd:.1f}).",
        f"Exposure to arrival of the image: {result['exposure_to_arrival_median_ms']:.1f} ms "
        f"(99 %: {result['exposure_to_arrival_p99_ms']:.1f}).",
        f"{cause.capitalize()} to image in this computer: {result[f'{cause}_to_image_ms']:.1f} ms.",
    ]
    if delay < -2 * sd:
        text.append(
            f"The light is seen before its {cause}: the images' times are too early by at least "
            f"{-delay:.1f} ms."
        )
    return text
