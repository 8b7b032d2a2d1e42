#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "tests/fuzz/rpc/rpc_script.h"

namespace geodesic::server::test {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

constexpr size_t kMostFrames = 16;
constexpr int kMostItems = 100;

class Mutator {
 public:
  explicit Mutator(std::mt19937_64& random) : random_(random) {}

  void Change(RpcScript& script) {
    const size_t choice = Below(20);
    if (script.empty() || (choice == 0 && script.size() < kMostFrames)) {
      const RpcScript& seed = Any(SeedScripts());
      script.insert(script.end(), seed.begin(), seed.end());
      return;
    }
    RpcFrame& frame = Any(script);
    if (choice == 1) {
      script.erase(script.begin() +
                   static_cast<ptrdiff_t>(Below(script.size())));
    } else if (choice == 2 && script.size() < kMostFrames) {
      script.push_back(RpcFrame(frame));
    } else if (choice == 3) {
      std::swap(frame, Any(script));
    } else if (choice == 4) {
      frame.method = static_cast<RpcMethod>(Below(kRpcMethods));
    } else if (choice == 5) {
      frame.cancel_after = static_cast<uint8_t>(Below(32));
    } else if (choice == 6) {
      frame.overlaps = !frame.overlaps;
      frame.ends_upload = Below(2) == 0;
    } else if (choice < 10) {
      ChangeBytes(frame.message);
    } else {
      ChangeFields(frame);
    }
  }

 private:
  size_t Below(size_t end) { return random_() % end; }

  template <typename Container>
  auto Any(Container& items) -> decltype(items[0]) {
    return items[Below(std::size(items))];
  }

  void ChangeBytes(std::string& bytes) {
    const size_t at = Below(bytes.size() + 1);
    switch (Below(4)) {
      case 0:
        bytes.insert(at, 1 + Below(4), static_cast<char>(random_()));
        break;
      case 1:
        bytes.erase(at, 1 + Below(4));
        break;
      case 2:
        bytes.insert(at, bytes.substr(Below(bytes.size() + 1), Below(32)));
        break;
      default:
        if (at < bytes.size()) {
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << Below(8)));
        }
    }
  }

  void ChangeFields(RpcFrame& frame) {
    const std::unique_ptr<Message> message = NewRequest(frame.method);
    // What cannot be read leaves what came before.
    message->ParsePartialFromString(frame.message);
    ChangeField(*message);
    frame.message = message->SerializePartialAsString();
  }

  void ChangeField(Message& message) {
    const auto* type = message.GetDescriptor();
    if (type->field_count() == 0) return;
    const FieldDescriptor* field =
        type->field(static_cast<int>(Below(type->field_count())));
    const Reflection& reflection = *message.GetReflection();
    if (field->is_repeated()) {
      ChangeItems(message, reflection, field);
    } else if (Below(8) == 0) {
      reflection.ClearField(&message, field);
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      ChangeField(*reflection.MutableMessage(&message, field));
    } else {
      SetValue(message, reflection, field);
    }
  }

  void ChangeItems(Message& message, const Reflection& reflection,
                   const FieldDescriptor* field) {
    const int size = reflection.FieldSize(message, field);
    const size_t choice = Below(6);
    if (size == 0 || (choice == 0 && size < kMostItems)) {
      const size_t count = Below(8) == 0 ? 1 + Below(20) : 1;
      for (size_t i = 0; i < count; ++i) AddItem(message, reflection, field);
    } else if (choice == 1) {
      reflection.RemoveLast(&message, field);
    } else if (choice == 2) {
      reflection.SwapElements(&message, field, static_cast<int>(Below(size)),
                              static_cast<int>(Below(size)));
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      ChangeField(*reflection.MutableRepeatedMessage(
          &message, field, static_cast<int>(Below(size))));
    } else {
      reflection.RemoveLast(&message, field);
      AddItem(message, reflection, field);
    }
  }

  void AddItem(Message& message, const Reflection& reflection,
               const FieldDescriptor* field) {
    switch (field->cpp_type()) {
      case FieldDescriptor::CPPTYPE_MESSAGE:
        ChangeField(*reflection.AddMessage(&message, field));
        break;
      case FieldDescriptor::CPPTYPE_ENUM:
        reflection.AddEnumValue(&message, field, EnumValue());
        break;
      case FieldDescriptor::CPPTYPE_DOUBLE:
        reflection.AddDouble(&message, field, Double());
        break;
      case FieldDescriptor::CPPTYPE_STRING:
        reflection.AddString(&message, field, Text(""));
        break;
      case FieldDescriptor::CPPTYPE_UINT64:
        reflection.AddUInt64(&message, field, Integer());
        break;
      default:
        break;  // the contract has no others
    }
  }

  void SetValue(Message& message, const Reflection& reflection,
                const FieldDescriptor* field) {
    switch (field->cpp_type()) {
      case FieldDescriptor::CPPTYPE_ENUM:
        reflection.SetEnumValue(&message, field, EnumValue());
        break;
      case FieldDescriptor::CPPTYPE_DOUBLE:
        reflection.SetDouble(&message, field, Double());
        break;
      case FieldDescriptor::CPPTYPE_STRING:
        reflection.SetString(&message, field,
                             Text(reflection.GetString(message, field)));
        break;
      case FieldDescriptor::CPPTYPE_UINT64:
        reflection.SetUInt64(&message, field, Integer());
        break;
      case FieldDescriptor::CPPTYPE_INT32:
        reflection.SetInt32(&message, field, static_cast<int32_t>(Integer()));
        break;
      case FieldDescriptor::CPPTYPE_BOOL:
        reflection.SetBool(&message, field, Below(2) == 0);
        break;
      default:
        break;
    }
  }

  int EnumValue() { return static_cast<int>(Below(12)) - 1; }

  uint64_t Integer() {
    constexpr uint64_t kMax = std::numeric_limits<uint64_t>::max();
    static constexpr uint64_t kEdges[] = {
        0,        1ull << 31, (1ull << 32) - 1, 1ull << 32, 1ull << 63,
        kMax - 1, kMax};
    return Below(3) > 0 ? Below(40) : Any(kEdges);
  }

  double Double() {
    using Limits = std::numeric_limits<double>;
    static constexpr double kEdges[] = {0.0,
                                        -0.0,
                                        1.0,
                                        -1.0,
                                        0.5,
                                        1.0 / 3,
                                        1e-9,
                                        1e-300,
                                        1e300,
                                        Limits::infinity(),
                                        -Limits::infinity(),
                                        Limits::quiet_NaN(),
                                        Limits::denorm_min(),
                                        Limits::max(),
                                        1 + Limits::epsilon()};
    if (Below(2) == 0) return Any(kEdges);
    return std::uniform_real_distribution<double>(0, 2)(random_);
  }

  std::string Text(std::string text) {
    if (Below(2) == 0) return std::string(1, static_cast<char>('A' + Below(8)));
    if (Below(8) == 0) return std::string(64, 'a');
    ChangeBytes(text);
    return text;
  }

  std::mt19937_64& random_;
};

}  // namespace

void Mutate(RpcScript& script, std::mt19937_64& random) {
  Mutator mutator(random);
  const size_t changes = 1 + random() % 4;
  for (size_t i = 0; i < changes; ++i) mutator.Change(script);
}

}  // namespace geodesic::server::test
