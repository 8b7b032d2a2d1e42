#include "server/rpc/calls/decoded_size.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/message.h>
#include <google/protobuf/wire_format_lite.h>

#include <map>

namespace geodesic::server {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::MessageFactory;
using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedInputStream;

// What an allocation and its place in a list cost beside its own bytes: the
// allocator's header and rounding, and a pointer in a list that may be twice as
// long as it is full.
constexpr uint64_t kAllocation = 32;
// A scalar in such a list, or a field that the type does not know.
constexpr uint64_t kScalar = 32;
// A string is an object beside its bytes.
constexpr uint64_t kString = kAllocation + 64;
// Packed numbers lie in such a list: those of fixed length as they are, and a
// varint of one byte as eight.
constexpr uint64_t kFixedGrowth = 2;
constexpr uint64_t kVarintGrowth = 16;

bool HasFixedLength(const FieldDescriptor& field) {
  return field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE ||
         field.cpp_type() == FieldDescriptor::CPPTYPE_FLOAT;
}

class Sizer {
 public:
  explicit Sizer(CodedInputStream& input) : input_(input) {}

  // Adds a message of this type, which is all up to the input's limit. False
  // when it is malformed.
  bool AddMessage(const Descriptor& type) {
    size_ += SizeOf(type);
    while (const uint32_t tag = input_.ReadTag()) {
      if (!AddField(type, tag)) return false;
    }
    return input_.ConsumedEntireMessage();
  }

  uint64_t size() const { return size_; }

 private:
  // More are refused by the parser, too.
  static constexpr int kDeepest = 100;

  bool AddField(const Descriptor& type, uint32_t tag) {
    const FieldDescriptor* field =
        type.FindFieldByNumber(WireFormatLite::GetTagFieldNumber(tag));
    switch (WireFormatLite::GetTagWireType(tag)) {
      case WireFormatLite::WIRETYPE_LENGTH_DELIMITED:
        return AddDelimited(field);
      case WireFormatLite::WIRETYPE_START_GROUP:
      case WireFormatLite::WIRETYPE_END_GROUP:
        // No message of the protocol has groups; the parser keeps them as
        // unknown fields.
        is_in_group_ = true;
        size_ += kString;
        return true;
      default:
        if (field == nullptr || field->is_repeated() || is_in_group_) {
          size_ += kScalar;
        }
        return WireFormatLite::SkipField(&input_, tag);
    }
  }

  bool AddDelimited(const FieldDescriptor* field) {
    uint32_t length = 0;
    if (!input_.ReadVarint32(&length)) return false;
    if (field == nullptr || field->message_type() == nullptr) {
      if (field != nullptr && field->is_packable()) {
        size_ +=
            kAllocation +
            (HasFixedLength(*field) ? kFixedGrowth : kVarintGrowth) * length;
      } else {
        size_ += kString + length;
      }
      return input_.Skip(static_cast<int>(length));
    }
    if (++depth_ > kDeepest) return false;
    size_ += kAllocation;
    const auto limit = input_.PushLimit(static_cast<int>(length));
    if (!AddMessage(*field->message_type())) return false;
    input_.PopLimit(limit);
    --depth_;
    return true;
  }

  uint64_t SizeOf(const Descriptor& type) {
    uint64_t& size = sizes_[&type];
    if (size == 0) {
      size = MessageFactory::generated_factory()
                 ->GetPrototype(&type)
                 ->SpaceUsedLong();
    }
    return size;
  }

  CodedInputStream& input_;
  std::map<const Descriptor*, uint64_t> sizes_;  // of empty messages
  uint64_t size_ = 0;
  int depth_ = 0;
  bool is_in_group_ = false;
};

}  // namespace

uint64_t DecodedSize(const Descriptor& type,
                     google::protobuf::io::ZeroCopyInputStream& bytes) {
  CodedInputStream input(&bytes);
  Sizer sizer(input);
  sizer.AddMessage(type);
  return sizer.size();
}

}  // namespace geodesic::server
