#!/usr/bin/env bash
# CLI11 2.1.2 (Debian 12) has options -k and --k side by side in one command;
# 2.4.1 (Debian 13) throws OptionAlreadyAdded when the second is added, so a
# program that was right ends before it reads a word. Neither prints a warning
# when it is compiled.
#
#   findings/cli11-one-letter-names.sh [MIRROR]    default: https://deb.debian.org/debian
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
  int count = 0, neighbours = 0;
  try {
    app.add_option("-k,--count", count);
    app.add_option("--k", neighbours);
    app.parse(argc, argv);
    std::cout << count << ' ' << neighbours << '\n';
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
  seen=$(./program -k 3 --k 50)
  echo "CLI11 $1: $seen"
  [[ $seen == "$2" ]] || { echo "expected: $2" >&2; exit 1; }
}
says 2.1.2+ds-1 "3 50"
says 2.4.1+ds-2 OptionAlreadyAdded
