"""The software renderer of the 3D view: ray casting of analytic shapes, in compiled code without
OpenGL.

`scene` stores the bodies in arrays and renders the image; `placing` transforms them into the camera
frame; `tiles` determines which of them each tile of pixels may show; `solids`, `grid` and `strokes`
intersect a ray with one; `layers` stores the intersections of a ray in order; `blending` computes
the colour, lit by `shading`; `image` iterates over the pixels; `view` contains the data that all of
them share.

The camera's frame C has x to the right, y down and z forward. A ray is (x, y, 1), so that the ray
parameter is the depth in m.
"""
