// Certificates for tests, made by the openssl command.

#ifndef GEODESIC_TESTS_SECURITY_CERTIFICATES_H_
#define GEODESIC_TESTS_SECURITY_CERTIFICATES_H_

#include <string>

#include "tests/client/temporary_folder.h"

namespace geodesic::client {

// Paths of PEM files.
struct Identity {
  std::string certificate;
  std::string key;
};

class Authority {
 public:
  // Makes it in `folder`, which outlives it; `name` begins its files' names.
  Authority(const TemporaryFolder& folder, const std::string& name);

  // A certificate for the DNS name meshes.test and the address 127.0.0.1.
  Identity Issue(const std::string& name) const;

  // Path of its own certificate.
  const std::string& path() const { return own_.certificate; }

 private:
  const TemporaryFolder& folder_;
  const std::string name_;
  const Identity own_;
};

// A certificate of nobody's but its own, whose day has passed.
Identity MakeExpired(const TemporaryFolder& folder);

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_SECURITY_CERTIFICATES_H_
