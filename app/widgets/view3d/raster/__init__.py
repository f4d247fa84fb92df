"""The painted 3D view's renderer: rays meet pure forms, in compiled code without OpenGL.

`scene` keeps the bodies in a few arrays and makes the image; `placing` brings them before the
camera; `tiles` tells which of them each tile of pixels may show; `solids`, `grid` and `strokes`
tell where a ray meets one; `layers` keeps what one ray meets in order; `blending` makes a colour of
it, under the light of `shading`; `image` goes over the pixels; `view` is what all of them share.

The camera's frame C has x to the right, y down and z ahead. A ray is (x, y, 1), so that how far it
goes is a depth in m.
"""
