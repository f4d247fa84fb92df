"""The program's own checks, as pyproject.toml declares them; imports happen when they run."""

from __future__ import annotations

from collections.abc import Iterable

from tracker.doctor.finding import Check, Finding
from tracker.doctor.machine import Machine


def _system(machine: Machine) -> Iterable[Finding]:
    from tracker.doctor.computer import system

    return system(machine)


def _processor(machine: Machine) -> Iterable[Finding]:
    from tracker.doctor.computer import processor

    return processor(machine)


def _disk(machine: Machine) -> Iterable[Finding]:
    from tracker.doctor.computer import disk

    return disk(machine)


def _graphics(machine: Machine) -> Iterable[Finding]:
    from tracker.doctor.computer import graphics

    return graphics(machine)


def _permissions(machine: Machine) -> Iterable[Finding]:
    from tracker.doctor.permissions import permissions

    return permissions(machine)


def _gloves(machine: Machine) -> Iterable[Finding]:
    from tracker.doctor.gloves import gloves

    return gloves(machine)


def _cameras(machine: Machine) -> Iterable[Finding]:
    from tracker.doctor.cameras import cameras

    return cameras(machine)


SYSTEM = Check("system", "System", _system, 10)
PROCESSOR = Check("processor", "Processor", _processor, 20)
DISK = Check("disk", "Disk", _disk, 30)
GRAPHICS = Check("graphics", "Graphics card", _graphics, 40)
PERMISSIONS = Check("permissions", "Permissions", _permissions, 60)
GLOVES = Check("gloves", "Gloves", _gloves, 70)
CAMERAS = Check("cameras", "Cameras", _cameras, 80)
