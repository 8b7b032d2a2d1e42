// Client's questions beside fields and pairs.

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "ask.h"
#include "connection.h"
#include "lines.h"
#include "translate.h"

namespace geodesic::client {
namespace {

using codec::AnswerReader;

constexpr int64_t kAny = AnswerReader::kAny;

// Asks for the rows of a matrix, or of what is found for each source. `numbers`
// names the array of their columns or targets; empty if rows have a value in
// each column. Hands rows out as they arrive, or at the end unless `streamed`.
template <typename Connection, typename Request, typename Query>
absl::Status AskForRows(const Connection& connection,
                        Question<Request> question, const Query& query,
                        const CallOptions& options, std::string_view numbers,
                        bool streamed, const MatrixReceiver& receiver,
                        AnswerInfo* info) {
  AnswerReader reader;
  const uint64_t rows = query.sources.size();
  const uint64_t targets = query.targets.size();
  const bool is_sparse = !numbers.empty();
  Groups groups;
  std::vector<uint32_t> columns;
  std::vector<double> values;
  const auto row_dimension = static_cast<int64_t>(rows);
  if (is_sparse) {
    reader.Collect("row_end", {row_dimension}, &groups.ends);
    reader.Collect(numbers, {kAny}, &columns);
    reader.Collect("distance", {kAny}, &values);
  } else {
    reader.Collect(
        "distance",
        {row_dimension, targets == 0 ? AnswerReader::kVertices
                                     : static_cast<int64_t>(targets)},
        &values);
  }
  bool has_shape = receiver.on_shape == nullptr;
  const std::function<absl::Status()> take = [&]() -> absl::Status {
    const uint64_t width =
        targets == 0 ? reader.header().vertex_count() : targets;
    if (!std::exchange(has_shape, true)) {
      absl::Status status = receiver.on_shape({rows, width});
      if (!status.ok()) return status;
    }
    while (!is_sparse && groups.ends.size() < rows) {
      groups.ends.push_back((groups.ends.size() + 1) * width);
    }
    const auto taken = groups.Take(
        is_sparse ? std::min(columns.size(), values.size()) : values.size(),
        reader.has_trailer(), rows,
        [&](uint64_t row, size_t first, size_t size) {
          std::span<const uint32_t> numbers_of_row = columns;
          if (is_sparse) numbers_of_row = numbers_of_row.subspan(first, size);
          for (const uint32_t number : numbers_of_row) {
            if (number < width) continue;
            return absl::DataLossError(absl::StrCat("the server sent column ",
                                                    number, " of ", width,
                                                    " in row ", row));
          }
          return receiver.on_row(
              {row, numbers_of_row, std::span(values).subspan(first, size)});
        });
    if (!taken.ok()) return taken.status();
    DropFront(is_sparse ? *taken : 0, &columns);
    DropFront(*taken, &values);
    return absl::OkStatus();
  };
  absl::Status status =
      connection.Ask(question, MakeRequest<Request>(query), options,
                     ReportTo(receiver.on_progress, rows), &reader, info,
                     streamed ? take : nullptr);
  return status.ok() && !streamed ? take() : status;
}

}  // namespace

absl::StatusOr<PathAnswer> Client::ComputePaths(
    const PathQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  PathAnswer answer;
  const auto count = static_cast<int64_t>(query.targets.size());
  std::vector<uint32_t> sources;
  std::vector<double> distances;
  std::vector<double> lengths;
  AnswerReader reader;
  reader.Collect("source", {count}, &sources);
  reader.Collect("distance", {count}, &distances);
  reader.Collect("length", {count}, &lengths);
  Lines lines(count, &reader);
  absl::Status status = connection_->Ask(
      &Questions::ComputePaths, MakeRequest<v1::ComputePathsRequest>(query),
      options, ReportTo(progress), &reader, &answer.info);
  if (!status.ok()) return status;
  status = lines.Take([&](Polyline line) {
    const size_t i = answer.paths.size();
    GeodesicPath& path = answer.paths.emplace_back();
    if (sources[i] != kNoSource) path.source = sources[i];
    path.distance = distances[i];
    path.length = lengths[i];
    path.line = std::move(line);
    return absl::OkStatus();
  });
  if (!status.ok()) return status;
  return answer;
}

absl::StatusOr<IsolineAnswer> Client::ComputeIsolines(
    const IsolineQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  IsolineAnswer answer;
  std::vector<double> levels;
  std::vector<uint8_t> closed;
  AnswerReader reader;
  reader.Collect("level", {kAny}, &levels);
  reader.Collect("is_closed", {kAny}, &closed);
  Lines lines(kAny, &reader);
  absl::Status status =
      connection_->Ask(&Questions::ComputeIsolines,
                       MakeRequest<v1::ComputeIsolinesRequest>(query), options,
                       ReportTo(progress), &reader, &answer.info);
  if (!status.ok()) return status;
  status = lines.Take([&](Polyline line) {
    const size_t i = answer.isolines.size();
    answer.isolines.push_back({levels[i], closed[i] != 0, std::move(line)});
    return absl::OkStatus();
  });
  if (!status.ok()) return status;
  return answer;
}

absl::StatusOr<AnswerInfo> Client::ComputeMatrix(const MatrixQuery& query,
                                                 const MatrixReceiver& receiver,
                                                 const CallOptions& options) {
  AnswerInfo info;
  absl::Status status = AskForRows(*connection_, &Questions::ComputeMatrix,
                                   query, options, query.sparse ? "column" : "",
                                   /*streamed=*/true, receiver, &info);
  if (!status.ok()) return status;
  return info;
}

absl::StatusOr<NearestAnswer> Client::FindNearest(
    const NearestQuery& query, const CallOptions& options,
    const CountProgressCallback& progress) {
  NearestAnswer answer;
  const auto add = [&answer](const MatrixRow& row) {
    std::vector<NearestTarget>& found = answer.found.emplace_back();
    for (size_t i = 0; i < row.values.size(); ++i) {
      found.push_back({row.columns[i], row.values[i]});
    }
    return absl::OkStatus();
  };
  absl::Status status = AskForRows(
      *connection_, &Questions::FindNearest, query, options, "target",
      /*streamed=*/false, {.on_row = add, .on_progress = progress},
      &answer.info);
  if (!status.ok()) return status;
  return answer;
}

absl::StatusOr<SampleAnswer> Client::SampleFarthestPoints(
    const SampleQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  SampleAnswer answer;
  std::vector<uint32_t> vertices;
  std::vector<double> distances;
  AnswerReader reader;
  reader.Collect("vertex", {kAny}, &vertices);
  reader.Collect("distance", {kAny}, &distances);
  absl::Status status =
      connection_->Ask(&Questions::SampleFarthestPoints,
                       MakeRequest<v1::SampleFarthestPointsRequest>(query),
                       options, ReportTo(progress), &reader, &answer.info);
  if (!status.ok()) return status;
  for (size_t i = 0; i < vertices.size(); ++i) {
    answer.samples.push_back({vertices[i], distances[i]});
  }
  return answer;
}

absl::StatusOr<LineAnswer> Client::TraceLines(
    const LineQuery& query, const CallOptions& options,
    const CountProgressCallback& progress) {
  LineAnswer answer;
  std::vector<double> lengths;
  std::vector<uint8_t> ends;
  AnswerReader reader;
  reader.Collect("length", {kAny}, &lengths);
  reader.Collect("end", {kAny}, &ends);
  Lines lines(kAny, &reader);
  const size_t directions =
      std::visit([](const auto& all) { return all.size(); }, query.directions);
  const uint64_t count =
      std::max({query.sources.size(), directions, query.lengths.size()});
  absl::Status status = connection_->Ask(
      &Questions::TraceLines, MakeRequest<v1::TraceLinesRequest>(query),
      options, ReportTo(progress, count), &reader, &answer.info);
  if (!status.ok()) return status;
  status = lines.Take([&](Polyline line) -> absl::Status {
    const size_t i = answer.lines.size();
    if (ends[i] > static_cast<uint8_t>(TraceEnd::kSingular)) {
      return absl::DataLossError(
          absl::StrCat("the server sent a line with end ", ends[i]));
    }
    answer.lines.push_back(
        {std::move(line), lengths[i], static_cast<TraceEnd>(ends[i])});
    return absl::OkStatus();
  });
  if (!status.ok()) return status;
  return answer;
}

absl::StatusOr<LogMap> Client::ComputeLogMap(
    const LogMapQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  LogMap map;
  std::vector<double> direction;
  AnswerReader reader;
  reader.Collect("zero_direction", {3}, &direction);
  reader.Collect("coordinates", {AnswerReader::kVertices, 2}, &map.coordinates);
  absl::Status status = connection_->Ask(
      &Questions::ComputeLogMap, MakeRequest<v1::ComputeLogMapRequest>(query),
      options, ReportTo(progress), &reader, &map.info);
  if (!status.ok()) return status;
  std::ranges::copy(direction, map.zero_direction.begin());
  return map;
}

}  // namespace geodesic::client
