// Places on the surface as the command line writes and reads them, and as JSON.

#ifndef GEODESIC_CLIENT_OUTPUT_PLACE_TEXT_H_
#define GEODESIC_CLIENT_OUTPUT_PLACE_TEXT_H_

#include <nlohmann/json.hpp>
#include <string>

#include "geodesic_client/surface_point.h"

namespace geodesic::client {

// "17", "edge:3-8@0.25" or "face:5@0.2,0.3,0.5", with the fewest digits that
// give the same doubles again.
std::string PointText(const SurfacePoint& point);

// The same, or the points of a curve with ';' between them; with ":OFFSET" at
// the end unless it is 0.
std::string SourceText(const Source& source);

// {"vertex": 17}, {"edge": [3, 8], "t": 0.25} or
// {"face": 5, "weights": [0.2, 0.3, 0.5]}.
nlohmann::ordered_json PointToJson(const SurfacePoint& point);

// The same, or {"curve": [point, ...]}; with "offset".
nlohmann::ordered_json SourceToJson(const Source& source);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_PLACE_TEXT_H_
