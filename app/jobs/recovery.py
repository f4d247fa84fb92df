"""Makes a whole file of a session that was cut off."""

from __future__ import annotations

from pathlib import Path

from app.platform.tasks import Job, JobProgress


def recover_job(path: Path) -> Job:
    """A job that copies what can be read to ``…_recovered.mcap``."""

    def run(progress: JobProgress) -> Path:
        from tracker.session.recover import recover

        progress(-1.0, path.name)
        return recover(path).path

    return run
