"""A simulated wearer, glove and camera: the truth that tracking is tested on.

Everything is a function of a seed and of time, so any instant can be asked for in any order:

- `motion` and `random_postures`, `recorded`: how the hand moves,
- `wearer`: how this person and this fitting differ from the hand and glove files,
- `imu`: what the glove's IMUs measure,
- `scene`, `render`: what the stereo camera sees, as blobs or as images,
- `two_hands`: a left and a right hand that cross, touch and hide one another,
- `scenario`: all of it joined, as messages in the order of their arrival.
"""
