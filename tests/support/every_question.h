// Every question that the core answers, for laws that hold for all of them.

#ifndef GEODESIC_TESTS_SUPPORT_EVERY_QUESTION_H_
#define GEODESIC_TESTS_SUPPORT_EVERY_QUESTION_H_

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"

namespace geodesic::test {

struct AnyQuestion {
  std::string name;
  // Asks it from a source at a vertex. Of what is asked of a field, the
  // checkpoint sees what is done after the field is there: first a poll.
  std::function<absl::Status(const Mesh&, uint32_t source, Checkpoint&)> ask;
};

// `algorithms`: fields by every algorithm; otherwise by the default one.
std::vector<AnyQuestion> EveryQuestion(bool algorithms);

// Fields and isolines of so many sources each: in faces, on edges, and at
// vertices with offsets. The source that is named plays no part.
std::vector<AnyQuestion> QuestionsOfManySources(uint32_t sources,
                                                bool algorithms);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_EVERY_QUESTION_H_
