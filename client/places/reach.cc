#include "client/places/reach.h"

#include <algorithm>
#include <numeric>
#include <type_traits>
#include <variant>

#include "absl/strings/str_cat.h"
#include "client/places/surface_faces.h"

namespace geodesic::client {

Reach::Reach(const MeshArrays& mesh, std::span<const Source> sources)
    : mesh_(mesh),
      components_(mesh.positions.size()),
      has_face_(mesh.positions.size()),
      is_reached_(mesh.positions.size()) {
  // A forest, with a tree for each component.
  std::iota(components_.begin(), components_.end(), 0);
  const auto root = [this](uint32_t vertex) {
    for (; components_[vertex] != vertex; vertex = components_[vertex]) {
      components_[vertex] = components_[components_[vertex]];
    }
    return vertex;
  };
  ForEachSurfaceFace(mesh, [&](uint64_t, const Triangle& triangle) {
    for (const uint32_t vertex : triangle) {
      has_face_[vertex] = true;
      components_[root(vertex)] = root(triangle[0]);
    }
  });
  for (const auto& [vertex, into] : mesh.joined) {
    has_face_[vertex] = has_face_[into];
    components_[root(vertex)] = root(into);
  }
  for (uint32_t v = 0; v < components_.size(); ++v) components_[v] = root(v);
  const auto enter = [this](const SurfacePoint& place) {
    first_source_ = VertexOf(place);
    all_are_isolated_ &= IsIsolated(first_source_);
    is_reached_[components_[first_source_]] = true;
  };
  // The rest of a curve is in the same component.
  for (const Source& source : sources) enter(FirstPoint(source));
}

bool Reach::IsIsolated(uint64_t vertex) const {
  return vertex < has_face_.size() && !has_face_[vertex];
}

uint32_t Reach::VertexOf(const SurfacePoint& place) const {
  uint64_t vertex = 0;
  if (const auto* at = std::get_if<VertexPoint>(&place)) {
    vertex = at->vertex;
  } else if (const auto* edge = std::get_if<EdgePoint>(&place)) {
    vertex = edge->from;
  } else if (const uint64_t face = std::get<FacePoint>(place).face;
             face < mesh_.triangles.size()) {
    vertex = mesh_.triangles[face][0];
  }
  return vertex < components_.size() ? static_cast<uint32_t>(vertex) : 0;
}

std::string Reach::WhyUnreached(const SurfacePoint& target,
                                std::string_view otherwise) {
  const uint32_t to = VertexOf(target);
  if (IsIsolated(to)) return absl::StrCat("vertex ", to, " is on no face");
  if (all_are_isolated_) {
    return absl::StrCat("vertex ", first_source_,
                        ", the source, is on no face");
  }
  const uint32_t component = components_[to];
  if (is_reached_[component]) return std::string(otherwise);
  const auto [seam, is_new] = seams_.try_emplace(component);
  if (is_new) seam->second = Seam(component);
  return absl::StrCat("it lies in another component of the mesh", seam->second);
}

std::string Reach::Seam(uint32_t component) const {
  std::vector<uint32_t> order(mesh_.positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::erase_if(order, [this](uint32_t v) { return !has_face_[v]; });
  const auto place = [this](uint32_t v) -> const Point& {
    return mesh_.positions[v];
  };
  std::ranges::stable_sort(order, {}, place);
  uint64_t shared = 0;
  std::string example;
  for (auto first = order.begin(); first != order.end();) {
    const auto end = std::find_if(first, order.end(), [&](uint32_t v) {
      return place(v) != place(*first);
    });
    const auto is_inside = [&](uint32_t v) {
      return components_[v] == component;
    };
    const auto inside = std::find_if(first, end, is_inside);
    const auto outside = std::find_if_not(first, end, is_inside);
    if (inside != end && outside != end && shared++ == 0) {
      example = absl::StrCat(*inside, " and ", *outside);
    }
    first = end;
  }
  if (shared == 0) return "";
  return absl::StrCat("; it touches others at ", shared,
                      shared == 1 ? " point" : " points",
                      ", where vertices lie twice (", example,
                      ", say): merge them to let paths pass");
}

}  // namespace geodesic::client
