#!/usr/bin/env bash
# h2load.sh: asks for a cached field with h2load, a load program that nobody
# here wrote.
#
#   h2load.sh BIN_FOLDER PROTO_FOLDER [QUESTIONS [VERTICES_A_SIDE]]
#
# Starts a geodesicd of its own. h2load knows HTTP/2 but not gRPC, so an error
# in the trailers is a success to it: that every answer was right is said by the
# server's own count of requests by code, and by the bytes that came. Prints what
# h2load says. Exit codes: 0 every question was answered; 1 not so; 2 wrong
# usage; 77 h2load or protoc is not installed (Debian: nghttp2-client,
# protobuf-compiler).
set -euo pipefail

(($# >= 2)) || { sed -n '5p' "$0" >&2; exit 2; }
bin=$1 protos=$2 questions=${3:-20000} side=${4:-64}
for tool in h2load protoc; do
  command -v "$tool" >/dev/null || { echo "there is no $tool" >&2; exit 77; }
done

source "$(dirname "$0")/../support/start_geodesicd.sh"
start_geodesicd "$bin/geodesicd" --metrics-listen 127.0.0.1:0
metrics=$(grep -oP 'metrics on port \K[0-9]+' "$folder/log")

# A square of side x side vertices.
awk -v n="$side" 'BEGIN {
  print "OFF"; print n * n, 2 * (n - 1) * (n - 1), 0
  for (j = 0; j < n; ++j) for (i = 0; i < n; ++i) print i, j, 0
  for (j = 0; j < n - 1; ++j) for (i = 0; i < n - 1; ++i) {
    a = i + j * n; b = a + n
    print 3, a, a + 1, b + 1; print 3, a, b + 1, b
  }
}' >"$folder/square.off"
geodesic=("$bin/geodesic" --server "127.0.0.1:$port" --json)
digest=$("${geodesic[@]}" upload "$folder/square.off" |
  grep -oPm1 '"digest": *"\K[0-9a-f]{64}')
# Computed once; then it is cached.
"${geodesic[@]}" field "$folder/square.off" --source 0 >"$folder/field.json"

# A gRPC message: not compressed, its length, itself.
protoc -I "$protos" --encode=geodesic.v1.ComputeFieldRequest \
  geodesic/v1/question_service.proto >"$folder/message" \
  <<<"mesh_digest: \"$digest\" sources { vertex: 0 }"
length=$(stat -c %s "$folder/message")
{
  printf '\0'
  printf '%08x' "$length" | sed 's/../\\x&/g' | xargs -0 printf '%b'
  cat "$folder/message"
} >"$folder/body"

answered() {
  local page
  exec {page}<>"/dev/tcp/127.0.0.1/$metrics"
  printf 'GET /metrics HTTP/1.1\r\nHost: h2load\r\n\r\n' >&"$page"
  tr -d '\r' <&"$page" |
    sed -n 's/^geodesic_requests_total{.*code="OK".*method="ComputeField".*} //p;
            s/^geodesic_requests_total{.*method="ComputeField".*code="OK".*} //p'
}
before=$(answered)
h2load --requests="$questions" --clients=4 --max-concurrent-streams=4 \
  --header='content-type: application/grpc' --header='te: trailers' \
  --data="$folder/body" \
  "http://127.0.0.1:$port/geodesic.v1.QuestionService/ComputeField" |
  tee "$folder/h2load" | grep -v '^progress:\|^spawning'

# A request is counted once gRPC is done with it, which is after the answer.
for ((i = 0; i < 50; ++i)); do
  gain=$(($(answered) - before))
  ((gain >= questions)) && break
  sleep 0.1
done
data=$(grep -oP '\(\K[0-9]+(?=\) data)' "$folder/h2load")
least=$((questions * side * side * 8))
echo "the server counts $gain OK; $data bytes came, of fields $least"
((gain == questions && data >= least))
