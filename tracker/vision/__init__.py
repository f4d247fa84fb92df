"""Detection of blobs in images, and stereo points from blobs: colours, detector, rig, CPD."""
