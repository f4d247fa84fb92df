"""Finger angles and segment orientations from inertial sensors alone.

S. Lemak et al.: Inertial sensor based solution for finger motion tracking. Computers 9 (2), 40,
2020, doi:10.3390/computers9020040. Equation and section numbers in this package are that paper's.

Planar estimators work in the flexion plane, where a vector is one complex number: the real part
points along the segment (+x of B), the imaginary part to the palm (-z of B). A rotation by the
flexion angle θ is then a product with exp(iθ). `tracker.inertial.plane` converts.
"""
