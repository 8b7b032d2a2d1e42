# To be sourced: a fresh Debian in a folder, made by debootstrap as root from the
# mirror that apt uses here, or $GEODESIC_DEBIAN_MIRROR.

# with_own_mounts ARGUMENT...: starts this check again, with these, where what it mounts
# is its own: gone when it ends, however it ends, and never in the way of others' rm -r.
with_own_mounts() {
  [[ ${GEODESIC_OWN_MOUNTS-} ]] ||
    GEODESIC_OWN_MOUNTS=1 exec unshare --mount -- "$PWD/scripts/checks/${0##*/}" "$@"
}

# debian_lacks: why none can be made here; nothing if one can.
debian_lacks() {
  if ((EUID != 0)); then
    echo "debootstrap and chroot want root"
  elif ! command -v debootstrap >/dev/null; then
    echo "debootstrap is not installed"
  elif [[ -z $(debian_mirror) ]]; then
    echo "apt knows no mirror of Debian; set GEODESIC_DEBIAN_MIRROR"
  fi
}

# debian_here: the name of this machine's release, e.g. bookworm.
debian_here() { (. /etc/os-release && echo "$VERSION_CODENAME"); }

debian_mirror() {
  echo "${GEODESIC_DEBIAN_MIRROR:-$(apt-get indextargets \
    --format '$(SITE) $(CODENAME)' | sed -n "s/ $(debian_here)\$//p" | head -1)}"
}

# make_debian ROOT RELEASE: in place of one that was there. Of this machine's release,
# it takes updates where this machine does, and so has the same packages.
make_debian() {
  remove_debian "$1" &&
    debootstrap --variant=minbase "$2" "$1" "$(debian_mirror)" || return
  [[ $2 != "$(debian_here)" ]] ||
    apt-get indextargets --format 'deb $(SITE) $(CODENAME) $(COMPONENT)' |
    grep -E " $2(-updates|-security)? " | sort -u >"$1/etc/apt/sources.list"
}

# enter_debian ROOT: gives it processes, devices and names; nothing that is installed
# there starts by itself, and apt asks no questions.
enter_debian() {
  local folder
  for folder in proc sys dev dev/pts; do
    mount --bind "/$folder" "$1/$folder"
  done
  cp /etc/resolv.conf "$1/etc/resolv.conf"
  # Installers and container engines write one.
  printf '127.0.0.1 localhost\n::1 localhost\n' >"$1/etc/hosts"
  printf '#!/bin/sh\nexit 101\n' >"$1/usr/sbin/policy-rc.d"
  chmod 755 "$1/usr/sbin/policy-rc.d"
  echo 'APT::Get::Assume-Yes "true";' >"$1/etc/apt/apt.conf.d/00assume-yes"
}

# mounts_below ROOT: the last come first.
mounts_below() {
  awk -v root="$1/" 'index($2, root) == 1 { print $2 }' /proc/mounts | sort -r
}

# leave_debian ROOT: undoes the mounts below it.
leave_debian() {
  local place
  for place in $(mounts_below "$1"); do umount -l "$place"; done
}

# remove_debian ROOT: and nothing that is mounted there.
remove_debian() {
  leave_debian "$1"
  [[ -z $(mounts_below "$1") ]] && rm -rf "$1"
}
