// Translates between the protocol's messages and the engine's types.

#ifndef GEODESIC_SERVER_RPC_MESSAGES_TRANSLATION_H_
#define GEODESIC_SERVER_RPC_MESSAGES_TRANSLATION_H_

#include <google/protobuf/repeated_field.h>
#include <google/protobuf/repeated_ptr_field.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/query.h"
#include "geodesic/rows/pairs.h"
#include "geodesic/surface_point.h"
#include "geodesic/trace.h"
#include "geodesic/v1/answer.pb.h"
#include "geodesic/v1/mesh.pb.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "geodesic/v1/query.pb.h"
#include "geodesic/v1/question_service.pb.h"
#include "geodesic/v1/surface.pb.h"
#include "geodesic_types/questions.h"
#include "server/engine/base/limits.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/meshes/mesh_catalogue.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/engine/meshes/method_store.h"
#include "server/engine/rows/pair_work.h"

namespace geodesic::server {

// Points and sources.

// Numbers of vertices, instead of places.
using PackedVertices = google::protobuf::RepeatedField<uint32_t>;

// Puts the targets of a request, in either form, into a query.
// Errors of these: as codec::FromProto (codec/places.h); RESOURCE_EXHAUSTED
// when they are more than the limit.
absl::Status AddTargets(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& targets,
    const PackedVertices& vertex_targets, const Limits& limits, Query& query);

// Puts the sources of a request into a query.
// Errors: also RESOURCE_EXHAUSTED when they are more than the limit, or their
// curves have more points than the limit.
absl::Status AddSources(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const Limits& limits, Query& query);

// The same for sources, in either form, that are rows of a matrix.
absl::Status AddRows(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const PackedVertices& vertex_sources, const Limits& limits, Query& query);

// The lines of a request.
// Errors: also RESOURCE_EXHAUSTED when they are more than the limit.
absl::StatusOr<LineQuestion> ReadLines(const v1::TraceLinesRequest& request,
                                       const Limits& limits);

// The pairs of a request, in either form.
// Errors: also RESOURCE_EXHAUSTED when they are more than the limit.
absl::Status AddPairs(const v1::ComputePairsRequest& request,
                      const Limits& limits, std::vector<PointPair>& pairs);

// Questions and their answers.

// What geodesic::Solve guarantees (solve.h).
inline constexpr double kRelativeTolerance = 1e-10;

// 1e-10 for exact distances, the certified error for those that have one,
// infinity for others.
double RelativeTolerance(const AlgorithmChoice& choice, double certified_error);
v1::AnswerOrigin ToProto(FieldOrigin origin);
v1::SolveProgress ToProto(const Progress& progress);
v1::SolveStatistics ToProto(const SolveStatistics& statistics);
v1::PairCounts ToProto(const PairCounts& counts);
// Without what depends on the question: origin and arrays.
v1::AnswerHeader MakeHeader(const ResidentMesh& mesh,
                            const AlgorithmChoice& algorithm,
                            const std::string& version);

// INVALID_ARGUMENT: this field of a request has a number that its enumeration
// does not have.
absl::Status Unknown(const std::string& field, int number);

// Errors of these: INVALID_ARGUMENT naming the part of the request at fault.
// Also if the question does not take this algorithm, or this tolerance, whose
// range the engine checks.
absl::StatusOr<AlgorithmChoice> ReadAlgorithm(
    const QuestionInfo& question, v1::Algorithm algorithm,
    const v1::Approximation& approximation, double tolerance);
// Never unspecified.
absl::StatusOr<v1::ValueType> ResolveValueType(v1::ValueType type);
absl::StatusOr<bool> IsBatch(v1::Priority priority);
// Adds to `question` what only field requests have.
// Errors: also RESOURCE_EXHAUSTED for counts beyond the limits.
absl::Status Translate(const v1::ComputeFieldRequest& request,
                       const Limits& limits, FieldRequest& question);

// Meshes and uploads.

v1::Mesh ToProto(const MeshDescription& mesh);
v1::MeshFormat ToProto(const UploadFormat& format);
v1::FileDigest ToProto(const FileKey& file);
// `path` is the message's. Errors: INVALID_ARGUMENT naming the field.
absl::StatusOr<FileKey> FromProto(const v1::FileDigest& file,
                                  const std::string& path);

// Errors of these: INVALID_ARGUMENT naming `field`, the path of the value in
// the request.
absl::StatusOr<UploadFormat> FromProto(v1::MeshFormat format,
                                       std::string_view field);
absl::StatusOr<UploadHeader> FromProto(const v1::UploadHeader& header);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESSAGES_TRANSLATION_H_
