// Client::ComputePairs, by as many calls as the server's limits ask for.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "ask.h"
#include "connection.h"
#include "geodesic_client/errors.h"
#include "lines.h"
#include "rpc_status.h"
#include "translate.h"

namespace geodesic::client {
namespace {

// The most bytes of a pair on the wire, and of the rest of a request.
constexpr uint64_t kVertexPairBytes = 2 * sizeof(uint32_t);
constexpr uint64_t kPairBytes = 96;
constexpr uint64_t kRequestBytes = 256;

// Whether the pairs can travel in the short form.
bool AreVertices(std::span<const PointPair> pairs) {
  return std::ranges::all_of(pairs, [](const PointPair& pair) {
    return AsVertex(pair.source) != nullptr && AsVertex(pair.target) != nullptr;
  });
}

absl::StatusOr<v1::ComputePairsRequest> MakePairRequest(
    const PairQuery& query, std::span<const PointPair> pairs) {
  auto made = MakeRequest<v1::ComputePairsRequest>(query);
  if (!made.ok()) return made;
  v1::ComputePairsRequest& request = *made;
  const bool are_vertices = AreVertices(pairs);
  for (const PointPair& pair : pairs) {
    if (are_vertices) {
      request.add_vertex_pairs(AsVertex(pair.source)->vertex);
      request.add_vertex_pairs(AsVertex(pair.target)->vertex);
    } else {
      v1::PointPair& message = *request.add_pairs();
      *message.mutable_source() = codec::ToProto(pair.source);
      *message.mutable_target() = codec::ToProto(pair.target);
    }
  }
  return made;
}

// How many of the pairs one call takes.
uint64_t PairsPerCall(std::span<const PointPair> pairs,
                      const ServerLimits& limits) {
  const uint64_t bytes = AreVertices(pairs) ? kVertexPairBytes : kPairBytes;
  const uint64_t room = limits.max_message_bytes -
                        std::min(limits.max_message_bytes, kRequestBytes);
  return std::max<uint64_t>(1, std::min(limits.max_pairs, room / bytes));
}

// The server numbers the pairs of one call; the caller knows others before
// them.
absl::Status Renumbered(const absl::Status& status, uint64_t first) {
  const std::string kPairs = "pairs[";
  const std::string field = ErrorField(status);
  const size_t end = field.find(']');
  uint64_t number = 0;
  if (first == 0 || !field.starts_with(kPairs) || end == std::string::npos ||
      !absl::SimpleAtoi(field.substr(kPairs.size(), end - kPairs.size()),
                        &number)) {
    return status;
  }
  return RenameField(status, field.substr(0, end + 1),
                     absl::StrCat(kPairs, first + number, "]"));
}

}  // namespace

absl::StatusOr<PairSummary> Client::ComputePairs(const PairQuery& query,
                                                 const PairReceiver& receiver,
                                                 const CallOptions& options) {
  const std::span<const PointPair> pairs = query.pairs;
  uint64_t per_call = 1;
  if (pairs.size() > 1) {
    absl::StatusOr<Capabilities> server = GetCapabilities(options);
    if (!server.ok()) return server.status();
    per_call = PairsPerCall(pairs, server->limits);
  }
  PairSummary summary;
  uint64_t first = 0;
  do {
    const auto some = pairs.subspan(
        first, std::min<uint64_t>(per_call, pairs.size() - first));
    const auto count = static_cast<int64_t>(some.size());
    codec::AnswerReader reader;
    std::vector<double> distances;
    reader.Collect("distance", {count}, &distances);
    std::optional<Lines> lines;
    if (query.paths) lines.emplace(count, &reader);
    uint64_t received = first;
    uint64_t pair = first;  // whose path is due
    PairSummary of_call;
    const absl::Status status = connection_->Ask(
        &Questions::ComputePairs, MakePairRequest(query, some), options,
        ReportTo(receiver.on_progress, pairs.size(), first), &reader,
        &of_call.info, [&]() -> absl::Status {
          const uint64_t number = received;
          received += distances.size();
          absl::Status taken = distances.empty()
                                   ? absl::OkStatus()
                                   : receiver.on_distances(number, distances);
          distances.clear();
          if (!taken.ok() || !lines.has_value()) return taken;
          return lines->Take(
              [&](Polyline path) {
                return receiver.on_path(pair++, std::move(path));
              },
              received - first);
        });
    if (!status.ok()) return Renumbered(status, first);
    const v1::PairCounts& counts = reader.trailer().pairs();
    of_call.searched = counts.searched();
    of_call.from_fields = counts.from_fields();
    of_call.from_cache = counts.from_cache();
    summary.Add(of_call);
    first += some.size();
  } while (first < pairs.size());
  return summary;
}

absl::StatusOr<PairAnswer> Client::ComputePairs(
    const PairQuery& query, const CallOptions& options,
    const CountProgressCallback& progress) {
  PairAnswer answer;
  const PairReceiver receiver = {
      .on_distances =
          [&answer](uint64_t, std::span<const double> distances) {
            answer.distances.insert(answer.distances.end(), distances.begin(),
                                    distances.end());
            return absl::OkStatus();
          },
      .on_path =
          [&answer](uint64_t, Polyline path) {
            answer.paths.push_back(std::move(path));
            return absl::OkStatus();
          },
      .on_progress = progress};
  absl::StatusOr<PairSummary> summary = ComputePairs(query, receiver, options);
  if (!summary.ok()) return summary.status();
  answer.summary = *std::move(summary);
  return answer;
}

}  // namespace geodesic::client
