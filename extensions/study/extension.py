"""Descriptors of studies."""

from __future__ import annotations

from extensions.study.command import CHECK, EXPORT, REPORT, RUN, STATUS, STUDY, TABLES

__all__ = ["CHECK", "EXPORT", "REPORT", "RUN", "STATUS", "STUDY", "TABLES"]
