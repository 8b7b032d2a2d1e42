// Distances of pairs, through the library and the command.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic_client/errors.h"
#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class PairsTest : public PlanarGridTest {
 protected:
  // Between all sorts of places.
  std::vector<PointPair> SomePairs(size_t count) const {
    std::vector<PointPair> pairs;
    for (uint32_t i = 0; i < count; ++i) {
      const VertexPoint vertex{i * 7 % kVertices};
      pairs.push_back(i % 5 == 0 ? PointPair{places_[i % 3], vertex}
                                 : PointPair{vertex, VertexPoint{i * i % 80}});
    }
    return pairs;
  }

  void ExpectEuclid(const std::vector<PointPair>& pairs,
                    std::span<const double> distances) const {
    ASSERT_EQ(distances.size(), pairs.size());
    for (size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_NEAR(distances[i],
                  Euclid(Where(pairs[i].source), Where(pairs[i].target)),
                  kTolerance)
          << i;
    }
  }
};

TEST_F(PairsTest, VerticesAndFloats) {
  PairQuery query = {.mesh_digest = digest_, .value_type = ValueType::kFloat32};
  for (uint32_t i = 0; i < 40; ++i) {
    query.pairs.push_back({VertexPoint{i}, VertexPoint{80 - i}});
  }
  const auto answer = client_.ComputePairs(query);
  ASSERT_TRUE(answer.ok()) << answer.status();
  for (size_t i = 0; i < 40; ++i) {
    EXPECT_FLOAT_EQ(answer->distances[i], Euclid(At(i), At(80 - i)));
  }
}

TEST_F(PairsTest, AReceiverMayEndIt) {
  const absl::Status full = absl::DataLossError("full");
  EXPECT_EQ(client_
                .ComputePairs(
                    {.mesh_digest = digest_, .pairs = SomePairs(20)},
                    PairReceiver{.on_distances =
                                     [&](uint64_t, std::span<const double>) {
                                       return full;
                                     }})
                .status(),
            full);
}

TEST_F(PairsTest, ALongListTakesSeveralCalls) {
  const RunningServer small(folder_, {"--limit", "max-pairs=7"});
  Client client(small.address());
  ASSERT_TRUE(client.UploadArrays(mesh_).ok());
  PairQuery query = {.mesh_digest = digest_, .pairs = SomePairs(100)};
  uint64_t next = 0;
  uint64_t finished = 0;
  std::vector<double> distances;
  const auto summary = client.ComputePairs(
      query,
      PairReceiver{.on_distances =
                       [&](uint64_t first, std::span<const double> some) {
                         EXPECT_EQ(first, next);
                         next += some.size();
                         distances.insert(distances.end(), some.begin(),
                                          some.end());
                         return absl::OkStatus();
                       },
                   .on_progress =
                       [&](uint64_t count, uint64_t total) {
                         EXPECT_GE(count, finished);
                         EXPECT_EQ(total, 100);
                         finished = count;
                       }});
  ASSERT_TRUE(summary.ok()) << summary.status();
  ExpectEuclid(query.pairs, distances);
  EXPECT_EQ(summary->searched, 100);
  EXPECT_EQ(summary->info.mesh_digest, digest_);
  // Errors know the number in the whole list.
  query.pairs[52].source = VertexPoint{1000};
  const absl::Status status = client.ComputePairs(query).status();
  EXPECT_EQ(ErrorField(status), "pairs[52].source.vertex");
  EXPECT_THAT(std::string(status.message()),
              StartsWith("pairs[52].source.vertex 1000 is out of range"));
}

TEST_F(PairsTest, TheCommandWritesPaths) {
  WriteFile(folder_ / "p.txt", "0 80\n3 edge:0-10@0.25\n");
  GeodesicJson({"distance", grid_, "--pairs", folder_ / "p.txt", "-o",
                folder_ / "p.json", "-o", folder_ / "d.csv", "-o",
                folder_ / "p.obj"});
  const json paths = json::parse(FileBytes(folder_ / "p.json"));
  ASSERT_EQ(paths["features"].size(), 2);
  const json& second = paths["features"][1];
  EXPECT_EQ(second["properties"]["pair"], 1);
  EXPECT_NEAR(second["properties"]["distance"],
              Euclid(At(3), Where(places_[1])), kTolerance);
  EXPECT_EQ(second["properties"]["points"].front()["vertex"], 3);
  EXPECT_EQ(second["properties"]["points"].back()["edge"], json({0, 10}));
  EXPECT_THAT(FileBytes(folder_ / "d.csv"),
              HasSubstr("\n0,80,1.41421356237309"));
  EXPECT_THAT(FileBytes(folder_ / "p.obj"), HasSubstr("\nl "));
}

TEST_F(PairsTest, TheCommandPrintsOneDistance) {
  const ProcessResult text = Geodesic({"distance", grid_, "0", "80", "-q"});
  EXPECT_THAT(text.out, HasSubstr("1.414213562373095"));
  const json answer =
      GeodesicJson({"distance", digest_, "9", "face:40@0.2,0.3,0.5"});
  EXPECT_NEAR(answer["distance"], Euclid(At(9), Where(places_[0])), kTolerance);
  EXPECT_EQ(answer["source"]["vertex"], 9);
  EXPECT_EQ(answer["target"]["face"], 40);
  EXPECT_EQ(answer["pairs_searched"], 1);
}

TEST_F(PairsTest, TheCommandWritesListsAsTheyCome) {
  // Enough for a field, with 64 landmarks as well.
  constexpr size_t kPairs = 76;
  std::string list = "# two places a line\n";
  std::vector<PointPair> pairs;
  for (uint32_t i = 0; i < kPairs; ++i) {
    absl::StrAppend(&list, i, i % 2 == 0 ? "," : " ", "edge:0-10@0.25\n");
    pairs.push_back({VertexPoint{i}, places_[1]});
  }
  WriteFile(folder_ / "p.txt", list);
  const json answer =
      GeodesicJson({"distance", grid_, "--pairs", folder_ / "p.txt", "-o",
                    folder_ / "d.csv", "-o", folder_ / "d.npy"});
  EXPECT_EQ(answer["pairs"], kPairs);
  EXPECT_EQ(answer["pairs_from_fields"], kPairs);
  EXPECT_FALSE(answer.contains("distances"));
  const std::string npy = FileBytes(folder_ / "d.npy");
  EXPECT_THAT(npy, HasSubstr(absl::StrCat("'shape': (", kPairs, ",), }")));
  std::vector<double> distances(kPairs);
  ASSERT_EQ(npy.size(), 128 + kPairs * sizeof(double));
  std::memcpy(distances.data(), npy.data() + 128, kPairs * sizeof(double));
  ExpectEuclid(pairs, distances);
  const ProcessResult text =
      Geodesic({"distance", grid_, "--pairs", folder_ / "p.txt"});
  EXPECT_EQ(text.out, FileBytes(folder_ / "d.csv"));
  EXPECT_THAT(text.out, StartsWith("source,target,distance\n"
                                   "0,edge:0-10@0.25,"));
  const json kept =
      GeodesicJson({"distance", grid_, "--pairs", folder_ / "p.txt"});
  EXPECT_EQ(kept["distances"].get<std::vector<double>>(), distances);
}

TEST_F(PairsTest, WhoWritesAPipeIsAnsweredAtOnce) {
  const std::string path = folder_ / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int end =
      open(path.c_str(), O_RDWR | O_CLOEXEC);  // so that neither end waits
  Process distance(CommandLine({"distance", grid_, "--pairs", path}));
  for (const auto& [pair, line] :
       {std::pair{"0 80\n", "\n0,80,1.41421356237309"},
        {"7 7\n", "\n7,7,0\n"}}) {
    ASSERT_EQ(write(end, pair, std::strlen(pair)), std::strlen(pair));
    EXPECT_TRUE(distance.AwaitOutput(line)) << line;
  }
  close(end);
  EXPECT_EQ(distance.Wait().exit_code, 0);
}

TEST_F(PairsTest, TheCommandNamesFileAndLine) {
  constexpr int kUsage = 2;
  constexpr int kFile = 3;
  constexpr int kRefused = 5;
  const std::string path = folder_ / "p.txt";
  const std::vector<std::string> list = {"distance", grid_, "--pairs", path};
  WriteFile(path, "0 1\n# comment\n2 81\n");
  EXPECT_THAT(Refusal(list, kRefused),
              HasSubstr(path + " line 3: pairs[1].target.vertex 81 is out of "
                               "range"));
  WriteFile(path, "0 1\n2 here\n");
  EXPECT_THAT(Refusal(list, kFile),
              HasSubstr(path + " line 2: 'here' is not a point"));
  WriteFile(path, "# nothing\n");
  EXPECT_THAT(Refusal(list, kFile), HasSubstr("lists nothing"));
  EXPECT_THAT(Refusal({"distance", grid_, "--pairs", folder_ / "none"}, kFile),
              HasSubstr("none"));
  EXPECT_THAT(Refusal({"distance", grid_, "0"}, kUsage),
              HasSubstr("name the second place"));
  EXPECT_THAT(Refusal({"distance", grid_}, kUsage),
              HasSubstr("two places, or --pairs FILE"));
  EXPECT_THAT(Refusal({"distance", grid_, "0", "1", "--pairs", path}, kUsage),
              HasSubstr("not both"));
  EXPECT_THAT(
      Refusal({"distance", grid_, "0", "-o", folder_ / "d.npz"}, kUsage),
      HasSubstr(".npy, .csv, .obj, .ply, .vtk and .json"));
  // A file that was begun is not left behind.
  WriteFile(path, "0 1\n0 81\n");
  Refusal({"distance", grid_, "--pairs", path, "-o", folder_ / "d.csv"},
          kRefused);
  EXPECT_THAT(FileBytes(folder_ / "d.csv"), IsEmpty());
}

}  // namespace
}  // namespace geodesic::client
