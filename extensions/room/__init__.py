"""The hand in a room: poses of trackers of other systems, and how a tracker is on the hand."""
