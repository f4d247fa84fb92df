"""The surface of a hand: a closed mesh built from the hand file, which follows its joints.

`form` places round cones along the bones, muscles and forearm; `field` blends them into one signed
distance; `mesh` extracts its zero surface and assigns bones to each vertex; `posing` deforms it.
"""
