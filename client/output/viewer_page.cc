#include "client/output/viewer_page.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "absl/strings/escaping.h"
#include "client/output/binary_numbers.h"
#include "viewer_template.h"

namespace geodesic::client {
namespace {

// What the template has where the answer belongs.
constexpr std::string_view kPlaceholder = "\"GEODESIC_ANSWER\"";

std::string Base64(const void* bytes, size_t size) {
  return absl::Base64Escape({static_cast<const char*>(bytes), size});
}

// The middle of the bounding box; halves first, so that no sum overflows.
Point MiddleOf(const std::vector<Point>& positions) {
  if (positions.empty()) return {};
  Point low = positions[0];
  Point high = positions[0];
  for (const Point& position : positions) {
    for (size_t axis = 0; axis < position.size(); ++axis) {
      low[axis] = std::min(low[axis], position[axis]);
      high[axis] = std::max(high[axis], position[axis]);
    }
  }
  return {low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2,
          low[2] / 2 + high[2] / 2};
}

std::string PositionsFrom(const Point& middle,
                          const std::vector<Point>& positions) {
  std::string bytes;
  bytes.reserve(positions.size() * 3 * sizeof(float));
  for (const Point& position : positions) {
    const Point offset = {position[0] - middle[0], position[1] - middle[1],
                          position[2] - middle[2]};
    AppendNumbers(offset, NumberType::kFloat32, &bytes);
  }
  return bytes;
}

}  // namespace

void WriteViewerPage(const MeshArrays& mesh, const ViewedField& field,
                     AtomicFile* file) {
  const Point middle = MiddleOf(mesh.positions);
  const std::string positions = PositionsFrom(middle, mesh.positions);
  const nlohmann::ordered_json answer = {
      {"name", field.name},
      {"digest", field.mesh_digest},
      {"center", middle},
      {"positions", Base64(positions.data(), positions.size())},
      {"faces",
       Base64(mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle))},
      {"distances",
       Base64(field.distances.data(), field.distances.size_bytes())},
      {"sources", Base64(field.sources.data(), field.sources.size_bytes())}};
  std::string json =
      answer.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  // A name may not end the element of HTML that holds it.
  for (size_t at = json.find('<'); at != std::string::npos;
       at = json.find('<', at)) {
    json.replace(at, 1, "\\u003c");
  }
  const std::string_view page = kViewerTemplate;
  const size_t place = page.find(kPlaceholder);
  file->Append(page.substr(0, place));
  file->Append(json);
  file->Append(page.substr(place + kPlaceholder.size()));
}

}  // namespace geodesic::client
