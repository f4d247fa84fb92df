"""The filter of `tracker.inertial.segments`, compiled; a row of the state is one IMU, the last
row its coefficients.

No fast-math: reassociation would fold the test for NaN away, and a batch would no longer equal the
same samples one by one.
"""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Stack, Vector, Written

# Columns of the state.
Q = 0  # q_GB, xyzw
OFFSET = 4  # of the gyroscope, rad/s
FIRST = 7  # specific force in G, low-passed once, m/s²
SECOND = 10  # and twice
MEAN_GYRO = 13  # slow averages in B, against which stillness is judged
MEAN_ACCEL = 16
STILL = 19  # s since the IMU began to stand still
TICKS = 20  # samples since the last levelling
COUNT = 21  # samples in all
ROWS = 22  # first two rows of R_GB, low-passed once, and twice from ROWS + 6
SIZE = 34

# Coefficients.
DT, K_TILT, EVERY, K_OFFSET, REST_TIME, K_REST, REST_GYRO, REST_ACCEL, K_REST_OFFSET, LIMIT = range(
    10
)


@kernel(error_model="numpy")
def step(state: Written[Matrix], gyro: Matrix, accel: Matrix) -> None:
    """One sample of every IMU.

    The row of ``state`` below those of the IMUs holds the coefficients: to hand one more array to
    compiled code would take a tenth of the whole call.
    """
    c = state[len(state) - 1]
    for i in range(len(state) - 1):
        # rows are not taken out here: a view each would cost as much as the arithmetic
        g_x, g_y, g_z = gyro[i, 0], gyro[i, 1], gyro[i, 2]
        a_x, a_y, a_z = accel[i, 0], accel[i, 1], accel[i, 2]
        if not np.isfinite(g_x + g_y + g_z + a_x + a_y + a_z):
            continue
        if state[i, COUNT] == 0:
            _start(state[i], gyro[i], accel[i])
        else:
            _rotate(state, i, c[DT], g_x, g_y, g_z)
        _filter(state, i, c[K_TILT], a_x, a_y, a_z)
        state[i, COUNT] += 1
        ticks = state[i, TICKS] + 1
        state[i, TICKS] = ticks
        if ticks >= c[EVERY]:
            _judge_rest(state[i], c, gyro[i], accel[i])
            _level(state[i], c)
            state[i, TICKS] = 0


@kernel
def _start(s: Written[Vector], g: Vector, a: Vector) -> None:
    """Level on the first sample."""
    s[MEAN_GYRO : MEAN_GYRO + 3] = g
    s[MEAN_ACCEL : MEAN_ACCEL + 3] = a
    norm = np.sqrt(a[0] ** 2 + a[1] ** 2 + a[2] ** 2)
    if norm > 0:
        _turn_to_up(s, a[0] / norm, a[1] / norm, a[2] / norm)


@kernel(error_model="numpy")
def _rotate(state: Written[Matrix], i: int, dt: float, g_x: float, g_y: float, g_z: float) -> None:
    """q ← q ⊗ exp(ω dt / 2), by series: a half angle below 0.3 rad leaves 1e-7."""
    h = 0.5 * dt
    x, y, z = h * (g_x - state[i, 4]), h * (g_y - state[i, 5]), h * (g_z - state[i, 6])
    n2 = x * x + y * y + z * z
    w = 1 - n2 * (0.5 - n2 * (1 / 24))
    f = 1 - n2 * (1 / 6 - n2 * (1 / 120))
    x, y, z = f * x, f * y, f * z
    q_x, q_y, q_z, q_w = state[i, 0], state[i, 1], state[i, 2], state[i, 3]
    n_x = q_w * x + q_x * w + q_y * z - q_z * y
    n_y = q_w * y - q_x * z + q_y * w + q_z * x
    n_z = q_w * z + q_x * y - q_y * x + q_z * w
    n_w = q_w * w - q_x * x - q_y * y - q_z * z
    m = 1.5 - 0.5 * (n_x * n_x + n_y * n_y + n_z * n_z + n_w * n_w)  # one Newton step of 1/norm
    state[i, 0], state[i, 1], state[i, 2], state[i, 3] = m * n_x, m * n_y, m * n_z, m * n_w


@kernel(error_model="numpy")
def _filter(state: Written[Matrix], i: int, k: float, a_x: float, a_y: float, a_z: float) -> None:
    """Specific force into G and through both low passes; plain averages while these are young."""
    x, y, z, w = state[i, 0], state[i, 1], state[i, 2], state[i, 3]
    t_x = 2 * (y * a_z - z * a_y)
    t_y = 2 * (z * a_x - x * a_z)
    t_z = 2 * (x * a_y - y * a_x)
    f_x = a_x + w * t_x + y * t_z - z * t_y
    f_y = a_y + w * t_y + z * t_x - x * t_z
    f_z = a_z + w * t_z + x * t_y - y * t_x
    if k * (state[i, COUNT] + 1) < 1:
        k = 1 / (state[i, COUNT] + 1)
    state[i, 7] += k * (f_x - state[i, 7])
    state[i, 8] += k * (f_y - state[i, 8])
    state[i, 9] += k * (f_z - state[i, 9])
    state[i, 10] += k * (state[i, 7] - state[i, 10])
    state[i, 11] += k * (state[i, 8] - state[i, 11])
    state[i, 12] += k * (state[i, 9] - state[i, 12])


@kernel
def _judge_rest(s: Written[Vector], c: Vector, g: Vector, a: Vector) -> None:
    """Rest is when the samples at levellings stay close to their slow averages."""
    off_gyro, off_accel = 0.0, 0.0
    for j in range(3):
        d_g = g[j] - s[MEAN_GYRO + j]
        d_a = a[j] - s[MEAN_ACCEL + j]
        s[MEAN_GYRO + j] += c[K_REST] * d_g
        s[MEAN_ACCEL + j] += c[K_REST] * d_a
        off_gyro += d_g * d_g
        off_accel += d_a * d_a
        if abs(s[MEAN_GYRO + j]) > c[LIMIT]:
            off_gyro = np.inf
    if off_gyro > c[REST_GYRO] ** 2 or off_accel > c[REST_ACCEL] ** 2:
        s[STILL] = 0.0
    else:
        s[STILL] += s[TICKS] * c[DT]
    if s[STILL] >= c[REST_TIME]:
        for j in range(3):
            s[OFFSET + j] += c[K_REST_OFFSET] * (s[MEAN_GYRO + j] - s[OFFSET + j])


@kernel
def _level(s: Written[Vector], c: Vector) -> None:
    """Turn G, by the shortest way, until the averaged specific force points up."""
    norm = np.sqrt(s[10] ** 2 + s[11] ** 2 + s[12] ** 2)
    if norm == 0:
        return
    e_x, e_y, e_z = s[10] / norm, s[11] / norm, s[12] / norm
    _average_rows(s, c)
    if s[STILL] < c[REST_TIME]:
        _learn_offset(s, c, e_y, -e_x)
    x, y, w = _turn_to_up(s, e_x, e_y, e_z)
    _rotate_vector(s, FIRST, x, y, w)
    _rotate_vector(s, SECOND, x, y, w)


@kernel
def _average_rows(s: Written[Vector], c: Vector) -> None:
    """The horizontal rows of R_GB through the same low passes as the specific force."""
    x, y, z, w = s[0], s[1], s[2], s[3]
    k = min(1.0, c[EVERY] * c[K_TILT])
    if k * s[COUNT] < c[EVERY]:
        k = c[EVERY] / s[COUNT]
    rows = (
        1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
        2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
    )  # fmt: skip
    for j in range(6):
        s[ROWS + j] += k * (rows[j] - s[ROWS + j])
        s[ROWS + 6 + j] += k * (s[ROWS + j] - s[ROWS + 6 + j])


@kernel
def _learn_offset(s: Written[Vector], c: Vector, r_x: float, r_y: float) -> None:
    """A levelling (r_x, r_y, 0) rad in G shows what the offset has turned the IMU by.

    An offset δ not known turns the estimate by R δ dt. The averaged force follows it through the
    low passes, so a levelling is -R̄ δ dt with R̄ the equally averaged R, and b -= k R̄ᵀ r descends.
    Where R has turned so fast that little is left of R̄ the step is enlarged, up to tenfold.
    """
    size = 0.0
    for j in range(6):
        size += s[ROWS + 6 + j] ** 2
    k = c[K_OFFSET] / max(0.1, 0.5 * size)
    for j in range(3):
        b = s[OFFSET + j] - k * (s[ROWS + 6 + j] * r_x + s[ROWS + 9 + j] * r_y)
        s[OFFSET + j] = min(max(b, -c[LIMIT]), c[LIMIT])


@kernel
def _turn_to_up(
    s: Written[Vector], u_x: float, u_y: float, u_z: float
) -> tuple[float, float, float]:
    """Turn q by the shortest rotation of the unit vector u to z; its quaternion (x, y, 0, w)."""
    w = np.sqrt(max(0.5 * (1 + u_z), 1e-12))
    x, y = 0.5 * u_y / w, -0.5 * u_x / w
    if u_z < -1 + 1e-9:  # upside down: any horizontal axis will do
        x, y, w = 1.0, 0.0, 0.0
    q_x, q_y, q_z, q_w = s[0], s[1], s[2], s[3]
    s[0] = w * q_x + x * q_w + y * q_z
    s[1] = w * q_y + y * q_w - x * q_z
    s[2] = w * q_z + x * q_y - y * q_x
    s[3] = w * q_w - x * q_x - y * q_y
    return x, y, w


@kernel
def _rotate_vector(s: Written[Vector], at: int, x: float, y: float, w: float) -> None:
    """Rotate the vector that starts at column ``at`` by the quaternion (x, y, 0, w)."""
    v_x, v_y, v_z = s[at], s[at + 1], s[at + 2]
    t_x, t_y, t_z = 2 * y * v_z, -2 * x * v_z, 2 * (x * v_y - y * v_x)
    s[at] = v_x + w * t_x + y * t_z
    s[at + 1] = v_y + w * t_y - x * t_z
    s[at + 2] = v_z + w * t_z + x * t_y - y * t_x


@kernel
def run(state: Written[Matrix], gyro: Stack, accel: Stack, out: Written[Stack]) -> None:
    """`step` over m samples; q_GB (m, n, 4) into ``out``."""
    for k in range(len(gyro)):
        step(state, gyro[k], accel[k])
        out[k] = state[:-1, Q : Q + 4]
