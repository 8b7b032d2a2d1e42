#!/usr/bin/env bash
# CLI11 2.1.2 (Debian 12) refuses an environment variable whose value its option does not
# take; 2.4.1 (Debian 13) passes over it without a word, so the program runs with the
# option's default.
#
#   findings/cli11-variables-not-taken.sh [MIRROR]    default: https://deb.debian.org/debian
#
# Needs curl, dpkg-deb and g++. Fails if one of the versions does otherwise.
set -euo pipefail
mirror=${1:-https://deb.debian.org/debian}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

cat >program.cc <<'END'
#include <CLI/CLI.hpp>
#include <iostream>

int main(int argc, char** argv) {
  CLI::App app;
  int threads = 1;
  app.add_option("--threads", threads)
      ->check(CLI::Range(1, 64))
      ->envname("PROGRAM_THREADS");
  try {
    app.parse(argc, argv);
    std::cout << threads << '\n';
  } catch (const CLI::Error& error) {
    std::cout << error.get_name() << '\n';
  }
}
END

# says VERSION OUTPUT: what the program prints with that version.
says() {
  local deb=libcli11-dev_$1_all.deb seen
  curl --fail --silent --show-error --remote-name "$mirror/pool/main/c/cli11/$deb"
  dpkg-deb --extract "$deb" "$1"
  g++ -std=c++17 -I "$1/usr/include" program.cc -o program
  seen=$(PROGRAM_THREADS=many ./program)
  echo "CLI11 $1: $seen"
  [[ $seen == "$2" ]] || { echo "expected: $2" >&2; exit 1; }
}
says 2.1.2+ds-1 ValidationError
says 2.4.1+ds-2 1
