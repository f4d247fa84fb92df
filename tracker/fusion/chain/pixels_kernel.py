"""The arithmetic of `tracker.fusion.chain.pixels`, compiled: the dearest loops of an image."""

from __future__ import annotations

import numpy as np

from tracker.fusion.chain.kinematics import (
    origin_slopes,
    points_of,
    put_own,
    segment_origins,
    turned,
)
from tracker.geometry.kernels import inverse3, rotate, rotate_back
from tracker.kernels import kernel
from tracker.vision.correspondence import ExpectedPixels, assigned
from tracker.vision.cpd import HuedPixels
from tracker.vision.rig import projected


@kernel
def pixel_jacobians(p_C, R_GC, fx, fy, baseline):  # type: ignore[no-untyped-def]
    """(2, n, 2, 3) d uv / d p_G of both cameras, of points p_C (n, 3)."""
    n = len(p_C)
    out = np.empty((2, n, 2, 3))
    for c in range(2):
        shift = baseline if c else 0.0
        for k in range(n):
            z = max(p_C[k, 2], 0.01)
            u_z = -fx * (p_C[k, 0] - shift) / z**2
            v_z = -fy * p_C[k, 1] / z**2
            for i in range(3):
                out[c, k, 0, i] = fx / z * R_GC[i, 0] + u_z * R_GC[i, 2]
                out[c, k, 1, i] = fy / z * R_GC[i, 1] + v_z * R_GC[i, 2]
    return out


@kernel
def worn(uv, hue, number):  # type: ignore[no-untyped-def]
    """uv, hue and row of the blobs uv (n, 2) px, hue (n,) that are finite and have a number >= 0.

    ``number`` (k,) is what the glove calls each hue.
    """
    keep, count = np.empty(len(uv), np.int64), 0
    for i in range(len(uv)):
        known = 0 <= hue[i] < len(number) and number[hue[i]] >= 0
        if known and np.isfinite(uv[i, 0] + uv[i, 1]):
            keep[count] = i
            count += 1
    rows = keep[:count].copy()
    return uv[rows], number[hue[rows]], rows


@kernel
def counted(match, prior):  # type: ignore[no-untyped-def]
    """Markers of match (2, M) that any lens shows; the sum of the larger of its priors (2, M)."""
    either, expected = 0, 0.0
    for j in range(match.shape[1]):
        either += match[0, j] >= 0 or match[1, j] >= 0
        expected += max(prior[0, j], prior[1, j])
    return either, expected


@kernel
def marker_places(  # type: ignore[no-untyped-def]
    parent, origin, base_of, lever, joint, scale, R_GB, p, segment, nominal, normal, offset,
    R_GC, p_GC, fx, fy, cx, cy, baseline,
):  # fmt: skip
    """p_GB (A, 3) of the active segments; of the markers p_G, normal_G, p_C (M, 3) and their
    rectified pixels uv (2, M, 2)."""
    p_GB = segment_origins(parent, origin, base_of, lever, joint, scale, R_GB, p)
    p_G = points_of(p_GB, R_GB, scale, segment, nominal, offset)
    p_C, uv = np.empty_like(p_G), np.empty((2, len(p_G), 2))
    for k in range(len(p_G)):
        p_C[k] = rotate_back(R_GC, p_G[k] - p_GC)
    for c in range(2):
        uv[c] = projected(p_C, baseline if c else 0.0, fx, fy, cx, cy)
    return p_GB, p_G, turned(R_GB, segment, normal), p_C, uv


@kernel
def expected(  # type: ignore[no-untyped-def]
    parent, origin, base_of, lever, joint, scale, R_GB, segment, nominal, offset,
    theta, scale_at, joint_at, marker_at, P, prior, least, A, sd_marker, sd_pixel,
):  # fmt: skip
    """The markers that may be seen: rows (n,), H and H P (n, 3, N), cov (n, 3, 3) m² in G with the
    placement's, and S (2, n, 2, 2) px².

    Those whose ``prior`` (2, M) is above ``least`` in a camera. A (2, M, 2, 3) = d uv / d p_G. What
    markers of one segment share of H P, the share of the segment's origin, is computed once.
    """
    rows = np.flatnonzero(np.maximum(prior[0], prior[1]) > least)
    count, column, value = origin_slopes(
        parent, origin, base_of, lever, joint, scale, R_GB, theta, scale_at, joint_at
    )
    of_origin = origin_products(parent, count, column, value, P)
    n, size = len(rows), len(P)
    H, HP, cov = np.zeros((n, 3, size)), np.empty((n, 3, size)), np.empty((n, 3, 3))
    S = np.empty((2, n, 2, 2))
    for i in range(n):
        m = rows[i]
        a = segment[m]
        k, h, at = count[a], value[a], column[a]
        end = k + put_own(
            h[:, k:], at[k:], a, nominal[m], offset[m], lever, scale, R_GB, theta, scale_at,
            marker_at + 3 * m,
        )  # fmt: skip
        HP[i] = of_origin[a]
        add_product(HP[i], h[:, k:end], at[k:end], P)
        for r in range(3):
            for c in range(end):
                H[i, r, at[c]] = h[r, c]
            for s in range(3):
                cov[i, r, s] = sd_marker**2 if r == s else 0.0
                for c in range(end):
                    cov[i, r, s] += HP[i, r, at[c]] * h[s, c]
        for c in range(2):
            S[c, i] = seen_covariance(A[c, m], cov[i], sd_pixel)
    return rows, H, HP, cov, S


@kernel
def seen_covariance(J, cov, sd_pixel):  # type: ignore[no-untyped-def]
    """J cov J^T + I sd_pixel² (e, e) px² of J (e, 3) and cov (3, 3) m²."""
    n = len(J)
    out = np.empty((n, n))
    for a in range(n):
        x = rotate(cov, J[a])
        for b in range(n):
            out[a, b] = x[0] * J[b, 0] + x[1] * J[b, 1] + x[2] * J[b, 2]
        out[a, a] += sd_pixel**2
    return out


@kernel
def origin_products(parent, count, column, value, P):  # type: ignore[no-untyped-def]
    """(A, 3, N) H P of the segments' origins, of `origin_slopes`: what a parent has is not made
    anew."""
    out = np.zeros((len(parent), 3, len(P)))
    for c in range(len(parent)):
        a = parent[c]
        begin = count[a] if a >= 0 else 0
        if a >= 0:
            out[c] = out[a]
        end = count[c]
        add_product(out[c], value[c, :, begin:end], column[c, begin:end], P)
    return out


@kernel
def add_product(out, value, column, P):  # type: ignore[no-untyped-def]
    """out (3, N) += H P of an H with the entries value (3, k) in the columns (k,)."""
    x, y, z = out[0], out[1], out[2]
    for c in range(len(column)):
        row = P[column[c]]
        a, b, d = value[0, c], value[1, c], value[2, c]
        for i in range(len(row)):
            x[i] += a * row[i]
            y[i] += b * row[i]
            z[i] += d * row[i]


@kernel
def matched(  # type: ignore[no-untyped-def]
    left, left_hue, right, right_hue, uv, rows, S, marker_hue, prior, gate, gate_px, alone,
    least_prior, usual_spread,
):  # fmt: skip
    """(2, M) row of the blobs left and right (k, 2) px for each marker, -1 for none.

    uv (2, M, 2) px and prior (2, M) of all markers, S (2, n, 2, 2) px² of the markers ``rows``
    that may be seen; limits as in `tracker.vision.correspondence.GateParams`. The cost ``alone`` of
    no match grows with the spread, or an unsure filter would match nothing.
    """
    out = np.full((2, uv.shape[1]), -1)
    for c in range(2):
        blobs, hue = (right, right_hue) if c else (left, left_hue)
        if len(blobs) == 0 or len(rows) == 0:
            continue
        markers = ExpectedPixels(
            uv[c][rows], S[c], marker_hue[rows], np.maximum(prior[c][rows], least_prior)
        )
        price = alone + max(0.0, spread(S[c]) - usual_spread)
        found = assigned(HuedPixels(blobs, hue), markers, gate, gate_px, price)
        for i in range(len(rows)):
            out[c, rows[i]] = found[i]
    return out


@kernel
def point_rows(  # type: ignore[no-untyped-def]
    H, HP, cov, A, rows, uv, match, left, right, sd_marker, sd_pixel, threshold
):  # fmt: skip
    """`stack_rows` of the markers ``rows`` (n,), with three rows in place of four where both
    cameras see one: what they say of its place in G. The fourth says nothing of the state.

    With J (4, 3) of both cameras' A, the residual is (JᵀJ)⁻¹ Jᵀ r (m) and its noise
    I sd_marker² + (JᵀJ)⁻¹ sd_pixel² (m²). cov (n, 3, 3) m² is that of the markers with their
    placement; uv (2, M, 2) px of all markers, match (2, M) rows of left and right (k, 2) px.
    """
    m = 0
    for k in range(len(rows)):
        seen = int(match[0, rows[k]] >= 0) + int(match[1, rows[k]] >= 0)
        m += seen + 1 if seen else 0
    rows_H, rows_HP = np.empty((m, H.shape[2])), np.empty((m, H.shape[2]))
    out_r, R = np.empty(m), np.zeros((m, m))
    J, r = np.empty((4, 3)), np.empty(4)
    at = 0
    for k in range(len(rows)):
        end = _put_pixels(J, r, rows[k], A, uv, match, left, right)
        if end == 0:
            continue
        weight = _huber(r[:end], seen_covariance(J[:end], cov[k], sd_pixel), threshold)
        if end == 4:
            noise, out_r[at : at + 3] = _solved(J, r)
            rows_H[at : at + 3], rows_HP[at : at + 3] = H[k], HP[k]
            noise *= sd_pixel**2
            for a in range(3):
                noise[a, a] += sd_marker**2
        else:
            out_r[at : at + 2] = r[:2]
            _put_product(rows_H[at : at + 2], J, H[k])
            _put_product(rows_HP[at : at + 2], J, HP[k])
            noise = seen_covariance(J[:2], np.eye(3) * sd_marker**2, sd_pixel)
        last = at + len(noise)
        R[at:last, at:last] = noise * weight
        at = last
    return rows_H, rows_HP, out_r, R


@kernel
def _put_pixels(J, r, marker, A, uv, match, left, right):  # type: ignore[no-untyped-def]
    """Slopes J (4, 3) and residuals r (4,) px of a marker in the lenses that show it, left before
    right; how many of the rows these are."""
    end = 0
    for c in range(2):
        row = match[c, marker]
        if row < 0:
            continue
        for a in range(2):
            J[end] = A[c, marker, a]
            r[end] = (right[row, a] if c else left[row, a]) - uv[c, marker, a]
            end += 1
    return end


@kernel
def _put_product(out, J, H):  # type: ignore[no-untyped-def]
    """out (k, N) = J H of the first k rows of J, for H (3, N)."""
    for a in range(len(out)):
        x, y, z = J[a]
        for i in range(H.shape[1]):
            out[a, i] = x * H[0, i] + y * H[1, i] + z * H[2, i]


@kernel
def _solved(J, r):  # type: ignore[no-untyped-def]
    """(JᵀJ)⁻¹ (3, 3) and (JᵀJ)⁻¹ Jᵀ r (3,)."""
    JJ, Jr = np.zeros((3, 3)), np.zeros(3)
    for e in range(len(J)):
        for a in range(3):
            Jr[a] += J[e, a] * r[e]
            for b in range(3):
                JJ[a, b] += J[e, a] * J[e, b]
    inverse = inverse3(JJ)
    return inverse, rotate(inverse, Jr)


@kernel
def spread(S):  # type: ignore[no-untyped-def]
    """Median of ln det of S (n, 2, 2) px²."""
    out = np.empty(len(S))
    for k in range(len(S)):
        out[k] = np.log(S[k, 0, 0] * S[k, 1, 1] - S[k, 0, 1] * S[k, 1, 0])
    return np.median(out)


@kernel
def stack_rows(H, HP, A, residual, sd_marker, sd_pixel, threshold):  # type: ignore[no-untyped-def]
    """H, HP (m, N), r (m,) and noise (m, m) of the markers that are matched.

    H, HP (n, 3, N) of n markers in G and their product with P; A (2, n, 2, 3) d uv / d p_G;
    residual (2, n, 2) px, NaN where a camera has no match. A marker's rows stand together, left
    before right. Its placement error sd_marker (m) is common to both images, sd_pixel (px) is not;
    beyond ``threshold`` standard deviations the noise grows with the distance.
    """
    matched = 0
    for c in range(2):
        for k in range(H.shape[0]):
            if not np.isnan(residual[c, k, 0]):
                matched += 1
    m, size = 2 * matched, H.shape[2]
    rows_H, rows_HP = np.empty((m, size)), np.empty((m, size))
    J, r, R = np.empty((m, 3)), np.empty(m), np.zeros((m, m))
    end = 0
    for k in range(H.shape[0]):
        start = end
        for c in range(2):
            if np.isnan(residual[c, k, 0]):
                continue
            for a in range(2):
                J[end], r[end] = A[c, k, a], residual[c, k, a]
                x, y, z = J[end]
                for i in range(size):
                    rows_H[end, i] = x * H[k, 0, i] + y * H[k, 1, i] + z * H[k, 2, i]
                    rows_HP[end, i] = x * HP[k, 0, i] + y * HP[k, 1, i] + z * HP[k, 2, i]
                end += 1
        if end > start:
            noise = J[start:end] @ J[start:end].T * sd_marker**2
            for i in range(end - start):
                noise[i, i] += sd_pixel**2
            S = rows_HP[start:end] @ rows_H[start:end].T + noise
            R[start:end, start:end] = noise * _huber(r[start:end], S, threshold)
    return rows_H, rows_HP, r, R


@kernel
def _huber(r, S, threshold):  # type: ignore[no-untyped-def]
    """Factor on the noise: 1 up to the threshold, then growing with the distance."""
    distance = np.sqrt(_mahalanobis2(S, r) / len(r))
    return max(1.0, distance / threshold) ** 2


@kernel
def _mahalanobis2(S, r):  # type: ignore[no-untyped-def]
    """r^T S^-1 r of a small positive definite S, by its Cholesky factor."""
    n, total = len(r), 0.0
    L, y = np.zeros((n, n)), np.empty(n)
    for i in range(n):
        for j in range(i + 1):
            x = S[i, j]
            for k in range(j):
                x -= L[i, k] * L[j, k]
            L[i, j] = np.sqrt(x) if i == j else x / L[j, j]
        y[i] = r[i]
        for k in range(i):
            y[i] -= L[i, k] * y[k]
        y[i] /= L[i, i]
        total += y[i] * y[i]
    return total
