// What the pairs of a question are answered with on a server, and how many of
// them were.

#ifndef GEODESIC_SERVER_ENGINE_ROWS_PAIR_WORK_H_
#define GEODESIC_SERVER_ENGINE_ROWS_PAIR_WORK_H_

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "geodesic/rows/rows.h"
#include "geodesic/surface_point.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/engine/searches/search_engine.h"

namespace geodesic::server {

// How pairs were answered.
struct PairCounts {
  uint64_t searched = 0;     // by a search of their own
  uint64_t from_fields = 0;  // by a field that was computed for several
  uint64_t from_cache = 0;   // by a field that was there already

  uint64_t all() const { return searched + from_fields + from_cache; }
};

// Thread-safe.
class PairCounter {
 public:
  void Add(AnsweredBy how, uint64_t pairs) {
    counts_[static_cast<size_t>(how)] += pairs;
  }
  PairCounts counts() const { return {counts_[0], counts_[1], counts_[2]}; }

 private:
  std::array<std::atomic<uint64_t>, 3> counts_ = {};  // by AnsweredBy
};

// Of one question. Thread-safe.
class PairWork final : public SearchMeans {
 public:
  // The references outlive it. `totals` are of all questions.
  PairWork(SearchEngine& searches, FieldEngine& fields, PairCounter& totals,
           MeshHandle mesh)
      : SearchMeans(searches, std::move(mesh)),
        fields_(fields),
        totals_(totals) {}

  FieldHandle FindWhole(const SurfacePoint& source) override {
    return fields_.FindWhole(*mesh(), source);
  }
  void Count(AnsweredBy how, uint64_t pairs) override {
    answered.Add(how, pairs);
    totals_.Add(how, pairs);
  }

  PairCounter answered;

 private:
  FieldEngine& fields_;
  PairCounter& totals_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_ROWS_PAIR_WORK_H_
