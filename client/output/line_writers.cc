#include "client/output/line_writers.h"

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/output/binary_numbers.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

using Json = nlohmann::ordered_json;

size_t PointCount(const Line& line) { return line.polyline.positions.size(); }

// Pieces between points, including the one that closes the line.
size_t PieceCount(const Line& line) {
  const size_t points = PointCount(line);
  return points < 2 ? 0 : points - (line.is_closed ? 0 : 1);
}

struct Totals {
  size_t points = 0;
  size_t pieces = 0;
  size_t lines = 0;  // with points
};

Totals TotalsOf(const Lines& lines) {
  Totals totals;
  for (const Line& line : lines.lines) {
    totals.points += PointCount(line);
    totals.pieces += PieceCount(line);
    totals.lines += PointCount(line) == 0 ? 0 : 1;
  }
  return totals;
}

// Visits the numbers of the line's points in order, the first of which is
// `first`. A closed line ends with `first` again.
template <typename Visit>
void VisitIndices(const Line& line, size_t first, Visit visit) {
  for (size_t i = 0; i < PointCount(line); ++i) visit(first + i);
  if (line.is_closed && PointCount(line) > 1) visit(first);
}

Json AttributeJson(const Attribute& attribute, double value) {
  if (!std::isfinite(value)) return nullptr;
  if (!IsInteger(attribute.type)) return value;
  if (value < 0) return nullptr;
  return static_cast<int64_t>(value);
}

Json GeometryJson(const Line& line) {
  if (PointCount(line) < 2) return nullptr;
  Json coordinates = line.polyline.positions;
  if (line.is_closed) coordinates.push_back(line.polyline.positions[0]);
  return {{"type", "LineString"}, {"coordinates", std::move(coordinates)}};
}

Json FeatureJson(const Lines& lines, const Line& line) {
  Json properties = Json::object();
  for (size_t i = 0; i < lines.attributes.size(); ++i) {
    properties[lines.attributes[i].name] =
        AttributeJson(lines.attributes[i], line.values[i]);
  }
  properties["closed"] = line.is_closed;
  Json points = Json::array();
  for (const SurfacePoint& point : line.polyline.points) {
    points.push_back(PointToJson(point));
  }
  properties["points"] = std::move(points);
  return {{"type", "Feature"},
          {"geometry", GeometryJson(line)},
          {"properties", std::move(properties)}};
}

void WriteObj(const Lines& lines, AtomicFile* file) {
  size_t first = 1;  // OBJ counts from 1
  for (size_t number = 0; number < lines.lines.size(); ++number) {
    const Line& line = lines.lines[number];
    if (PointCount(line) == 0) continue;
    std::string text = "#";
    for (size_t i = 0; i < lines.attributes.size(); ++i) {
      absl::StrAppend(&text, " ", lines.attributes[i].name, " ",
                      TextOf(line.values[i], lines.attributes[i].type));
    }
    absl::StrAppend(&text, "\ng line_", number, "\n");
    for (const Point& point : line.polyline.positions) {
      absl::StrAppend(&text, "v ", NumberText(point[0]), " ",
                      NumberText(point[1]), " ", NumberText(point[2]), "\n");
    }
    if (PointCount(line) == 1) {
      absl::StrAppend(&text, "p ", first, "\n");
    } else {
      // Widely used readers keep the first piece of a longer statement alone.
      size_t previous = 0;
      VisitIndices(line, first, [&text, &previous](size_t i) {
        if (previous != 0) absl::StrAppend(&text, "l ", previous, " ", i, "\n");
        previous = i;
      });
    }
    first += PointCount(line);
    file->Append(text);
  }
}

void WritePly(const Lines& lines, AtomicFile* file) {
  const Totals totals = TotalsOf(lines);
  std::string text = absl::StrCat(
      "ply\nformat binary_little_endian 1.0\nelement vertex ", totals.points,
      "\nproperty double x\nproperty double y\nproperty double z\n"
      "element edge ",
      totals.pieces,
      "\nproperty int vertex1\nproperty int vertex2\nproperty int line\n");
  for (const Attribute& attribute : lines.attributes) {
    absl::StrAppend(&text, "property ", std::string(PlyName(attribute.type)),
                    " ", attribute.name, "\n");
  }
  file->Append(text + "end_header\n");
  for (const Line& line : lines.lines) {
    file->Append(line.polyline.positions.data(),
                 line.polyline.positions.size() * sizeof(Point));
  }
  size_t first = 0;
  for (size_t number = 0; number < lines.lines.size(); ++number) {
    const Line& line = lines.lines[number];
    std::string rows;
    double previous = -1;
    VisitIndices(line, first, [&](size_t index) {
      const auto vertex = static_cast<double>(index);
      if (previous >= 0) {
        const std::array<double, 3> edge = {previous, vertex,
                                            static_cast<double>(number)};
        AppendNumbers(edge, NumberType::kInt32, &rows);
        for (size_t i = 0; i < lines.attributes.size(); ++i) {
          AppendNumbers({&line.values[i], 1}, lines.attributes[i].type, &rows);
        }
      }
      previous = vertex;
    });
    file->Append(rows);
    first += PointCount(line);
  }
}

void WriteVtk(const Lines& lines, AtomicFile* file) {
  const Totals totals = TotalsOf(lines);
  file->Append(absl::StrCat(
      "# vtk DataFile Version 3.0\ngeodesic lines\nBINARY\nDATASET POLYDATA\n"
      "POINTS ",
      totals.points, " double\n"));
  size_t indices = 0;
  for (const Line& line : lines.lines) {
    for (const Point& point : line.polyline.positions) {
      AppendNumbers(point, NumberType::kFloat64, file, std::endian::big);
    }
    VisitIndices(line, 0, [&indices](size_t) { ++indices; });
  }
  file->Append(absl::StrCat("\nLINES ", totals.lines, " ",
                            totals.lines + indices, "\n"));
  size_t first = 0;
  for (const Line& line : lines.lines) {
    if (PointCount(line) == 0) continue;
    std::vector<double> row = {0};
    VisitIndices(line, first,
                 [&row](size_t i) { row.push_back(static_cast<double>(i)); });
    row[0] = static_cast<double>(row.size() - 1);
    AppendNumbers(row, NumberType::kInt32, file, std::endian::big);
    first += PointCount(line);
  }
  file->Append(absl::StrCat("\nCELL_DATA ", totals.lines));
  for (size_t i = 0; i < lines.attributes.size(); ++i) {
    // Integers, too, are double here.
    const NumberType type = IsInteger(lines.attributes[i].type)
                                ? NumberType::kFloat64
                                : lines.attributes[i].type;
    file->Append(absl::StrCat("\nSCALARS ", lines.attributes[i].name, " ",
                              std::string(PlyName(type)),
                              " 1\nLOOKUP_TABLE default\n"));
    for (const Line& line : lines.lines) {
      if (PointCount(line) == 0) continue;
      AppendNumbers({&line.values[i], 1}, type, file, std::endian::big);
    }
  }
  file->Append("\n");
}

void WriteCsv(const Lines& lines, AtomicFile* file) {
  CsvLine row;
  for (const char* name : {"line", "point", "x", "y", "z", "place"}) {
    row.Text(name);
  }
  for (const Attribute& attribute : lines.attributes) row.Text(attribute.name);
  file->Append(row.End());
  for (size_t number = 0; number < lines.lines.size(); ++number) {
    const Line& line = lines.lines[number];
    int64_t point = 0;
    VisitIndices(line, 0, [&](size_t i) {
      row.Number(number).Number(point++);
      for (const double coordinate : line.polyline.positions[i]) {
        row.Number(coordinate);
      }
      row.Text(PointText(line.polyline.points[i]));
      for (size_t a = 0; a < lines.attributes.size(); ++a) {
        row.Text(TextOf(line.values[a], lines.attributes[a].type));
      }
      file->Append(row.End());
    });
  }
}

void WriteJson(const Lines& lines, AtomicFile* file) {
  file->Append("{\"type\":\"FeatureCollection\",\"features\":[");
  const char* separator = "\n";
  for (const Line& line : lines.lines) {
    file->Append(separator);
    file->Append(FeatureJson(lines, line).dump());
    separator = ",\n";
  }
  file->Append("\n]}\n");
}

}  // namespace

void WriteLines(const Lines& lines, OutputFormat format, AtomicFile* file) {
  switch (format) {
    case OutputFormat::kObj:
      return WriteObj(lines, file);
    case OutputFormat::kPly:
      return WritePly(lines, file);
    case OutputFormat::kVtk:
      return WriteVtk(lines, file);
    case OutputFormat::kCsv:
      return WriteCsv(lines, file);
    default:
      return WriteJson(lines, file);
  }
}

}  // namespace geodesic::client
