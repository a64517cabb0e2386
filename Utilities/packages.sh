# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by the commands in this directory: what they need from Debian 12, and how they get it.
#
#   install_packages NAME...   installs those packages that are missing; silent when none is
#
# An installed package is removed only with consent: an answer at the terminal, or
# DIRECTIONFIELDS_ALLOW_REMOVAL=1 in the environment.

# find_package(ParaView) asks for the development files of every library that ParaView was built
# with; paraview-dev depends on a few of them only. What these packages depend on is not repeated.
# xmlpatterns (qtxmlpatterns5-dev-tools) makes the plugin's help pages, Python's development files are
# for the filters' Python package, dpkg-dev and file for the Debian packages.
# shellcheck disable=SC2034
plugin_packages=(
  g++ make cmake libeigen3-dev libsuitesparse-dev libgtest-dev
  paraview-dev python3-paraview python3-numpy xvfb xauth libgl1-mesa-dri
  qttools5-dev libqt5svg5-dev libqt5opengl5-dev qtxmlpatterns5-dev-tools
  libopenmpi-dev libgdal-dev libglew-dev libgl2ps-dev libfreetype-dev
  libtheora-dev libavformat-dev libswscale-dev libutfcpp-dev libdouble-conversion-dev libpython3-dev
  dpkg-dev file)

# What the tests need beyond.
# shellcheck disable=SC2034
benchmark_packages=(libbenchmark-dev)

# For the checks of the sources' style.
# shellcheck disable=SC2034
style_packages=(clang-format-14 shellcheck)

# Debian's own VTK 9.1: its libraries, and what its CMake files ask for beyond the above. Its
# development package excludes python3-paraview and is unpacked beside instead of installed.
# shellcheck disable=SC2034
vtk91_packages=(libvtk9.1 libjsoncpp-dev libtbb-dev)
# shellcheck disable=SC2034
vtk91_unpacked_packages=(libvtk9-dev libvtk9.1 vtk9 python3-vtk9)

say() {
  printf '== %s\n' "$*"
}

fail() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

require_debian_12() {
  local id=unknown version=''
  if [[ -r /etc/os-release ]]; then
    # shellcheck disable=SC1091
    read -r id version < <(. /etc/os-release && echo "${ID:-unknown} ${VERSION_ID:-}")
  fi
  if [[ $id != debian || $version != 12 ]]; then
    fail "this command installs packages of Debian 12, but this system is" \
      "$id${version:+ $version}; build with CMake as the README describes instead."
  fi
}

missing_packages() {
  local name state
  declare -A installed=()
  while read -r name state; do
    if [[ $state == installed ]]; then
      installed[$name]=1
    fi
  done < <(dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null)
  for name in "$@"; do
    if [[ -z ${installed[$name]:-} ]]; then
      echo "$name"
    fi
  done
}

# Runs a command that talks a lot; what it said is shown only if it fails.
quietly() {
  local log
  log=$(mktemp)
  if ! "$@" >"$log" 2>&1; then
    tail -n 30 "$log" >&2
    rm -f "$log"
    return 1
  fi
  rm -f "$log"
}

update_lists() {
  say "Fetching the package lists (apt-get update)"
  quietly "${privileged[@]}" apt-get --quiet -o DPkg::Lock::Timeout=300 update ||
    fail "apt-get update failed; are the network and the package sources in order?"
}

# Sets plan to what apt-get would do.
simulate() {
  plan=$(LC_ALL=C apt-get --simulate --no-install-recommends install "${missing[@]}" 2>&1)
}

# Sets removal to the options under which apt-get may carry out the plan.
consent_to_removals() {
  local removed answer=''
  removed=$(awk '$1 == "Remv" { printf "%s%s", separator, $2; separator = " " }' <<<"$plan")
  removal=(--no-remove)
  if [[ -z $removed ]]; then
    return
  fi
  if [[ ${DIRECTIONFIELDS_ALLOW_REMOVAL:-} == 1 ]]; then
    say "Removing, as DIRECTIONFIELDS_ALLOW_REMOVAL=1 allows: $removed"
  elif [[ -t 0 && -t 1 ]]; then
    read -r -p "Installing these packages removes: $removed. Go on? [y/N] " answer || true
    if [[ $answer != [yY]* ]]; then
      fail "nothing was installed or removed."
    fi
  else
    fail "installing the missing packages would remove $removed;" \
      "run again with DIRECTIONFIELDS_ALLOW_REMOVAL=1 to allow it."
  fi
  removal=()
}

install_packages() {
  local missing removal plan count privileged=()
  require_debian_12
  mapfile -t missing < <(missing_packages "$@")
  if [[ ${#missing[@]} -eq 0 ]]; then
    return
  fi
  if [[ $EUID -ne 0 ]]; then
    command -v sudo >/dev/null ||
      fail "packages have to be installed, which takes root or sudo: ${missing[*]}"
    privileged=(sudo)
  fi
  local lists=(/var/lib/apt/lists/*_Packages*)
  if [[ ! -e ${lists[0]} ]]; then
    update_lists
  fi
  if ! simulate; then
    # Lists from before the last point release name files that the mirrors no longer have.
    update_lists
    simulate || fail "apt-get cannot install ${missing[*]}: $(grep -m 1 '^E:' <<<"$plan" || true)"
  fi
  consent_to_removals
  count=$(grep -c '^Inst ' <<<"$plan" || true)
  say "Installing ${missing[*]}"
  say "These and what they depend on are $count packages; this can take a few minutes."
  local install=("${privileged[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --yes --quiet
    --no-install-recommends -o DPkg::Lock::Timeout=300 "${removal[@]}" install "${missing[@]}")
  if ! quietly "${install[@]}"; then
    update_lists
    quietly "${install[@]}" || fail "apt-get could not install ${missing[*]}."
  fi
}
