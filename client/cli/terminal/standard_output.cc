#include "client/cli/terminal/standard_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace geodesic::client {

StandardOutput::StandardOutput() {
  int descriptor = 0;
  while ((descriptor = open("/dev/null", O_RDONLY | O_CLOEXEC)) >= 0 &&
         descriptor <= STDERR_FILENO) {
  }
  close(descriptor);
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

absl::Status StandardOutput::Finish() {
  sync();
  if (close(STDOUT_FILENO) != 0 && error_ == 0) error_ = errno;
  return error_ == 0
             ? absl::OkStatus()
             : absl::ErrnoToStatus(error_, "cannot write standard output");
}

StandardOutput::int_type StandardOutput::overflow(int_type c) {
  if (sync() != 0) return traits_type::eof();
  return traits_type::eq_int_type(c, traits_type::eof())
             ? traits_type::not_eof(c)
             : sputc(traits_type::to_char_type(c));
}

int StandardOutput::sync() {
  for (const char* next = pbase(); error_ == 0 && next != pptr();) {
    const ssize_t count =
        write(STDOUT_FILENO, next, static_cast<size_t>(pptr() - next));
    if (count >= 0) {
      next += count;
    } else if (errno != EINTR) {
      error_ = errno;
    }
  }
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return error_ == 0 ? 0 : -1;
}

}  // namespace geodesic::client
