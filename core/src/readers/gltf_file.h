// A glTF 2.0 file: its scene as JSON, and the numbers that its accessors name.

#ifndef GEODESIC_READERS_GLTF_FILE_H_
#define GEODESIC_READERS_GLTF_FILE_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace geodesic {

// An array of numbers, all of which lie in the file.
class GltfNumbers {
 public:
  uint64_t count() const { return count_; }

  // Component `k` of item `i`; integers are divided by the greatest of their
  // type if the accessor says so. Not NaN unless the file holds one.
  double Real(uint64_t i, int k) const;
  // The same of an array of unsigned integers.
  uint32_t Index(uint64_t i) const;

 private:
  friend class GltfFile;

  const char* at(uint64_t i, int k) const {
    return bytes_ + i * stride_ + k * item_bytes_;
  }

  const char* bytes_ = nullptr;
  uint64_t count_ = 0;
  uint64_t stride_ = 0;
  int component_type_ = 0;
  int item_bytes_ = 0;  // of one component
  bool is_normalized_ = false;
};

// .glb, or .gltf whose buffers stand in it as "data:" URIs. The bytes may be
// hostile: nothing is believed that does not fit the file. Refers to the bytes
// that it was opened with.
class GltfFile {
 public:
  using Json = nlohmann::json;

  // Errors: INVALID_ARGUMENT naming the byte or the item of the scene.
  static absl::StatusOr<GltfFile> Open(std::string_view bytes);

  const Json& scene() const { return scene_; }

  // The numbers of accessor `index`, which must be of `type`: "VEC3", "VEC4",
  // or "SCALAR", and then of unsigned integers. Errors: INVALID_ARGUMENT naming
  // the accessor.
  absl::StatusOr<GltfNumbers> Accessor(uint64_t index,
                                       std::string_view type) const;

  // Item `index` of an array of the scene ("nodes"); null if there is none.
  const Json* Item(const char* array, uint64_t index) const;

 private:
  absl::Status ReadScene(std::string_view text, uint64_t offset);
  absl::Status ReadBuffers();
  absl::StatusOr<std::string_view> View(uint64_t index, uint64_t& stride) const;

  Json scene_;
  // What follows the scene in a .glb.
  std::string_view binary_;
  // The bytes of each buffer; in `decoded_` if they were written as text.
  std::vector<std::string_view> buffers_;
  std::vector<std::string> decoded_;
};

inline constexpr uint64_t kNoGltfNumber = std::numeric_limits<uint64_t>::max();

// The member of an object; null if it is absent, or this is no object.
const nlohmann::json* GltfMember(const nlohmann::json& object,
                                 const char* name);
// A count or an index; `missing` if it is absent, kNoGltfNumber if it is no
// whole number.
uint64_t GltfNumber(const nlohmann::json& object, const char* name,
                    uint64_t missing);

}  // namespace geodesic

#endif  // GEODESIC_READERS_GLTF_FILE_H_
