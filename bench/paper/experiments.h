// The experiments of Xu et al. 2015, each of which prints a table.

#ifndef GEODESIC_BENCH_PAPER_EXPERIMENTS_H_
#define GEODESIC_BENCH_PAPER_EXPERIMENTS_H_

#include <span>

#include "bench/paper/measurement.h"

namespace geodesic::paper {

struct Setting {
  bool quick = false;  // small meshes and few steps: to see that it works
  std::span<const Subject> models;  // meshes the user gave

  int most_runs() const { return quick ? 1 : 5; }
};

// Time and windows of every algorithm against the number of faces (Fig. 6), on
// a smooth and on a rough surface.
void RunResolution(const Setting& setting);
// The same against anisotropy, at one number of faces (Fig. 7).
void RunAnisotropy(const Setting& setting);
// The same on models, with iterations (Table 1, Fig. 15).
void RunModels(const Setting& setting);
// K, the size of the wavefront and the spread of its labels over time (Figs. 9
// and 11).
void RunWavefront(const Setting& setting);
// Fixed against adaptive K (Fig. 10).
void RunBatch(const Setting& setting);
// Bucket widths (Fig. 12).
void RunBucketWidth(const Setting& setting);
// Distances on polyhedra against those on the smooth surfaces they are made
// from, and against each other (section 7.2).
void RunAccuracy(const Setting& setting);
// Approximate methods beside exact algorithms on models: what they take to
// prepare and to ask, and their errors (Table 3).
void RunMethods(const Setting& setting);
// The saddle vertex graph against K, built by FWP and by ICH (Fig. 8).
void RunNeighbours(const Setting& setting);
// Fast marching with a heap and with untidy buckets, against anisotropy
// (Fig. 13).
void RunMarching(const Setting& setting);
// The heat method against the time that heat spreads for (Fig. 14).
void RunHeatTime(const Setting& setting);
// Error against time for everything that computes a field.
void RunTradeOff(const Setting& setting);

}  // namespace geodesic::paper

#endif  // GEODESIC_BENCH_PAPER_EXPERIMENTS_H_
