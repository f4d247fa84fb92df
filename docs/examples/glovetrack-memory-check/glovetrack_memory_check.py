"""A check for ``glovetrack doctor``: whether enough memory is free for recording images."""

from __future__ import annotations

from collections.abc import Iterator

from glovetrack.checks import Check, Finding, Machine, Severity, plain

NEEDED_MB = 500


def free_memory(machine: Machine) -> Iterator[Finding]:
    """One finding; none on systems without ``/proc``."""
    table = machine.root / "proc" / "meminfo"
    if not table.exists():
        return
    fields = dict(line.split(":", 1) for line in table.read_text("ascii").splitlines())
    free_mb = int(fields["MemAvailable"].split()[0]) // 1024
    if free_mb < NEEDED_MB:
        found = plain(f"{free_mb} MB of memory are free.", Severity.WARNING)
        yield Finding(found, plain(f"Close programs until {NEEDED_MB} MB are free."))
    else:
        yield Finding(plain(f"{free_mb} MB of memory are free."))


MEMORY = Check("memory", "Memory", free_memory)
