#include "tests/rpc/reply.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "codec/value_type.h"

namespace geodesic::server::test {
namespace {

// How many numbers an item of an array has.
uint64_t WidthOf(const v1::ArrayInfo& array) {
  return std::accumulate(array.shape().begin() + 1, array.shape().end(),
                         uint64_t{1}, std::multiplies<>());
}

// That of these numbers of each array none is of a line whose points have not
// come. `ends`: of the lines.
void ExpectPointsFirst(
    const google::protobuf::RepeatedPtrField<v1::ArrayInfo>& arrays,
    const std::vector<uint64_t>& received, const std::vector<uint64_t>& ends) {
  uint64_t points = std::numeric_limits<uint64_t>::max();
  uint64_t lines = 0;
  for (int i = 0; i < arrays.size(); ++i) {
    const std::string& name = arrays[i].name();
    if (name == "position" || name.starts_with("point_")) {
      points = std::min(points, received[i] / WidthOf(arrays[i]));
    } else {
      lines = std::max(lines, received[i]);
    }
  }
  if (lines > 0) {
    EXPECT_LE(ends.at(lines - 1), points);
  }
}

}  // namespace

std::string Reply::answer_id() const {
  for (const v1::Answer& message : messages) {
    if (!message.answer_id().empty()) return message.answer_id();
  }
  return "";
}

ptrdiff_t Reply::pieces() const {
  return std::ranges::count_if(messages, [](const v1::Answer& message) {
    return !message.blocks().empty();
  });
}

std::string Reply::Bytes(size_t array) const {
  std::string bytes;
  for (const v1::Answer& message : messages) {
    for (const v1::Block& block : message.blocks()) {
      if (block.array() == array) bytes += block.values();
    }
  }
  return bytes;
}

size_t Reply::NumberOf(const std::string& name) const {
  const auto& arrays = header().arrays();
  const auto array = std::ranges::find(arrays, name, &v1::ArrayInfo::name);
  if (array == arrays.end()) throw std::out_of_range(name);
  return array - arrays.begin();
}

Reply ReadAll(AnswerReader& reader) {
  Reply reply;
  v1::Answer message;
  while (reader.Read(&message)) reply.messages.push_back(std::move(message));
  reply.status = reader.Finish();
  return reply;
}

void ExpectRules(const Reply& reply, const v1::Resumption& before) {
  if (reply.messages.empty()) {
    EXPECT_FALSE(reply.status.ok());
    return;
  }
  const auto& arrays = reply.header().arrays();
  std::vector<uint64_t> next(before.received().begin(),
                             before.received().end());
  next.resize(arrays.size());
  std::vector<uint64_t> line_ends;
  if (reply.status.ok() && before.received().empty() &&
      std::ranges::count(arrays, "line_end", &v1::ArrayInfo::name) > 0) {
    line_ends = reply.Values<uint64_t>("line_end");
  }
  bool is_named = false;
  for (const v1::Answer& message : reply.messages) {
    EXPECT_EQ(message.has_header(), &message == &reply.messages.front());
    EXPECT_EQ(message.has_trailer(),
              reply.status.ok() && &message == &reply.messages.back());
    // With the first block, or at the end if there is none.
    const bool brings_name = !message.blocks().empty() || message.has_trailer();
    EXPECT_EQ(message.answer_id().empty(), is_named || !brings_name);
    is_named |= brings_name;
    for (const v1::Block& block : message.blocks()) {
      ASSERT_LT(block.array(), arrays.size());
      const size_t size = codec::SizeOf(arrays[block.array()].type());
      EXPECT_EQ(block.first(), next[block.array()]);
      EXPECT_GT(block.values().size(), 0);
      EXPECT_EQ(block.values().size() % size, 0);
      next[block.array()] += block.values().size() / size;
    }
    if (!line_ends.empty()) ExpectPointsFirst(arrays, next, line_ends);
  }
  if (!reply.status.ok()) return;
  for (int i = 0; i < arrays.size(); ++i) {
    const int64_t items = arrays[i].shape(0);
    const uint64_t width = WidthOf(arrays[i]);
    EXPECT_EQ(next[i], items < 0 ? next[i] / width * width : items * width)
        << arrays[i].name();
  }
}

}  // namespace geodesic::server::test
