// Asking a question: lists are read, the mesh is made resident, places are
// found.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_QUESTION_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_QUESTION_H_

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "client/cli/arguments/options.h"
#include "client/cli/commands/command.h"
#include "client/output/binary_numbers.h"
#include "geodesic_client/answer.h"

namespace geodesic::client {

// A question about a mesh, before it is sent.
struct Question {
  std::string mesh_digest;
  // In the order in which the server numbers them.
  std::vector<Source> sources;
  std::vector<SurfacePoint> targets;
  // Of each source that is a curve, by its number, in the mesh's unit.
  std::map<size_t, double> curve_lengths = {};
  // What to say of the sources beside the answer.
  std::vector<std::string> notes = {};
};

// Reads the lists of --sources and --targets, checks that the outputs can be
// written, makes the mesh resident, finds the places on it that are written by
// what they are near to, and calls `answer`, with notes on the sources
// (notes.h). If the server has evicted the mesh meanwhile, it uploads the mesh
// and asks once more. Errors: FileErrors, those of AskAboutMesh, PlaceFinder
// and `answer`.
absl::Status AskQuestion(
    const Session& session, const QuestionArguments& arguments,
    const std::function<absl::Status(const Question&)>& answer);

// A command that answers a question; its `Arguments` are QuestionArguments.
template <typename Arguments>
Command MakeQuestion(std::string name, std::string help, std::string examples,
                     void (*add_options)(CLI::App*, Arguments*),
                     absl::Status (*answer)(const Arguments&, const Session&,
                                            const Question&)) {
  return MakeCommand<Arguments>(
      std::move(name), std::move(help), std::move(examples), add_options,
      [answer](const Arguments& arguments, const Session& session) {
        return AskQuestion(session, arguments, [&](const Question& question) {
          return answer(arguments, session, question);
        });
      });
}

// The types of numbers on the wire and in binary files.
inline ValueType ValueTypeOf(bool float32) {
  return float32 ? ValueType::kFloat32 : ValueType::kFloat64;
}
inline NumberType NumberTypeOf(bool float32) {
  return float32 ? NumberType::kFloat32 : NumberType::kFloat64;
}

// A query with the members that several kinds of query have.
template <typename Query>
Query MakeQuery(const QuestionArguments& arguments, const Question& question) {
  Query query;
  query.mesh_digest = question.mesh_digest;
  query.algorithm = arguments.algorithm;
  if constexpr (requires { query.approximation; }) {
    query.approximation = arguments.approximation;
  }
  if constexpr (requires { query.tolerance; }) {
    query.tolerance = arguments.tolerance;
  }
  query.priority = arguments.priority;
  if constexpr (requires { query.sources; }) query.sources = question.sources;
  if constexpr (requires { query.targets; }) query.targets = question.targets;
  if constexpr (requires { query.radius; }) query.radius = arguments.radius;
  if constexpr (requires { query.value_type; }) {
    query.value_type = ValueTypeOf(arguments.float32);
  }
  return query;
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_QUESTION_H_
