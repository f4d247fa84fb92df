"""Raw samples of all IMUs, as recorded: CSV or Parquet, one row per packet of the glove."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from tracker.messages import Array
from tracker.session.export.options import ExportOptions
from tracker.session.export.tables import arrow
from tracker.session.raw_imu import RawImu, read_raw_imu
from tracker.session.reader import SessionReader

UNITS = {"acc": "m/s^2", "gyr": "rad/s"}
CLOCKS = ("sampled [ns]", "arrived [ns]", "device [s]", "packet")
"""Computer's time since 1970 at which a packet was sampled and at which it arrived, the glove's
own clock, and the packet's number."""


def export_imu_csv(reader: SessionReader, path: Path, options: ExportOptions) -> None:
    """The header contains the units; missing readings are empty. Raises FileError without IMUs."""
    raw = _selected(reader, options)
    names, values = columns(raw)
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write(",".join([*CLOCKS, *names]) + "\n")
        for k, row in enumerate(values):
            device = f"{raw.device_s[k]:.9f}" if np.isfinite(raw.device_s[k]) else ""
            seq = str(raw.seq[k]) if raw.seq[k] >= 0 else ""
            clocks = [str(raw.stamp_ns[k]), str(raw.arrival_ns[k]), device, seq]
            cells = [f"{v:.9g}" if np.isfinite(v) else "" for v in row]
            out.write(",".join([*clocks, *cells]) + "\n")


def export_imu_parquet(reader: SessionReader, path: Path, options: ExportOptions) -> None:
    """The same columns. Raises ConfigError without Arrow, FileError without IMUs."""
    pa, pq = arrow()
    raw = _selected(reader, options)
    names, values = columns(raw)
    clocks = (raw.stamp_ns, raw.arrival_ns, raw.device_s, np.where(raw.seq < 0, np.nan, raw.seq))
    table: dict[str, Any] = {
        n: pa.array(v, from_pandas=True) for n, v in zip(CLOCKS, clocks, strict=True)
    }
    table |= {n: pa.array(v, from_pandas=True) for n, v in zip(names, values.T, strict=True)}
    pq.write_table(pa.table(table), path)


def columns(raw: RawImu) -> tuple[list[str], Array]:
    """Names with units, and values (N, 6 n)."""
    names, values = raw.channels()
    return [f"{n} [{UNITS[n.rsplit('_', 2)[1]]}]" for n in names], values


def _selected(reader: SessionReader, options: ExportOptions) -> RawImu:
    """The part from ``start`` to ``stop``, s from the first packet; without the date, times start
    at 0."""
    raw = read_raw_imu(reader)
    at = (raw.stamp_ns - raw.stamp_ns[0]) * 1e-9
    low = -np.inf if options.start is None else options.start
    high = np.inf if options.stop is None else options.stop
    return raw.rows(
        np.flatnonzero((at >= low) & (at <= high)),
        int(raw.stamp_ns[0]) if "time" in options.anonymous else 0,
    )
