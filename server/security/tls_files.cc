#include "server/security/tls_files.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <ctime>
#include <memory>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/security/file_text.h"

namespace geodesic::server {
namespace {

struct Freed {
  void operator()(BIO* text) const { BIO_free(text); }
  void operator()(X509* certificate) const { X509_free(certificate); }
  void operator()(EVP_PKEY* key) const { EVP_PKEY_free(key); }
};
template <typename Thing>
using Owned = std::unique_ptr<Thing, Freed>;

// Without this OpenSSL would wait for somebody to type a key's passphrase.
int NoPassphrase(char*, int, int, void*) { return -1; }

Owned<BIO> Opened(const std::string& text) {
  return Owned<BIO>(
      BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

absl::Status HoldsNo(const char* kind, const std::string& path) {
  ERR_clear_error();
  return absl::InvalidArgumentError(
      absl::StrCat(path, " holds no ", kind, " in PEM form"));
}

// The first one in the text of the file at `path`. Errors: INVALID_ARGUMENT:
// there is none, or one of all that follow is cut off.
absl::StatusOr<Owned<X509>> ParseCertificate(const std::string& text,
                                             const std::string& path) {
  const Owned<BIO> source = Opened(text);
  const auto read = [&source] {
    return Owned<X509>(
        PEM_read_bio_X509(source.get(), nullptr, &NoPassphrase, nullptr));
  };
  Owned<X509> first = read();
  if (first == nullptr) return HoldsNo("certificate", path);
  while (read() != nullptr) {
  }
  const bool ends =
      ERR_GET_REASON(ERR_peek_last_error()) == PEM_R_NO_START_LINE;
  ERR_clear_error();
  if (ends) return first;
  return absl::InvalidArgumentError(
      absl::StrCat(path, " holds a certificate that is cut off or damaged"));
}

absl::Status Check(const TlsTexts& texts, const TlsFiles& files) {
  const auto certificate =
      ParseCertificate(texts.certificate, files.certificate);
  if (!certificate.ok()) return certificate.status();
  const Owned<EVP_PKEY> key(PEM_read_bio_PrivateKey(
      Opened(texts.key).get(), nullptr, &NoPassphrase, nullptr));
  if (key == nullptr) return HoldsNo("unencrypted private key", files.key);
  const bool match = X509_check_private_key(certificate->get(), key.get()) == 1;
  ERR_clear_error();
  if (!match) {
    return absl::InvalidArgumentError(
        absl::StrCat(files.key, " is not the key of the certificate in ",
                     files.certificate));
  }
  if (files.client_authorities.empty()) return absl::OkStatus();
  return ParseCertificate(texts.client_authorities, files.client_authorities)
      .status();
}

}  // namespace

absl::StatusOr<TlsTexts> ReadTlsFiles(const TlsFiles& files) {
  TlsTexts texts;
  const auto read = [](const std::string& path, std::string& text) {
    absl::StatusOr<std::string> found = ReadFileText(path);
    if (!found.ok()) return found.status();
    text = *std::move(found);
    return absl::OkStatus();
  };
  absl::Status status = read(files.certificate, texts.certificate);
  if (status.ok()) status = read(files.key, texts.key);
  if (status.ok() && !files.client_authorities.empty()) {
    status = read(files.client_authorities, texts.client_authorities);
  }
  if (status.ok()) status = Check(texts, files);
  if (!status.ok()) return status;
  return texts;
}

absl::StatusOr<std::chrono::system_clock::time_point> CertificateEnd(
    const TlsFiles& files) {
  const absl::StatusOr<std::string> text = ReadFileText(files.certificate);
  if (!text.ok()) return text.status();
  const auto certificate = ParseCertificate(*text, files.certificate);
  if (!certificate.ok()) return certificate.status();
  std::tm end = {};
  if (ASN1_TIME_to_tm(X509_get0_notAfter(certificate->get()), &end) != 1) {
    return absl::InvalidArgumentError(
        absl::StrCat(files.certificate, " has no end"));
  }
  return std::chrono::system_clock::from_time_t(timegm(&end));
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
