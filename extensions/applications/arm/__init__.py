"""A six-axis robot arm controlled by the hand (Lee et al. 2021, Fig. 1C, movie 1)."""
