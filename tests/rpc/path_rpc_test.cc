// PathService: shortest paths and isolines.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "tests/rpc/questions_fixture.h"

namespace geodesic::server {
namespace {

using test::Euclid;
using test::kInfinity;
using test::Values;

std::vector<Point> Positions(const v1::PolylinePiece& piece) {
  return Values<Point>(piece.positions());
}

double LengthOf(const std::vector<Point>& points) {
  double length = 0;
  for (size_t i = 1; i < points.size(); ++i) {
    length += Euclid(points[i - 1], points[i]);
  }
  return length;
}

class PathRpcTest : public test::QuestionsTest {
 protected:
  v1::ComputePathsRequest Request() const {
    v1::ComputePathsRequest request;
    request.set_mesh_digest(digest_);
    request.add_sources()->set_vertex(Vertex(0, 0));
    return request;
  }
};

TEST_F(PathRpcTest, PathsOnAPlaneAreStraight) {
  v1::ComputePathsRequest request = Request();
  request.add_targets()->set_vertex(Vertex(7, 3));
  SetEdge(Vertex(2, 9), Vertex(3, 9), 0.25, *request.add_targets());
  request.add_targets()->set_vertex(Vertex(0, 0));
  const std::vector<Point> ends = {{7, 3, 0}, {2.25, 9, 0}, {0, 0, 0}};
  const auto messages = Messages(request);
  ExpectHeader(messages.front().header());
  std::vector<v1::GeodesicPath> paths;
  for (const auto& message : messages) {
    if (message.has_path()) paths.push_back(message.path());
  }
  ASSERT_EQ(paths.size(), 3);
  EXPECT_EQ(messages.back().trailer().item_count(), 3);
  EXPECT_GT(messages.back().trailer().windows_propagated(), 0);
  for (size_t i = 0; i < paths.size(); ++i) {
    const double expected = Euclid({0, 0, 0}, ends[i]);
    EXPECT_EQ(paths[i].target(), i);
    EXPECT_EQ(paths[i].source(), 0);
    EXPECT_NEAR(paths[i].length(), expected, 1e-10);
    EXPECT_NEAR(paths[i].distance(), expected, 1e-10);
    const std::vector<Point> points = Positions(paths[i].piece());
    ASSERT_EQ(points.size(), paths[i].piece().points_size());
    ASSERT_EQ(points.size(), paths[i].piece().point_count());
    EXPECT_NEAR(LengthOf(points), expected, 1e-10);
    EXPECT_NEAR(Euclid(points.front(), {0, 0, 0}), 0, 1e-12);
    EXPECT_NEAR(Euclid(points.back(), ends[i]), 0, 1e-12);
  }
}

TEST_F(PathRpcTest, SourcesAreNumberedAsInTheRequest) {
  v1::ComputePathsRequest request = Request();
  request.clear_sources();
  // Not in the order of the mesh, a curve in between.
  v1::Source& far = *request.add_sources();
  far.set_vertex(Vertex(10, 10));
  far.set_offset(0.5);
  request.add_sources()->mutable_curve()->add_points()->set_vertex(
      Vertex(10, 0));
  request.add_sources()->set_vertex(Vertex(0, 0));
  request.add_targets()->set_vertex(Vertex(9, 9));
  request.add_targets()->set_vertex(Vertex(9, 1));
  request.add_targets()->set_vertex(Vertex(1, 1));
  const auto messages = Messages(request);
  uint64_t target = 0;
  for (const auto& message : messages) {
    if (!message.has_path()) continue;
    EXPECT_EQ(message.path().source(), target);
    EXPECT_NEAR(message.path().length(), std::sqrt(2), 1e-10);
    EXPECT_NEAR(message.path().distance(),
                std::sqrt(2) + (target == 0 ? 0.5 : 0), 1e-10);
    ++target;
  }
  EXPECT_EQ(target, 3);
}

TEST_F(PathRpcTest, WhatIsNotReachedHasNoPath) {
  v1::ComputePathsRequest request = Request();
  request.add_targets()->set_vertex(Vertex(5, 0));
  request.set_radius(4);
  // Once computed, once from a field that reaches further.
  for (int i = 0; i < 2; ++i) {
    const auto messages = Messages(request);
    for (const auto& message : messages) {
      if (!message.has_path()) continue;
      EXPECT_EQ(message.path().length(), kInfinity);
      EXPECT_EQ(message.path().distance(), kInfinity);
      EXPECT_FALSE(message.path().has_source());
      EXPECT_EQ(message.path().piece().point_count(), 0);
    }
    v1::ComputePathsRequest further = request;
    further.clear_radius();
    EXPECT_EQ(CodeOf(further), grpc::StatusCode::OK);
  }
}

TEST_F(PathRpcTest, LongPathsTakeSeveralMessages) {
  // A strip that a path runs along through more than 8192 faces.
  soup_ = geodesic::test::MakeGrid({.columns = 9000, .rows = 1});
  digest_ = Upload(soup_);
  v1::ComputePathsRequest request = Request();
  request.clear_sources();
  request.add_sources()->set_vertex(0);
  request.add_targets()->set_vertex(2 * 9001 - 1);
  const auto messages = Messages(request);
  std::vector<Point> points;
  int pieces = 0;
  for (const auto& message : messages) {
    if (!message.has_path()) continue;
    ++pieces;
    const v1::PolylinePiece& piece = message.path().piece();
    EXPECT_EQ(piece.first_point(), points.size());
    const auto more = Positions(piece);
    points.insert(points.end(), more.begin(), more.end());
    EXPECT_NEAR(message.path().length(), std::hypot(9000, 1), 1e-6);
  }
  EXPECT_GT(pieces, 1);
  EXPECT_NEAR(LengthOf(points), std::hypot(9000, 1), 1e-6);
}

TEST_F(PathRpcTest, WrongArgumentsAreNamed) {
  v1::ComputePathsRequest request = Request();
  EXPECT_EQ(Fault(request), "targets");
  request.add_targets()->set_vertex(1);
  ExpectFaults(request, {{"targets { vertex: 1000 }", "targets[1].vertex"},
                         {"radius: nan", "radius"}});
  ExpectUsual(request);
  request.clear_sources();
  EXPECT_EQ(Fault(request), "sources");
  request.add_sources()->set_vertex(0);
  for (int i = 0; i < 100; ++i) request.add_targets()->set_vertex(0);
  EXPECT_EQ(CodeOf(request), grpc::StatusCode::RESOURCE_EXHAUSTED);
}

class IsolineRpcTest : public test::QuestionsTest {
 protected:
  v1::ComputeIsolinesRequest Request() const {
    v1::ComputeIsolinesRequest request;
    request.set_mesh_digest(digest_);
    request.add_sources()->set_vertex(Vertex(5, 5));
    return request;
  }
};

TEST_F(IsolineRpcTest, IsolinesOnAPlaneAreCircles) {
  v1::ComputeIsolinesRequest request = Request();
  request.add_levels(4.5);
  request.add_levels(2.25);
  const auto messages = Messages(request);
  ExpectHeader(messages.front().header());
  std::map<double, int> seen;
  uint64_t number = 0;
  for (const auto& message : messages) {
    if (!message.has_isoline()) continue;
    const v1::Isoline& isoline = message.isoline();
    EXPECT_EQ(isoline.number(), number++);
    EXPECT_TRUE(isoline.is_closed());
    ++seen[isoline.level()];
    const std::vector<Point> points = Positions(isoline.piece());
    EXPECT_GT(points.size(), 8);
    EXPECT_EQ(points.size(), isoline.piece().points_size());
    for (const Point& point : points) {
      EXPECT_NEAR(Euclid(point, {5, 5, 0}), isoline.level(), 1e-9);
    }
  }
  EXPECT_EQ(seen, (std::map<double, int>{{2.25, 1}, {4.5, 1}}));
  EXPECT_EQ(messages.back().trailer().item_count(), 2);
}

TEST_F(IsolineRpcTest, WrongArgumentsAreNamed) {
  v1::ComputeIsolinesRequest request = Request();
  EXPECT_EQ(Fault(request), "levels");
  request.add_levels(1);
  ExpectFaults(request, {{"levels: 0", "levels[1]"},
                         {"levels: -1", "levels[1]"},
                         {"levels: inf", "levels[1]"},
                         {"levels: nan", "levels[1]"}});
  ExpectUsual(request);
  for (int i = 0; i < 5; ++i) request.add_levels(1 + i);
  EXPECT_EQ(CodeOf(request), grpc::StatusCode::RESOURCE_EXHAUSTED);
}

}  // namespace
}  // namespace geodesic::server
