"""Virtual objects that fingertips touch (Lee et al. 2021, Fig. 8)."""
