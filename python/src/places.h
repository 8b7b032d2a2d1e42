// Sources and targets as they cross from Python: arrays, so that many places
// cost no more than their bytes.

#ifndef GEODESIC_PYTHON_PLACES_H_
#define GEODESIC_PYTHON_PLACES_H_

#include <pybind11/numpy.h>

#include <cstdint>
#include <vector>

#include "geodesic/query.h"
#include "geodesic/surface_point.h"

namespace geodesic::python {

// N places, as geodesic/places.py makes them.
struct PlaceArrays {
  template <typename T>
  using Array = pybind11::array_t<T, pybind11::array::c_style>;

  Array<uint8_t> kinds;  // (N,): 0 a vertex, 1 a point of an edge, 2 of a face
  Array<uint32_t> numbers;  // (N, 2): vertex; from, to; face
  Array<double> weights;    // (N, 3): nothing; t; three barycentric weights
};

// S sources: places in order; a curve has several.
struct SourceArrays {
  PlaceArrays places;
  PlaceArrays::Array<int64_t> counts;  // (S,): -1 for a point, else a curve's
  PlaceArrays::Array<double> offsets;  // (S,)
};

// REQUIRES: the shapes above, kinds below 3, and counts that add up.
std::vector<SurfacePoint> ToSurfacePoints(const PlaceArrays& places);
std::vector<Source> ToSources(const SourceArrays& sources);

PlaceArrays ToPlaceArrays(const std::vector<SurfacePoint>& points);

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_PLACES_H_
