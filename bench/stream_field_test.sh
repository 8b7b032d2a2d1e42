#!/usr/bin/env bash
# stream_field_test.sh GEODESICD STREAM_FIELD: starts a server and streams a large
# cached field from it and a small one, a few times. Fails unless every answer is
# right.
set -euo pipefail
source "$(dirname "$0")/../tests/support/start_geodesicd.sh"
start_geodesicd "$1"
for vertices in 200000 4000; do
  "$2" "127.0.0.1:$port" --vertices "$vertices" --repeat 20
done
