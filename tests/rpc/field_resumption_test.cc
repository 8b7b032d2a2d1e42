// Reading on where the stream of a field broke.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "tests/rpc/questions_fixture.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server {
namespace {

// The parts of a field's stream.
struct Parts {
  grpc::Status status;
  uint64_t first_vertex = 0;
  std::string field_id;
  std::string distances;
  std::string nearest_sources;
  std::string gradients;
  std::string targets;
  v1::FieldTrailer trailer;
};

class FieldResumptionTest : public test::RpcTest {
 protected:
  void SetUp() override {
    Start();
    digest_ = Upload(geodesic::test::Icosphere(5));
    request_ = FieldRequest(digest_, 0);
    request_.add_sources()->set_vertex(100);
    request_.add_quantities(v1::FIELD_QUANTITY_NEAREST_SOURCE);
    request_.add_quantities(v1::FIELD_QUANTITY_GRADIENT);
    request_.add_targets()->set_vertex(5000);
  }

  Parts Read(const v1::ComputeFieldRequest& request) {
    Parts parts;
    grpc::ClientContext context;
    const auto reader = fields_->ComputeField(&context, request);
    v1::ComputeFieldResponse message;
    bool has_chunk = false;
    while (reader->Read(&message)) {
      if (message.has_chunk()) {
        const v1::FieldChunk& chunk = message.chunk();
        // Named once.
        EXPECT_EQ(chunk.field_id().empty(), has_chunk);
        if (!has_chunk) {
          parts.first_vertex = chunk.offset();
          parts.field_id = chunk.field_id();
        }
        has_chunk = true;
        parts.distances += chunk.distances();
        parts.nearest_sources += chunk.nearest_sources();
        parts.gradients += chunk.gradients();
      }
      if (message.has_targets()) parts.targets += message.targets().distances();
      if (message.has_trailer()) parts.trailer = message.trailer();
    }
    parts.status = reader->Finish();
    return parts;
  }

  static v1::ComputeFieldRequest From(v1::ComputeFieldRequest request,
                                      const std::string& field_id,
                                      uint64_t first_vertex) {
    request.mutable_resumption()->set_field_id(field_id);
    request.mutable_resumption()->set_first_vertex(first_vertex);
    return request;
  }

  static constexpr uint64_t kVertices = 10242;

  std::string digest_;
  v1::ComputeFieldRequest request_;
};

TEST_F(FieldResumptionTest, TheRestIsBitByBitTheRest) {
  const Parts whole = Read(request_);
  ASSERT_TRUE(whole.status.ok()) << whole.status.error_message();
  ASSERT_EQ(whole.distances.size(), kVertices * 8);
  for (const uint64_t first :
       {uint64_t{0}, uint64_t{1}, uint64_t{6000}, kVertices - 1, kVertices}) {
    const Parts rest = Read(From(request_, whole.field_id, first));
    ASSERT_TRUE(rest.status.ok()) << rest.status.error_message();
    EXPECT_EQ(rest.distances, whole.distances.substr(first * 8));
    EXPECT_EQ(rest.nearest_sources, whole.nearest_sources.substr(first * 4));
    EXPECT_EQ(rest.gradients, whole.gradients.substr(first * 24));
    EXPECT_EQ(rest.targets, whole.targets);
    EXPECT_EQ(rest.trailer.origin(), v1::FIELD_ORIGIN_CACHED);
    if (first < kVertices) {
      EXPECT_EQ(rest.first_vertex, first);
      EXPECT_EQ(rest.field_id, whole.field_id);
    }
  }
}

TEST_F(FieldResumptionTest, WhatWasCutStaysCut) {
  request_.set_radius(0.5);
  // The cache has more than is asked for.
  v1::ComputeFieldRequest further = request_;
  further.clear_radius();
  ASSERT_TRUE(Read(further).status.ok());
  const Parts whole = Read(request_);
  ASSERT_TRUE(whole.status.ok());
  EXPECT_EQ(whole.trailer.settled_radius(), 0.5);
  const Parts rest = Read(From(request_, whole.field_id, kVertices));
  EXPECT_TRUE(rest.status.ok());
  EXPECT_EQ(rest.trailer.settled_radius(), 0.5);
}

TEST_F(FieldResumptionTest, AFieldThatIsNotKeptIsNotFound) {
  const Parts whole = Read(request_);
  ASSERT_TRUE(whole.status.ok());
  const auto expect_not_kept = [&](const v1::ComputeFieldRequest& request) {
    const grpc::Status status = Read(request).status;
    EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
    EXPECT_EQ(test::Reason(status), "FIELD_NOT_KEPT");
  };
  // Another name; another question; and one that nobody asked before, for
  // which nothing is computed.
  expect_not_kept(From(request_, std::string(64, 'a'), 10));
  v1::ComputeFieldRequest other = request_;
  other.set_value_type(v1::VALUE_TYPE_FLOAT32);
  expect_not_kept(From(other, whole.field_id, 10));
  const uint64_t solves = server_->engine().counters().solves_started;
  other = request_;
  other.add_sources()->set_vertex(7);
  expect_not_kept(From(other, whole.field_id, 10));
  EXPECT_EQ(server_->engine().counters().solves_started, solves);
}

TEST_F(FieldResumptionTest, WhatCannotBeResumedIsRefused) {
  const Parts whole = Read(request_);
  v1::ComputeFieldRequest request =
      From(request_, whole.field_id, kVertices + 1);
  grpc::Status status = Read(request).status;
  EXPECT_EQ(test::FieldAtFault(status), "resumption.first_vertex");
  request = From(request_, whole.field_id, 1);
  request.clear_quantities();
  request.set_progressive(true);
  status = Read(request).status;
  EXPECT_EQ(test::FieldAtFault(status), "resumption");
}

TEST_F(FieldResumptionTest, TheNameDependsOnTheQuestionAndNotOnItsPriority) {
  const Parts whole = Read(request_);
  v1::ComputeFieldRequest again = request_;
  again.set_priority(v1::PRIORITY_BATCH);
  EXPECT_EQ(Read(again).field_id, whole.field_id);
  again.mutable_sources(0)->set_vertex(1);
  EXPECT_NE(Read(again).field_id, whole.field_id);
}

}  // namespace
}  // namespace geodesic::server
