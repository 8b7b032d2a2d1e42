// glTF 2.0 (".glb", ".gltf"): the triangles of a scene, in its coordinates.
//
// The vertices of each node follow those of the nodes before, in the order of
// the accessors that its primitives name first. Animations go unread.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "readers/gltf_file.h"
#include "readers/reader_errors.h"
#include "readers/readers.h"
#include "readers/soup_builder.h"

namespace geodesic {
namespace {

using Json = nlohmann::json;

// How many times as many vertices a mesh may have as its file has room for:
// accessors may lie over each other.
constexpr uint64_t kMostRepeats = 64;
constexpr uint64_t kVertexBytes = 3 * sizeof(float);
constexpr uint64_t kFewVertices = uint64_t{1} << 16;

enum Mode : uint64_t { kTriangles = 4, kStrip = 5, kFan = 6 };

// x -> columns[0] x[0] + columns[1] x[1] + columns[2] x[2] + columns[3].
struct Placement {
  std::array<std::array<double, 3>, 4> columns = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

  Point Turn(const Point& x) const {
    Point y;
    for (int row = 0; row < 3; ++row) {
      y[row] = columns[0][row] * x[0] + columns[1][row] * x[1] +
               columns[2][row] * x[2];
    }
    return y;
  }
  Point Move(const Point& x) const {
    Point y = Turn(x);
    for (int row = 0; row < 3; ++row) y[row] += columns[3][row];
    return y;
  }
  // First `inner`, then this.
  Placement After(const Placement& inner) const {
    Placement both;
    for (int column = 0; column < 3; ++column) {
      both.columns[column] = Turn(inner.columns[column]);
    }
    both.columns[3] = Move(inner.columns[3]);
    return both;
  }
};

// An array of `kCount` numbers; `missing` if it is absent, empty if malformed.
template <size_t kCount>
std::optional<std::array<double, kCount>> Numbers(
    const Json& node, const char* name, std::array<double, kCount> missing) {
  const Json* const list = GltfMember(node, name);
  if (list == nullptr) return missing;
  if (!list->is_array() || list->size() != kCount) return std::nullopt;
  for (size_t i = 0; i < kCount; ++i) {
    if (!(*list)[i].is_number()) return std::nullopt;
    missing[i] = (*list)[i].get<double>();
  }
  return missing;
}

// Scales, then turns by a quaternion of length 1, then shifts.
Placement PlacementOf(const std::array<double, 3>& shift,
                      const std::array<double, 4>& turn,
                      const std::array<double, 3>& scale) {
  const auto [x, y, z, w] = turn;
  Placement placement;
  placement.columns = {
      {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
       {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
       {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
       shift}};
  for (int column = 0; column < 3; ++column) {
    for (double& entry : placement.columns[column]) entry *= scale[column];
  }
  return placement;
}

// Where a node puts what is in it; empty if it is malformed.
std::optional<Placement> PlacementOf(const Json& node) {
  if (GltfMember(node, "matrix") != nullptr) {
    const auto matrix = Numbers<16>(node, "matrix", {});
    if (!matrix.has_value()) return std::nullopt;
    Placement placement;
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) {
        placement.columns[column][row] = (*matrix)[4 * column + row];
      }
    }
    return placement;
  }
  const auto shift = Numbers<3>(node, "translation", {0, 0, 0});
  const auto turn = Numbers<4>(node, "rotation", {0, 0, 0, 1});
  const auto scale = Numbers<3>(node, "scale", {1, 1, 1});
  if (!shift.has_value() || !turn.has_value() || !scale.has_value()) {
    return std::nullopt;
  }
  return PlacementOf(*shift, *turn, *scale);
}

// Its methods return whether to go on, as SoupBuilder's do.
class GltfReader {
 public:
  GltfReader(const GltfFile& file, uint64_t file_bytes,
             const ReadLimits& limits)
      : file_(file),
        most_of_mesh_(kMostRepeats * (file_bytes / kVertexBytes) +
                      kFewVertices),
        builder_(limits) {}

  absl::StatusOr<TriangleSoup> Read() {
    const Json* const nodes = GltfMember(file_.scene(), "nodes");
    is_placed_.resize(nodes == nullptr ? 0 : nodes->size());
    const uint64_t shown = GltfNumber(file_.scene(), "scene", 0);
    const Json* const scene = file_.Item("scenes", shown);
    if (scene == nullptr) {
      if (shown == kNoGltfNumber) {
        Refuse("the scene that is shown is not named by a number");
      } else {
        Refuse("there is no scene ", shown);
      }
    } else if (Push(absl::StrCat("scene ", shown), *scene, "nodes", {})) {
      while (!to_visit_.empty()) {
        const auto [node, placement] = to_visit_.back();
        to_visit_.pop_back();
        if (!ReadNode(node, placement)) break;
      }
    }
    absl::StatusOr<TriangleSoup> soup = std::move(builder_).Take();
    // The standard has no other coordinates, wherever they are put.
    if (soup.ok()) soup->is_single_precision = true;
    return soup;
  }

 private:
  struct Visit {
    uint64_t node;
    Placement parent;
  };

  // An accessor's, as the builder numbers them.
  struct Vertices {
    uint64_t first = 0;
    uint64_t count = 0;
  };

  template <typename... Parts>
  bool Refuse(const Parts&... parts) {
    return builder_.Refuse(absl::InvalidArgumentError(absl::StrCat(parts...)));
  }

  // Puts the nodes that a member of `name` lists on the stack, the first on
  // top.
  bool Push(const std::string& name, const Json& parent, const char* member,
            const Placement& at) {
    const Json* const list = GltfMember(parent, member);
    if (list == nullptr || !list->is_array()) return true;
    for (size_t i = list->size(); i-- > 0;) {
      const Json& node = (*list)[i];
      const uint64_t index =
          node.is_number_unsigned() ? node.get<uint64_t>() : kNoGltfNumber;
      if (index >= is_placed_.size()) {
        return Refuse(name, ": entry ", i, " of '", member,
                      "' names no node of this file");
      }
      // The standard has trees only, which also keeps a scene from growing
      // beyond its file.
      if (is_placed_[index]) return Refuse("node ", index, " has two parents");
      is_placed_[index] = true;
      to_visit_.push_back({index, at});
    }
    return true;
  }

  bool ReadNode(uint64_t index, const Placement& parent) {
    const Json& node = *file_.Item("nodes", index);
    const std::optional<Placement> own = PlacementOf(node);
    if (!own.has_value()) {
      return Refuse("node ", index,
                    " is placed by something else than numbers");
    }
    const Placement placement = parent.After(*own);
    if (GltfMember(node, "mesh") != nullptr) {
      const uint64_t mesh = GltfNumber(node, "mesh", kNoGltfNumber);
      const Json* const found = file_.Item("meshes", mesh);
      if (found == nullptr) {
        return Refuse("node ", index, " has a mesh that is not there");
      }
      if (GltfMember(node, "skin") != nullptr) {
        return Refuse("node ", index, " has a skin, which is not read: ",
                      "apply its pose, or save the mesh without");
      }
      if (IsMorphed(GltfMember(node, "weights") != nullptr ? node : *found)) {
        return Refuse("node ", index, " has a mesh whose morph targets have ",
                      "weights, which are not read: apply them first");
      }
      if (!ReadInstances(index, node, mesh, *found, placement)) return false;
    }
    return Push(absl::StrCat("node ", index), node, "children", placement);
  }

  // Whether its morph targets change the mesh.
  static bool IsMorphed(const Json& node_or_mesh) {
    const Json* const weights = GltfMember(node_or_mesh, "weights");
    return weights != nullptr &&
           !std::all_of(weights->begin(), weights->end(),
                        [](const Json& weight) { return weight == 0; });
  }

  // The mesh of a node once, or where EXT_mesh_gpu_instancing puts it.
  bool ReadInstances(uint64_t index, const Json& node, uint64_t mesh_index,
                     const Json& mesh, const Placement& placement) {
    const Json* const extensions = GltfMember(node, "extensions");
    const Json* const instancing =
        extensions == nullptr
            ? nullptr
            : GltfMember(*extensions, "EXT_mesh_gpu_instancing");
    if (instancing == nullptr) return ReadMesh(mesh_index, mesh, placement);
    const Json* const attributes = GltfMember(*instancing, "attributes");
    std::array<std::optional<GltfNumbers>, 3> parts;
    std::optional<uint64_t> count;
    for (int i = 0; i < 3; ++i) {
      constexpr std::array<const char*, 3> kNames = {"TRANSLATION", "ROTATION",
                                                     "SCALE"};
      if (attributes == nullptr ||
          GltfMember(*attributes, kNames[i]) == nullptr) {
        continue;
      }
      const absl::StatusOr<GltfNumbers> found =
          file_.Accessor(GltfNumber(*attributes, kNames[i], kNoGltfNumber),
                         i == 1 ? "VEC4" : "VEC3");
      if (!found.ok()) {
        return Refuse("node ", index,
                      ": instances: ", found.status().message());
      }
      if (count.value_or(found->count()) != found->count()) {
        return Refuse("node ", index, ": its instances have ", *count, " and ",
                      found->count(), " places");
      }
      count = found->count();
      parts[i] = *found;
    }
    if (!count.has_value()) {
      return Refuse("node ", index, ": its instances have no TRANSLATION, ",
                    "ROTATION or SCALE");
    }
    for (uint64_t instance = 0; instance < *count; ++instance) {
      std::array<double, 3> shift = {0, 0, 0};
      std::array<double, 4> turn = {0, 0, 0, 1};
      std::array<double, 3> scale = {1, 1, 1};
      const auto take = [instance](const std::optional<GltfNumbers>& numbers,
                                   auto& values) {
        if (!numbers.has_value()) return;
        for (size_t k = 0; k < values.size(); ++k) {
          values[k] = numbers->Real(instance, static_cast<int>(k));
        }
      };
      take(parts[0], shift);
      take(parts[1], turn);
      take(parts[2], scale);
      // A mesh may be long to read, and add nothing.
      if (!builder_.Poll() ||
          !ReadMesh(mesh_index, mesh,
                    placement.After(PlacementOf(shift, turn, scale)))) {
        return false;
      }
    }
    return true;
  }

  bool ReadMesh(uint64_t index, const Json& mesh, const Placement& placement) {
    const Json* const primitives = GltfMember(mesh, "primitives");
    if (primitives == nullptr || !primitives->is_array()) return true;
    // Parts of a mesh often share their vertices.
    std::map<uint64_t, Vertices> vertices;
    mesh_begin_ = builder_.vertices();
    for (const Json& primitive : *primitives) {
      const uint64_t mode = GltfNumber(primitive, "mode", kTriangles);
      if (mode < kTriangles) continue;  // points and lines
      if (mode > kFan) {
        return Refuse("mesh ", index,
                      ": the mode of a primitive is not one of 0 to ", kFan);
      }
      const Json* const attributes = GltfMember(primitive, "attributes");
      const uint64_t positions =
          attributes == nullptr
              ? kNoGltfNumber
              : GltfNumber(*attributes, "POSITION", kNoGltfNumber);
      if (positions == kNoGltfNumber) {
        return Refuse("mesh ", index, ": a primitive has no POSITION");
      }
      const auto [entry, is_new] = vertices.try_emplace(positions);
      if (is_new && !AddVertices(index, positions, placement, entry->second)) {
        return false;
      }
      if (!AddFaces(index, primitive, mode, entry->second)) return false;
    }
    return true;
  }

  bool AddVertices(uint64_t mesh, uint64_t accessor, const Placement& placement,
                   Vertices& vertices) {
    const absl::StatusOr<GltfNumbers> points = file_.Accessor(accessor, "VEC3");
    if (!points.ok()) return RefuseMesh(mesh, points.status());
    vertices = {.first = builder_.vertices(), .count = points->count()};
    if (vertices.first - mesh_begin_ + vertices.count > most_of_mesh_) {
      return Refuse("mesh ", mesh, " repeats its vertices more than ",
                    kMostRepeats, " times");
    }
    for (uint64_t i = 0; i < points->count(); ++i) {
      const Point point = placement.Move(
          {points->Real(i, 0), points->Real(i, 1), points->Real(i, 2)});
      if (!std::isfinite(point[0]) || !std::isfinite(point[1]) ||
          !std::isfinite(point[2])) {
        return Refuse("mesh ", mesh, ": vertex ", i, " of accessor ", accessor,
                      " is not finite where its node puts it");
      }
      if (!builder_.AddVertex(point)) return false;
    }
    return true;
  }

  bool AddFaces(uint64_t mesh, const Json& primitive, uint64_t mode,
                const Vertices& vertices) {
    std::optional<GltfNumbers> indices;
    if (GltfMember(primitive, "indices") != nullptr) {
      absl::StatusOr<GltfNumbers> found = file_.Accessor(
          GltfNumber(primitive, "indices", kNoGltfNumber), "SCALAR");
      if (!found.ok()) return RefuseMesh(mesh, found.status());
      indices = *found;
    }
    const uint64_t corners =
        indices.has_value() ? indices->count() : vertices.count;
    if (mode == kTriangles && corners % 3 != 0) {
      return Refuse("mesh ", mesh, ": ", corners,
                    " corners are no whole number of triangles");
    }
    const uint64_t step = mode == kTriangles ? 3 : 1;
    for (uint64_t first = 0; first + 2 < corners; first += step) {
      std::array<uint64_t, 3> face = {first, first + 1, first + 2};
      if (mode == kFan) face[0] = 0;
      // Every other one of a strip turns the other way.
      if (mode == kStrip && first % 2 == 1) std::swap(face[1], face[2]);
      builder_.BeginFace();
      for (const uint64_t corner : face) {
        const uint64_t vertex =
            indices.has_value() ? indices->Index(corner) : corner;
        if (vertex >= vertices.count) {
          return Refuse(
              "mesh ", mesh, ": corner ", corner,
              NamesNoVertex(static_cast<int64_t>(vertex), vertices.count));
        }
        if (!builder_.AddCorner(
                static_cast<uint32_t>(vertices.first + vertex))) {
          return false;
        }
      }
    }
    return true;
  }

  bool RefuseMesh(uint64_t mesh, const absl::Status& why) {
    return Refuse("mesh ", mesh, ": ", why.message());
  }

  const GltfFile& file_;
  const uint64_t most_of_mesh_;  // vertices
  SoupBuilder builder_;
  uint64_t mesh_begin_ = 0;      // the first vertex of the mesh at hand
  std::vector<bool> is_placed_;  // by node
  std::vector<Visit> to_visit_;
};

}  // namespace

absl::StatusOr<TriangleSoup> ReadGltf(std::string_view bytes,
                                      const ReadLimits& limits) {
  const absl::StatusOr<GltfFile> file = GltfFile::Open(bytes);
  if (!file.ok()) return file.status();
  return GltfReader(*file, bytes.size(), limits).Read();
}

}  // namespace geodesic
