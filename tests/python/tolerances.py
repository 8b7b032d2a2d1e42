"""How far answers may be from what they are compared with."""

# Relative, of distances: what the core promises (core/include/geodesic/solve.h).
EXACT = 1e-10
# Relative, of oracles that add up lengths and unfold some faces: they round
# about as often as the solver does.
ORACLE = 1e-9
# Relative to the mesh's extent, of coordinates and weights that were computed
# from a rounded t in [0, 1].
COORDINATES = 1e-9
