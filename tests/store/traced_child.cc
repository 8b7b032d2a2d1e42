#include "tests/store/traced_child.h"

#include <signal.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

namespace geodesic::server::test {
namespace {

constexpr int kTracingForbidden = 77;

[[noreturn]] void BeChild(int pipe, const std::function<void()>& prepare,
                          const std::function<bool()>& work) {
  if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) {
    _exit(kTracingForbidden);
  }
  prepare();
  raise(SIGSTOP);
  if (work() && write(pipe, "!", 1) != 1) _exit(1);
  _exit(0);
}

// Lets the child run to its next system call. False when it has ended.
bool NextCall(pid_t child, uint64_t* number) {
  for (;;) {
    if (ptrace(PTRACE_SYSCALL, child, nullptr, nullptr) != 0) return false;
    int status = 0;
    if (waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) {
      return false;
    }
    __ptrace_syscall_info info{};
    ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof(info), &info);
    if (info.op != PTRACE_SYSCALL_INFO_ENTRY) continue;
    *number = info.entry.nr;
    return true;
  }
}

}  // namespace

TracedRun RunTraced(const std::function<void()>& prepare,
                    const std::function<bool()>& work, size_t kill_before) {
  int pipes[2];
  if (pipe(pipes) != 0) throw std::runtime_error("cannot make a pipe");
  const pid_t child = fork();
  if (child == 0) BeChild(pipes[1], prepare, work);
  close(pipes[1]);

  TracedRun run;
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSTOPPED(status)) {
    run.is_permitted = true;
    ptrace(PTRACE_SETOPTIONS, child, nullptr,
           PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
    uint64_t number = 0;
    run.has_ended = true;
    while (NextCall(child, &number)) {
      if (run.calls.size() == kill_before) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
        run.has_ended = false;
        break;
      }
      run.calls.push_back(number);
    }
    // Its exit is no call of `work`.
    if (run.has_ended && !run.calls.empty()) run.calls.pop_back();
  }
  char byte = 0;
  run.has_acknowledged = read(pipes[0], &byte, 1) == 1;
  close(pipes[0]);
  return run;
}

}  // namespace geodesic::server::test
