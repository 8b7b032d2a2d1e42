#!/usr/bin/env bash
# man shows the pages of the programs without a warning, and the shells that are
# installed complete what is begun.
#
#   shells_test.sh FOLDER_OF_GEODESIC FOLDER_OF_GEODESICD
set -euo pipefail
client=$1 server=$2
failures=0

# expect NAME WORD TEXT: one of the text's lines begins with this word.
expect() {
  grep -qE -- "^$2(\$|[[:space:]])" <<<"$3" && return
  echo "$1 does not offer $2 but: ${3:-nothing}" >&2
  failures=$((failures + 1))
}

# What bash offers for these words, the last of which is begun.
in_bash() {
  bash --norc -c '. "$0"; COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)); _geodesic
    printf "%s\n" "${COMPREPLY[@]}"' "$client/geodesic.bash" "$@"
}
in_fish() {
  HOME=$(mktemp -d) fish -c "source $client/geodesic.fish; complete -C '$*'"
}

for shell in bash fish; do
  command -v $shell >/dev/null || { echo "$shell is not installed"; continue; }
  expect $shell field "$(in_$shell geodesic fie)"
  expect $shell --source "$(in_$shell geodesic field --so)"
  expect $shell --server "$(in_$shell geodesic field --se)"
  expect $shell batch "$(in_$shell geodesic field --priority b)"
done
if command -v zsh >/dev/null; then
  zsh -n "$client/_geodesic" || failures=$((failures + 1))
fi

if command -v man >/dev/null; then
  for page in "$client"/*.gz "$server"/*.gz; do
    shown=$(MANWIDTH=80 man --warnings --encoding=UTF-8 -l "$page" 2>&1 >/dev/null)
    [[ -z $shown ]] || { echo "$page: $shown" >&2; failures=$((failures + 1)); }
  done
fi
((failures == 0))
