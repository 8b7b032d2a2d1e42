// A web page of one file that shows a mesh coloured by its distances, and needs
// no server: it turns, zooms, and tells the distance under the cursor.

#ifndef GEODESIC_CLIENT_OUTPUT_VIEWER_PAGE_H_
#define GEODESIC_CLIENT_OUTPUT_VIEWER_PAGE_H_

#include <span>
#include <string>

#include "client/output/atomic_file.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

struct ViewedField {
  // What the page is called, e.g. the mesh's file.
  std::string name;
  std::string mesh_digest;
  // One per vertex; +infinity where no path leads.
  std::span<const double> distances;
  // Where distances are measured from, if these are points without an offset.
  // Then isolines are drawn as circles around them, even inside one face.
  std::span<const Point> sources;
};

// Fills web/template/viewer.html (web/src/embedded.ts says how). Coordinates
// are rounded to floats, as seen from the middle of the mesh; distances are
// not. REQUIRES: one distance per vertex.
void WriteViewerPage(const MeshArrays& mesh, const ViewedField& field,
                     AtomicFile* file);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_VIEWER_PAGE_H_
