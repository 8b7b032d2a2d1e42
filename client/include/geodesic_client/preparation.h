// Preparing a mesh for questions, so that the first of them need not wait.

#ifndef GEODESIC_CLIENT_PREPARATION_H_
#define GEODESIC_CLIENT_PREPARATION_H_

#include <cstdint>
#include <string>

#include "geodesic_client/answer.h"

namespace geodesic::client {

// What is to be made ready for later questions.
struct PreparationQuery {
  std::string mesh_digest;
  // One of ApproximateAlgorithmNames(). DEFAULT: empty, for the landmarks that
  // make exact distances of pairs faster.
  std::string algorithm = {};
  Approximation approximation = {};
  Priority priority = Priority::kInteractive;
};

// What was made ready.
struct Preparation {
  AnswerInfo info;
  // It was there before; nothing was done.
  bool already_prepared = false;
  // Memory that it takes on the server.
  uint64_t bytes = 0;
  // How long it took to make, or to load from disk.
  double prepare_seconds = 0;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PREPARATION_H_
