// A child process whose output is kept.

#ifndef GEODESIC_TESTS_INTEGRATION_PROCESS_H_
#define GEODESIC_TESTS_INTEGRATION_PROCESS_H_

#include <sys/types.h>

#include <string>
#include <vector>

namespace geodesic::client {

struct ProcessResult {
  // What it exited with, or minus the signal that ended it.
  int exit_code = 0;
  std::string out;
  std::string err;
};

// Not thread-safe. Killed at the end if it still runs.
class Process {
 public:
  // Starts a program. Its standard error goes to the file `error_path`, or is
  // kept if that is empty.
  explicit Process(const std::vector<std::string>& arguments,
                   const std::string& error_path = "");
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t id() const { return id_; }

  void Signal(int signal) const;

  // Waits until it has written `text` to its standard error, which it must
  // within a minute. Whether it has.
  bool AwaitError(const std::string& text);
  // The same for its standard output.
  bool AwaitOutput(const std::string& text);

  // Waits for its end.
  ProcessResult Wait();

 private:
  // Takes what has come on either pipe; false when both have ended or a minute
  // has passed without anything.
  bool ReadSome();
  // `kept` is of result_.
  bool Await(const std::string& kept, const std::string& text);

  pid_t id_ = -1;
  int out_pipe_ = -1;
  int err_pipe_ = -1;
  ProcessResult result_;
};

// Runs a program to its end.
ProcessResult RunProgram(const std::vector<std::string>& arguments);

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_INTEGRATION_PROCESS_H_
