"""Pointing and grasping in a virtual place (Lemak et al. 2020, section 1.1, Fig. 1 to 4)."""
