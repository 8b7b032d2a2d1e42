// Client::ComputeField and StreamField: into the final buffer, or for the
// callback.

#include <algorithm>
#include <string>
#include <utility>

#include "ask.h"
#include "connection.h"
#include "lines.h"
#include "translate.h"

namespace geodesic::client {
namespace {

using codec::AnswerReader;

void CollectTargets(const FieldQuery& query, AnswerReader* reader,
                    Field* field) {
  if (query.targets.empty()) return;
  const auto count = static_cast<int64_t>(query.targets.size());
  reader->Collect("target_distance", {count}, &field->target_distances);
}

}  // namespace

absl::StatusOr<Field> Client::ComputeField(
    const FieldQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  Field field;
  AnswerReader reader;
  const AnswerReader::Shape shape = {AnswerReader::kVertices};
  reader.Collect("distance", shape, &field.distances);
  if (query.nearest_sources) {
    reader.Collect("nearest_source", shape, &field.nearest_sources);
  }
  if (query.gradients) {
    reader.Collect("gradient", {AnswerReader::kVertices, 3}, &field.gradients);
  }
  if (query.certified_errors) {
    reader.Collect("certified_error", shape, &field.certified_errors);
  }
  CollectTargets(query, &reader, &field);
  absl::Status status = connection_->Ask(
      &Questions::ComputeField, MakeRequest<v1::ComputeFieldRequest>(query),
      options, ReportTo(progress), &reader, &field);
  if (!status.ok()) return status;
  return field;
}

absl::StatusOr<Field> Client::StreamField(
    const FieldQuery& query, const SettledCallback& on_settled,
    const CallOptions& options, const SolveProgressCallback& progress) {
  auto request = MakeRequest<v1::ComputeFieldRequest>(query);
  if (request.ok()) request->set_progressive(true);
  Field field;
  std::vector<uint32_t> vertices;
  std::vector<double> distances;
  uint64_t received = 0;
  AnswerReader reader;
  reader.Collect("settled_vertex", {AnswerReader::kAny}, &vertices);
  reader.Collect("settled_distance", {AnswerReader::kAny}, &distances);
  CollectTargets(query, &reader, &field);
  const auto take = [&]() -> absl::Status {
    std::vector<SettledVertex> settled;
    for (size_t i = 0; i < std::min(vertices.size(), distances.size()); ++i) {
      settled.push_back({vertices[i], distances[i]});
    }
    received += settled.size();
    if (received > reader.header().vertex_count()) {
      return absl::DataLossError("the server settled more than all vertices");
    }
    DropFront(settled.size(), &vertices);
    DropFront(settled.size(), &distances);
    if (!settled.empty()) on_settled(settled);
    return absl::OkStatus();
  };
  absl::Status status =
      connection_->Ask(&Questions::ComputeField, std::move(request), options,
                       ReportTo(progress), &reader, &field, take);
  if (!status.ok()) return status;
  return field;
}

}  // namespace geodesic::client
