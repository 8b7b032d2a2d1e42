#include "server/security/tls_files.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <cerrno>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>

#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

struct Freed {
  void operator()(FILE* file) const { std::fclose(file); }
  void operator()(X509* certificate) const { X509_free(certificate); }
  void operator()(EVP_PKEY* key) const { EVP_PKEY_free(key); }
};
template <typename Thing>
using Owned = std::unique_ptr<Thing, Freed>;

// Without this OpenSSL would wait for somebody to type a key's passphrase.
int NoPassphrase(char*, int, int, void*) { return -1; }

// Reads `thing` from the PEM file by `read`.
template <typename Thing>
absl::Status Read(const std::string& path, const char* kind,
                  Thing* (*read)(FILE*, Thing**, pem_password_cb*, void*),
                  Owned<Thing>& thing) {
  const Owned<FILE> file(std::fopen(path.c_str(), "re"));
  if (file == nullptr) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot read ", path));
  }
  thing.reset(read(file.get(), nullptr, &NoPassphrase, nullptr));
  ERR_clear_error();
  if (thing != nullptr) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat(path, " holds no ", kind, " in PEM form"));
}

absl::Status ReadText(const std::string& path, std::string& text) {
  std::ifstream file(path);
  text.assign(std::istreambuf_iterator<char>(file), {});
  if (file.is_open() && !file.bad()) return absl::OkStatus();
  return absl::ErrnoToStatus(errno, absl::StrCat("cannot read ", path));
}

}  // namespace

absl::Status CheckTlsFiles(const TlsFiles& files) {
  Owned<X509> certificate;
  absl::Status status =
      Read(files.certificate, "certificate", &PEM_read_X509, certificate);
  if (!status.ok()) return status;
  Owned<EVP_PKEY> key;
  status =
      Read(files.key, "unencrypted private key", &PEM_read_PrivateKey, key);
  if (!status.ok()) return status;
  const bool match = X509_check_private_key(certificate.get(), key.get()) == 1;
  ERR_clear_error();
  if (!match) {
    return absl::InvalidArgumentError(
        absl::StrCat(files.key, " is not the key of the certificate in ",
                     files.certificate));
  }
  if (files.client_authorities.empty()) return absl::OkStatus();
  Owned<X509> authority;
  return Read(files.client_authorities, "certificate", &PEM_read_X509,
              authority);
}

absl::StatusOr<std::chrono::system_clock::time_point> CertificateEnd(
    const TlsFiles& files) {
  Owned<X509> certificate;
  absl::Status status =
      Read(files.certificate, "certificate", &PEM_read_X509, certificate);
  if (!status.ok()) return status;
  std::tm end = {};
  if (ASN1_TIME_to_tm(X509_get0_notAfter(certificate.get()), &end) != 1) {
    return absl::InvalidArgumentError(
        absl::StrCat(files.certificate, " has no end"));
  }
  return std::chrono::system_clock::from_time_t(timegm(&end));
}

absl::StatusOr<TlsTexts> ReadTlsFiles(const TlsFiles& files) {
  TlsTexts texts;
  absl::Status status = ReadText(files.certificate, texts.certificate);
  status.Update(ReadText(files.key, texts.key));
  if (!status.ok()) return status;
  return texts;
}

bool IsLoopback(std::string_view address) {
  if (address.starts_with("unix:")) return true;
  std::string host(address.substr(0, address.rfind(':')));
  if (host == "localhost") return true;
  if (in_addr v4; inet_pton(AF_INET, host.c_str(), &v4) == 1) {
    return ntohl(v4.s_addr) >> 24 == IN_LOOPBACKNET;
  }
  if (!host.starts_with('[') || !host.ends_with(']')) return false;
  host = host.substr(1, host.size() - 2);
  in6_addr v6;
  return inet_pton(AF_INET6, host.c_str(), &v6) == 1 &&
         IN6_IS_ADDR_LOOPBACK(&v6);
}

}  // namespace geodesic::server
