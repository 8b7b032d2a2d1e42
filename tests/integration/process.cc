#include "tests/integration/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace geodesic::client {
namespace {

constexpr int kPatienceMs = 60'000;

// Appends what there is to read; closes the pipe at its end.
void Drain(int* pipe, std::string* text) {
  std::array<char, 4096> buffer;
  const ssize_t count = read(*pipe, buffer.data(), buffer.size());
  if (count > 0) {
    text->append(buffer.data(), static_cast<size_t>(count));
  } else {
    close(*pipe);
    *pipe = -1;
  }
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments,
                 const std::string& error_path) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  int out[2], err[2];
  if (pipe2(out, O_CLOEXEC) != 0 || pipe2(err, O_CLOEXEC) != 0) {
    throw std::runtime_error("cannot make pipes");
  }
  id_ = fork();
  if (id_ == 0) {
    dup2(out[1], STDOUT_FILENO);
    dup2(error_path.empty()
             ? err[1]
             : open(error_path.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666),
         STDERR_FILENO);
    execv(words[0], words.data());
    _exit(127);
  }
  close(out[1]);
  close(err[1]);
  out_pipe_ = out[0];
  err_pipe_ = err[0];
}

Process::~Process() {
  if (id_ > 0) {
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
  if (out_pipe_ >= 0) close(out_pipe_);
  if (err_pipe_ >= 0) close(err_pipe_);
}

void Process::Signal(int signal) const { kill(id_, signal); }

bool Process::ReadSome() {
  std::array<pollfd, 2> ready = {
      {{out_pipe_, POLLIN, 0}, {err_pipe_, POLLIN, 0}}};
  if (out_pipe_ < 0 && err_pipe_ < 0) return false;
  if (poll(ready.data(), ready.size(), kPatienceMs) <= 0) return false;
  if (ready[0].revents != 0) Drain(&out_pipe_, &result_.out);
  if (ready[1].revents != 0) Drain(&err_pipe_, &result_.err);
  return true;
}

bool Process::Await(const std::string& kept, const std::string& text) {
  while (kept.find(text) == std::string::npos) {
    if (!ReadSome()) return false;
  }
  return true;
}

bool Process::AwaitError(const std::string& text) {
  return Await(result_.err, text);
}

bool Process::AwaitOutput(const std::string& text) {
  return Await(result_.out, text);
}

ProcessResult Process::Wait() {
  while (ReadSome()) {
  }
  int status = 0;
  waitpid(id_, &status, 0);
  id_ = -1;
  result_.exit_code =
      WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return result_;
}

ProcessResult RunProgram(const std::vector<std::string>& arguments) {
  return Process(arguments).Wait();
}

}  // namespace geodesic::client
