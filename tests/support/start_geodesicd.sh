# To be sourced.
#
# start_geodesicd PROGRAM [FLAG...]: starts a server on a free port of this
# machine and waits until it listens. Sets `folder`, a temporary one that has the
# server's `log`, and `port`. Both end with the script.
start_geodesicd() {
  folder=$(mktemp -d)
  trap stop_geodesicd EXIT
  # A named pipe as the port file: reading it waits for the server.
  mkfifo "$folder/port"
  "$1" --listen 127.0.0.1:0 --port-file "$folder/port" "${@:2}" \
    2>"$folder/log" &
  server=$!
  port=$(<"$folder/port")
}

stop_geodesicd() {
  [[ -z ${server-} ]] || { kill -TERM "$server" && wait "$server"; } || true
  rm -rf "$folder"
}
