// Standard output, of which nothing is lost without a word.

#ifndef GEODESIC_CLIENT_CLI_TERMINAL_STANDARD_OUTPUT_H_
#define GEODESIC_CLIENT_CLI_TERMINAL_STANDARD_OUTPUT_H_

#include <array>
#include <ostream>
#include <streambuf>

#include "absl/status/status.h"

namespace geodesic::client {

// Buffers what is written to standard output. The stream is bad once a write
// has failed, and Finish says why. A reader that closes its end of a pipe ends
// the process by SIGPIPE, as it does with most tools. Not thread-safe.
class StandardOutput : private std::streambuf {
 public:
  // If standard input, output or error is closed, it is replaced by one that
  // cannot be written to, so that no file or connection takes its number.
  StandardOutput();

  std::ostream& stream() { return stream_; }

  // Writes what waits and closes standard output.
  // Errors: those of the first write that failed.
  absl::Status Finish();

 private:
  int_type overflow(int_type c) override;
  int sync() override;

  std::array<char, 1 << 16> buffer_;
  // errno of the first write that failed.
  int error_ = 0;
  std::ostream stream_{this};
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_TERMINAL_STANDARD_OUTPUT_H_
