// A view that shows much of a mesh, and of what is marked on it.

#ifndef GEODESIC_CLIENT_PICTURE_DEFAULT_VIEW_H_
#define GEODESIC_CLIENT_PICTURE_DEFAULT_VIEW_H_

#include <vector>

#include "client/picture/camera.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

// z for a mesh that is flat along z, as terrains are, or that would stand on a
// floor along z but fall over along y; y otherwise, as in most models.
UpAxis GuessUpAxis(const std::vector<Point>& positions);

// Tries oblique views of `shown`, the points that are to fit, from all around
// and takes the one in which the mesh has the largest outline, preferring those
// that see more of the marks, which lie on the surface.
View ChooseView(const MeshArrays& mesh, const std::vector<Point>& shown,
                const std::vector<Point>& marks, UpAxis up);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_DEFAULT_VIEW_H_
