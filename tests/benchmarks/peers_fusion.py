"""The same work from off-the-shelf parts: dense numpy filters, plain OpenCV, pycpd."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec

import numpy as np

from tracker.messages import Array


def pycpd_installed() -> bool:
    """Whether the optional peer is there."""
    return find_spec("pycpd") is not None


def dense_covariance(F: Array, P: Array, q: Array) -> Array:
    """F P F^T + diag(q), as a textbook writes it; F, P (N, N), q (N,)."""
    return F @ P @ F.T + np.diag(q)


def dense_joseph(P: Array, H: Array, r: Array, R: Array) -> tuple[Array, Array]:
    """dx (N,) and (I - K H) P (I - K H)^T + K R K^T: the Kalman update in Joseph's form."""
    S = H @ P @ H.T + R
    K = np.linalg.solve(S, H @ P).T
    A = np.eye(len(P)) - K @ H
    return K @ r, A @ P @ A.T + K @ R @ K.T


def rigid_registration(target: Array, source: Array) -> object:
    """pycpd's rigid registration of two point sets (n, d), (m, d)."""
    return import_module("pycpd").RigidRegistration(X=target, Y=source, w=0.1).register()


@dataclass(frozen=True, eq=False)
class FrameCloud:
    """One exposure as pycpd sees it: left and right (n, 2) px, points (m, 3) m in C."""

    left: Array
    right: Array
    points: Array


@dataclass(frozen=True, eq=False)
class PlainFilter:
    """A dense filter of N states: F (N, N), q (N,), H (m, N), r (m,), R (m, m), P (N, N)."""

    F: Array
    q: Array
    P: Array
    H: Array
    r: Array
    R: Array


def plain_second(
    clouds: Sequence[FrameCloud], markers: Array, plain: PlainFilter, packets: int
) -> Array:
    """What a second costs without detection: ``packets`` predictions, and per exposure two
    registrations (image to image, points to ``markers`` (M, 3)) and one update.

    The peer is favoured: no linearisation, no nominal state, no output and nothing redone for a
    late image.
    """
    for _ in range(packets):
        P = dense_covariance(plain.F, plain.P, plain.q)
    for cloud in clouds:
        rigid_registration(cloud.right, cloud.left)
        rigid_registration(cloud.points, markers)
        dense_joseph(P, plain.H, plain.r, plain.R)
    return P
