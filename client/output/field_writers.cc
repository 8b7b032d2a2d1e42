// The formats that hold the values only: .npy, .csv, .f64 and .f32.

#include "client/output/field_writers.h"

#include "absl/strings/str_cat.h"
#include "client/output/csv.h"
#include "client/output/npy.h"

namespace geodesic::client {

void WriteNpy(const Column& column, AtomicFile* file) {
  std::vector<uint64_t> shape = {column.count()};
  if (column.components > 1) shape.push_back(column.components);
  file->Append(NpyHeader(NumpyName(column.type), shape));
  AppendNumbers(column.values, column.type, file);
}

void WriteCsv(std::span<const Column> columns, AtomicFile* file) {
  CsvLine line;
  line.Text("vertex");
  for (const Column& column : columns) {
    if (column.components == 1) {
      line.Text(column.name);
    } else {
      for (const char* axis : {"_x", "_y", "_z"}) line.Text(column.name + axis);
    }
  }
  file->Append(line.End());
  const size_t count = columns.empty() ? 0 : columns[0].count();
  for (size_t vertex = 0; vertex < count; ++vertex) {
    line.Integer(static_cast<int64_t>(vertex));
    for (const Column& column : columns) {
      for (size_t i = 0; i < column.components; ++i) {
        const double value = column.values[vertex * column.components + i];
        if (column.is_integer()) {
          line.Integer(static_cast<int64_t>(value));
        } else if (column.type == NumberType::kFloat32) {
          line.Number(static_cast<float>(value));
        } else {
          line.Number(value);
        }
      }
    }
    file->Append(line.End());
  }
}

void WriteRaw(const Column& column, NumberType type, AtomicFile* file) {
  AppendNumbers(column.values, type, file);
}

}  // namespace geodesic::client
