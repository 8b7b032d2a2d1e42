#include "tests/support/meshes/planar_meshes.h"

#include <algorithm>

#include "tests/support/half_edges.h"
#include "tests/support/random.h"

namespace geodesic::test {
namespace {

class GridBuilder {
 public:
  explicit GridBuilder(const GridOptions& options)
      : options_(options),
        random_(options.seed),
        numbers_((options.columns + 1) * (options.rows + 1), kUnused) {}

  TriangleSoup Build() {
    for (uint32_t y = 0; y <= options_.rows; ++y) {
      for (uint32_t x = 0; x <= options_.columns; ++x) AddVertex(x, y);
    }
    for (uint32_t y = 0; y < options_.rows; ++y) {
      for (uint32_t x = 0; x < options_.columns; ++x) {
        if (!Removed(x, y)) AddCell(x, y);
      }
    }
    return std::move(soup_);
  }

 private:
  static constexpr uint32_t kUnused = 0xffffffffu;

  bool Removed(uint32_t x, uint32_t y) const {
    if (x >= options_.columns || y >= options_.rows) return true;
    return std::any_of(options_.removed.begin(), options_.removed.end(),
                       [&](const CellRect& r) {
                         return r.x0 <= x && x < r.x1 && r.y0 <= y && y < r.y1;
                       });
  }

  void AddVertex(uint32_t x, uint32_t y) {
    int cells = 0;  // of the four around the vertex
    for (uint32_t dx = 0; dx < 2; ++dx) {
      for (uint32_t dy = 0; dy < 2; ++dy) {
        // x - dx wraps around at 0, which Removed takes for outside.
        if (!Removed(x - dx, y - dy)) ++cells;
      }
    }
    if (cells == 0) return;
    double px = x, py = y;
    if (cells == 4 && options_.jitter > 0) {
      px += random_.Uniform(-options_.jitter, options_.jitter);
      py += random_.Uniform(-options_.jitter, options_.jitter);
    }
    Number(x, y) = static_cast<uint32_t>(soup_.positions.size());
    soup_.positions.push_back(
        {px * options_.cell_width, py * options_.cell_height, 0});
  }

  void AddCell(uint32_t x, uint32_t y) {
    const uint32_t a = Number(x, y), b = Number(x + 1, y);
    const uint32_t c = Number(x + 1, y + 1), d = Number(x, y + 1);
    bool rising = true;
    if (options_.diagonals == Diagonals::kAlternating) rising = (x + y) % 2;
    if (options_.diagonals == Diagonals::kRandom) rising = random_.Below(2);
    if (rising) {
      soup_.triangles.push_back({a, b, c});
      soup_.triangles.push_back({a, c, d});
    } else {
      soup_.triangles.push_back({a, b, d});
      soup_.triangles.push_back({b, c, d});
    }
  }

  uint32_t& Number(uint32_t x, uint32_t y) {
    return numbers_[y * (options_.columns + 1) + x];
  }

  const GridOptions& options_;
  Random random_;
  std::vector<uint32_t> numbers_;  // of the vertex at each grid point
  TriangleSoup soup_;
};

}  // namespace

TriangleSoup MakeGrid(const GridOptions& options) {
  return GridBuilder(options).Build();
}

TriangleSoup MakePlate(const GridOptions& options, double thickness) {
  const TriangleSoup top = MakeGrid(options);
  const uint32_t below = static_cast<uint32_t>(top.positions.size());
  TriangleSoup plate = top;
  for (const Point& p : top.positions) {
    plate.positions.push_back({p[0], p[1], -thickness});
  }
  const HalfEdges edges(top);
  for (const auto& [a, b, c] : top.triangles) {
    plate.triangles.push_back({below + a, below + c, below + b});
  }
  for (uint32_t h = 0; h < edges.size(); ++h) {
    if (edges.Twin(h) != kBorder) continue;
    const uint32_t a = edges.From(h), b = edges.To(h);
    plate.triangles.push_back({b, a, below + a});
    plate.triangles.push_back({b, below + a, below + b});
  }
  return plate;
}

GridOptions WithHole(GridOptions options) {
  const uint32_t w = options.columns, h = options.rows;
  options.removed.push_back({w / 3, h / 3, w - w / 3, h - h / 4});
  return options;
}

GridOptions LShape(GridOptions options) {
  const uint32_t w = options.columns, h = options.rows;
  options.removed.push_back({w / 2, h / 3, w, h});
  return options;
}

GridOptions UShape(GridOptions options) {
  const uint32_t w = options.columns, h = options.rows;
  options.removed.push_back({w / 3, h / 4, w - w / 3, h});
  return options;
}

}  // namespace geodesic::test
