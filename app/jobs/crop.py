"""Makes a session of a part of another one."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from app.platform.aside import aside
from app.platform.tasks import Job, JobProgress


def crop_job(source: Path, part: tuple[float, float]) -> Job:
    """A job that copies ``part`` (s of the replay) to ``…_crop.mcap``, or leaves none."""

    def run(progress: JobProgress) -> Path:
        out: Path = aside("crop", partial(_crop, source, part), progress)
        return out

    return run


def _crop(source: Path, part: tuple[float, float], progress: Callable[..., None]) -> Path:
    from tracker.base.files import free_path
    from tracker.offline.crop import crop

    out = free_path(source.with_name(f"{source.stem}_crop{source.suffix}"))
    crop(source, out, *part, progress)
    return out
