// A field cut into messages, and cut at the radius that was asked for: the
// field itself may reach further.

#ifndef GEODESIC_SERVER_RPC_MESSAGES_FIELD_CHUNKS_H_
#define GEODESIC_SERVER_RPC_MESSAGES_FIELD_CHUNKS_H_

#include <cstdint>
#include <vector>

#include "geodesic/v1/field_service.pb.h"
#include "server/engine/query_engine.h"

namespace geodesic::server {

// Not thread-safe. Pins the field.
class FieldChunks {
 public:
  // The first chunk begins at `first_vertex`.
  // REQUIRES: `call` outlives the chunks and led to `answer`.
  FieldChunks(const FieldCall& call, FieldAnswer answer, FieldExtras extras,
              v1::ValueType value_type, uint64_t first_vertex);

  // Fills the next message of its kind; false when there is none left.
  bool Next(v1::FieldChunk& chunk);
  bool NextTargets(v1::TargetChunk& chunk);

  // Up to where every distance was sent. Final once every chunk was made.
  double settled_radius() const;

  const FieldAnswer& answer() const { return answer_; }

 private:
  // +infinity for what lies beyond the radius; remembers that there was such.
  double Cut(double distance);

  const FieldCall& call_;
  const FieldAnswer answer_;
  const FieldExtras extras_;
  const v1::ValueType value_type_;
  uint64_t next_vertex_;
  uint64_t next_target_ = 0;
  // Of the field's own targets, which are those that are no vertices or all.
  uint64_t next_own_target_ = 0;
  bool was_cut_ = false;
  std::vector<double> values_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESSAGES_FIELD_CHUNKS_H_
