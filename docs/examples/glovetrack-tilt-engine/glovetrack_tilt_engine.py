"""An engine for Glovetrack: a stiff hand, turned by a complementary filter on one IMU."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from glovetrack import engine as gt


@dataclass(frozen=True)
class TiltParams:
    gain: float = 0.5  # 1/s, at which the accelerometer corrects the tilt


@gt.record("tilt", shapes={"R_GI": "3 3"})  # never rename it: recordings contain it
@dataclass(eq=False)
class TiltState:
    R_GI: np.ndarray
    t: float = float("nan")


class TiltEngine(gt.Engine):
    def __init__(self, hand, glove, rig, params):
        self.hand, self.glove, self.gain = hand, glove, params.gain
        self.state, self.results = TiltState(np.eye(3)), []

    def feed_imu(self, sample):
        dt = np.nan_to_num(sample.t - self.state.t)
        if sample.valid[0]:
            R = self.state.R_GI @ Rotation.from_rotvec(sample.gyro[0] * dt).as_matrix()
            up = R @ sample.accel[0] / np.linalg.norm(sample.accel[0])
            turn = np.cross(up, [0.0, 0.0, 1.0]) * min(1.0, self.gain * dt)  # G: z is up
            self.state = TiltState(Rotation.from_rotvec(turn).as_matrix() @ R, sample.t)
        return self.predict(sample.t)

    def predict(self, t):
        hand, joints = self.hand, len(self.hand.joint_names)
        R_GB = self.state.R_GI @ self.glove.imus[0].R_BI.T
        R, p = hand.forward(np.zeros(joints), R_GB, np.zeros(3))
        points = self.glove.keypoint_positions(hand, R, p)
        q = Rotation.from_matrix(R[self.glove.keypoint_segments(hand)]).as_quat()
        guess, sd = gt.Validity.INFERRED, np.full(len(points), 0.1)
        states = np.full(len(points), guess), np.full(joints, guess)
        lost = gt.Tracking.LOST  # it has no position
        return gt.Estimate(t, lost, points, q, states[0], sd, np.zeros(joints), states[1], R, p)

    def feed_frame(self, frame):
        markers = len(self.glove.markers)
        self.results.append(gt.FrameResult.nothing(frame.t, gt.Tracking.LOST, markers))

    def take_results(self):
        results, self.results = self.results, []
        return results

    def calibration(self):
        return gt.Calibration.nothing(self.state.t, [imu.segment for imu in self.glove.imus])

    def get_state(self):
        return replace(self.state)

    def set_state(self, state):
        self.state = replace(state)


CAN = gt.Capabilities(images=False)
TILT = gt.EngineKind("tilt", "tilt (a stiff hand)", TiltEngine, lambda: TiltState, TiltParams, CAN)
