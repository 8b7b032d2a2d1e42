#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "client/src/assemblers.h"
#include "tests/client/wire_bytes.h"

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;
using v1::ComputeFieldResponse;
using Messages = std::vector<ComputeFieldResponse>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ComputeFieldResponse Accepted(uint64_t vertex_count) {
  ComputeFieldResponse message;
  message.mutable_header()->set_vertex_count(vertex_count);
  message.mutable_header()->set_mesh_digest("abc");
  message.mutable_header()->set_algorithm(v1::ALGORITHM_FWP_MMP);
  return message;
}

ComputeFieldResponse Chunk(uint64_t offset, const std::vector<double>& values,
                           const std::string& field_id = "") {
  ComputeFieldResponse message;
  message.mutable_chunk()->set_offset(offset);
  message.mutable_chunk()->set_distances(Bytes(values));
  message.mutable_chunk()->set_field_id(field_id);
  return message;
}

ComputeFieldResponse Settled(uint64_t offset,
                             const std::vector<uint32_t>& vertices,
                             const std::vector<double>& distances) {
  ComputeFieldResponse message;
  message.mutable_settled()->set_offset(offset);
  message.mutable_settled()->set_vertices(Bytes(vertices));
  message.mutable_settled()->set_distances(Bytes(distances));
  return message;
}

ComputeFieldResponse Trailer() {
  ComputeFieldResponse message;
  message.mutable_trailer()->set_origin(v1::FIELD_ORIGIN_CACHED);
  message.mutable_trailer()->mutable_statistics()->set_iterations(7);
  message.mutable_trailer()->set_relative_tolerance(1e-10);
  message.mutable_trailer()->set_server_version("1.2.3");
  return message;
}

// Takes the messages; the first status that is not OK.
absl::Status Consume(const Messages& messages, FieldAssembler* assembler) {
  absl::Status status;
  for (const ComputeFieldResponse& message : messages) {
    status.Update(assembler->Consume(message));
  }
  return status;
}

// The field that these messages make, or why there is none.
absl::StatusOr<Field> Assembled(const Messages& messages,
                                const FieldQuery& query = {},
                                const SettledCallback& on_settled = nullptr) {
  FieldAssembler assembler(query, on_settled, nullptr);
  absl::Status status = Consume(messages, &assembler);
  if (!status.ok()) return status;
  return std::move(assembler).Finish();
}

TEST(FieldAssemblerTest, PutsChunksTogether) {
  const absl::StatusOr<Field> field =
      Assembled({Accepted(4), Chunk(0, {0, 1.5}), Chunk(2, {kInfinity, 2.25}),
                 Trailer()});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0, 1.5, kInfinity, 2.25));
  EXPECT_EQ(field->mesh_digest, "abc");
  EXPECT_EQ(field->algorithm, "fwp-mmp");
  EXPECT_EQ(field->origin, FieldOrigin::kCached);
  EXPECT_EQ(field->statistics.iterations, 7);
  EXPECT_EQ(field->relative_tolerance, 1e-10);
  EXPECT_EQ(field->server_version, "1.2.3");
}

class BrokenStreamTest : public ::testing::Test {
 protected:
  const FieldQuery query_;
  FieldAssembler assembler_{query_, nullptr, nullptr};
};

TEST_F(BrokenStreamTest, IsReadOn) {
  ASSERT_TRUE(
      Consume({Accepted(4), Chunk(0, {0, 1.5}, "the field"), Chunk(2, {2})},
              &assembler_)
          .ok());
  const FieldAssembler::Position position = assembler_.Resume();
  EXPECT_EQ(position.field_id, "the field");
  EXPECT_EQ(position.first_vertex, 3);
  EXPECT_FALSE(assembler_.has_header());
  ASSERT_TRUE(
      Consume({Accepted(4), Chunk(3, {7}, "the field"), Trailer()}, &assembler_)
          .ok());
  const absl::StatusOr<Field> field = std::move(assembler_).Finish();
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0, 1.5, 2, 7));
}

TEST_F(BrokenStreamTest, WhatHasNoNameIsReadFromTheStart) {
  ASSERT_TRUE(Consume({Accepted(4), Chunk(0, {0, 1.5})}, &assembler_).ok());
  EXPECT_EQ(assembler_.Resume().field_id, "");
  EXPECT_EQ(assembler_.received(), 0);
  ExpectDataLoss(Consume({Accepted(4), Chunk(2, {2})}, &assembler_),
                 "from vertex 0 were due");
}

TEST_F(BrokenStreamTest, IsNotReadOnWithAnotherField) {
  ASSERT_TRUE(
      Consume({Accepted(4), Chunk(0, {0, 1.5}, "the field")}, &assembler_)
          .ok());
  assembler_.Resume();
  ExpectDataLoss(Consume({Accepted(1)}, &assembler_), "another field");
}

TEST(FieldAssemblerTest, ReportsProgress) {
  ComputeFieldResponse message;
  message.mutable_progress()->set_settled_radius(0.5);
  message.mutable_progress()->set_vertices_reached(4);
  std::vector<SolveProgress> seen;
  const FieldQuery query;
  FieldAssembler assembler(query, nullptr, [&](const SolveProgress& progress) {
    seen.push_back(progress);
  });
  ASSERT_TRUE(Consume({Accepted(10), message}, &assembler).ok());
  ASSERT_EQ(seen.size(), 1);
  EXPECT_EQ(seen[0].settled_radius, 0.5);
  EXPECT_EQ(seen[0].vertices_reached, 4);
  EXPECT_EQ(seen[0].vertex_count, 10);
}

TEST(FieldAssemblerTest, TakesQuantitiesAndTargets) {
  ComputeFieldResponse chunk = Chunk(0, {1, 2});
  chunk.mutable_chunk()->set_nearest_sources(Bytes<uint32_t>({3, kNoSource}));
  chunk.mutable_chunk()->set_gradients(Bytes<double>({1, 0, 0, 0, 0.5, 0}));
  ComputeFieldResponse targets;
  targets.mutable_targets()->set_distances(Bytes<double>({0.25}));
  ComputeFieldResponse trailer = Trailer();
  trailer.mutable_trailer()->set_settled_radius(2);
  const FieldQuery query = {
      .targets = {VertexPoint{0}}, .nearest_sources = true, .gradients = true};
  const absl::StatusOr<Field> field =
      Assembled({Accepted(2), chunk, targets, trailer}, query);
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->nearest_sources, ElementsAre(3, kNoSource));
  EXPECT_EQ(field->gradients[1], (std::array<double, 3>{0, 0.5, 0}));
  EXPECT_THAT(field->target_distances, ElementsAre(0.25));
  EXPECT_EQ(field->settled_radius, 2);
  // What was asked for and is missing, and what was not.
  ExpectDataLoss(
      Assembled({Accepted(2), Chunk(0, {1, 2}), targets, trailer}, query)
          .status(),
      "0 of 2 nearest sources");
  ExpectDataLoss(Assembled({Accepted(2), chunk, trailer}, query).status(),
                 "0 of 1 target");
  ExpectDataLoss(Assembled({Accepted(2), chunk, trailer}).status(),
                 "nearest sources");
}

TEST(FieldAssemblerTest, WidensFloats) {
  ComputeFieldResponse chunk;
  chunk.mutable_chunk()->set_distances(Bytes<float>({0.5F, 0.1F}));
  chunk.mutable_chunk()->set_gradients(Bytes<float>({1, 0, 0, 0, 0.1F, 0}));
  const absl::StatusOr<Field> field =
      Assembled({Accepted(2), chunk, Trailer()},
                {.gradients = true, .value_type = ValueType::kFloat32});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0.5, double{0.1F}));
  EXPECT_EQ(field->gradients[1], (std::array<double, 3>{0, 0.1F, 0}));
}

TEST(FieldAssemblerTest, HandsOutSettledVertices) {
  std::vector<std::pair<uint32_t, double>> seen;
  const auto on_settled = [&](std::span<const SettledVertex> settled) {
    for (const SettledVertex& vertex : settled) {
      seen.emplace_back(vertex.vertex, vertex.distance);
    }
  };
  const absl::StatusOr<Field> field =
      Assembled({Accepted(4), Settled(0, {2, 0}, {0, 1}),
                 Settled(2, {3}, {1.5}), Trailer()},
                {}, on_settled);
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(field->vertex_count, 4);
  EXPECT_TRUE(field->distances.empty());
  EXPECT_THAT(seen, ElementsAre(std::pair(2U, 0.0), std::pair(0U, 1.0),
                                std::pair(3U, 1.5)));
  for (const ComputeFieldResponse& wrong :
       {Settled(1, {2}, {0}), Settled(0, {2, 3}, {0})}) {
    ExpectDataLoss(Assembled({Accepted(4), wrong}, {}, on_settled).status(),
                   "settled");
  }
  ExpectDataLoss(Assembled({Accepted(4), Settled(0, {2}, {0})}).status(),
                 "settled");
}

TEST(FieldAssemblerTest, RefusesWhatIsNotDue) {
  ComputeFieldResponse half;
  half.mutable_chunk()->set_distances("0123456789");
  ComputeFieldResponse two_thirds = Chunk(0, {1});
  two_thirds.mutable_chunk()->set_gradients(Bytes<double>({1, 0}));
  // A count that is no reason to take memory.
  constexpr uint64_t kHuge = std::numeric_limits<uint64_t>::max();
  const std::vector<std::pair<Messages, std::string>> table = {
      {{Chunk(0, {1})}, "without accepting"},
      {{Accepted(1), Trailer(), Chunk(0, {1})}, "outside"},
      {{Accepted(4), Chunk(0, {1}), Chunk(2, {1})}, "from vertex 2 where"},
      {{Accepted(2), Chunk(0, {1, 2, 3})}, "more than the 2"},
      {{Accepted(2), half}, "part of a number"},
      {{Accepted(2), two_thirds}, "part of a number"},
      {{Accepted(2), Chunk(0, {1}), Trailer()}, "1 of 2"},
      {{Accepted(1), Chunk(0, {1})}, "trailer"},
      {{Accepted(kHuge), Chunk(0, {1}), Trailer()},
       "1 of 18446744073709551615"}};
  for (const auto& [messages, words] : table) {
    ExpectDataLoss(Assembled(messages).status(), words);
  }
}

}  // namespace
}  // namespace geodesic::client
