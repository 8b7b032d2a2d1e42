#include "tests/reliability/hard_questions.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <type_traits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic_types/mesh_format.h"
#include "tests/support/meshes/crowded_meshes.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/developable_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/needle_meshes.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/test_meshes.h"

namespace geodesic::client {
namespace {

using test::Random;

// Cells a side of a grid that has three fifths of so many faces.
uint32_t Side(uint32_t faces) {
  return static_cast<uint32_t>(std::lround(std::sqrt(0.3 * faces)));
}

TriangleSoup Grid(uint32_t faces) {
  return test::MakeGrid({.columns = Side(faces), .rows = Side(faces)});
}

// Every corner a vertex of its own: all edges are seams.
TriangleSoup TakenApart(const TriangleSoup& soup) {
  TriangleSoup apart;
  for (const Triangle& corners : soup.triangles) {
    const auto next = static_cast<uint32_t>(apart.positions.size());
    for (const uint32_t v : corners) {
      apart.positions.push_back(soup.positions[v]);
    }
    apart.triangles.push_back({next, next + 1, next + 2});
  }
  return apart;
}

uint32_t Levels(uint32_t faces) {
  uint32_t levels = 0;
  while (uint64_t{20} << 2 * (levels + 1) <= faces) ++levels;
  return levels;
}

std::vector<HardMesh> MadeMeshes(uint32_t n) {
  using namespace geodesic::test;  // NOLINT(google-build-using-namespace)
  std::vector<HardMesh> meshes = {
      {"pages", [n] { return Pages(n); }},
      {"needles", [n] { return NeedleFan(n); }},
      {"one point", [n] { return FanInOnePoint(n); }},
      {"fins", [n] { return FinnedStrip(n / 4); }},
      {"strip", [n] { return Strip(n / 2, 0.1, 1); }},
      {"folded strip", [n] { return FoldedSheet(n / 2, 1, 1).soup(); }},
      {"grid", [n] { return Grid(n); }},
      {"grid taken apart", [n] { return TakenApart(Grid(n / 2)); }},
      {"grid from both sides", [n] { return AddBackFaces(Grid(n / 2)); }},
      {"grid in two layers",
       [n] { return AddLayer(Grid(n / 2), n / 6, 0, 1); }},
      {"grid with needles",
       [n] { return InsertNeedles(Grid(n / 2), n / 6, 1); }},
      {"grid with faces without area",
       [n] { return InsertZeroAreaFaces(Grid(n / 20), n / 1000, 1); }},
      {"book",
       [n] { return Book(MakeGrid({.columns = 10, .rows = 30}), n / 600); }},
      {"hubs", [n] { return UvSphere(n / 4, 3); }},
      {"saddle fan",
       [n] {
         return Fan({.spokes = n / 6 * 2, .rings = 2, .total_angle = 20})
             .soup();
       }},
      {"prism", [n] { return Prism({.sides = n / 2, .rows = 1}).soup(); }},
      {"saddles", [n] { return HyperbolicGrid(Side(n), Side(n), 1e-3); }},
      {"saddle row", [] { return SaddleRow(900, 1e-8, 30); }},
      {"saddle cluster", [] { return SaddleCluster(1e-8, 40, 1.5); }},
      {"terrain", [n] { return Terrain(Side(n), Side(n), 1, 1); }},
      {"cliffs", [n] { return Terrain(Side(n), Side(n), 100, 1); }},
      {"long faces", [n] { return Torus({.around = n / 100, .across = 50}); }},
      {"sphere", [n] { return Icosphere(Levels(n)); }}};
  for (uint32_t seed = 1; seed <= 2; ++seed) {
    const std::string number = " " + std::to_string(seed);
    meshes.push_back({"needle rows" + number, [seed] {
                        Random random(seed);
                        return NeedleRows(random);
                      }});
    meshes.push_back({"needle book" + number, [seed] {
                        Random random(seed);
                        return NeedleBook(random);
                      }});
    meshes.push_back({"edited" + number, [seed] {
                        return EditedMesh(seed, /*degenerate=*/true);
                      }});
  }
  return meshes;
}

// Draws what a question names.
class Draw {
 public:
  Draw(const Subject& subject, Random& random)
      : mesh_(subject.info), random_(random) {}

  const std::string& mesh() const { return mesh_.digest; }

  // The mesh's, or almost none.
  double size() const {
    const Point& low = mesh_.bounding_box_min;
    const Point& high = mesh_.bounding_box_max;
    const double size =
        std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    return std::max(size, 1e-300);
  }

  // Every other time one of the first three, where most faces meet.
  SurfacePoint Vertex() {
    const auto count = static_cast<uint32_t>(mesh_.vertices);
    const bool is_first = random_.Below(2) == 0;
    return VertexPoint{random_.Below(is_first ? std::min(3u, count) : count)};
  }
  SurfacePoint Inside() { return InFace(Face()); }

  std::vector<SurfacePoint> Vertices(size_t count) {
    return Several<SurfacePoint>(count, [this] { return Vertex(); });
  }
  std::vector<SurfacePoint> Insides(size_t count) {
    return Several<SurfacePoint>(count, [this] { return Inside(); });
  }
  // At vertices.
  std::vector<Source> Sources(size_t count = 1) {
    return Several<Source>(count, [this] { return Source{Vertex()}; });
  }
  std::vector<Source> SourcesInside(size_t count = 1) {
    return Several<Source>(count, [this] { return Source{Inside()}; });
  }
  std::vector<Source> SomeCurve() {
    const uint32_t face = Face();
    return {{Curve{{InFace(face), InFace(face), InFace(face)}}}};
  }
  std::vector<PointPair> Pairs() {
    return Several<PointPair>(1000, [this] {
      return PointPair{Vertex(), Vertex()};
    });
  }

 private:
  template <typename Item, typename Make>
  static std::vector<Item> Several(size_t count, Make make) {
    std::vector<Item> items(count);
    std::ranges::generate(items, make);
    return items;
  }
  uint32_t Face() { return random_.Below(static_cast<uint32_t>(mesh_.faces)); }
  SurfacePoint InFace(uint32_t face) {
    const double a = random_.Uniform(0, 1);
    const double b = random_.Uniform(0, 1 - a);
    return FacePoint{face, {a, b, 1 - a - b}};
  }

  const MeshInfo& mesh_;
  Random& random_;
};

struct Streamed {
  FieldQuery query;
};

absl::Status Ask(Client& client, const FieldQuery& query,
                 const CallOptions& options) {
  return client.ComputeField(query, options).status();
}
absl::Status Ask(Client& client, const Streamed& streamed,
                 const CallOptions& options) {
  const auto ignore = [](std::span<const SettledVertex>) {};
  return client.StreamField(streamed.query, ignore, options).status();
}
absl::Status Ask(Client& client, const PathQuery& query,
                 const CallOptions& options) {
  return client.ComputePaths(query, options).status();
}
absl::Status Ask(Client& client, const IsolineQuery& query,
                 const CallOptions& options) {
  return client.ComputeIsolines(query, options).status();
}
absl::Status Ask(Client& client, const LogMapQuery& query,
                 const CallOptions& options) {
  return client.ComputeLogMap(query, options).status();
}
absl::Status Ask(Client& client, const SampleQuery& query,
                 const CallOptions& options) {
  return client.SampleFarthestPoints(query, options).status();
}
absl::Status Ask(Client& client, const MatrixQuery& query,
                 const CallOptions& options) {
  const auto ignore = [](const MatrixRow&) { return absl::OkStatus(); };
  return client.ComputeMatrix(query, {.on_row = ignore}, options).status();
}
absl::Status Ask(Client& client, const NearestQuery& query,
                 const CallOptions& options) {
  return client.FindNearest(query, options).status();
}
absl::Status Ask(Client& client, const PairQuery& query,
                 const CallOptions& options) {
  return client.ComputePairs(query, options).status();
}

// `make` makes a query of what it draws.
template <typename Make>
HardQuestion Question(std::string name, Make make) {
  using Query = std::invoke_result_t<Make, Draw&>;
  return {.name = std::move(name),
          .ask =
              [make](Client& client, const Subject& subject, Random& random,
                     const CallOptions& options) {
                Draw draw(subject, random);
                return Ask(client, make(draw), options);
              },
          .searches = std::is_same_v<Query, PathQuery> ||
                      std::is_same_v<Query, PairQuery>};
}
template <typename Make>
HardQuestion Search(std::string name, Make make) {
  HardQuestion question = Question(std::move(name), make);
  question.searches = true;
  return question;
}

// `send` returns an UploadOutcome.
template <typename Send>
HardQuestion Upload(std::string name, Send send) {
  return {.name = std::move(name),
          .ask = [send](Client& client, const Subject& subject, Random& random,
                        const CallOptions& options) -> absl::Status {
            const absl::StatusOr<UploadOutcome> outcome =
                send(client, subject, random, options);
            if (!outcome.ok()) return outcome.status();
            return client.DeleteMesh(outcome->mesh.digest);
          },
          .is_upload = true};
}

void AddUploads(std::vector<HardQuestion>& all) {
  all.push_back(Upload("upload", [](Client& client, const Subject& subject,
                                    Random&, const CallOptions& options) {
    return subject.Upload(client, options);
  }));
  all.push_back(
      Upload("upload of a file", [](Client& client, const Subject& subject,
                                    Random&, const CallOptions& options) {
        return client.UploadFile(subject.path, options);
      }));
  all.push_back(Upload("upload of a file to be welded",
                       [](Client& client, const Subject& subject,
                          Random& random, const CallOptions& options) {
                         return client.UploadFile(
                             subject.path, *MeshFormatFromPath(subject.path),
                             {.distance = random.OfAnySize(1e-6, 1)}, options);
                       }));
  all.push_back(
      {.name = "download",
       .ask = [](Client& client, const Subject& subject, Random&,
                 const CallOptions& options) {
         return client.ReadMesh(subject.info.digest, options).status();
       }});
}

void AddFields(std::vector<HardQuestion>& all) {
  for (const std::string& name : AlgorithmNames()) {
    all.push_back(Question("field by " + name, [name](Draw& draw) {
      return FieldQuery{.mesh_digest = draw.mesh(),
                        .sources = draw.Sources(),
                        .algorithm = name};
    }));
  }
  all.push_back(Question("field with gradients", [](Draw& draw) {
    return FieldQuery{.mesh_digest = draw.mesh(),
                      .sources = draw.Sources(3),
                      .nearest_sources = true,
                      .gradients = true};
  }));
  all.push_back(Question("field of many sources", [](Draw& draw) {
    return FieldQuery{.mesh_digest = draw.mesh(),
                      .sources = draw.SourcesInside(1000),
                      .nearest_sources = true,
                      .gradients = true};
  }));
  all.push_back(Question("field of a curve", [](Draw& draw) {
    return FieldQuery{.mesh_digest = draw.mesh(), .sources = draw.SomeCurve()};
  }));
  all.push_back(Question("field within a tolerance", [](Draw& draw) {
    return FieldQuery{.mesh_digest = draw.mesh(),
                      .sources = draw.Sources(),
                      .tolerance = 0.01,
                      .certified_errors = true};
  }));
  all.push_back(Search("field up to targets", [](Draw& draw) {
    return FieldQuery{.mesh_digest = draw.mesh(),
                      .sources = draw.SourcesInside(),
                      .targets = draw.Insides(100),
                      .stop_after_targets = 50};
  }));
  all.push_back(Question("streamed field", [](Draw& draw) {
    return Streamed{
        {.mesh_digest = draw.mesh(), .sources = draw.SourcesInside()}};
  }));
}

void AddFromFields(std::vector<HardQuestion>& all) {
  for (const size_t count : {1, 8, 1000}) {
    all.push_back(Question(count == 1 ? "path" : absl::StrCat(count, " paths"),
                           [count](Draw& draw) {
                             return PathQuery{.mesh_digest = draw.mesh(),
                                              .sources = draw.Sources(),
                                              .targets = draw.Vertices(count)};
                           }));
  }
  for (const double chord_error : {0.0, 1e-7}) {
    all.push_back(Question(chord_error == 0 ? "isolines" : "smooth isolines",
                           [chord_error](Draw& draw) {
                             IsolineQuery query{
                                 .mesh_digest = draw.mesh(),
                                 .sources = draw.Sources(),
                                 .levels = {},
                                 .chord_error = chord_error * draw.size()};
                             for (int i = 1; i <= 50; ++i) {
                               query.levels.push_back(draw.size() * i / 50);
                             }
                             return query;
                           }));
  }
  all.push_back(Question("log map", [](Draw& draw) {
    return LogMapQuery{.mesh_digest = draw.mesh(), .source = draw.Vertex()};
  }));
  all.push_back(Question("log map in a face", [](Draw& draw) {
    return LogMapQuery{.mesh_digest = draw.mesh(), .source = draw.Inside()};
  }));
  all.push_back(Question("samples", [](Draw& draw) {
    return SampleQuery{
        .mesh_digest = draw.mesh(), .sources = draw.Sources(), .count = 100};
  }));
}

void AddOfMany(std::vector<HardQuestion>& all) {
  all.push_back(Question("matrix", [](Draw& draw) {
    return MatrixQuery{.mesh_digest = draw.mesh(), .sources = draw.Sources(20)};
  }));
  all.push_back(Search("matrix of few targets", [](Draw& draw) {
    return MatrixQuery{.mesh_digest = draw.mesh(),
                       .sources = draw.Sources(50),
                       .targets = draw.Vertices(8)};
  }));
  all.push_back(Search("nearest", [](Draw& draw) {
    return NearestQuery{.mesh_digest = draw.mesh(),
                        .sources = draw.SourcesInside(50),
                        .targets = draw.Insides(1000),
                        .count = 3};
  }));
  all.push_back(Question("pairs", [](Draw& draw) {
    return PairQuery{.mesh_digest = draw.mesh(), .pairs = draw.Pairs()};
  }));
  all.push_back(Question("pairs with one end", [](Draw& draw) {
    PairQuery query{.mesh_digest = draw.mesh(), .pairs = {}};
    const SurfacePoint end = draw.Inside();
    for (const SurfacePoint& other : draw.Insides(1000)) {
      query.pairs.push_back({end, other});
    }
    return query;
  }));
  all.push_back(Question("pairs with paths", [](Draw& draw) {
    return PairQuery{
        .mesh_digest = draw.mesh(), .pairs = draw.Pairs(), .paths = true};
  }));
  all.push_back(Question("pairs within a tolerance", [](Draw& draw) {
    return PairQuery{
        .mesh_digest = draw.mesh(), .pairs = draw.Pairs(), .tolerance = 0.01};
  }));
}

void AddApproximate(std::vector<HardQuestion>& all) {
  for (const std::string& name : ApproximateAlgorithmNames()) {
    all.push_back(Question("field by " + name, [name](Draw& draw) {
      return FieldQuery{.mesh_digest = draw.mesh(),
                        .sources = draw.Sources(),
                        .algorithm = name};
    }));
    all.push_back(Question("matrix by " + name, [name](Draw& draw) {
      return MatrixQuery{.mesh_digest = draw.mesh(),
                         .sources = draw.Sources(20),
                         .algorithm = name};
    }));
    all.push_back(Question("pairs by " + name, [name](Draw& draw) {
      return PairQuery{
          .mesh_digest = draw.mesh(), .pairs = draw.Pairs(), .algorithm = name};
    }));
  }
  all.push_back(Question("field by svg of 1000 neighbours", [](Draw& draw) {
    return FieldQuery{.mesh_digest = draw.mesh(),
                      .sources = draw.Sources(),
                      .algorithm = "svg",
                      .approximation = {.neighbours = 1000}};
  }));
}

}  // namespace

std::vector<HardMesh> HardMeshes(uint32_t faces) {
  std::vector<HardMesh> meshes = MadeMeshes(faces);
  for (const char* name : {"flat_saddles", "hostile"}) {
    const std::filesystem::path folder = test::TestMeshFolder() / name;
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (!MeshFormatFromPath(entry.path().string()).ok()) continue;
      meshes.push_back({entry.path().filename(), nullptr, entry.path()});
    }
  }
  return meshes;
}

absl::StatusOr<UploadOutcome> Subject::Upload(
    Client& client, const CallOptions& options) const {
  return arrays.positions.empty() ? client.UploadFile(path, options)
                                  : client.UploadArrays(arrays, options);
}

std::vector<HardQuestion> HardQuestions() {
  std::vector<HardQuestion> all;
  AddUploads(all);
  AddFields(all);
  AddFromFields(all);
  AddOfMany(all);
  AddApproximate(all);
  return all;
}

}  // namespace geodesic::client
