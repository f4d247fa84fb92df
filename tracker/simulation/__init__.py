"""A simulated wearer, glove and camera: ground truth for tests of tracking.

Everything is a function of a seed and of time, so it can be evaluated at any times in any order:

- `motion` and `random_postures`, `recorded`: the motion of the hand,
- `wearer`: deviations of this person and fitting from the hand and glove files,
- `imu`: the measurements of the glove's IMUs,
- `scene`, `render`: the stereo camera's view, as blobs or as images,
- `two_hands`: a left and a right hand that cross, touch and occlude each other,
- `scenario`: all of these combined, as messages in the order of their arrival.
"""
