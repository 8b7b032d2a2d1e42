// Facts about meshes, as geodesic/v1/mesh.proto has them.

#ifndef GEODESIC_CODEC_MESH_SUMMARY_H_
#define GEODESIC_CODEC_MESH_SUMMARY_H_

#include "geodesic/v1/mesh.pb.h"
#include "geodesic/v1/surface.pb.h"
#include "geodesic_types/mesh_summary.h"
#include "geodesic_types/places.h"

namespace geodesic::codec {

void ToProto(const Point& point, v1::Point& proto);
Point FromProto(const v1::Point& proto);

// These set the facts alone.
void ToProto(const MeshSummary& summary, v1::Mesh& proto);
void FromProto(const v1::Mesh& proto, MeshSummary& summary);

}  // namespace geodesic::codec

#endif  // GEODESIC_CODEC_MESH_SUMMARY_H_
