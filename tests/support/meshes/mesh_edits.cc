#include "tests/support/meshes/mesh_edits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "tests/support/half_edges.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/developable_meshes.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/random.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

uint32_t AddPoint(TriangleSoup& soup, const Point& p) {
  soup.positions.push_back(p);
  return static_cast<uint32_t>(soup.positions.size() - 1);
}

// weights[i] at corner i of the face.
Point Blend(const TriangleSoup& soup, const Triangle& t, const Point& weights) {
  Point p{};
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < 3; ++i) p[c] += weights[i] * soup.positions[t[i]][c];
  }
  return p;
}

void SplitFace(TriangleSoup& soup, uint32_t face, const Point& weights) {
  const Triangle t = soup.triangles[face];
  const uint32_t p = AddPoint(soup, Blend(soup, t, weights));
  soup.triangles[face] = {t[0], t[1], p};
  soup.triangles.push_back({t[1], t[2], p});
  soup.triangles.push_back({t[2], t[0], p});
}

void Shuffle(std::vector<uint32_t>& items, Random& random) {
  for (size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[random.Below(static_cast<uint32_t>(i))]);
  }
}

std::vector<uint32_t> Shuffled(size_t count, Random& random) {
  std::vector<uint32_t> items(count);
  std::iota(items.begin(), items.end(), 0u);
  Shuffle(items, random);
  return items;
}

// An interior half-edge at random, or kBorder after many misses.
uint32_t InteriorHalfEdge(const HalfEdges& edges, Random& random) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const uint32_t h = random.Below(edges.size());
    if (edges.Twin(h) != kBorder) return h;
  }
  return kBorder;
}

void ReplaceCorner(Triangle& t, uint32_t from, uint32_t to) {
  std::replace(t.begin(), t.end(), from, to);
}

}  // namespace

TriangleSoup SubdivideAtMidpoints(const TriangleSoup& soup) {
  TriangleSoup fine{.positions = soup.positions};
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> midpoints;
  const auto midpoint = [&](uint32_t a, uint32_t b) {
    const auto [it, is_new] = midpoints.emplace(std::minmax(a, b), 0u);
    if (is_new) {
      it->second = AddPoint(fine, Blend(soup, {a, b, b}, {0.5, 0.5, 0}));
    }
    return it->second;
  };
  for (const auto& [a, b, c] : soup.triangles) {
    const uint32_t ab = midpoint(a, b), bc = midpoint(b, c),
                   ca = midpoint(c, a);
    fine.triangles.push_back({a, ab, ca});
    fine.triangles.push_back({ab, b, bc});
    fine.triangles.push_back({ca, bc, c});
    fine.triangles.push_back({ab, bc, ca});
  }
  return fine;
}

TriangleSoup SplitFaces(TriangleSoup soup, uint32_t count, uint64_t seed) {
  Random random(seed);
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t face =
        random.Below(static_cast<uint32_t>(soup.triangles.size()));
    const double u = random.Uniform(0.1, 0.45), v = random.Uniform(0.1, 0.45);
    SplitFace(soup, face, {u, v, 1 - u - v});
  }
  return soup;
}

TriangleSoup InsertNeedles(TriangleSoup soup, uint32_t count, uint64_t seed) {
  Random random(seed);
  constexpr double kNear = 1e-6;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t face =
        random.Below(static_cast<uint32_t>(soup.triangles.size()));
    const double u = random.Below(2) ? kNear : random.Uniform(0.2, 0.8);
    Point weights = {kNear, u, 1 - u - kNear};
    std::rotate(weights.begin(), weights.begin() + random.Below(3),
                weights.end());
    SplitFace(soup, face, weights);
  }
  return soup;
}

TriangleSoup InsertZeroAreaFaces(TriangleSoup soup, uint32_t count,
                                 uint64_t seed) {
  Random random(seed);
  for (uint32_t i = 0; i < count; ++i) {
    const HalfEdges edges(soup);
    const uint32_t h = InteriorHalfEdge(edges, random);
    if (h == kBorder) break;
    const uint32_t a = edges.From(h), b = edges.To(h), c = edges.Opposite(h);
    const uint32_t m = AddPoint(soup, Blend(soup, {a, b, c}, {0.5, 0.5, 0}));
    soup.triangles[h / 3] = {a, m, c};
    soup.triangles.push_back({m, b, c});
    soup.triangles.push_back({a, b, m});
  }
  return soup;
}

TriangleSoup DoubleVertices(TriangleSoup soup, uint32_t count, uint64_t seed,
                            std::vector<uint32_t>* doubled) {
  Random random(seed);
  std::vector<uint32_t> originals;
  for (int attempt = 0; attempt < 1000 && originals.size() < count; ++attempt) {
    const HalfEdges edges(soup);
    // The faces around v from one edge to another get the double.
    const uint32_t first = random.Below(edges.size());
    const uint32_t v = edges.From(first);
    std::vector<uint32_t> around;  // half-edges that leave v, turning left
    uint32_t h = first;
    do {
      around.push_back(h);
      h = edges.Twin(PreviousSide(h));
    } while (h != kBorder && h != first);
    if (h == kBorder || around.size() < 4) continue;
    const size_t faces =
        2 + random.Below(static_cast<uint32_t>(around.size() - 3));
    const uint32_t a = edges.To(around[0]), b = edges.To(around[faces]);
    const uint32_t twin = AddPoint(soup, Point(soup.positions[v]));
    for (size_t i = 0; i < faces; ++i) {
      ReplaceCorner(soup.triangles[around[i] / 3], v, twin);
    }
    // The sector from a to b now has its corner at `twin`; the faces without
    // area reach from there back to v.
    soup.triangles.push_back({a, twin, v});
    soup.triangles.push_back({v, twin, b});
    originals.push_back(v);
  }
  if (doubled != nullptr) *doubled = std::move(originals);
  return soup;
}

TriangleSoup FlipEdges(TriangleSoup soup, uint32_t count, uint64_t seed) {
  Random random(seed);
  for (uint32_t i = 0; i < count; ++i) {
    const HalfEdges edges(soup);
    const uint32_t h = InteriorHalfEdge(edges, random);
    if (h == kBorder) break;
    const uint32_t t = edges.Twin(h);
    const uint32_t a = edges.From(h), b = edges.To(h);
    const uint32_t c = edges.Opposite(h), d = edges.Opposite(t);
    bool taken = c == d;
    for (uint32_t e = 0; e < edges.size(); ++e) {
      const uint32_t from = edges.From(e), to = edges.To(e);
      taken = taken || (from == c && to == d) || (from == d && to == c);
    }
    if (taken) continue;
    soup.triangles[h / 3] = {a, d, c};
    soup.triangles[t / 3] = {d, b, c};
  }
  return soup;
}

Relabelled Relabel(const TriangleSoup& soup, uint64_t seed) {
  Random random(seed);
  Relabelled result;
  result.new_number = Shuffled(soup.positions.size(), random);
  result.soup.positions.resize(soup.positions.size());
  for (size_t v = 0; v < soup.positions.size(); ++v) {
    result.soup.positions[result.new_number[v]] = soup.positions[v];
  }
  for (const uint32_t f : Shuffled(soup.triangles.size(), random)) {
    Triangle t = soup.triangles[f];
    for (uint32_t& v : t) v = result.new_number[v];
    std::rotate(t.begin(), t.begin() + random.Below(3), t.end());
    result.soup.triangles.push_back(t);
  }
  return result;
}

TriangleSoup TurnFaces(TriangleSoup soup, uint64_t seed) {
  Random random(seed);
  for (Triangle& face : soup.triangles) {
    if (random.Below(2) == 0) std::swap(face[0], face[1]);
  }
  return soup;
}

TriangleSoup AddBackFaces(TriangleSoup soup) {
  const size_t count = soup.triangles.size();
  for (size_t f = 0; f < count; ++f) {
    const auto [a, b, c] = soup.triangles[f];
    soup.triangles.push_back({b, a, c});
  }
  return soup;
}

TriangleSoup RotateAndShift(TriangleSoup soup, uint64_t seed) {
  Random random(seed);
  Point shift;
  for (double& s : shift) s = random.Uniform(-3, 3);
  for (int axis = 0; axis < 3; ++axis) {
    const double angle = random.Uniform(0, 2 * std::numbers::pi);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (Point& p : soup.positions) {
      const double pu = p[u], pv = p[v];
      p[u] = cosine * pu - sine * pv;
      p[v] = sine * pu + cosine * pv;
    }
  }
  for (Point& p : soup.positions) {
    for (int c = 0; c < 3; ++c) p[c] += shift[c];
  }
  return soup;
}

TriangleSoup Scale(TriangleSoup soup, double factor) {
  for (Point& p : soup.positions) {
    for (double& c : p) c *= factor;
  }
  return soup;
}

TriangleSoup Join(TriangleSoup a, const TriangleSoup& b) {
  const uint32_t first = static_cast<uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return a;
}

TriangleSoup Book(const TriangleSoup& page, uint32_t pages) {
  TriangleSoup book = page;
  for (uint32_t i = 1; i < pages; ++i) {
    const double angle = 2 * std::numbers::pi * i / pages;
    std::vector<uint32_t> number;
    for (uint32_t v = 0; v < page.positions.size(); ++v) {
      const Point& p = page.positions[v];
      const Point turned = {p[0] * std::cos(angle), p[1],
                            p[0] * std::sin(angle)};
      number.push_back(p[0] == 0 ? v : AddPoint(book, turned));
    }
    for (const auto& [a, b, c] : page.triangles) {
      book.triangles.push_back({number[a], number[b], number[c]});
    }
  }
  return book;
}

TriangleSoup AddLayer(TriangleSoup soup, uint32_t count, double lift,
                      uint64_t seed) {
  Random random(seed);
  std::vector<std::vector<uint32_t>> faces_at(soup.positions.size());
  for (uint32_t f = 0; f < soup.triangles.size(); ++f) {
    for (const uint32_t v : soup.triangles[f]) faces_at[v].push_back(f);
  }
  std::vector<uint32_t> faces = {
      random.Below(static_cast<uint32_t>(soup.triangles.size()))};
  std::set<uint32_t> is_in = {faces[0]};
  for (size_t i = 0; i < faces.size() && faces.size() < count; ++i) {
    for (const uint32_t v : soup.triangles[faces[i]]) {
      for (const uint32_t f : faces_at[v]) {
        if (faces.size() < count && is_in.insert(f).second) faces.push_back(f);
      }
    }
  }
  std::map<uint32_t, uint32_t> number;
  for (const uint32_t f : faces) {
    const Triangle corners = soup.triangles[f];
    Triangle above;
    for (uint32_t i = 0; i < 3; ++i) {
      const uint32_t v = corners[i];
      const bool ends = !std::ranges::all_of(
          faces_at[v], [&](uint32_t other) { return is_in.contains(other); });
      if (!ends && !number.contains(v)) {
        const double most = lift * static_cast<double>(Distance(
                                       soup.positions[v],
                                       soup.positions[corners[(i + 1) % 3]]));
        Point place = soup.positions[v];
        for (double& c : place) c += random.Uniform(-most, most);
        number[v] = AddPoint(soup, place);
      }
      above[i] = ends ? v : number[v];
    }
    soup.triangles.push_back(above);
  }
  return soup;
}

TriangleSoup AddIsolatedVertices(TriangleSoup soup, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    AddPoint(soup, {0.1 * i, 0.2, 0.3});
  }
  return soup;
}

TriangleSoup EditedMesh(uint64_t seed, bool degenerate) {
  Random random(seed);
  const GridOptions grid{.columns = 3 + random.Below(4),
                         .rows = 3 + random.Below(3),
                         .diagonals = static_cast<Diagonals>(random.Below(3)),
                         .jitter = random.Below(2) == 0 ? 0 : 0.2,
                         .seed = seed};
  TriangleSoup soup;
  switch (seed % 5) {
    case 0:
      soup = MakePlate(random.Below(2) == 0 ? WithHole(grid) : UShape(grid),
                       random.Uniform(0.1, 2));
      break;
    case 1:
      soup = MakeGrid(grid);
      for (Point& p : soup.positions) p[2] = random.Below(3);
      break;
    case 2:
      soup = BoxGrid(1, 2, 3, 2, 1 + random.Below(3), 1 + random.Below(3));
      break;
    case 3:
      soup = UvSphere(3 + random.Below(8), 3 + random.Below(4));
      break;
    case 4:
      soup = Fan({.spokes = 8,
                  .rings = 1 + random.Below(3),
                  .total_angle = random.Uniform(0.2, 12),
                  .closed = random.Below(2) == 0})
                 .soup();
      break;
  }
  soup = FlipEdges(soup, random.Below(20), seed);
  if (degenerate) {
    soup = InsertZeroAreaFaces(soup, 1 + random.Below(4), seed);
    soup = DoubleVertices(soup, random.Below(3), seed);
  }
  return RotateAndShift(SplitFaces(soup, random.Below(8), seed), seed);
}

}  // namespace geodesic::test
