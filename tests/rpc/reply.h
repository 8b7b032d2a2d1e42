// Whole answers to questions.

#ifndef GEODESIC_TESTS_RPC_REPLY_H_
#define GEODESIC_TESTS_RPC_REPLY_H_

#include <grpcpp/support/status.h>
#include <grpcpp/support/sync_stream.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "geodesic/v1/question_service.grpc.pb.h"

namespace geodesic::server::test {

using AnswerReader = grpc::ClientReader<v1::Answer>;

// Everything a question brought.
struct Reply {
  grpc::Status status;
  std::vector<v1::Answer> messages;

  const v1::AnswerHeader& header() const { return messages.at(0).header(); }
  const v1::AnswerTrailer& trailer() const { return messages.back().trailer(); }
  // "" if no block came.
  std::string answer_id() const;
  // How many messages brought blocks.
  ptrdiff_t pieces() const;

  // What came of the array, whose number and name these are. Throws, which
  // fails the test, if the header does not name it.
  std::string Bytes(size_t array) const;
  size_t NumberOf(const std::string& name) const;
  template <typename T>
  std::vector<T> Values(const std::string& name) const {
    const std::string bytes = Bytes(NumberOf(name));
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
};

// Reads to the end.
Reply ReadAll(AnswerReader& reader);

// That these messages keep the rules of answer.proto, and bring all of the
// answer if it ended well but for what came before.
void ExpectRules(const Reply& reply, const v1::Resumption& before);

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_RPC_REPLY_H_
