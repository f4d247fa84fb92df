"""Judges a recording in a background job; writes the page and the labels next to it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from app.platform.tasks import Job, JobProgress
from extensions.conformance.run import judge, read_take
from extensions.conformance.take import labels_path, write_labels
from tracker.base.files import free_path, write_whole

if TYPE_CHECKING:
    from extensions.conformance.run import TakeVerdict


class Judged(NamedTuple):
    """The verdict and its page as HTML."""

    verdict: TakeVerdict
    page: Path


def conformance_job(take: Path) -> Job:
    """A job that returns `Judged`. The steps are notes of the session ``take``."""

    def run(progress: JobProgress) -> Judged:
        from extensions.conformance.page import page

        progress(0.1, take.name)
        takes, steps = read_take(take)
        progress(0.6, take.name)
        verdict = judge(take.name, takes, steps)
        write_labels(labels_path(take), take.name, steps, min(int(t.sample[0]) for t in takes))
        out = free_path(take.with_suffix(".conformance.html"))
        write_whole(out, page(verdict))
        return Judged(verdict, out)

    return run
