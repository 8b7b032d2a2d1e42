// Parts of a surface that only touch in a vertex, taken apart.

#ifndef GEODESIC_MESH_SPLIT_TOUCHING_H_
#define GEODESIC_MESH_SPLIT_TOUCHING_H_

#include "geodesic/triangle_soup.h"

namespace geodesic {

// For soups whose vertices are places: where the faces around one form several
// fans that share no edge, all but the first get a vertex of their own behind
// the others. Counts the edges of two faces or more as seams. O(V + F log F).
// REQUIRES: the triangles name vertices of the soup.
void SplitTouching(TriangleSoup& soup);

}  // namespace geodesic

#endif  // GEODESIC_MESH_SPLIT_TOUCHING_H_
