#include "server/web/web_door.h"

#include <microhttpd.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "server/operations/listen_address.h"
#include "server/web/grpc_web.h"
#include "server/web/page_file.h"
#include "server/web/web_call.h"
#include "server/web/web_metadata.h"

namespace geodesic::server {
namespace {

// What libmicrohttpd may take for a connection: the head of a request, then
// bytes on their way in or out.
constexpr size_t kConnectionBytes = 64 << 10;
// Bounds a request's metadata.
constexpr size_t kMaxHeaderBytes = 16 << 10;

// The page needs its own files and this server, nothing else; three.js makes
// images of its own, and the page a worker that simplifies meshes in
// WebAssembly.
constexpr std::string_view kContentPolicy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; "
    "style-src 'self'; "
    "img-src 'self' data: blob:; font-src 'self'; connect-src 'self'; "
    "worker-src 'self' blob:; manifest-src 'self'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";

struct DestroyResponse {
  void operator()(MHD_Response* response) const {
    MHD_destroy_response(response);
  }
};
using Response = std::unique_ptr<MHD_Response, DestroyResponse>;

Response StaticResponse(std::string_view body) {
  return Response(MHD_create_response_from_buffer(
      body.size(), const_cast<char*>(body.data()), MHD_RESPMEM_PERSISTENT));
}

Response TextResponse(std::string body) {
  body += '\n';
  return Response(MHD_create_response_from_buffer(body.size(), body.data(),
                                                  MHD_RESPMEM_MUST_COPY));
}

void AddHeader(const Response& response, const std::string& name,
               std::string_view value) {
  MHD_add_response_header(response.get(), name.c_str(),
                          std::string(value).c_str());
}

MHD_Result Queue(MHD_Connection* connection, unsigned code,
                 const Response& response) {
  AddHeader(response, "X-Content-Type-Options", "nosniff");
  AddHeader(response, "Referrer-Policy", "no-referrer");
  return MHD_queue_response(connection, code, response.get());
}

MHD_Result Refuse(MHD_Connection* connection, unsigned code,
                  std::string message) {
  const Response response = TextResponse(std::move(message));
  AddHeader(response, "Content-Type", "text/plain; charset=utf-8");
  AddHeader(response, "Cache-Control", "no-store");
  return Queue(connection, code, response);
}

// The headers of a request; those that have no value are left out.
HttpHeaders HeadersOf(MHD_Connection* connection) {
  HttpHeaders headers;
  MHD_get_connection_values_n(
      connection, MHD_HEADER_KIND,
      [](void* data, MHD_ValueKind, const char* name, size_t name_size,
         const char* value, size_t value_size) {
        if (value != nullptr) {
          static_cast<HttpHeaders*>(data)->emplace_back(
              std::string(name, name_size), std::string(value, value_size));
        }
        return MHD_YES;
      },
      &headers);
  return headers;
}

// The first value of a header; empty if there is none.
std::string_view Header(MHD_Connection* connection, const char* name) {
  const char* value =
      MHD_lookup_connection_value(connection, MHD_HEADER_KIND, name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

// Why the end of a request's body, or the host it is for, is not clear, so that
// a proxy may have read another request; empty if they are (RFC 9112, sections
// 3.2 and 6.3).
std::string_view Ambiguity(const HttpHeaders& headers) {
  const auto count = [&](std::string_view name) {
    return std::ranges::count_if(headers, [&](const auto& header) {
      return absl::EqualsIgnoreCase(
          header.first, absl::string_view(name.data(), name.size()));
    });
  };
  if (count("Host") > 1) return "the request names its host twice";
  if (count("Content-Length") + count("Transfer-Encoding") > 1) {
    return "the request tells the length of its body twice";
  }
  return "";
}

// Undoes "%20" and the like in a path; leaves one alone that "%00" would end.
size_t Unescape(void*, MHD_Connection*, char* text) {
  const std::string_view path = text;
  return path.find("%00") == std::string_view::npos ? MHD_http_unescape(text)
                                                    : path.size();
}

// The browser's address as gRPC writes one.
std::string Address(MHD_Connection* connection) {
  const auto* info =
      MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CLIENT_ADDRESS);
  if (info == nullptr) return "unknown";
  const sockaddr* address = info->client_addr;
  const bool is_v6 = address->sa_family == AF_INET6;
  std::array<char, NI_MAXHOST> host = {};
  std::array<char, NI_MAXSERV> port = {};
  if (getnameinfo(address, is_v6 ? sizeof(sockaddr_in6) : sizeof(sockaddr_in),
                  host.data(), host.size(), port.data(), port.size(),
                  NI_NUMERICHOST | NI_NUMERICSERV) != 0) {
    return "unknown";
  }
  return is_v6 ? absl::StrCat("ipv6:[", host.data(), "]:", port.data())
               : absl::StrCat("ipv4:", host.data(), ":", port.data());
}

// "/package.Service/Method"
bool IsMethod(std::string_view path) {
  const auto is_legal = [](char c) {
    return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '.' ||
           c == '_' || c == '/';
  };
  return path.starts_with('/') && std::ranges::count(path, '/') == 2 &&
         std::ranges::all_of(path, is_legal);
}

uint64_t ConnectionNumber(MHD_Connection* connection) {
  return reinterpret_cast<uintptr_t>(
      MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT)
          ->socket_context);
}

}  // namespace

// One request and its answer. libmicrohttpd holds it until they are done.
class WebDoor::Exchange {
 public:
  Exchange(WebDoor& door, MHD_Connection* connection)
      : door_(door),
        connection_(connection),
        number_(ConnectionNumber(connection)) {}

  ~Exchange() {
    if (call_ != nullptr) {
      call_->Leave();
      door_.watch_.Detach(number_);
    }
    door_.watch_.Expect(number_);
  }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  // The request's head has come.
  MHD_Result Begin(std::string_view method, const std::string& path) {
    door_.watch_.Rest(number_);
    const HttpHeaders headers = HeadersOf(connection_);
    const std::string_view ambiguity = Ambiguity(headers);
    if (!ambiguity.empty()) {
      return Refuse(connection_, MHD_HTTP_BAD_REQUEST, std::string(ambiguity));
    }
    const std::string_view host = Header(connection_, "Host");
    if (!door_.policy_.IsHost(host)) {
      return Refuse(
          connection_, MHD_HTTP_MISDIRECTED_REQUEST,
          absl::StrCat("this server does not answer for the host \"",
                       std::string(host), "\"; --web-allow-origin allows one"));
    }
    if (method == MHD_HTTP_METHOD_POST) return BeginCall(path, headers);
    // The connection is kept only if the answer comes after the whole request.
    if (method == MHD_HTTP_METHOD_OPTIONS) {
      answer_ = [this] { return AnswerPreflight(); };
    } else if (method == MHD_HTTP_METHOD_GET ||
               method == MHD_HTTP_METHOD_HEAD) {
      answer_ = [this, path] { return AnswerPage(path); };
    } else {
      return Refuse(connection_, MHD_HTTP_METHOD_NOT_ALLOWED,
                    "GET for the page, POST for gRPC-Web");
    }
    return MHD_YES;
  }

  // More of its body, or its end.
  MHD_Result GoOn(const char* body, size_t* size) {
    if (answer_) return *size == 0 ? answer_() : MHD_NO;
    if (call_ == nullptr || call_->has_left()) return MHD_NO;
    if (*size > 0) {
      body_bytes_ += *size;
      if (body_bytes_ > door_.options_.max_body_bytes) return MHD_NO;
      const size_t taken = call_->Receive({body, *size});
      body_bytes_ -= *size - taken;
      *size -= taken;
      Watch(/*is_browsers_turn=*/*size == 0);
      return MHD_YES;
    }
    Watch(/*is_browsers_turn=*/false);
    if (!call_->EndBody() || !call_->CanAnswer()) {
      return call_->has_left() ? MHD_NO : MHD_YES;
    }
    return Answer();
  }

 private:
  // Each message has its time, from when the browser can send it.
  void Watch(bool is_browsers_turn) {
    if (!is_browsers_turn) {
      door_.watch_.Rest(number_);
    } else if (!is_expected_ || messages_ != call_->messages()) {
      door_.watch_.Expect(number_);
    }
    is_expected_ = is_browsers_turn;
    messages_ = call_->messages();
  }

  MHD_Result AnswerPage(const std::string& path) {
    const PageFile* file = FindPageFile(path);
    if (file == nullptr) {
      return Refuse(connection_, MHD_HTTP_NOT_FOUND, "there is no such file");
    }
    const bool is_known =
        Header(connection_, "If-None-Match").find(file->etag) !=
        std::string_view::npos;
    const Response response =
        StaticResponse(is_known ? std::string_view() : file->content);
    AddHeader(response, "Content-Type", file->content_type);
    AddHeader(response, "ETag", file->etag);
    // Asked for again each time, so that a new server's page is seen at once.
    AddHeader(response, "Cache-Control", "no-cache");
    AddHeader(response, "Content-Security-Policy", kContentPolicy);
    AddHeader(response, "Cross-Origin-Opener-Policy", "same-origin");
    AddHeader(response, "Cross-Origin-Resource-Policy", "same-origin");
    return Queue(connection_, is_known ? MHD_HTTP_NOT_MODIFIED : MHD_HTTP_OK,
                 response);
  }

  // A browser asks whether a page of another origin may call.
  MHD_Result AnswerPreflight() {
    const std::string_view origin = Header(connection_, "Origin");
    if (!door_.policy_.IsAllowed(origin)) return RefuseOrigin(origin);
    const Response response = StaticResponse("");
    AddHeader(response, "Access-Control-Allow-Origin", origin);
    AddHeader(response, "Access-Control-Allow-Methods", "POST");
    AddHeader(response, "Access-Control-Allow-Headers",
              Header(connection_, "Access-Control-Request-Headers"));
    AddHeader(response, "Access-Control-Max-Age", "7200");
    AddHeader(response, "Vary",
              "Origin, Access-Control-Request-Method, "
              "Access-Control-Request-Headers");
    return Queue(connection_, MHD_HTTP_NO_CONTENT, response);
  }

  MHD_Result RefuseOrigin(std::string_view origin) {
    return Refuse(connection_, MHD_HTTP_FORBIDDEN,
                  absl::StrCat("pages of the origin \"", std::string(origin),
                               "\" may not call; --web-allow-origin allows "
                               "one"));
  }

  MHD_Result BeginCall(const std::string& path, const HttpHeaders& headers) {
    const std::string_view origin = Header(connection_, "Origin");
    if (door_.policy_.IsAllowed(origin)) {
      origin_ = origin;
    } else if (!origin.empty() &&
               !door_.policy_.IsOwn(origin, Header(connection_, "Host"))) {
      return RefuseOrigin(origin);
    }
    const std::optional<WebEncoding> encoding =
        WebEncodingOf(Header(connection_, "Content-Type"));
    if (!encoding) {
      return Refuse(connection_, MHD_HTTP_UNSUPPORTED_MEDIA_TYPE,
                    "the content type must be application/grpc-web+proto or "
                    "application/grpc-web-text+proto");
    }
    if (!IsMethod(path)) {
      return Refuse(connection_, MHD_HTTP_NOT_FOUND, "there is no such method");
    }
    size_t bytes = 0;
    for (const auto& [name, value] : headers) {
      bytes += name.size() + value.size();
    }
    if (bytes > kMaxHeaderBytes) {
      return Refuse(connection_, MHD_HTTP_REQUEST_HEADER_FIELDS_TOO_LARGE,
                    absl::StrCat("the headers are too large: at most ",
                                 kMaxHeaderBytes, " bytes"));
    }
    uint64_t length = 0;
    const std::string_view given = Header(connection_, "Content-Length");
    if (absl::SimpleAtoi(absl::string_view(given.data(), given.size()),
                         &length) &&
        length > door_.options_.max_body_bytes) {
      return Refuse(
          connection_, MHD_HTTP_CONTENT_TOO_LARGE,
          absl::StrCat("a body has at most ", door_.options_.max_body_bytes,
                       " bytes (limit max-upload-bytes)"));
    }
    const std::string address = Address(connection_);
    auto call = std::make_shared<WebCall>(door_.calls_, *connection_, address,
                                          *encoding);
    const absl::Status status = AddMetadata(headers, call->context());
    if (!status.ok()) {
      return Refuse(connection_, MHD_HTTP_BAD_REQUEST,
                    std::string(status.message()));
    }
    door_.peers_.Name(address, call->context());
    call->Start(path);
    call_ = std::move(call);
    door_.watch_.Attach(number_, call_);
    Watch(/*is_browsers_turn=*/true);
    return MHD_YES;
  }

  MHD_Result Answer() {
    // The response has its own share of the call: libmicrohttpd frees it last.
    auto* held = new std::shared_ptr<WebCall>(call_);
    const Response response(MHD_create_response_from_callback(
        MHD_SIZE_UNKNOWN, /*block_size=*/4096,
        [](void* data, uint64_t, char* out, size_t room) {
          return (*static_cast<std::shared_ptr<WebCall>*>(data))
              ->Read(out, room);
        },
        held,
        [](void* data) {
          delete static_cast<std::shared_ptr<WebCall>*>(data);
        }));
    std::string names = "grpc-status, grpc-message, grpc-status-details-bin";
    for (const auto& [name, value] : call_->Headers()) {
      AddHeader(response, name, value);
      absl::StrAppend(&names, ", ", name);
    }
    AddHeader(response, "Content-Type", ContentTypeOf(call_->encoding()));
    AddHeader(response, "Cache-Control", "no-store");
    if (!origin_.empty()) {
      AddHeader(response, "Access-Control-Allow-Origin", origin_);
      AddHeader(response, "Access-Control-Expose-Headers", names);
      AddHeader(response, "Vary", "Origin");
    }
    return Queue(connection_, MHD_HTTP_OK, response);
  }

  WebDoor& door_;
  MHD_Connection* const connection_;
  const uint64_t number_;
  std::function<MHD_Result()> answer_;  // unless it is a call
  std::shared_ptr<WebCall> call_;
  std::string origin_;  // of an allowed page; else empty
  uint64_t body_bytes_ = 0;
  bool is_expected_ = false;  // a message that has not come
  uint64_t messages_ = 0;     // those that came before it
};

void WebDoor::Stop::operator()(MHD_Daemon* daemon) const {
  MHD_stop_daemon(daemon);
}

WebDoor::WebDoor(WebDoorOptions options, std::shared_ptr<grpc::Channel> channel,
                 const Peers& peers, Intake& intake)
    : options_(std::move(options)),
      policy_(options_.listen, !options_.key.empty(), options_.origins),
      peers_(peers),
      queue_(std::move(channel)),
      calls_{.queue = queue_,
             .intake = intake,
             .max_message_bytes = options_.max_message_bytes},
      watch_(options_.patience) {}

WebDoor::~WebDoor() {
  if (daemon_ == nullptr) return;
  // No connection may be suspended when the daemon stops.
  const MHD_socket listening = MHD_quiesce_daemon(daemon_.get());
  watch_.LeaveAll();
  daemon_.reset();
  if (listening != MHD_INVALID_SOCKET) close(listening);
}

absl::Status WebDoor::Start() {
  const auto resolved = ResolveListenAddress(options_.listen);
  if (resolved == nullptr) {
    return absl::UnavailableError(
        absl::StrCat("cannot serve the page on ", options_.listen,
                     ": it is no HOST:PORT of this machine"));
  }
  const MHD_AccessHandlerCallback serve =
      [](void* data, MHD_Connection* connection, const char* url,
         const char* method, const char*, const char* body, size_t* size,
         void** context) {
        auto*& exchange = reinterpret_cast<Exchange*&>(*context);
        if (exchange != nullptr) return exchange->GoOn(body, size);
        exchange = new Exchange(*static_cast<WebDoor*>(data), connection);
        return exchange->Begin(method, url);
      };
  const MHD_RequestCompletedCallback completed =
      [](void*, MHD_Connection*, void** context, MHD_RequestTerminationCode) {
        delete static_cast<Exchange*>(std::exchange(*context, nullptr));
      };
  const MHD_NotifyConnectionCallback connected =
      [](void* data, MHD_Connection* connection, void** context,
         MHD_ConnectionNotificationCode code) {
        ConnectionWatch& watch = static_cast<WebDoor*>(data)->watch_;
        if (code == MHD_CONNECTION_NOTIFY_STARTED) {
          const int socket = MHD_get_connection_info(
                                 connection, MHD_CONNECTION_INFO_CONNECTION_FD)
                                 ->connect_fd;
          *context = reinterpret_cast<void*>(watch.Open(socket));
        } else {
          watch.Close(reinterpret_cast<uintptr_t>(*context));
        }
      };
  // One thread serves all connections by epoll.
  unsigned flags = MHD_USE_EPOLL_INTERNAL_THREAD | MHD_ALLOW_SUSPEND_RESUME;
  if (resolved->ai_family == AF_INET6) flags |= MHD_USE_IPv6;
  std::array<MHD_OptionItem, 3> tls = {{{MHD_OPTION_END, 0, nullptr}}};
  if (!options_.key.empty()) {
    flags |= MHD_USE_TLS;
    const auto text = [](const std::string& pem) {
      return const_cast<char*>(pem.c_str());
    };
    tls = {{{MHD_OPTION_HTTPS_MEM_CERT, 0, text(options_.certificate)},
            {MHD_OPTION_HTTPS_MEM_KEY, 0, text(options_.key)},
            {MHD_OPTION_END, 0, nullptr}}};
  }
  daemon_.reset(MHD_start_daemon(
      flags, 0, nullptr, nullptr, serve, this, MHD_OPTION_ARRAY, tls.data(),
      MHD_OPTION_SOCK_ADDR, resolved->ai_addr, MHD_OPTION_NOTIFY_COMPLETED,
      completed, this, MHD_OPTION_NOTIFY_CONNECTION, connected, this,
      MHD_OPTION_CONNECTION_LIMIT, options_.max_connections,
      MHD_OPTION_CONNECTION_TIMEOUT,
      static_cast<unsigned>(options_.patience.count()),
      MHD_OPTION_CONNECTION_MEMORY_LIMIT, kConnectionBytes,
      MHD_OPTION_STRICT_FOR_CLIENT, 1, MHD_OPTION_UNESCAPE_CALLBACK, &Unescape,
      nullptr, MHD_OPTION_END));
  if (daemon_ != nullptr) return absl::OkStatus();
  return absl::UnavailableError(absl::StrCat(
      "cannot serve the page on ", options_.listen,
      ": the port is in use or the address is not of this machine"));
}

int WebDoor::port() const {
  return MHD_get_daemon_info(daemon_.get(), MHD_DAEMON_INFO_BIND_PORT)->port;
}

}  // namespace geodesic::server
