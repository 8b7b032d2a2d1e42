#include "tests/security/certificates.h"

#include <stdexcept>
#include <vector>

#include "tests/integration/process.h"

namespace geodesic::client {
namespace {

// Runs `openssl req -x509` with these arguments more.
Identity Make(const TemporaryFolder& folder, const std::string& name,
              const std::vector<std::string>& more) {
  // Nothing but what is said here, whatever the machine's own file adds.
  const std::string config = folder / "openssl.cnf";
  WriteFile(config, "[req]\ndistinguished_name=name\n[name]\n");
  Identity identity{folder / (name + ".pem"), folder / (name + ".key")};
  std::vector<std::string> words = {OPENSSL_BINARY,
                                    "req",
                                    "-x509",
                                    "-config",
                                    config,
                                    "-newkey",
                                    "ec",
                                    "-pkeyopt",
                                    "ec_paramgen_curve:P-256",
                                    "-nodes",
                                    "-days",
                                    "2",
                                    "-subj",
                                    "/CN=" + name,
                                    "-out",
                                    identity.certificate,
                                    "-keyout",
                                    identity.key};
  words.insert(words.end(), more.begin(), more.end());
  const ProcessResult result = RunProgram(words);
  if (result.exit_code != 0) throw std::runtime_error(result.err);
  return identity;
}

}  // namespace

Authority::Authority(const TemporaryFolder& folder, const std::string& name)
    : folder_(folder),
      name_(name),
      own_(Make(folder, name,
                {"-addext", "basicConstraints=critical,CA:TRUE"})) {}

Identity Authority::Issue(const std::string& name) const {
  return Make(folder_, name_ + "-" + name,
              {"-CA", own_.certificate, "-CAkey", own_.key, "-addext",
               "basicConstraints=CA:FALSE", "-addext",
               "subjectAltName=DNS:meshes.test,IP:127.0.0.1"});
}

}  // namespace geodesic::client
