// Numbers in text, as coordinates of an OBJ.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "geodesic/read_mesh.h"
#include "tests/core/readers/soup_checks.h"

namespace geodesic {
namespace {

// Nothing where it is refused.
std::optional<double> Read(const std::string& token) {
  const auto soup = ReadMesh("v 0 " + token + " 0\n", MeshFormat::kObj);
  if (soup.ok()) return soup->positions.at(0)[1];
  EXPECT_THAT(soup, test::IsInvalid("line 1: vertex 0: '" + token +
                                    "' is not a finite number"));
  return std::nullopt;
}

TEST(NumbersTest, AreCorrectlyRounded) {
  for (const auto& [token, value] :
       std::initializer_list<std::pair<std::string, double>>{
           {"0.1", 0.1},
           {"1e-300", 1e-300},
           {"9007199254740993", 9007199254740992.0},
           {"2.2250738585072011e-308", 2.2250738585072011e-308},
           {"1.7976931348623157e308", std::numeric_limits<double>::max()},
           // Just above the midpoint of 1 and the next double, by its 800th
           // digit.
           {"1.00000000000000011102230246251565404236316680908203125" +
                std::string(750, '0') + "1",
            std::nextafter(1.0, 2.0)},
           // Spellings of exporters.
           {"+1", 1},
           {".5", 0.5},
           {"-.5", -0.5},
           {"+5.", 5},
           {"2.e+1", 20},
           {"1E02", 100},
           // What is too small is 0 or subnormal.
           {"5e-324", 5e-324},
           {"1e-400", 0},
           {"-1e-99999", 0},
           {"0e99999", 0}}) {
    EXPECT_EQ(Read(token), value) << token;
  }
  EXPECT_TRUE(std::signbit(Read("-0").value()));
}

TEST(NumbersTest, EverythingElseIsRefused) {
  for (const char* token :
       {"+",        "-",     ".",      "+-1",    "++1",  "--1",
        "1e",       "1e+",   "3.1+e2", "1,5",    "1.0f", "1.0D5",
        "0x10",     "nan",   "NaN",    "-nan",   "inf",  "-inf",
        "infinity", "1e309", "-1e309", "1e99999"}) {
    EXPECT_EQ(Read(token), std::nullopt) << token;
  }
}

}  // namespace
}  // namespace geodesic
