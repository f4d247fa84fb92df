"""The core's export formats: tables, HDF5 and the session's own format."""

from __future__ import annotations

from tracker.session.export.formats import COPIED, ExportFormat, Writer


def _csv() -> Writer:
    from tracker.session.export.tables import export_csv

    return export_csv


def _parquet() -> Writer:
    from tracker.session.export.tables import export_parquet

    return export_parquet


def _h5() -> Writer:
    from tracker.session.export.h5 import export_h5

    return export_h5


def _mcap() -> Writer:
    from tracker.session.export.mcap import export_mcap

    return export_mcap


def _imu_csv() -> Writer:
    from tracker.session.export.imu import export_imu_csv

    return export_imu_csv


def _imu_parquet() -> Writer:
    from tracker.session.export.imu import export_imu_parquet

    return export_imu_parquet


CSV = ExportFormat("csv", "Table for spreadsheets and everything else (CSV)", _csv, order=10)
PARQUET = ExportFormat(
    "parquet", "Table for Python and R (Parquet)", _parquet, extra="glovetrack[parquet]", order=20
)
H5 = ExportFormat("h5", "Arrays for MATLAB and Python (HDF5)", _h5, order=30)
MCAP = ExportFormat(
    "mcap",
    "Session, whole or the chosen part (MCAP)",
    _mcap,
    options=COPIED,
    both_hands=True,
    order=140,
)
IMU_CSV = ExportFormat(
    "imu.csv", "Raw samples of the IMUs (CSV)", _imu_csv, options=COPIED, order=160
)
IMU_PARQUET = ExportFormat(
    "imu.parquet",
    "Raw samples of the IMUs (Parquet)",
    _imu_parquet,
    options=COPIED,
    extra="glovetrack[parquet]",
    order=170,
)
