"""Checks of the computer itself: system, processor, disk, graphics card."""

from __future__ import annotations

import platform
import time
from collections.abc import Iterator
from statistics import median

import numpy as np
import psutil

from tracker import __version__
from tracker.base.files import disk_error, free_bytes
from tracker.base.notices import Severity, notice, warning
from tracker.doctor.finding import Finding, graded
from tracker.doctor.machine import Machine
from tracker.engine.pipeline import Pipeline
from tracker.glove import library
from tracker.kernels import are_compiled, compiler
from tracker.messages import BlobFrame, ImuSample
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.colours import parse_profile
from tracker.vision.detector import Detector

LEAST_CORES = 2
LEAST_MEMORY_GB = 3.5  # of a computer sold as one with 4 GB
FPS = 60.0
"""Image pairs per second of the fastest usual camera."""
LOADED_PERCENT = 60.0
RECORDING_MB_S = 30.0
"""A stereo pair of 2560 × 720 at 60 Hz as JPEG of quality 90."""
FREE_GB, LEAST_FREE_GB = 20.0, 5.0
WRITTEN_MB = 64


def system(machine: Machine) -> Iterator[Finding]:
    """Operating system, memory and compiled code."""
    about = {"python": platform.python_version(), "platform": platform.platform()}
    yield Finding(notice("doctor.system", version=__version__, **about))
    cores, memory_gb = psutil.cpu_count() or 1, psutil.virtual_memory().total / 1e9
    size = notice("doctor.machine", cores=cores, memory_gb=memory_gb)
    if cores < LEAST_CORES or memory_gb < LEAST_MEMORY_GB:
        remedy = notice("doctor.larger_machine", cores=LEAST_CORES)
        yield Finding(size.with_severity(Severity.WARNING), remedy)
    else:
        yield Finding(size)
    if are_compiled():
        yield Finding(notice("doctor.compiled"))
    else:
        slow = warning("doctor.not_compiled", compiler=compiler())
        yield Finding(slow, notice("doctor.reinstall"))


def processor(machine: Machine) -> Iterator[Finding]:
    """How loaded the cores are, and what share of a core tracking takes."""
    load = psutil.cpu_percent(interval=0.5)
    yield graded(
        notice("doctor.load", load_percent=load),
        Severity.WARNING if load > LOADED_PERCENT else Severity.INFO,
        notice("doctor.close_programs"),
    )
    detection, fusion = 100 * detection_s() * FPS, 100 * tracking_s()
    share = detection + fusion
    what = notice(
        "doctor.tracking_load",
        fps=FPS,
        share_percent=share,
        detection_percent=detection,
        filter_percent=fusion,
    )
    yield graded(what, level(share, 60.0, 100.0), notice("doctor.lower_rate"))
    if machine.is_linux:
        yield _priority(machine)


def _priority(machine: Machine) -> Finding:
    """Whether tracking goes before other programs."""
    if machine.may_run_first():
        return Finding(notice("doctor.urgent"))
    return Finding(notice("doctor.not_urgent"), notice("doctor.allow_urgent"))


def level(value: float, warn_above: float, fail_above: float) -> Severity:
    """The severity of a figure that should be small."""
    if value > fail_above:
        return Severity.ERROR
    return Severity.WARNING if value > warn_above else Severity.INFO


def disk(machine: Machine) -> Iterator[Finding]:
    """Whether the disk of the recordings is fast enough and has room."""
    folder = machine.folder
    try:
        speed = machine.writing_speed(folder, WRITTEN_MB)
    except OSError as problem:
        refused = disk_error(folder, problem).notice.with_severity(Severity.ERROR)
        yield Finding(refused, notice("doctor.other_folder"))
        return
    needed = {"disk_mb_s": speed, "needed_mb_s": RECORDING_MB_S}
    what = notice("doctor.disk_speed", folder=folder, **needed)
    severity = level(-speed, -2 * RECORDING_MB_S, -RECORDING_MB_S)
    yield graded(what, severity, notice("doctor.other_disk"))
    free_gb = free_bytes(folder) / 1e9
    minutes = 1000 * free_gb / RECORDING_MB_S / 60
    what = notice("doctor.disk_room", free_gb=free_gb, minutes=minutes)
    severity = level(-free_gb, -FREE_GB, -LEAST_FREE_GB)
    yield graded(what, severity, notice("doctor.free_disk"))


def graphics(machine: Machine) -> Iterator[Finding]:
    """Graphics cards that Linux lists; other systems are left to the window's own check."""
    if not machine.is_linux:
        return
    nodes = sorted((machine.root / "dev/dri").glob("renderD*"))
    if not nodes:
        yield Finding(warning("doctor.no_graphics"), notice("doctor.graphics_driver"))
    for node in nodes:
        if machine.is_accessible(str(node)):
            yield Finding(notice("doctor.graphics", name=node.name))
        else:
            refused = warning("doctor.graphics_refused", name=node.name)
            yield Finding(refused, notice("doctor.graphics_group"))


IMAGE_SIZE = (720, 1280)
COLOURS_BGR = ((40, 40, 220), (220, 90, 30), (60, 190, 40), (40, 220, 230))
MARKERS = 40
SEED = 1
WARM, SPAN = 1.0, 1.0
"""s of simulated data that are tracked before the measurement, and in it."""


def detection_s(rounds: int = 9) -> float:
    """Median time of a search for markers in a whole pair of noisy images, s."""
    image = np.random.default_rng(SEED).integers(90, 130, (*IMAGE_SIZE, 3), np.uint8)
    for k in range(MARKERS):
        row, column = divmod(k, 8)
        y, x = 100 + 100 * row, 100 + 140 * column
        image[y : y + 20, x : x + 20] = COLOURS_BGR[k % len(COLOURS_BGR)]
    detector = Detector(parse_profile(library.text("colours", library.DEFAULT_COLOURS)))
    times = []
    for _ in range(rounds + 1):
        start = time.perf_counter()
        for _eye in range(2):
            detector.detect(image)
        times.append(time.perf_counter() - start)
    return median(times[1:])  # the first call loads the compiled code


def tracking_s(fps: float = 60.0, warm: float = WARM, span: float = SPAN) -> float:
    """Time that the filter takes per second of data: seven IMUs at 100 Hz, ``fps`` image pairs.

    ``span`` s are timed after ``warm`` s.
    """
    hand, glove = library.load()
    motion = RandomPostures(hand, SEED, duration=warm + span + 0.1)
    sim = Simulation(hand, glove, motion, SEED, fps=fps)
    pipeline = Pipeline(hand, glove, sim.rig)
    measured = 0.0
    for message in sim.feed():
        if not isinstance(message, ImuSample | BlobFrame):
            continue
        start = time.perf_counter()
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
        else:
            pipeline.feed_frame(message)
        pipeline.take_results()
        if message.t_arrival >= warm:
            measured += time.perf_counter() - start
    return measured / span
