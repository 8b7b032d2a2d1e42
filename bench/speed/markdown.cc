#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "bench/speed/benchmarks.h"
#include "bench/speed/report.h"

namespace geodesic::speed {
namespace {

using Value = std::optional<double>;

std::string Text(const Value& value, const char* format) {
  if (!value.has_value()) return "-";
  char text[64];
  std::snprintf(text, sizeof(text), format, *value);
  return text;
}

Value operator/(const Value& a, const Value& b) {
  if (!a.has_value() || !b.has_value()) return std::nullopt;
  return *a / *b;
}

Value operator*(const Value& a, double factor) {
  if (!a.has_value()) return std::nullopt;
  return *a * factor;
}

struct Column {
  std::string title;
  std::function<std::string(const Subject&)> cell;
};

// One row a subject.
void WriteTable(std::ostream& out, std::span<const Subject> subjects,
                const std::vector<Column>& columns) {
  out << "| mesh | faces |";
  for (const Column& column : columns) out << " " << column.title << " |";
  out << "\n|---|--:|";
  for (size_t i = 0; i < columns.size(); ++i) out << "--:|";
  out << "\n";
  for (const Subject& subject : subjects) {
    out << "| " << subject.name << " | " << subject.mesh->face_count() << " |";
    for (const Column& column : columns) {
      out << " " << column.cell(subject) << " |";
    }
    out << "\n";
  }
  out << "\n";
}

std::string SolveName(std::string_view algorithm, const Subject& subject) {
  return absl::StrCat("solve/", std::string(algorithm), "/", subject.name);
}

// A column for each algorithm that is measured, of `cell(name, subject)`.
template <typename Cell>
void AddAlgorithms(std::vector<Column>& columns, Cell cell) {
  for (const AlgorithmInfo& info : kAlgorithms) {
    if (!IsMeasured(info.algorithm)) continue;
    columns.push_back({absl::StrCat("`", std::string(info.name), "`"),
                       [cell, name = info.name](const Subject& subject) {
                         return cell(name, subject);
                       }});
  }
}

std::string CpuModel() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

void WriteHead(std::ostream& out, const std::string& command) {
  char date[32];
  const std::time_t now = std::time(nullptr);
  std::strftime(date, sizeof(date), "%Y-%m-%d", std::gmtime(&now));
  const benchmark::CPUInfo& cpu = benchmark::CPUInfo::Get();
  out << "# Benchmarks\n\nWritten by `scripts/bench`; "
         "docs/benchmarks.md says what the figures mean.\n\n"
      << "- " << date << ", " << CpuModel() << ", " << cpu.num_cpus
      << " processors, load "
      << Text(cpu.load_avg.empty() ? Value() : Value(cpu.load_avg[0]), "%.1f")
      << " at the start\n- g++ " << __VERSION__
#ifdef GEODESIC_CGAL_VERSION
      << ", CGAL " << GEODESIC_CGAL_VERSION
#endif
      << "\n- `" << command
      << "`\n\nTimes are processor time, but elapsed time where threads run "
         "side by side: medians of rounds in which all benchmarks take turns "
         "at random.\n\n";
}

void WriteSolve(std::ostream& out, const Report& report,
                std::span<const Subject> subjects) {
  const auto ms = [&](std::string_view algorithm, const Subject& subject) {
    return report.Milliseconds(SolveName(algorithm, subject));
  };
  const auto cgal = [&](const Subject& subject) {
    return report.Milliseconds(absl::StrCat("cgal/", subject.name));
  };
  const std::string_view fastest = AlgorithmName(kDefaultAlgorithm);
  out << "## One source, one thread\n\nMilliseconds, and how many times "
         "faster. CGAL is its Surface_mesh_shortest_path, run once; the last "
         "column is the largest relative difference from it.\n\n";
  std::vector<Column> columns;
  AddAlgorithms(columns, [=](std::string_view name, const Subject& subject) {
    return Text(ms(name, subject), "%.1f");
  });
  const auto ratio = [&](std::string_view slow, std::string_view fast) {
    columns.push_back(
        {absl::StrCat("`", std::string(slow), "` / `", std::string(fast), "`"),
         [=](const Subject& subject) {
           return Text(ms(slow, subject) / ms(fast, subject), "%.2f");
         }});
  };
  ratio("ich", "fwp-ch");
  ratio("mmp", "fwp-mmp");
  columns.push_back({"CGAL", [=](const Subject& subject) {
                       return Text(cgal(subject), "%.0f");
                     }});
  columns.push_back({absl::StrCat("CGAL / `", std::string(fastest), "`"),
                     [=](const Subject& subject) {
                       return Text(cgal(subject) / ms(fastest, subject),
                                   "%.0f");
                     }});
  columns.push_back(
      {"apart", [&](const Subject& subject) {
         return Text(report.Counter(absl::StrCat("cgal/", subject.name), "off"),
                     "%.0e");
       }});
  WriteTable(out, subjects, columns);
}

void WriteWindows(std::ostream& out, const Report& report,
                  std::span<const Subject> subjects) {
  const auto envelope = [&](const Subject& subject) {
    return report.Counter(absl::StrCat("envelope/", subject.name), "windows");
  };
  out << "## Windows\n\nThe lower envelope is what an edge-window method "
         "creates at the least: the windows that `fwp-mmp` ends with if it "
         "keeps all lists. Of each algorithm, windows created / envelope, and "
         "nanoseconds a window propagated.\n\n";
  std::vector<Column> columns;
  columns.push_back(
      {"envelope, a face", [=](const Subject& subject) {
         return Text(envelope(subject) /
                         Value(static_cast<double>(subject.mesh->face_count())),
                     "%.1f");
       }});
  AddAlgorithms(columns, [&report, envelope](std::string_view name,
                                             const Subject& subject) {
    const std::string solve = SolveName(name, subject);
    return absl::StrCat(
        Text(report.Counter(solve, "created") / envelope(subject), "%.2f"),
        ", ",
        Text(report.Milliseconds(solve) * 1e6 /
                 report.Counter(solve, "propagated"),
             "%.0f"),
        " ns");
  });
  WriteTable(out, subjects, columns);
}

void WriteMemory(std::ostream& out, const Report& report,
                 std::span<const Subject> subjects) {
  out << "## Memory\n\nBytes of the resident mesh, and what a solver holds "
         "beyond mesh and result (8 bytes a vertex) at its peak, in percent of "
         "the mesh.\n\n";
  std::vector<Column> columns;
  const auto resident = [](const Subject& subject) {
    return static_cast<double>(subject.mesh->resident_bytes());
  };
  columns.push_back(
      {"mesh, a face", [=](const Subject& subject) {
         return Text(resident(subject) / subject.mesh->face_count(), "%.1f");
       }});
  AddAlgorithms(columns, [&report, resident](std::string_view name,
                                             const Subject& subject) {
    const Value bytes = report.Counter(SolveName(name, subject), "bytes");
    if (!bytes.has_value()) return std::string("-");
    return Text(
        (*bytes - 8.0 * subject.mesh->vertex_count()) / resident(subject) * 100,
        "%.0f%%");
  });
  WriteTable(out, subjects, columns);
}

void WriteSources(std::ostream& out, const Report& report,
                  std::span<const Subject> subjects) {
  const auto ms = [&](int threads, const Subject& subject) {
    return report.Milliseconds(
        absl::StrCat("sources/", threads, "/", subject.name));
  };
  out << "## Many sources side by side\n\nMilliseconds for the fields of 64 "
         "sources, and how many times faster than one thread.\n\n";
  std::vector<Column> columns;
  for (int threads = 1; threads <= benchmark::CPUInfo::Get().num_cpus;
       threads *= 2) {
    columns.push_back(
        {absl::StrCat(threads, threads == 1 ? " thread" : " threads"),
         [=](const Subject& subject) {
           return Text(ms(threads, subject), "%.0f") +
                  (threads == 1
                       ? ""
                       : " (" +
                             Text(ms(1, subject) / ms(threads, subject),
                                  "%.2f") +
                             ")");
         }});
  }
  WriteTable(out, subjects, columns);
}

void WritePairs(std::ostream& out, const Report& report,
                std::span<const Subject> subjects) {
  const auto counter = [&](const Subject& subject, const std::string& name) {
    return report.Counter(absl::StrCat("pairs/", subject.name), name);
  };
  const auto cgal = [&](const Subject& subject, const std::string& name) {
    return report.Counter(absl::StrCat("cgal_pairs/", subject.name), name);
  };
  out << "## Pairs\n\nMilliseconds and windows for the distance between two "
         "random vertices: the median and the 99th percentile of 1,000 pairs, "
         "by a search without landmarks, with 64, and by a field that stops at "
         "the target. Then what making the landmarks takes, how many times "
         "faster than the field the searches are, and CGAL's median of three "
         "of the pairs; last the largest relative difference of all of "
         "them.\n\n";
  std::vector<Column> columns;
  for (const char* way : {"search", "landmarks", "field"}) {
    const auto add = [&](const std::string& title, const std::string& name,
                         const char* format) {
      columns.push_back({title, [=](const Subject& subject) {
                           return absl::StrCat(
                               Text(counter(subject, name), format), ", ",
                               Text(counter(subject, name + "_p99"), format));
                         }});
    };
    add(absl::StrCat(way, ", ms"), way, "%.1f");
    add(absl::StrCat(way, ", windows"), absl::StrCat(way, "_windows"), "%.0f");
  }
  columns.push_back({"made, ms", [=](const Subject& subject) {
                       return Text(counter(subject, "made"), "%.0f");
                     }});
  for (const char* way : {"search", "landmarks"}) {
    columns.push_back({absl::StrCat("field / ", way), [=](const Subject& s) {
                         return Text(counter(s, "field") / counter(s, way),
                                     "%.1f");
                       }});
  }
  columns.push_back({"CGAL, ms", [=](const Subject& subject) {
                       return Text(cgal(subject, "median"), "%.0f");
                     }});
  columns.push_back({"apart", [=](const Subject& subject) {
                       const Value ours = counter(subject, "off");
                       const Value theirs = cgal(subject, "off");
                       return Text(ours < theirs ? theirs : ours, "%.0e");
                     }});
  WriteTable(out, subjects, columns);
}

void WriteUpload(std::ostream& out, const Report& report,
                 std::span<const Subject> subjects) {
  out << "## Upload\n\nMilliseconds from the first byte at the engine to a "
         "resident mesh, by steps (which overlap in `whole`), beside a plain "
         "loop that reads the same file (binary PLY of triangles only).\n\n";
  std::vector<Column> columns;
  const auto ms = [&](const char* step, const Subject& subject) {
    return report.Milliseconds(
        absl::StrCat("upload/", step, "/", subject.name));
  };
  for (const char* step :
       {"plain", "receive", "parse", "digest", "build", "summarize", "whole"}) {
    columns.push_back({step, [=](const Subject& subject) {
                         return Text(ms(step, subject), "%.1f");
                       }});
  }
  columns.push_back({"whole / plain", [=](const Subject& subject) {
                       return Text(ms("whole", subject) / ms("plain", subject),
                                   "%.1f");
                     }});
  WriteTable(out, subjects, columns);
}

}  // namespace

void WriteMarkdown(std::ostream& out, const Report& report,
                   std::span<const Subject> subjects,
                   const std::string& command) {
  WriteHead(out, command);
  WriteSolve(out, report, subjects);
  WriteWindows(out, report, subjects);
  WriteMemory(out, report, subjects);
  WriteSources(out, report, subjects);
  WritePairs(out, report, subjects);
  WriteUpload(out, report, subjects);
}

}  // namespace geodesic::speed
