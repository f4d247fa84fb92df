"""Descriptors of studies."""

from __future__ import annotations

from extensions.study.command import CHECK, RUN, STATUS, STUDY

__all__ = ["CHECK", "RUN", "STATUS", "STUDY"]
