#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "arrays.h"
#include "bindings.h"
#include "geodesic/join_seams.h"
#include "geodesic/mesh_summary.h"
#include "geodesic/polygons.h"
#include "geodesic/read_mesh.h"
#include "geodesic/surface_point.h"
#include "places.h"
#include "status.h"
#include "subject.h"
#include "watch.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;
using DoubleArray = py::array_t<double, py::array::c_style>;
using IntegerArray = py::array_t<int64_t, py::array::c_style>;

// More than the largest mesh takes in any format.
constexpr uint64_t kMostGzipBytes = uint64_t{1} << 40;

using JoinedArray = py::array_t<uint32_t, py::array::c_style>;

// `distance` has no value: seams.
Welding WeldingOf(bool joins, std::optional<double> distance) {
  if (!joins) return {.kind = Welding::Kind::kNone};
  if (!distance.has_value()) return {};
  return {.kind = Welding::Kind::kWithin, .distance = *distance};
}

MeshHandle BuildMesh(const DoubleArray& vertices, const py::array& faces,
                     bool joins, std::optional<double> distance) {
  TriangleSoup soup{ToPoints(vertices), ToTriangles(faces)};
  const Welding welding = WeldingOf(joins, distance);
  Watch watch{py::none()};
  return MeshHandle(
      watch.Run([&]() -> absl::StatusOr<std::shared_ptr<const Mesh>> {
        const absl::Status status = JoinSeams(welding, soup, watch);
        if (!status.ok()) return status;
        return Mesh::Build(std::move(soup), watch);
      }));
}

// A mesh of what another one told of itself. `joined`: (J, 2); `numbers`: seam
// edges, crossing polygons and the first of these.
MeshHandle RestoreMesh(const DoubleArray& vertices, const py::array& faces,
                       const JoinedArray& joined,
                       const std::array<uint64_t, 3>& numbers) {
  TriangleSoup soup{ToPoints(vertices), ToTriangles(faces)};
  soup.reading.seam_edges = numbers[0];
  soup.reading.crossing_polygons = numbers[1];
  soup.reading.first_crossing_polygon = numbers[2];
  for (py::ssize_t i = 0; i < joined.shape(0); ++i) {
    soup.reading.joined.push_back({joined.at(i, 0), joined.at(i, 1)});
  }
  Watch watch{py::none()};
  return MeshHandle(
      watch.Run([&] { return Mesh::Build(std::move(soup), watch); }));
}

// (joined, numbers) as RestoreMesh takes them.
py::tuple ReadingOf(const MeshHandle& self) {
  const Reading& reading = self.mesh->reading();
  std::vector<std::array<uint32_t, 2>> joined;
  joined.reserve(reading.joined.size());
  for (const auto& [vertex, into] : reading.joined) {
    joined.push_back({vertex, into});
  }
  return py::make_tuple(
      ToArray(std::move(joined)),
      std::array<uint64_t, 3>{reading.seam_edges, reading.crossing_polygons,
                              reading.first_crossing_polygon});
}

py::tuple Triangulate(const DoubleArray& vertices, const IntegerArray& corners,
                      const IntegerArray& sizes) {
  std::vector<Point> positions = ToPoints(vertices);
  const auto all = [](const IntegerArray& numbers) {
    return std::span(numbers.data(), static_cast<size_t>(numbers.size()));
  };
  Watch watch{py::none()};
  TriangleSoup soup = watch.Run([&] {
    return TriangulatePolygons(std::move(positions), all(corners), all(sizes),
                               &watch);
  });
  return py::make_tuple(ToArray(std::move(soup.triangles)),
                        soup.reading.crossing_polygons,
                        soup.reading.first_crossing_polygon);
}

std::string FormatOf(const std::string& path) {
  return std::string(MeshFormatName(ValueOrThrow(MeshFormatFromPath(path))));
}

MeshHandle ReadFile(const py::bytes& bytes, const std::string& name, bool joins,
                    std::optional<double> distance) {
  const MeshFormat format = ValueOrThrow(MeshFormatFromPath(name));
  const std::string_view text = bytes;
  Watch watch{py::none()};
  return MeshHandle(
      watch.Run([&]() -> absl::StatusOr<std::shared_ptr<const Mesh>> {
        absl::StatusOr<TriangleSoup> soup =
            ReadMesh(text, format,
                     {.max_gzip_bytes = kMostGzipBytes,
                      .checkpoint = &watch,
                      .welding = WeldingOf(joins, distance)});
        if (!soup.ok()) return soup.status();
        return Mesh::Build(*std::move(soup), watch);
      }));
}

py::array_t<double> Positions(const py::object& self) {
  const auto& mesh = *self.cast<const MeshHandle&>().mesh;
  return ViewOf(mesh.positions().data()->data(), {mesh.vertex_count(), 3},
                self);
}

py::array_t<double> PositionsOf(const MeshHandle& self,
                                const PlaceArrays& places) {
  const Mesh& mesh = *self.mesh;
  std::vector<Point> positions;
  for (const SurfacePoint& point : ToSurfacePoints(places)) {
    const absl::Status status =
        Validate(point, mesh, absl::StrCat("places[", positions.size(), "]"));
    if (!status.ok()) Throw(status);
    // As in questions, weights are divided by their sum.
    positions.push_back(PositionOf(Canonicalize(point, mesh), mesh));
  }
  return ToArray(std::move(positions));
}

py::array_t<int32_t> Triangles(const MeshHandle& self) {
  std::vector<std::array<int32_t, 3>> faces(self.mesh->face_count());
  for (uint32_t f = 0; f < self.mesh->face_count(); ++f) {
    std::ranges::copy(self.mesh->NamedTriangle(f), faces[f].begin());
  }
  return ToArray(std::move(faces));
}

std::vector<std::string> NotesOf(const MeshHandle& self) {
  const py::gil_scoped_release unlocked;
  return Notes(SummarizeReading(*self.mesh));
}

// Which of the vertices are on no face; false for numbers out of range.
py::array_t<bool> Isolated(const MeshHandle& self,
                           const IntegerArray& vertices) {
  const Mesh& mesh = *self.mesh;
  py::array_t<bool> isolated(vertices.size());
  for (py::ssize_t i = 0; i < vertices.size(); ++i) {
    const int64_t v = vertices.data()[i];
    isolated.mutable_data()[i] =
        v >= 0 && v < mesh.vertex_count() &&
        mesh.Outgoing(mesh.JoinedInto(static_cast<uint32_t>(v))).empty();
  }
  return isolated;
}

py::dict Facts(const MeshHandle& self) {
  MeshSummary summary;
  {
    const py::gil_scoped_release unlocked;
    summary = Summarize(*self.mesh);
  }
  py::dict facts;
  ForEachFact(summary, [&facts](const char* name, const auto& fact) {
    facts[name] = py::cast(fact);
  });
  facts["notes"] = py::cast(Notes(summary));
  return facts;
}

QueryHandle MakeQuery(const MeshHandle& mesh, const SourceArrays& sources,
                      const PlaceArrays& targets, const std::string& algorithm,
                      bool trace, double tolerance) {
  return {mesh, ValueOrThrow(ValidQuery::Make(
                    {.sources = ToSources(sources),
                     .targets = ToSurfacePoints(targets),
                     .algorithm = ValueOrThrow(AlgorithmFromName(algorithm)),
                     .trace = trace,
                     .tolerance = tolerance},
                    *mesh.mesh))};
}

}  // namespace

void BindMesh(py::module_& module) {
  py::class_<PlaceArrays>(module, "Places")
      .def(py::init<PlaceArrays::Array<uint8_t>, PlaceArrays::Array<uint32_t>,
                    PlaceArrays::Array<double>>())
      .def_readonly("kinds", &PlaceArrays::kinds)
      .def_readonly("numbers", &PlaceArrays::numbers)
      .def_readonly("weights", &PlaceArrays::weights);
  py::class_<SourceArrays>(module, "Sources")
      .def(py::init<PlaceArrays, PlaceArrays::Array<int64_t>,
                    PlaceArrays::Array<double>>());
  py::class_<MeshHandle>(module, "Mesh")
      .def(py::init(&BuildMesh))
      .def_static("read", &ReadFile)
      .def_static("restore", &RestoreMesh)
      .def("reading", &ReadingOf)
      .def("notes", &NotesOf)
      .def("isolated", &Isolated)
      .def_property_readonly("positions", &Positions)
      .def("positions_of", &PositionsOf)
      .def_property_readonly(
          "vertex_count",
          [](const MeshHandle& self) { return self.mesh->vertex_count(); })
      .def_property_readonly(
          "face_count",
          [](const MeshHandle& self) { return self.mesh->face_count(); })
      .def("triangles", &Triangles)
      .def("facts", &Facts);
  module.def("mesh_format", &FormatOf);
  module.def("triangulate", &Triangulate);
  py::class_<QueryHandle>(module, "Query").def(py::init(&MakeQuery));
}

}  // namespace geodesic::python
