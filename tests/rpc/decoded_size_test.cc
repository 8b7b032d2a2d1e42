#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <gtest/gtest.h>

#include <string>

#include "geodesic/v1/mesh_service.pb.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/rpc/calls/intake.h"

namespace geodesic::server {
namespace {

template <typename Message>
uint64_t SizeOf(const std::string& bytes) {
  google::protobuf::io::ArrayInputStream stream(bytes.data(),
                                                static_cast<int>(bytes.size()));
  return DecodedSize(*Message::descriptor(), stream);
}

// That the size of what these bytes become is bounded from above, and not by
// much.
template <typename Message>
void ExpectBound(const std::string& bytes) {
  Message message;
  ASSERT_TRUE(message.ParseFromString(bytes));
  const uint64_t bound = SizeOf<Message>(bytes);
  EXPECT_GE(bound, message.SpaceUsedLong());
  EXPECT_LE(bound, 4 * message.SpaceUsedLong());
}

TEST(DecodedSize, BoundsWhatIsDecoded) {
  v1::ComputePathsRequest paths;
  ExpectBound<v1::ComputePathsRequest>(paths.SerializeAsString());
  paths.set_mesh_digest(std::string(64, 'a'));
  for (int i = 0; i < 1000; ++i) {
    paths.add_targets()->set_vertex(i);
    v1::FacePoint& face = *paths.add_sources()->mutable_face();
    for (int k = 0; k < 3; ++k) face.add_weights(1);
    v1::Curve& curve = *paths.add_sources()->mutable_curve();
    curve.add_points()->mutable_edge()->set_t(0.5);
  }
  ExpectBound<v1::ComputePathsRequest>(paths.SerializeAsString());

  v1::ComputeIsolinesRequest isolines;
  for (int i = 0; i < 1000; ++i) isolines.add_levels(i);
  ExpectBound<v1::ComputeIsolinesRequest>(isolines.SerializeAsString());

  v1::ComputeFieldRequest field;
  for (int i = 0; i < 1000; ++i) {
    field.add_quantities(v1::FIELD_QUANTITY_GRADIENT);
    field.mutable_resumption()->add_received(i);
  }
  ExpectBound<v1::ComputeFieldRequest>(field.SerializeAsString());

  v1::CreateMeshRequest upload;
  upload.mutable_chunk()->set_data(std::string(100'000, 'x'));
  ExpectBound<v1::CreateMeshRequest>(upload.SerializeAsString());
}

TEST(DecodedSize, CountsWhatIsSmallOnTheWire) {
  // Targets without a place: two bytes each.
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += std::string("\x5a\x00", 2);
  ExpectBound<v1::ComputePathsRequest>(bytes);
  EXPECT_GT(SizeOf<v1::ComputePathsRequest>(bytes), 20 * bytes.size());
}

TEST(DecodedSize, CountsWhatTheProtocolDoesNotKnow) {
  std::string bytes;
  // Field 100: a number, a string, and a group with a number in it.
  for (int i = 0; i < 1000; ++i) {
    bytes += std::string("\xa0\x06\x01", 3) + "\xa2\x06\x02hi" +
             "\xa3\x06\xa0\x06\x01\xa4\x06";
  }
  v1::ComputePathsRequest message;
  ASSERT_TRUE(message.ParseFromString(bytes));
  EXPECT_GE(SizeOf<v1::ComputePathsRequest>(bytes), message.SpaceUsedLong());
}

TEST(DecodedSize, EndsWhereTheBytesAreMalformed) {
  const uint64_t empty = SizeOf<v1::ComputePathsRequest>("");
  // A target of two gigabytes, one of more than there are, a tag alone.
  for (const std::string& bytes :
       {std::string("\x5a\xff\xff\xff\xff\x07"), std::string("\x5a\x05\x08"),
        std::string("\x5a"), std::string("\x08\x08\x08")}) {
    EXPECT_LE(SizeOf<v1::ComputePathsRequest>(bytes), empty + 200) << bytes;
  }
  // Curves in curves are no curves; this is deep only in the unknown.
  std::string nested;
  for (int i = 0; i < 100'000; ++i) nested += "\xa3\x06";
  EXPECT_GT(SizeOf<v1::ComputePathsRequest>(nested), nested.size());
}

}  // namespace
}  // namespace geodesic::server
