"""Checks of the computer itself: system, processor, disk, graphics card."""

from __future__ import annotations

import platform
from collections.abc import Iterator

import psutil

from tracker import __version__
from tracker.base.files import disk_error, free_bytes
from tracker.doctor.finding import Finding, error, ok, warning
from tracker.doctor.machine import Machine
from tracker.doctor.speed import detection_s, tracking_s
from tracker.kernels import are_compiled, compiler

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
    cores, memory_gb = psutil.cpu_count() or 1, psutil.virtual_memory().total / 1e9
    about = f"Glovetrack {__version__}, Python {platform.python_version()}, {platform.platform()}."
    yield ok(about)
    what = f"{cores} cores, {memory_gb:.1f} GB of memory."
    if cores < LEAST_CORES or memory_gb < LEAST_MEMORY_GB:
        remedy = f"Use a computer with at least {LEAST_CORES} cores and 4 GB."
        yield warning(what, remedy, cores=cores, memory_gb=memory_gb)
    else:
        yield ok(what, cores=cores, memory_gb=memory_gb)
    if are_compiled():
        yield ok("The program's numerical code is compiled.")
    else:
        what = f"The program's numerical code is compiled while it runs (by {compiler()})."
        yield warning(what, "The first start takes minutes; reinstall the package to avoid this.")


def processor(machine: Machine) -> Iterator[Finding]:
    """How loaded the cores are, and what share of a core tracking takes."""
    load = psutil.cpu_percent(interval=0.5)
    what = f"Other programs use {load:.0f} % of all cores."
    if load > LOADED_PERCENT:
        yield warning(what, "Close other programs before you track.", load_percent=load)
    else:
        yield ok(what, load_percent=load)
    detection, fusion = 100 * detection_s() * FPS, 100 * tracking_s()
    share = detection + fusion
    what = (
        f"Tracking at {FPS:.0f} images per second takes {share:.0f} % of a core at the present "
        f"load: {detection:.0f} % for the images, {fusion:.0f} % for the filter."
    )
    values = {"detection_percent": detection, "filter_percent": fusion}
    if share > 100:
        yield error(what, "Close other programs, and choose 30 images per second.", **values)
    elif share > 60:
        yield warning(what, "Close other programs, or choose 30 images per second.", **values)
    else:
        yield ok(what, **values)


def disk(machine: Machine) -> Iterator[Finding]:
    """Whether the disk of the recordings is fast enough and has room."""
    folder = machine.folder
    try:
        speed = machine.writing_speed(folder, WRITTEN_MB)
    except OSError as trouble:
        yield error(str(disk_error(folder, trouble)), "Choose another folder for recordings.")
        return
    what = f"The disk of {folder} takes {speed:.0f} MB/s; a recording needs up to {{}} MB/s."
    what = what.format(f"{RECORDING_MB_S:.0f}")
    remedy = "Record to another disk, or record without images."
    if speed < RECORDING_MB_S:
        yield error(what, remedy, disk_mb_s=speed)
    elif speed < 2 * RECORDING_MB_S:
        yield warning(what, remedy, disk_mb_s=speed)
    else:
        yield ok(what, disk_mb_s=speed)
    yield _room(free_bytes(folder) / 1e9)


def _room(free_gb: float) -> Finding:
    minutes = 1000 * free_gb / RECORDING_MB_S / 60
    what = f"{free_gb:.0f} GB are free: at least {minutes:.0f} minutes of recording with images."
    remedy = "Delete or move old recordings."
    if free_gb < LEAST_FREE_GB:
        return error(what, remedy, free_gb=free_gb)
    if free_gb < FREE_GB:
        return warning(what, remedy, free_gb=free_gb)
    return ok(what, free_gb=free_gb)


def graphics(machine: Machine) -> Iterator[Finding]:
    """Graphics cards that Linux lists; other systems are left to the window's own check."""
    if not machine.is_linux:
        return
    nodes = sorted((machine.root / "dev/dri").glob("renderD*"))
    if not nodes:
        yield warning(
            "There is no graphics card: the processor draws the 3D view.",
            "Install the card's driver; tracking itself does not need one.",
        )
    for node in nodes:
        if machine.is_accessible(str(node)):
            yield ok(f"Graphics card {node.name}.")
        else:
            yield warning(
                f"This user may not use the graphics card {node.name}.",
                "Add yourself to its group (sudo usermod -aG render,video $USER) and log in again.",
            )
