#include "tests/security/secure_fixture.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include "absl/strings/str_split.h"
#include "tests/integration/process.h"

namespace geodesic::client {
namespace {

void RunOpenssl(std::vector<std::string> words) {
  words.insert(words.begin(), OPENSSL_BINARY);
  const ProcessResult result = RunProgram(words);
  if (result.exit_code != 0) throw std::runtime_error(result.err);
}

// Runs `openssl req -x509` with these arguments more.
Identity Make(const TemporaryFolder& folder, const std::string& name,
              const std::vector<std::string>& more) {
  // Nothing but what is said here, whatever the machine's own file adds.
  const std::string config = folder / "openssl.cnf";
  WriteFile(config, "[req]\ndistinguished_name=name\n[name]\n");
  Identity identity{folder / (name + ".pem"), folder / (name + ".key")};
  std::vector<std::string> words = absl::StrSplit(
      "req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 2",
      ' ');
  words.insert(words.end(), {"-config", config, "-subj", "/CN=" + name, "-out",
                             identity.certificate, "-keyout", identity.key});
  words.insert(words.end(), more.begin(), more.end());
  RunOpenssl(std::move(words));
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

Identity MakeExpired(const TemporaryFolder& folder) {
  // Only `openssl ca` takes dates.
  const std::string config = folder / "expired.cnf";
  const std::string index = folder / "expired.index";
  const std::string request = folder / "expired.csr";
  WriteFile(index, "");
  WriteFile(config,
            "[req]\ndistinguished_name=name\n[name]\n"
            "[ca]\ndefault_ca=own\n"
            "[own]\nrand_serial=yes\ndefault_md=sha256\npolicy=policy\n"
            "database=" +
                index + "\nnew_certs_dir=" + (folder / "") +
                "\n[policy]\ncommonName=supplied\n");
  Identity identity{folder / "expired.pem", folder / "expired.key"};
  RunOpenssl({"req", "-new", "-config", config, "-newkey", "ec", "-pkeyopt",
              "ec_paramgen_curve:P-256", "-nodes", "-subj", "/CN=expired",
              "-out", request, "-keyout", identity.key});
  RunOpenssl({"ca", "-batch", "-notext", "-selfsign", "-config", config, "-in",
              request, "-keyfile", identity.key, "-startdate",
              "20200101000000Z", "-enddate", "20200102000000Z", "-out",
              identity.certificate});
  return identity;
}

}  // namespace geodesic::client
