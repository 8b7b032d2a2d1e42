#ifndef GEODESIC_CLIENT_CLI_OWN_SERVER_DESCRIPTOR_H_
#define GEODESIC_CLIENT_CLI_OWN_SERVER_DESCRIPTOR_H_

#include <unistd.h>

#include <utility>

namespace geodesic::client {

// A file descriptor that is closed at the end; negative for none.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept
      : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }

  bool is_open() const { return number_ >= 0; }
  int get() const { return number_; }

 private:
  int number_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_OWN_SERVER_DESCRIPTOR_H_
