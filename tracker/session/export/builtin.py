"""The core's export formats: tables, HDF5 and the session's own format."""

from __future__ import annotations

from tracker.base.registry import deferred
from tracker.session.export.formats import COPIED, ExportFormat

CSV = ExportFormat(
    "csv",
    "Table for spreadsheets and everything else (CSV)",
    deferred("tracker.session.export.tables:export_csv").load,
    order=10,
)
PARQUET = ExportFormat(
    "parquet",
    "Table for Python and R (Parquet)",
    deferred("tracker.session.export.tables:export_parquet").load,
    extra="glovetrack[parquet]",
    order=20,
)
H5 = ExportFormat(
    "h5",
    "Arrays for MATLAB and Python (HDF5)",
    deferred("tracker.session.export.h5:export_h5").load,
    order=30,
)
MCAP = ExportFormat(
    "mcap",
    "Session, whole or the chosen part (MCAP)",
    deferred("tracker.session.export.mcap:export_mcap").load,
    options=COPIED,
    both_hands=True,
    order=140,
)
IMU_CSV = ExportFormat(
    "imu.csv",
    "Raw samples of the IMUs (CSV)",
    deferred("tracker.session.export.imu:export_imu_csv").load,
    options=COPIED,
    order=160,
)
IMU_PARQUET = ExportFormat(
    "imu.parquet",
    "Raw samples of the IMUs (Parquet)",
    deferred("tracker.session.export.imu:export_imu_parquet").load,
    options=COPIED,
    extra="glovetrack[parquet]",
    order=170,
)
