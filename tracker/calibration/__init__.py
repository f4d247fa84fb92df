"""Calibrations before or besides tracking: colours, stereo camera, the glove's sensors."""
