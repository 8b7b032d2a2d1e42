#include "questions/isolines/face_sources.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "surface/surface_location.h"

namespace geodesic {

FaceSources::FaceSources(const Mesh& mesh, std::span<const Anchor> anchors)
    : mesh_(mesh), anchors_(anchors) {
  for (uint32_t i = 0; i < anchors.size(); ++i) {
    const auto& [begin, end, is_segment, offset, source] = anchors[i];
    if (!is_segment && std::holds_alternative<VertexPoint>(begin)) continue;
    if (const auto* edge = std::get_if<EdgePoint>(&begin);
        edge && !is_segment) {
      AddOnEdge(i, edge->from, edge->to);
      continue;
    }
    VisitSharedFaces(
        mesh, begin, end, [&](const FacePoint& at, const FacePoint& to) {
          const std::optional<HalfEdge> side = SharedSide(mesh, at, to);
          if (side.has_value()) {
            AddOnEdge(i, mesh.From(*side), mesh.To(*side));
          } else {
            in_faces_[at.face].push_back(i);
          }
          return side.has_value();
        });
  }
}

void FaceSources::AddOnEdge(uint32_t number, uint32_t from, uint32_t to) {
  std::vector<HalfEdge>& edges =
      edges_between_[std::pair(std::min(from, to), std::max(from, to))];
  if (edges.empty()) {
    VisitSides(mesh_, from, to, [&](HalfEdge h) {
      if (mesh_.FirstOfEdge(h) == h) edges.push_back(h);
      return false;
    });
  }
  for (const HalfEdge edge : edges) on_edges_[edge].push_back(number);
}

bool FaceSources::HasAny(uint32_t face) const {
  if (in_faces_.contains(face)) return true;
  if (on_edges_.empty()) return false;
  const HalfEdge first = mesh_.FirstSide(face);
  for (HalfEdge h = first; h < first + 3; ++h) {
    if (on_edges_.contains(mesh_.FirstOfEdge(h))) return true;
  }
  return false;
}

FaceSources::Within FaceSources::In(uint32_t face) const {
  if (!HasAny(face)) return {};
  Numbers numbers;
  const auto add = [&](const auto& by_key, uint32_t key) {
    const auto found = by_key.find(key);
    if (found == by_key.end()) return;
    numbers.insert(numbers.end(), found->second.begin(), found->second.end());
  };
  add(in_faces_, face);
  const HalfEdge first = mesh_.FirstSide(face);
  for (HalfEdge h = first; h < first + 3 && !on_edges_.empty(); ++h) {
    add(on_edges_, mesh_.FirstOfEdge(h));
  }
  std::ranges::sort(numbers);
  Within within;
  for (const uint32_t number : numbers) {
    const Anchor& anchor = anchors_[number];
    const double sigma = std::ldexp(anchor.offset, -mesh_.scale_exponent());
    const FacePoint begin = *WithinFace(mesh_, anchor.begin, face);
    if (anchor.is_segment) {
      const FacePoint end = *WithinFace(mesh_, anchor.end, face);
      within.segments.push_back({CurveSegment(mesh_, begin, end), sigma});
    } else {
      within.points.push_back({begin, sigma});
    }
  }
  return within;
}

}  // namespace geodesic
