#include "codec/answer_writer.h"

#include <algorithm>
#include <variant>

#include "absl/strings/str_cat.h"
#include "codec/value_type.h"
#include "geodesic_types/field_path.h"

namespace geodesic::codec {
namespace {

// 0, 1, 2 as point_kind has it.
static_assert(std::is_same_v<SurfacePoint,
                             std::variant<VertexPoint, EdgePoint, FacePoint>>);

// What point_numbers and point_weights have of a point at place `i`.
uint32_t NumberOf(const SurfacePoint& point, uint64_t i) {
  if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    return i == 0 ? edge->from : edge->to;
  }
  if (i > 0) return 0;
  const auto* face = std::get_if<FacePoint>(&point);
  return face != nullptr ? face->face : std::get<VertexPoint>(point).vertex;
}

double WeightOf(const SurfacePoint& point, uint64_t i) {
  if (const auto* face = std::get_if<FacePoint>(&point)) {
    return face->weights[i];
  }
  const auto* edge = std::get_if<EdgePoint>(&point);
  return edge != nullptr && i == 0 ? edge->t : 0;
}

}  // namespace

uint32_t AnswerWriter::Announce(const std::string& name, v1::ValueType type,
                                const std::vector<int64_t>& shape) {
  const auto number = static_cast<uint32_t>(arrays_.size());
  v1::ArrayInfo& info = *infos_.Add();
  info.set_name(name);
  info.set_type(type);
  info.mutable_shape()->Add(shape.begin(), shape.end());
  arrays_.push_back(
      {.size = SizeOf(type),
       .made = number < received_.size() ? received_[number] : 0});
  return number;
}

void AnswerWriter::Begin(v1::Answer& message) {
  message.clear_blocks();
  message_ = &message;
  bytes_ = 0;
  for (Array& array : arrays_) array.block = nullptr;
}

AnswerWriter::Part AnswerWriter::Take(uint32_t array, uint64_t first,
                                      uint64_t count) {
  Array& to = arrays_[array];
  to.end = std::max(to.end, first + count);
  const uint64_t begin = std::min(to.made - first, count);
  const uint64_t taken =
      std::min(count - begin, (kMessageBytes - bytes_) / to.size);
  if (taken == 0) return {begin, begin, nullptr};
  if (to.block == nullptr) {
    to.block = message_->add_blocks();
    to.block->set_array(array);
    to.block->set_first(to.made);
  }
  to.made += taken;
  bytes_ += taken * to.size;
  return {begin, begin + taken, to.block->mutable_values()};
}

template <typename Type>
bool AnswerWriter::PutBytes(uint32_t array, uint64_t first,
                            std::span<const Type> numbers) {
  const Part part = Take(array, first, numbers.size());
  if (part.bytes != nullptr) {
    part.bytes->append(
        reinterpret_cast<const char*>(numbers.data() + part.begin),
        (part.end - part.begin) * sizeof(Type));
  }
  return part.end == numbers.size();
}

bool AnswerWriter::Put(uint32_t array, uint64_t first,
                       std::span<const double> numbers) {
  if (arrays_[array].size == sizeof(double)) {
    return PutBytes(array, first, numbers);
  }
  return Put(array, first, numbers.size(),
             [&](uint64_t i) { return numbers[i]; });
}

bool AnswerWriter::Put(uint32_t array, uint64_t first,
                       std::span<const uint32_t> numbers) {
  return PutBytes(array, first, numbers);
}

absl::Status AnswerWriter::CheckReceived() const {
  if (received_.size() > arrays_.size()) {
    return InvalidField("resumption.received",
                        absl::StrCat("resumption.received has ",
                                     received_.size(), " numbers; the answer ",
                                     "has ", arrays_.size(), " arrays"));
  }
  for (size_t i = 0; i < received_.size(); ++i) {
    const uint64_t end = arrays_[i].end;
    if (received_[i] <= end) continue;
    return InvalidField(
        "resumption.received",
        absl::StrCat("resumption.received[", i, "] is ", received_[i],
                     "; the answer's array ", i, " has ", end, " numbers"));
  }
  return absl::OkStatus();
}

LineWriter::LineWriter(AnswerWriter& answer, int64_t lines)
    : answer_(answer),
      position_(answer.Announce("position", v1::VALUE_TYPE_FLOAT64, {-1, 3})),
      kind_(answer.Announce("point_kind", v1::VALUE_TYPE_UINT8, {-1})),
      numbers_(
          answer.Announce("point_numbers", v1::VALUE_TYPE_UINT32, {-1, 2})),
      weights_(
          answer.Announce("point_weights", v1::VALUE_TYPE_FLOAT64, {-1, 3})),
      line_end_(answer.Announce("line_end", v1::VALUE_TYPE_UINT64, {lines})) {}

bool LineWriter::Put(std::span<const SurfacePoint> points,
                     std::span<const std::array<double, 3>> positions) {
  const uint64_t count = points.size();
  end_ = first_ + count;
  return answer_.Put(position_, 3 * first_, 3 * count, [&](uint64_t i) {
    return positions[i / 3][i % 3];
  }) && answer_.Put(kind_, first_, count, [&](uint64_t i) {
    return static_cast<uint8_t>(points[i].index());
  }) && answer_.Put(numbers_, 2 * first_, 2 * count, [&](uint64_t i) {
    return NumberOf(points[i / 2], i % 2);
  }) && answer_.Put(weights_, 3 * first_, 3 * count, [&](uint64_t i) {
    return WeightOf(points[i / 3], i % 3);
  }) && answer_.PutOne(line_end_, line_, end_);
}

}  // namespace geodesic::codec
