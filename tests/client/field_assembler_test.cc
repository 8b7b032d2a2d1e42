#include "client/src/field_assembler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using v1::ComputeFieldResponse;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ComputeFieldResponse Accepted(uint64_t vertex_count) {
  ComputeFieldResponse message;
  message.mutable_header()->set_vertex_count(vertex_count);
  message.mutable_header()->set_mesh_digest("abc");
  message.mutable_header()->set_algorithm(v1::ALGORITHM_FWP_MMP);
  return message;
}

ComputeFieldResponse Chunk(uint64_t offset, const std::vector<double>& values) {
  ComputeFieldResponse message;
  message.mutable_chunk()->set_offset(offset);
  message.mutable_chunk()->set_distances(
      std::string(reinterpret_cast<const char*>(values.data()),
                  values.size() * sizeof(double)));
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

class FieldAssemblerTest : public ::testing::Test {
 protected:
  absl::Status Consume(const ComputeFieldResponse& message) {
    return assembler_.Consume(message);
  }

  void ExpectDataLoss(const absl::Status& status, const std::string& words) {
    EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr(words));
  }

  std::vector<SolveProgress> progress_;
  FieldAssembler assembler_{{}, [this](const SolveProgress& progress) {
                              progress_.push_back(progress);
                            }};
};

TEST_F(FieldAssemblerTest, PutsChunksTogether) {
  ASSERT_TRUE(Consume(Accepted(4)).ok());
  ASSERT_TRUE(Consume(Chunk(0, {0, 1.5})).ok());
  ASSERT_TRUE(Consume(Chunk(2, {kInfinity, 2.25})).ok());
  ASSERT_TRUE(Consume(Trailer()).ok());
  absl::StatusOr<Field> field = std::move(assembler_).Finish();
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0, 1.5, kInfinity, 2.25));
  EXPECT_EQ(field->mesh_digest, "abc");
  EXPECT_EQ(field->algorithm, "fwp-mmp");
  EXPECT_EQ(field->origin, FieldOrigin::kCached);
  EXPECT_EQ(field->statistics.iterations, 7);
  EXPECT_EQ(field->relative_tolerance, 1e-10);
  EXPECT_EQ(field->server_version, "1.2.3");
}

ComputeFieldResponse NamedChunk(uint64_t offset,
                                const std::vector<double>& values) {
  ComputeFieldResponse message = Chunk(offset, values);
  message.mutable_chunk()->set_field_id("the field");
  return message;
}

TEST_F(FieldAssemblerTest, ReadsOnWhereAStreamBroke) {
  ASSERT_TRUE(Consume(Accepted(4)).ok());
  ASSERT_TRUE(Consume(NamedChunk(0, {0, 1.5})).ok());
  ASSERT_TRUE(Consume(Chunk(2, {2})).ok());
  const FieldAssembler::Position position = assembler_.Resume();
  EXPECT_EQ(position.field_id, "the field");
  EXPECT_EQ(position.first_vertex, 3);
  EXPECT_FALSE(assembler_.has_header());
  ASSERT_TRUE(Consume(Accepted(4)).ok());
  ASSERT_TRUE(Consume(NamedChunk(3, {7})).ok());
  ASSERT_TRUE(Consume(Trailer()).ok());
  absl::StatusOr<Field> field = std::move(assembler_).Finish();
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0, 1.5, 2, 7));
}

TEST_F(FieldAssemblerTest, WhatHasNoNameIsReadFromTheStart) {
  ASSERT_TRUE(Consume(Accepted(4)).ok());
  ASSERT_TRUE(Consume(Chunk(0, {0, 1.5})).ok());
  EXPECT_EQ(assembler_.Resume().field_id, "");
  EXPECT_EQ(assembler_.received(), 0);
  ASSERT_TRUE(Consume(Accepted(4)).ok());
  ExpectDataLoss(Consume(Chunk(2, {2})), "from vertex 0 were due");
}

TEST_F(FieldAssemblerTest, AFieldIsNotReadOnWithAnother) {
  ASSERT_TRUE(Consume(Accepted(4)).ok());
  ASSERT_TRUE(Consume(NamedChunk(0, {0, 1.5})).ok());
  assembler_.Resume();
  ExpectDataLoss(Consume(Accepted(1)), "another field");
}

TEST_F(FieldAssemblerTest, ReportsProgress) {
  ASSERT_TRUE(Consume(Accepted(10)).ok());
  ComputeFieldResponse message;
  message.mutable_progress()->set_settled_radius(0.5);
  message.mutable_progress()->set_vertices_reached(4);
  ASSERT_TRUE(Consume(message).ok());
  ASSERT_EQ(progress_.size(), 1);
  EXPECT_EQ(progress_[0].settled_radius, 0.5);
  EXPECT_EQ(progress_[0].vertices_reached, 4);
  EXPECT_EQ(progress_[0].vertex_count, 10);
}

template <typename Number>
std::string Bytes(const std::vector<Number>& numbers) {
  return std::string(reinterpret_cast<const char*>(numbers.data()),
                     numbers.size() * sizeof(Number));
}

// The field that these messages make, or why there is none.
absl::StatusOr<Field> Assembled(
    const FieldExpectation& expected,
    const std::vector<ComputeFieldResponse>& messages) {
  FieldAssembler assembler(expected, nullptr);
  for (const ComputeFieldResponse& message : messages) {
    absl::Status status = assembler.Consume(message);
    if (!status.ok()) return status;
  }
  return std::move(assembler).Finish();
}

TEST_F(FieldAssemblerTest, TakesQuantitiesAndTargets) {
  ComputeFieldResponse chunk = Chunk(0, {1, 2});
  chunk.mutable_chunk()->set_nearest_sources(Bytes<uint32_t>({3, kNoSource}));
  chunk.mutable_chunk()->set_gradients(Bytes<double>({1, 0, 0, 0, 0.5, 0}));
  ComputeFieldResponse targets;
  targets.mutable_targets()->set_distances(Bytes<double>({0.25}));
  ComputeFieldResponse trailer = Trailer();
  trailer.mutable_trailer()->set_settled_radius(2);
  const FieldExpectation expected = {
      .nearest_sources = true, .gradients = true, .target_count = 1};
  absl::StatusOr<Field> field =
      Assembled(expected, {Accepted(2), chunk, targets, trailer});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->nearest_sources, ElementsAre(3, kNoSource));
  EXPECT_EQ(field->gradients[1], (std::array<double, 3>{0, 0.5, 0}));
  EXPECT_THAT(field->target_distances, ElementsAre(0.25));
  EXPECT_EQ(field->settled_radius, 2);
  // What was asked for and is missing, and what was not.
  ExpectDataLoss(
      Assembled(expected, {Accepted(2), Chunk(0, {1, 2}), targets, trailer})
          .status(),
      "0 of 2 nearest sources");
  ExpectDataLoss(Assembled(expected, {Accepted(2), chunk, trailer}).status(),
                 "0 of 1 target");
  ExpectDataLoss(Assembled({}, {Accepted(2), chunk, trailer}).status(),
                 "nearest sources");
}

TEST_F(FieldAssemblerTest, WidensFloats) {
  ComputeFieldResponse chunk;
  chunk.mutable_chunk()->set_distances(Bytes<float>({0.5F, 0.1F}));
  absl::StatusOr<Field> field = Assembled({.value_type = ValueType::kFloat32},
                                          {Accepted(2), chunk, Trailer()});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0.5, double{0.1F}));
}

TEST_F(FieldAssemblerTest, HandsOutSettledVertices) {
  std::vector<std::pair<uint32_t, double>> seen;
  const FieldExpectation expected = {
      .on_settled = [&](std::span<const SettledVertex> settled) {
        for (const SettledVertex& vertex : settled) {
          seen.emplace_back(vertex.vertex, vertex.distance);
        }
      }};
  const auto settled = [](uint64_t offset,
                          const std::vector<uint32_t>& vertices,
                          const std::vector<double>& distances) {
    ComputeFieldResponse message;
    message.mutable_settled()->set_offset(offset);
    message.mutable_settled()->set_vertices(Bytes(vertices));
    message.mutable_settled()->set_distances(Bytes(distances));
    return message;
  };
  absl::StatusOr<Field> field =
      Assembled(expected, {Accepted(4), settled(0, {2, 0}, {0, 1}),
                           settled(2, {3}, {1.5}), Trailer()});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(field->vertex_count, 4);
  EXPECT_TRUE(field->distances.empty());
  EXPECT_THAT(seen, ElementsAre(std::pair(2U, 0.0), std::pair(0U, 1.0),
                                std::pair(3U, 1.5)));
  ExpectDataLoss(
      Assembled(expected, {Accepted(4), settled(1, {2}, {0})}).status(),
      "settled");
  ExpectDataLoss(
      Assembled(expected, {Accepted(4), settled(0, {2, 3}, {0})}).status(),
      "settled");
  ExpectDataLoss(Assembled({}, {Accepted(4), settled(0, {2}, {0})}).status(),
                 "settled");
}

TEST_F(FieldAssemblerTest, RefusesChunkBeforeAccepted) {
  ExpectDataLoss(Consume(Chunk(0, {1})), "without accepting");
}

TEST_F(FieldAssemblerTest, RefusesChunkAfterTrailer) {
  ASSERT_TRUE(Consume(Accepted(1)).ok());
  ASSERT_TRUE(Consume(Trailer()).ok());
  ExpectDataLoss(Consume(Chunk(0, {1})), "outside");
}

TEST_F(FieldAssemblerTest, RefusesGap) {
  ASSERT_TRUE(Consume(Accepted(4)).ok());
  ASSERT_TRUE(Consume(Chunk(0, {1})).ok());
  ExpectDataLoss(Consume(Chunk(2, {1})), "from vertex 2 where");
}

TEST_F(FieldAssemblerTest, RefusesMoreThanAnnounced) {
  ASSERT_TRUE(Consume(Accepted(2)).ok());
  ExpectDataLoss(Consume(Chunk(0, {1, 2, 3})), "more than the 2");
}

TEST_F(FieldAssemblerTest, RefusesHalfAValue) {
  ASSERT_TRUE(Consume(Accepted(2)).ok());
  ComputeFieldResponse message;
  message.mutable_chunk()->set_distances("0123456789");
  ExpectDataLoss(Consume(message), "part of a number");
}

TEST_F(FieldAssemblerTest, RefusesEarlyEnd) {
  ASSERT_TRUE(Consume(Accepted(2)).ok());
  ASSERT_TRUE(Consume(Chunk(0, {1})).ok());
  ASSERT_TRUE(Consume(Trailer()).ok());
  ExpectDataLoss(std::move(assembler_).Finish().status(), "1 of 2");
}

TEST_F(FieldAssemblerTest, RefusesMissingTrailer) {
  ASSERT_TRUE(Consume(Accepted(1)).ok());
  ASSERT_TRUE(Consume(Chunk(0, {1})).ok());
  ExpectDataLoss(std::move(assembler_).Finish().status(), "trailer");
}

TEST_F(FieldAssemblerTest, HugeVertexCountTakesNoMemory) {
  ASSERT_TRUE(Consume(Accepted(std::numeric_limits<uint64_t>::max())).ok());
  ASSERT_TRUE(Consume(Chunk(0, {1})).ok());
  ASSERT_TRUE(Consume(Trailer()).ok());
  ExpectDataLoss(std::move(assembler_).Finish().status(),
                 "1 of 18446744073709551615");
}

}  // namespace
}  // namespace geodesic::client
