#include "places.h"

#include <cstddef>
#include <utility>
#include <variant>

#include "arrays.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

enum Kind : uint8_t { kVertex = 0, kEdge = 1, kFace = 2 };

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

}  // namespace

std::vector<SurfacePoint> ToSurfacePoints(const PlaceArrays& places) {
  const auto kinds = places.kinds.unchecked<1>();
  const auto numbers = places.numbers.unchecked<2>();
  const auto weights = places.weights.unchecked<2>();
  std::vector<SurfacePoint> points;
  points.reserve(static_cast<size_t>(kinds.shape(0)));
  for (py::ssize_t i = 0; i < kinds.shape(0); ++i) {
    switch (kinds(i)) {
      case kVertex:
        points.push_back(VertexPoint{numbers(i, 0)});
        break;
      case kEdge:
        points.push_back(
            EdgePoint{numbers(i, 0), numbers(i, 1), weights(i, 0)});
        break;
      default:
        points.push_back(FacePoint{
            numbers(i, 0), {weights(i, 0), weights(i, 1), weights(i, 2)}});
    }
  }
  return points;
}

std::vector<Source> ToSources(const SourceArrays& sources) {
  const std::vector<SurfacePoint> points = ToSurfacePoints(sources.places);
  const auto counts = sources.counts.unchecked<1>();
  const auto offsets = sources.offsets.unchecked<1>();
  std::vector<Source> result;
  result.reserve(static_cast<size_t>(counts.shape(0)));
  auto next = points.begin();
  for (py::ssize_t s = 0; s < counts.shape(0); ++s) {
    if (counts(s) < 0) {
      result.push_back({*next++, offsets(s)});
    } else {
      result.push_back({Curve{{next, next + counts(s)}}, offsets(s)});
      next += counts(s);
    }
  }
  return result;
}

PlaceArrays ToPlaceArrays(const std::vector<SurfacePoint>& points) {
  std::vector<uint8_t> kinds;
  std::vector<std::array<uint32_t, 2>> numbers;
  std::vector<std::array<double, 3>> weights;
  kinds.reserve(points.size());
  numbers.reserve(points.size());
  weights.reserve(points.size());
  const auto add = [&](Kind kind, std::array<uint32_t, 2> of,
                       std::array<double, 3> with) {
    kinds.push_back(kind);
    numbers.push_back(of);
    weights.push_back(with);
  };
  for (const SurfacePoint& point : points) {
    std::visit(Overloaded{[&](const VertexPoint& p) {
                            add(kVertex, {p.vertex, 0}, {});
                          },
                          [&](const EdgePoint& p) {
                            add(kEdge, {p.from, p.to}, {p.t});
                          },
                          [&](const FacePoint& p) {
                            add(kFace, {p.face, 0}, p.weights);
                          }},
               point);
  }
  return {ToArray(std::move(kinds)), ToArray(std::move(numbers)),
          ToArray(std::move(weights))};
}

}  // namespace geodesic::python
