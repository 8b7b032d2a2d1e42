#include "codec/answer_reader.h"

#include <google/protobuf/util/message_differencer.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <span>
#include <type_traits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "codec/value_type.h"

namespace geodesic::codec {
namespace {

// How many bytes to reserve on the server's word alone. That takes address
// space only, until numbers arrive. Larger arrays grow as vectors do.
constexpr uint64_t kMostReserved = uint64_t{1} << 27;

// What an element is made of.
template <typename Element>
struct NumberOf {
  using Type = Element;
};
template <typename Number, size_t kSize>
struct NumberOf<std::array<Number, kSize>> {
  using Type = Number;
};
template <typename Element>
constexpr size_t kNumbers = sizeof(Element) /
                            sizeof(typename NumberOf<Element>::Type);

// Doubles take floats, too.
bool HasType(const v1::ArrayInfo& info, const AnswerReader::Values& values) {
  const auto is_right = [&]<typename Element>(const std::vector<Element>*) {
    using Number = typename NumberOf<Element>::Type;
    const v1::ValueType type = info.type();
    const bool is_float = type == v1::VALUE_TYPE_FLOAT32;
    return (is_float || type == v1::VALUE_TYPE_FLOAT64) ==
               std::is_floating_point_v<Number> &&
           (SizeOf(type) == sizeof(Number) ||
            (is_float && sizeof(Number) == sizeof(double)));
  };
  return std::visit(is_right, values);
}

// Appends whole elements of numbers that have `size` bytes each. Returns what
// is left over.
template <typename Element>
std::string_view Append(std::string_view bytes, size_t size,
                        std::vector<Element>* elements) {
  using Number = typename NumberOf<Element>::Type;
  const size_t had = elements->size();
  const size_t count = bytes.size() / (kNumbers<Element> * size);
  elements->resize(had + count);
  char* to = reinterpret_cast<char*>(elements->data() + had);
  if (size == sizeof(Number) && count > 0) {
    std::memcpy(to, bytes.data(), count * sizeof(Element));
  } else {
    for (size_t i = 0; i < count * kNumbers<Element>;
         ++i, to += sizeof(Number)) {
      float narrow;
      std::memcpy(&narrow, bytes.data() + i * size, sizeof(narrow));
      const auto wide = static_cast<Number>(narrow);
      std::memcpy(to, &wide, sizeof(wide));
    }
  }
  return bytes.substr(count * kNumbers<Element> * size);
}

// How many numbers an array of this shape has, or each of its rows; nothing if
// there can be none such.
std::optional<uint64_t> Product(std::span<const int64_t> shape) {
  uint64_t product = 1;
  for (const int64_t size : shape) {
    if (size < 0 || __builtin_mul_overflow(product, size, &product)) {
      return std::nullopt;
    }
  }
  return product;
}

bool HasShape(const v1::ArrayInfo& info, const AnswerReader::Shape& shape,
              uint64_t vertex_count) {
  return std::ranges::equal(
      info.shape(), shape, [vertex_count](int64_t announced, int64_t wanted) {
        if (wanted == AnswerReader::kVertices) {
          return std::cmp_equal(announced, vertex_count);
        }
        return wanted <= AnswerReader::kAny || announced == wanted;
      });
}

}  // namespace

void AnswerReader::Collect(std::string_view name, const Shape& shape,
                           Values values) {
  wanted_.push_back({std::string(name), shape, values});
}

absl::Status AnswerReader::TakeHeader(const v1::AnswerHeader& header) {
  using google::protobuf::util::MessageDifferencer;
  // A stream that is resumed must continue the same answer.
  if (!arrays_.empty()) {
    return header.vertex_count() == header_.vertex_count() &&
                   std::ranges::equal(header.arrays(), header_.arrays(),
                                      MessageDifferencer::Equals)
               ? absl::OkStatus()
               : absl::DataLossError("the server went on with another answer");
  }
  for (const v1::ArrayInfo& info : header.arrays()) {
    const std::span shape(info.shape().data(), info.shape().size());
    const bool is_open = !shape.empty() && shape[0] == -1;
    const auto per_row = Product(shape.subspan(shape.empty() ? 0 : 1));
    const auto count = is_open ? std::nullopt : Product(shape);
    if (shape.empty() || SizeOf(info.type()) == 0 || per_row.value_or(0) == 0 ||
        !(is_open || count.has_value())) {
      return absl::DataLossError(absl::StrCat(
          "the server announced numbers that cannot be: ", info.name()));
    }
    arrays_.push_back({.per_row = *per_row, .count = count});
  }
  for (const Wanted& wanted : wanted_) {
    const auto info =
        std::ranges::find(header.arrays(), wanted.name, &v1::ArrayInfo::name);
    if (info == header.arrays().end() ||
        !HasShape(*info, wanted.shape, header.vertex_count()) ||
        !HasType(*info, wanted.values)) {
      return absl::DataLossError(absl::StrCat(
          "the server announced no or other numbers of ", wanted.name));
    }
    Array& array = arrays_[info - header.arrays().begin()];
    array.wanted = wanted;
    std::visit(
        [&]<typename Element>(std::vector<Element>* values) {
          values->reserve(std::min(array.count.value_or(0) / array.per_row,
                                   kMostReserved / sizeof(Element)));
        },
        wanted.values);
  }
  return absl::OkStatus();
}

absl::Status AnswerReader::TakeBlock(const v1::Block& block) {
  if (block.array() >= arrays_.size()) {
    return absl::DataLossError(absl::StrCat(
        "the server sent array ", block.array(), " of ", arrays_.size()));
  }
  const v1::ArrayInfo& info = header_.arrays(static_cast<int>(block.array()));
  Array& array = arrays_[block.array()];
  std::string_view bytes = block.values();
  const size_t size = SizeOf(info.type());
  if (block.first() != array.received || bytes.size() % size != 0 ||
      (array.count.has_value() &&
       bytes.size() / size > *array.count - array.received)) {
    return absl::DataLossError(absl::StrCat(
        "the server sent ", bytes.size(), " bytes of ", info.name(),
        " from number ", block.first(), " after ", array.received,
        array.count.has_value() ? absl::StrCat(" of ", *array.count) : ""));
  }
  array.received += bytes.size() / size;
  if (!array.wanted.has_value()) return absl::OkStatus();
  std::visit(
      [&]<typename Element>(std::vector<Element>* values) {
        // First the element that the last block has begun.
        const size_t whole = size * kNumbers<Element>;
        const size_t missing =
            array.rest.empty() ? 0 : whole - array.rest.size();
        array.rest += bytes.substr(0, missing);
        bytes.remove_prefix(std::min(missing, bytes.size()));
        if (array.rest.size() == whole) {
          Append(std::exchange(array.rest, ""), size, values);
        }
        array.rest += Append(bytes, size, values);
      },
      array.wanted->values);
  return absl::OkStatus();
}

absl::Status AnswerReader::CheckComplete() const {
  std::map<int64_t, uint64_t> sizes;  // that have names
  for (size_t i = 0; i < arrays_.size(); ++i) {
    const Array& array = arrays_[i];
    uint64_t due =
        array.count.value_or(array.received - array.received % array.per_row);
    if (array.wanted.has_value() && array.wanted->shape[0] <= kAny) {
      due = sizes.emplace(array.wanted->shape[0], due / array.per_row)
                .first->second *
            array.per_row;
    }
    if (array.received != due) {
      return absl::DataLossError(absl::StrCat(
          "the server sent ", array.received, " of ", due, " numbers of ",
          header_.arrays(static_cast<int>(i)).name()));
    }
  }
  return absl::OkStatus();
}

absl::Status AnswerReader::Consume(const v1::Answer& message) {
  if (message.has_header() == is_begun_ || is_complete_) {
    return absl::DataLossError("the server's answer is out of order");
  }
  absl::Status status;
  if (message.has_header()) {
    status = TakeHeader(message.header());
    header_ = message.header();
    is_begun_ = true;
  }
  if (!message.answer_id().empty()) answer_id_ = message.answer_id();
  for (const v1::Block& block : message.blocks()) {
    if (status.ok()) status = TakeBlock(block);
  }
  if (status.ok() && message.has_trailer()) {
    status = CheckComplete();
    trailer_ = message.trailer();
    is_complete_ = true;
  }
  return status;
}

uint64_t AnswerReader::received() const {
  uint64_t numbers = 0;
  for (const Array& array : arrays_) numbers += array.received;
  return numbers;
}

std::optional<v1::Resumption> AnswerReader::Resume() {
  is_begun_ = false;
  is_complete_ = false;
  if (answer_id_.empty()) return std::nullopt;
  v1::Resumption resumption;
  resumption.set_answer_id(answer_id_);
  for (const Array& array : arrays_) resumption.add_received(array.received);
  return resumption;
}

void AnswerReader::Restart() {
  for (const Wanted& wanted : wanted_) {
    std::visit([](auto* values) { values->clear(); }, wanted.values);
  }
  arrays_.clear();
  answer_id_.clear();
}

}  // namespace geodesic::codec
