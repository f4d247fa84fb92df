"""Finger angles and segment orientations from inertial sensors alone (Lemak et al. 2020).

Planar estimators work in the flexion plane, where a vector is one complex number: the real part
points along the segment (+x of B), the imaginary part to the palm (-z of B). A rotation by the
flexion angle θ is then a product with exp(iθ). `tracker.inertial.plane` converts.
"""
