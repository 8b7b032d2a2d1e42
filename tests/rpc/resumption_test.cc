// Reading on where the stream of an answer broke.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "codec/value_type.h"
#include "tests/rpc/questions_fixture.h"

namespace geodesic::server {
namespace {

using test::Reply;

class ResumptionTest : public test::QuestionsTest {
 protected:
  static constexpr uint32_t kLong = 5000;  // cells

  void Use(const TriangleSoup& soup) { digest_ = Upload(soup); }
  // A strip, along which lines have many points.
  void UseStrip() {
    Use(geodesic::test::MakeGrid({.columns = kLong, .rows = 1}));
  }
  // One with so many vertices that their numbers take several messages; most
  // are on no face, so that answers take little time.
  void UseManyVertices() {
    TriangleSoup soup =
        geodesic::test::MakeGrid({.columns = 10, .rows = 10, .jitter = 0.2});
    soup.positions.resize(40'000, {5, 5, 5});
    Use(soup);
  }
  void UseLargeGrid() {
    Use(geodesic::test::MakeGrid({.columns = 100, .rows = 100}));
  }

  // That an answer can be read on after any message and amid any block, but not
  // beyond its end, and no other one instead.
  template <typename Request>
  void ExpectResumes(Request request) {
    SCOPED_TRACE(request.GetTypeName());
    const Reply whole = Answered(request);
    const auto& arrays = whole.header().arrays();
    std::vector<uint64_t> received(arrays.size());
    request.mutable_resumption()->set_answer_id(whole.answer_id());
    const auto set_received = [&] {
      request.mutable_resumption()->mutable_received()->Assign(received.begin(),
                                                               received.end());
    };
    const auto expect_rest = [&] {
      set_received();
      ExpectRest(whole, Answered(request), received);
    };
    for (const v1::Answer& message : whole.messages) {
      for (const v1::Block& block : message.blocks()) {
        const uint64_t count =
            block.values().size() / codec::SizeOf(arrays[block.array()].type());
        received[block.array()] += count / 2;
        expect_rest();
        received[block.array()] += count - count / 2;
      }
      expect_rest();
    }
    for (uint64_t& count : received) {
      ++count;
      set_received();
      EXPECT_EQ(test::FieldAtFault(Ask(request).status), "resumption.received");
      --count;
    }
    received.push_back(0);
    set_received();
    EXPECT_EQ(test::FieldAtFault(Ask(request).status), "resumption.received");
    request.mutable_resumption()->clear_received();
    ExpectRest(whole, Answered(request), std::vector<uint64_t>(arrays.size()));
    request.mutable_resumption()->set_answer_id(std::string(64, 'a'));
    ExpectNotKept(request);
  }

  static void ExpectRest(const Reply& whole, const Reply& rest,
                         const std::vector<uint64_t>& received) {
    ASSERT_EQ(rest.header().arrays_size(), received.size());
    for (size_t i = 0; i < received.size(); ++i) {
      const v1::ArrayInfo& array = whole.header().arrays(i);
      SCOPED_TRACE(testing::Message() << array.name() << ' ' << received[i]);
      EXPECT_EQ(rest.header().arrays(i).SerializeAsString(),
                array.SerializeAsString());
      EXPECT_TRUE(
          rest.Bytes(i) ==
          whole.Bytes(i).substr(received[i] * codec::SizeOf(array.type())));
    }
    if (rest.pieces() > 0) {
      EXPECT_EQ(rest.answer_id(), whole.answer_id());
    }
  }

  template <typename Request>
  void ExpectNotKept(const Request& request) {
    const grpc::Status status = Ask(request).status;
    EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
    EXPECT_EQ(test::Reason(status), "ANSWER_NOT_KEPT");
  }

  v1::ComputeFieldRequest Field() const {
    auto request = From<v1::ComputeFieldRequest>(0);
    request.add_sources()->set_vertex(100);
    request.add_quantities(v1::FIELD_QUANTITY_NEAREST_SOURCE);
    request.add_quantities(v1::FIELD_QUANTITY_GRADIENT);
    request.add_vertex_targets(50);
    return request;
  }
};

TEST_F(ResumptionTest, OfFields) {
  UseManyVertices();
  ExpectResumes(Field());
}

TEST_F(ResumptionTest, OfLogMaps) {
  UseManyVertices();
  ExpectResumes(From<v1::ComputeLogMapRequest>(5));
}

TEST_F(ResumptionTest, OfPaths) {
  UseStrip();
  auto request = From<v1::ComputePathsRequest>(0);
  for (const uint32_t target : {2 * kLong + 1, kLong / 2, 7u}) {
    request.add_vertex_targets(target);
  }
  EXPECT_GT(Answered(request).pieces(), 1);
  ExpectResumes(request);
  // From a field, and one target that has no path.
  request.set_radius(kLong * 0.75);
  ExpectResumes(request);
}

TEST_F(ResumptionTest, OfPairs) {
  UseStrip();
  v1::ComputePairsRequest request;
  request.set_mesh_digest(digest_);
  for (uint32_t i = 0; i < 4; ++i) {
    request.add_vertex_pairs(i);
    request.add_vertex_pairs(2 * kLong + 1 - i);
  }
  request.set_paths(true);
  ExpectResumes(request);
  request.set_paths(false);
  ExpectResumes(request);
  request.set_value_type(v1::VALUE_TYPE_FLOAT32);
  ExpectResumes(request);
}

TEST_F(ResumptionTest, OfMatrices) {
  UseLargeGrid();
  auto request = From<v1::ComputeMatrixRequest>(0);
  for (uint32_t i = 1; i < 10; ++i) request.add_sources()->set_vertex(i * 777);
  ExpectResumes(request);
  request.set_radius(60);
  request.set_layout(v1::MATRIX_LAYOUT_SPARSE);
  ExpectResumes(request);
}

TEST_F(ResumptionTest, RowsThatHaveComeAreNotComputedAgain) {
  UseLargeGrid();
  auto request = From<v1::ComputeMatrixRequest>(0);
  for (uint32_t i = 1; i < 4; ++i) request.add_sources()->set_vertex(i * 777);
  const Reply whole = Answered(request);
  request.mutable_resumption()->set_answer_id(whole.answer_id());
  // Three of four rows, and a number of the last.
  const uint64_t row = 101 * 101;
  request.mutable_resumption()->add_received(3 * row + 1);
  const Reply rest = Answered(request);
  EXPECT_GT(rest.trailer().windows_propagated(), 0);
  EXPECT_LT(2 * rest.trailer().windows_propagated(),
            whole.trailer().windows_propagated());
}

// As far off as was allowed, though the rows that are left are less so.
TEST_F(ResumptionTest, RowsThatHaveComeAreCertifiedToTheTolerance) {
  UseLargeGrid();
  auto request = From<v1::ComputeMatrixRequest>(0);
  for (uint32_t i = 1; i < 4; ++i) request.add_sources()->set_vertex(i * 777);
  request.set_tolerance(0.01);
  const Reply whole = Answered(request);
  EXPECT_LT(whole.trailer().certified_error(), 0.01);
  request.mutable_resumption()->set_answer_id(whole.answer_id());
  request.mutable_resumption()->add_received(3 * 101 * 101);
  EXPECT_EQ(Answered(request).trailer().certified_error(), 0.01);
}

TEST_F(ResumptionTest, OfNearestTargets) {
  v1::FindNearestRequest request;
  request.set_mesh_digest(digest_);
  for (uint32_t i = 0; i < 100; ++i) {
    request.add_vertex_sources(i);
    request.add_vertex_targets(120 - i);
  }
  request.set_count(40);
  ExpectResumes(request);
}

TEST_F(ResumptionTest, OfIsolines) {
  UseLargeGrid();
  auto request = From<v1::ComputeIsolinesRequest>(50 * 101 + 50);
  for (const double level : {10, 30, 60}) request.add_levels(level);
  request.set_chord_error(1e-6);
  ExpectResumes(request);
}

TEST_F(ResumptionTest, OfSamples) {
  auto request = From<v1::SampleFarthestPointsRequest>(0);
  request.set_count(20);
  ExpectResumes(request);
}

TEST_F(ResumptionTest, WhatWasCutStaysCut) {
  v1::ComputeFieldRequest request = Field();
  Answered(request);  // the cache has more than is asked for
  request.set_radius(3.5);
  const Reply whole = Answered(request);
  EXPECT_EQ(whole.trailer().settled_radius(), 3.5);
  request.mutable_resumption()->set_answer_id(whole.answer_id());
  request.mutable_resumption()->add_received(soup_.positions.size());
  const Reply rest = Answered(request);
  EXPECT_EQ(rest.trailer().settled_radius(), 3.5);
  EXPECT_EQ(rest.trailer().origin(), v1::ANSWER_ORIGIN_CACHED);
}

TEST_F(ResumptionTest, NothingIsComputedForAnotherQuestion) {
  v1::ComputeFieldRequest request = Field();
  const std::string answer_id = Answered(request).answer_id();
  request.mutable_resumption()->set_answer_id(answer_id);
  const uint64_t solves = server_->engine().counters().solves_started;
  v1::ComputeFieldRequest other = request;
  other.set_value_type(v1::VALUE_TYPE_FLOAT32);
  ExpectNotKept(other);
  other = request;
  other.add_sources()->set_vertex(7);
  ExpectNotKept(other);
  EXPECT_EQ(server_->engine().counters().solves_started, solves);
}

TEST_F(ResumptionTest, AProgressiveFieldHasNone) {
  v1::ComputeFieldRequest request = Field();
  const std::string answer_id = Answered(request).answer_id();
  request.mutable_resumption()->set_answer_id(answer_id);
  request.clear_quantities();
  request.set_progressive(true);
  EXPECT_EQ(Fault(request), "resumption");
}

TEST_F(ResumptionTest, TheNameDependsOnTheQuestionAndNotOnItsPriority) {
  const std::string name = Answered(Field()).answer_id();
  v1::ComputeFieldRequest request = Field();
  request.set_priority(v1::PRIORITY_BATCH);
  EXPECT_EQ(Answered(request).answer_id(), name);
  request.mutable_sources(0)->set_vertex(1);
  EXPECT_NE(Answered(request).answer_id(), name);
}

}  // namespace
}  // namespace geodesic::server
