"""Propagation of one pose by geometric relationships (Guerrero et al. 2014).

`propagating` is the way in. `query` says what relates a shape to what stands about it, `matching` which
features of another area that is compared with, `importance` by which weights. `lattice` and `bands` evaluate
the importance on a grid, `dense` at any points, `pose_space` over positions and directions; `maxima` and
`refining` find poses. `validation`, `arrays`, `coordinates`, `choosing` and `symmetry` are a subject each.
"""
