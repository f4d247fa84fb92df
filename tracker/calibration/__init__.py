"""What is found out before tracking or apart from it: colours, stereo camera, glove's sensors."""
