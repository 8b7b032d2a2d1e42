#include "readers/gltf_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <type_traits>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "readers/byte_order.h"
#include "readers/reader_errors.h"

namespace geodesic {
namespace {

using Json = nlohmann::json;

// A scene of this many values takes some 50 MB of memory at the worst.
constexpr uint64_t kMaxValues = uint64_t{1} << 18;
constexpr int kMaxDepth = 64;

constexpr std::string_view kMagic = "glTF";
constexpr size_t kHeaderBytes = 12;
constexpr size_t kChunkHeaderBytes = 8;
constexpr uint32_t kJsonChunk = 0x4E4F534A;
constexpr uint32_t kBinaryChunk = 0x004E4942;

enum ComponentType {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126,
};

int BytesOf(uint64_t component_type) {
  switch (component_type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

uint32_t Word(std::string_view bytes, size_t offset) {
  return Load<uint32_t, std::endian::little>(bytes.data() + offset);
}

// Counts what a scene would hold, so that no memory is taken for too much.
class SceneLimits : public nlohmann::json_sax<Json> {
 public:
  const absl::Status& status() const { return status_; }

  bool null() override { return Count(); }
  bool boolean(bool) override { return Count(); }
  bool number_integer(number_integer_t) override { return Count(); }
  bool number_unsigned(number_unsigned_t) override { return Count(); }
  bool number_float(number_float_t, const string_t&) override {
    return Count();
  }
  bool string(string_t&) override { return Count(); }
  bool binary(binary_t&) override { return Count(); }
  bool key(string_t&) override { return Count(); }
  bool start_object(size_t) override { return Enter(); }
  bool start_array(size_t) override { return Enter(); }
  bool end_object() override { return Leave(); }
  bool end_array() override { return Leave(); }
  bool parse_error(size_t position, const std::string&,
                   const nlohmann::detail::exception&) override {
    // It counts from 1.
    status_ =
        AtByte(position == 0 ? 0 : position - 1, "the scene is not valid JSON");
    return false;
  }

 private:
  bool Count() {
    if (++values_ <= kMaxValues) return true;
    status_ = absl::InvalidArgumentError(absl::StrCat(
        "the scene's JSON holds more than ", kMaxValues, " values"));
    return false;
  }
  bool Enter() {
    if (++depth_ <= kMaxDepth) return Count();
    status_ = absl::InvalidArgumentError(absl::StrCat(
        "the scene's JSON is nested deeper than ", kMaxDepth, " levels"));
    return false;
  }
  bool Leave() {
    --depth_;
    return true;
  }

  absl::Status status_;
  uint64_t values_ = 0;
  int depth_ = 0;
};

template <typename... Parts>
absl::Status Invalid(const Parts&... parts) {
  return absl::InvalidArgumentError(absl::StrCat(parts...));
}

template <typename T>
double RealAt(const char* bytes, bool is_normalized) {
  const T value = Load<T, std::endian::little>(bytes);
  if constexpr (std::is_integral_v<T>) {
    constexpr double kMost = std::numeric_limits<T>::max();
    if (is_normalized) return std::max(value / kMost, -1.0);
  }
  return value;
}

// Whether it is read, or touches the look only.
bool IsKnown(std::string_view extension) {
  return extension == "KHR_mesh_quantization" ||
         extension == "EXT_mesh_gpu_instancing" ||
         extension.starts_with("KHR_materials_") ||
         extension.starts_with("KHR_texture_") ||
         extension.starts_with("KHR_lights_") ||
         extension.starts_with("EXT_texture_");
}

}  // namespace

const Json* GltfMember(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

uint64_t GltfNumber(const Json& object, const char* name, uint64_t missing) {
  const Json* const number = GltfMember(object, name);
  if (number == nullptr) return missing;
  return number->is_number_unsigned() ? number->get<uint64_t>() : kNoGltfNumber;
}

double GltfNumbers::Real(uint64_t i, int k) const {
  const char* const bytes = at(i, k);
  switch (component_type_) {
    case kByte:
      return RealAt<int8_t>(bytes, is_normalized_);
    case kUnsignedByte:
      return RealAt<uint8_t>(bytes, is_normalized_);
    case kShort:
      return RealAt<int16_t>(bytes, is_normalized_);
    case kUnsignedShort:
      return RealAt<uint16_t>(bytes, is_normalized_);
    case kUnsignedInt:
      return RealAt<uint32_t>(bytes, is_normalized_);
    default:
      return RealAt<float>(bytes, is_normalized_);
  }
}

uint32_t GltfNumbers::Index(uint64_t i) const {
  switch (component_type_) {
    case kUnsignedByte:
      return static_cast<uint8_t>(*at(i, 0));
    case kUnsignedShort:
      return Load<uint16_t, std::endian::little>(at(i, 0));
    default:
      return Load<uint32_t, std::endian::little>(at(i, 0));
  }
}

absl::StatusOr<GltfFile> GltfFile::Open(std::string_view bytes) {
  GltfFile file;
  std::string_view text = bytes;
  uint64_t offset = 0;
  if (bytes.starts_with(kMagic)) {
    if (bytes.size() < kHeaderBytes + kChunkHeaderBytes) {
      return AtByte(bytes.size(), "the file ends within its header");
    }
    if (Word(bytes, 4) != 2) {
      return AtByte(4, "glTF version ", Word(bytes, 4),
                    " is not read; save it as version 2");
    }
    offset = kHeaderBytes + kChunkHeaderBytes;
    text = bytes.substr(offset);
    if (Word(bytes, kHeaderBytes + 4) != kJsonChunk) {
      return AtByte(kHeaderBytes + 4, "the first chunk is not the scene");
    }
    const uint32_t text_bytes = Word(bytes, kHeaderBytes);
    if (text_bytes > text.size()) {
      return AtByte(kHeaderBytes, "the scene has ", text_bytes, " bytes, but ",
                    text.size(), " follow");
    }
    std::string_view rest = text.substr(text_bytes);
    text = text.substr(0, text_bytes);
    if (rest.size() >= kChunkHeaderBytes && Word(rest, 4) == kBinaryChunk) {
      const uint32_t binary_bytes = Word(rest, 0);
      rest.remove_prefix(kChunkHeaderBytes);
      if (binary_bytes > rest.size()) {
        return AtByte(bytes.size() - rest.size(), "the binary chunk has ",
                      binary_bytes, " bytes, but ", rest.size(), " follow");
      }
      file.binary_ = rest.substr(0, binary_bytes);
    }
  }
  if (absl::Status s = file.ReadScene(text, offset); !s.ok()) return s;
  if (absl::Status s = file.ReadBuffers(); !s.ok()) return s;
  return file;
}

absl::Status GltfFile::ReadScene(std::string_view text, uint64_t offset) {
  SceneLimits limits;
  if (!Json::sax_parse(text.begin(), text.end(), &limits)) {
    return offset == 0 || limits.status().ok()
               ? limits.status()
               : Invalid("in the scene, which begins at byte ", offset, ": ",
                         std::string(limits.status().message()));
  }
  scene_ = Json::parse(text.begin(), text.end(), nullptr,
                       /*allow_exceptions=*/false);
  const Json* const asset = GltfMember(scene_, "asset");
  const Json* const version =
      asset == nullptr ? nullptr : GltfMember(*asset, "version");
  if (version == nullptr || !version->is_string() ||
      !version->get_ref<const std::string&>().starts_with("2.")) {
    return Invalid("the scene does not say that it is glTF 2 (asset.version)");
  }
  if (const Json* const needed = GltfMember(scene_, "extensionsRequired");
      needed != nullptr && needed->is_array()) {
    for (const Json& name : *needed) {
      const auto* const extension = name.get_ptr<const std::string*>();
      if (extension != nullptr && IsKnown(*extension)) continue;
      return Invalid("the file needs ",
                     extension == nullptr ? "an extension without a name"
                                          : Printable(*extension),
                     ", which is not read: save it without");
    }
  }
  return absl::OkStatus();
}

absl::Status GltfFile::ReadBuffers() {
  const Json* const buffers = GltfMember(scene_, "buffers");
  if (buffers == nullptr || !buffers->is_array()) return absl::OkStatus();
  // The views below refer to them.
  decoded_.reserve(buffers->size());
  for (size_t i = 0; i < buffers->size(); ++i) {
    const Json& buffer = (*buffers)[i];
    const Json* const uri = GltfMember(buffer, "uri");
    std::string_view bytes = binary_;
    if (uri != nullptr) {
      const auto* const text = uri->get_ptr<const std::string*>();
      constexpr std::string_view kMark = ";base64,";
      const size_t mark = text == nullptr || !text->starts_with("data:")
                              ? std::string::npos
                              : text->find(kMark);
      if (mark == std::string::npos) {
        return Invalid("buffer ", i, " is in another file",
                       text == nullptr ? "" : " (" + Printable(*text) + ")",
                       ": save the scene as .glb, which has all in one");
      }
      const std::string_view data =
          std::string_view(*text).substr(mark + kMark.size());
      std::string& decoded = decoded_.emplace_back();
      if (!absl::Base64Unescape({data.data(), data.size()}, &decoded)) {
        return Invalid("buffer ", i, " is not valid base64");
      }
      bytes = decoded;
    } else if (i > 0 || binary_.empty()) {
      return Invalid("buffer ", i, " has neither a uri nor a binary chunk");
    }
    const uint64_t length = GltfNumber(buffer, "byteLength", kNoGltfNumber);
    if (length == kNoGltfNumber) {
      return Invalid("buffer ", i, " has no number as byteLength");
    }
    if (length > bytes.size()) {
      return Invalid("buffer ", i, " has fewer bytes than its byteLength");
    }
    buffers_.push_back(bytes.substr(0, length));
  }
  return absl::OkStatus();
}

const Json* GltfFile::Item(const char* array, uint64_t index) const {
  const Json* const items = GltfMember(scene_, array);
  return items != nullptr && items->is_array() && index < items->size()
             ? &(*items)[index]
             : nullptr;
}

absl::StatusOr<std::string_view> GltfFile::View(uint64_t index,
                                                uint64_t& stride) const {
  const Json* const view = Item("bufferViews", index);
  if (view == nullptr) return Invalid("there is no bufferView ", index);
  const uint64_t buffer = GltfNumber(*view, "buffer", kNoGltfNumber);
  const uint64_t offset = GltfNumber(*view, "byteOffset", 0);
  const uint64_t length = GltfNumber(*view, "byteLength", kNoGltfNumber);
  stride = GltfNumber(*view, "byteStride", 0);
  if (buffer >= buffers_.size() || offset > buffers_[buffer].size() ||
      length > buffers_[buffer].size() - offset) {
    return Invalid("bufferView ", index, " lies outside its buffer");
  }
  return buffers_[buffer].substr(offset, length);
}

absl::StatusOr<GltfNumbers> GltfFile::Accessor(uint64_t index,
                                               std::string_view type) const {
  const Json* const accessor = Item("accessors", index);
  if (accessor == nullptr) return Invalid("there is no accessor ", index);
  const Json* const given = GltfMember(*accessor, "type");
  if (given == nullptr || *given != std::string(type)) {
    return Invalid("accessor ", index, " is not of type ", std::string(type));
  }
  const bool is_index = type == "SCALAR";
  const uint64_t component =
      GltfNumber(*accessor, "componentType", kNoGltfNumber);
  const bool is_unsigned = component == kUnsignedByte ||
                           component == kUnsignedShort ||
                           component == kUnsignedInt;
  if (component == kNoGltfNumber) {
    return Invalid("accessor ", index, " has no number as componentType");
  }
  if (BytesOf(component) == 0 || (is_index && !is_unsigned)) {
    return Invalid("accessor ", index, " has componentType ", component,
                   ", which is not read here");
  }
  if (GltfMember(*accessor, "sparse") != nullptr) {
    return Invalid("accessor ", index,
                   " is sparse, which is not read: save it without");
  }
  const uint64_t view = GltfNumber(*accessor, "bufferView", kNoGltfNumber);
  if (view == kNoGltfNumber) {
    return Invalid("accessor ", index, " has no data; it may be compressed: ",
                   "save the scene without compression");
  }
  GltfNumbers numbers;
  absl::StatusOr<std::string_view> bytes = View(view, numbers.stride_);
  if (!bytes.ok()) {
    return Invalid("accessor ", index, ": ",
                   std::string(bytes.status().message()));
  }
  numbers.component_type_ = static_cast<int>(component);
  numbers.item_bytes_ = BytesOf(component);
  const uint64_t item_bytes =
      static_cast<uint64_t>(numbers.item_bytes_) * (is_index         ? 1
                                                    : type == "VEC3" ? 3
                                                                     : 4);
  if (numbers.stride_ == 0) numbers.stride_ = item_bytes;
  const uint64_t offset = GltfNumber(*accessor, "byteOffset", 0);
  numbers.count_ = GltfNumber(*accessor, "count", kNoGltfNumber);
  if (numbers.stride_ < item_bytes || offset > bytes->size() ||
      (numbers.count_ > 0 &&
       (bytes->size() - offset < item_bytes ||
        numbers.count_ - 1 >
            (bytes->size() - offset - item_bytes) / numbers.stride_))) {
    return Invalid("accessor ", index, " lies outside its bufferView");
  }
  const Json* const normalized = GltfMember(*accessor, "normalized");
  numbers.is_normalized_ = normalized != nullptr && *normalized == true;
  numbers.bytes_ = bytes->data() + offset;
  return numbers;
}

}  // namespace geodesic
