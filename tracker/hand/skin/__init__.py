"""The surface of a hand: a closed mesh made of the hand's file, which follows its joints.

`form` lays round cones along the bones, muscles and forearm; `field` blends them into one distance;
`polygons` makes a mesh where that is zero; `weights` says which bones each point follows; `mesh`
puts it together; `posing` moves it.
"""
