"""The surface of a hand: a closed mesh built from the hand file, which follows its joints.

`form` places round cones along the bones, muscles and forearm; `field` blends them into one
distance; `mesh` builds a mesh where that is zero and assigns the bones that each point follows;
`posing` moves it.
"""
