"""Exports as jobs of the window."""

from __future__ import annotations

from pathlib import Path

from app.tasks import Job, Progress

FORMATS = ("csv", "parquet", "h5", "c3d", "trc", "mot", "bvh", "glb", "urdf", "mp4")


def export_job(source: Path, form: str, target: Path) -> Job:
    """A job that writes ``source`` to ``target`` in the format ``form``."""

    def run(progress: Progress) -> Path:
        from tracker.session.export import export

        progress(-1.0, form)
        export(source, form, target)
        return target

    return run
