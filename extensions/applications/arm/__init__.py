"""A six-axis robot arm that takes commands by hand (Lee et al. 2021, Fig. 1C, movie 1)."""
