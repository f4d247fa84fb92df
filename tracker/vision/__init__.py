"""From pixels to blobs, and from blobs to points: colours, detection, the stereo rig, CPD."""
