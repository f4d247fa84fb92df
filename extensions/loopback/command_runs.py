"""``glovetrack loop-back``: from a command to its light in an image."""

from __future__ import annotations

from typing import Any

import numpy as np

from extensions.loopback.command import LoopBackArguments
from extensions.loopback.measure import LoopBack, measure
from glovetrack.devices import glove_devices, with_camera
from tracker.base.terminal import check_json, finish
from tracker.sensors.glove_link import GloveLink


def run_loop_back(args: LoopBackArguments) -> int:
    check_json(args, [])
    devices = with_camera(glove_devices(args.port), args.camera, args.calibration)
    glove = devices.gloves[0].source
    assert isinstance(glove, GloveLink)  # which `glove_devices` finds
    try:
        found = measure(glove, devices.camera, args.seconds, args.channel)
    finally:
        glove.close()
        devices.camera.close()
    result = figures(found)
    finish(args, result, lines(result), [])
    return 0


def figures(found: LoopBack) -> dict[str, Any]:
    """In ms: the command until the light by the images' times, the images' way to this computer,
    and the sum."""
    delay, sd = 1e3 * found.light.delay, 1e3 * found.light.sd
    arrival = 1e3 * found.arrival
    median, late = float(np.median(arrival)), float(np.percentile(arrival, 99))
    return {
        "command_to_light_ms": delay,
        "command_to_light_sd_ms": sd,
        "exposure_to_arrival_median_ms": median,
        "exposure_to_arrival_p99_ms": late,
        "command_to_image_ms": delay + median,
        "correlation": found.light.correlation,
        "light_px": list(found.place),
        "pulses": found.pulses,
        "images": found.images,
    }


def lines(result: dict[str, Any]) -> list[str]:
    """As text, with what a delay means that devices cannot have."""
    delay, sd = result["command_to_light_ms"], result["command_to_light_sd_ms"]
    text = [
        f"Light at ({result['light_px'][0]}, {result['light_px'][1]}) px of the left image, "
        f"{result['pulses']} pulses in {result['images']} images.",
        f"Command to light, by the images' times: {delay:.1f} ms (sd {sd:.1f}).",
        f"Exposure to arrival of the image: {result['exposure_to_arrival_median_ms']:.1f} ms "
        f"(99 %: {result['exposure_to_arrival_p99_ms']:.1f}).",
        f"Command to image in this computer: {result['command_to_image_ms']:.1f} ms.",
    ]
    if delay < -2 * sd:
        text.append(
            "The light is seen before its command: the images' times are too early by at least "
            f"{-delay:.1f} ms."
        )
    return text
