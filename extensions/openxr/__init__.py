"""OpenXR: the hand for any application of the user, by an API layer over shared memory."""
