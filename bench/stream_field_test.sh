#!/usr/bin/env bash
# stream_field_test.sh GEODESICD STREAM_FIELD: starts a server and streams a large
# cached field from it and a small one, a few times. Fails unless every answer is
# right.
set -euo pipefail
folder=$(mktemp -d)
server=
cleanup() {
  [[ -z $server ]] || { kill -TERM "$server" && wait "$server"; } || true
  rm -rf "$folder"
}
trap cleanup EXIT

# A named pipe as the port file: reading it waits for the server.
mkfifo "$folder/port"
"$1" --listen 127.0.0.1:0 --port-file "$folder/port" 2>"$folder/log" &
server=$!
port=$(<"$folder/port")
for vertices in 200000 4000; do
  "$2" "127.0.0.1:$port" --vertices "$vertices" --repeat 20
done
