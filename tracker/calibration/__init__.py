"""What is found out before tracking: colours, the stereo camera, the glove's sensors."""
