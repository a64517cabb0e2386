# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by the commands in this directory: what they need from Debian 12, 13 or sid, and how they get
# it.
#
#   install_packages NAME...   installs those packages that are missing; silent when none is
#
# An installed package is removed only with consent: an answer at the terminal, or
# DIRECTIONFIELDS_ALLOW_REMOVAL=1 in the environment. With DIRECTIONFIELDS_SKIP_PACKAGES=1 nothing is
# looked for or installed, on any system.

# Debian's release: its number, sid, which has none, or nothing on other systems.
debian_release() {
  local id='' version=''
  if [[ -r /etc/os-release ]]; then
    # shellcheck disable=SC1091
    read -r id version < <(. /etc/os-release && echo "${ID:-} ${VERSION_ID:-sid}")
  fi
  if [[ $id == debian ]]; then
    echo "$version"
  fi
}
release=$(debian_release)

# find_package(ParaView) asks for the development files of every library that ParaView was built
# with; paraview-dev depends on a few of them only. What these packages depend on is not repeated.
# Python's development files are for the filters' Python package, dpkg-dev and file for the Debian
# packages, locales for the tests of users whose numbers have a decimal comma.
# shellcheck disable=SC2034
plugin_packages=(
  g++ make cmake libeigen3-dev libgtest-dev
  paraview paraview-dev python3-paraview python3-numpy libpython3-dev xvfb xauth libgl1-mesa-dri
  dpkg-dev file locales)
paraview_packages=(
  libopenmpi-dev libgdal-dev libglew-dev libgl2ps-dev libfreetype-dev libtheora-dev libavformat-dev
  libswscale-dev libutfcpp-dev libdouble-conversion-dev)
qt6_packages=(qt6-base-dev qt6-tools-dev qt6-tools-dev-tools qt6-svg-dev qt6-5compat-dev)
# For VTK without ParaView: Debian's own VTK, its libraries, and what its CMake files ask for beyond the
# above. Where its development package excludes python3-paraview it is unpacked beside instead of
# installed.
vtk_packages=()
unpacked_vtk_packages=()
# shellcheck disable=SC2034
case $release in
  12)
    # xmlpatterns (qtxmlpatterns5-dev-tools) makes the plugin's help pages.
    plugin_packages+=("${paraview_packages[@]}"
      qttools5-dev libqt5svg5-dev libqt5opengl5-dev qtxmlpatterns5-dev-tools)
    vtk_packages=(libvtk9.1 libjsoncpp-dev libtbb-dev)
    unpacked_vtk_packages=(libvtk9-dev libvtk9.1 vtk9 python3-vtk9)
    ;;
  13)
    plugin_packages+=("${paraview_packages[@]}" "${qt6_packages[@]}")
    vtk_packages=(libvtk9.3 libjsoncpp-dev libtbb-dev)
    unpacked_vtk_packages=(libvtk9-dev libvtk9.3 vtk9 python3-vtk9)
    ;;
  sid)
    # This ParaView is built upon Debian's VTK.
    plugin_packages+=("${qt6_packages[@]}" xsltproc libvtk9-dev libvtk9-qt-dev
      python3-vtk9)
    vtk_packages=(libvtk9-dev python3-vtk9)
    ;;
esac

# What the tests need beyond: for benchmarks, and for surfaces on several processes that are not gathered.
# shellcheck disable=SC2034
benchmark_packages=(libbenchmark-dev)
# shellcheck disable=SC2034
distributed_packages=(libpetsc-complex-dev)

# A solver of finite elements that computes with the meshes written for it, which Debian 13 has not.
# shellcheck disable=SC2034
solver_packages=()
if [[ $release != 13 ]]; then
  solver_packages+=(calculix-ccx)
fi

# For the Python package on NumPy arrays (DIRECTIONFIELDS_BUILD_NUMPY), its test with pip, and the one with
# PyVista, which Debian 12 has not.
# shellcheck disable=SC2034
numpy_packages=(pybind11-dev python3-venv)
if [[ $release != 12 ]]; then
  numpy_packages+=(python3-pyvista)
fi

# For the checks of the sources' style; clang-format 14 has come with Debian 12 only.
# shellcheck disable=SC2034
style_packages=(shellcheck)
if [[ $release == 12 ]]; then
  style_packages+=(clang-format-14)
fi

# What is done now, after how many minutes and seconds.
say() {
  printf '== %d:%02d %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$*"
}

fail() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

require_debian() {
  case $release in
    12 | 13 | sid) return ;;
  esac
  local name=unknown
  if [[ -r /etc/os-release ]]; then
    # shellcheck disable=SC1091
    name=$(. /etc/os-release && echo "${PRETTY_NAME:-unknown}")
  fi
  cat >&2 <<EOF
${0##*/}: this command installs packages of Debian 12, 13 and sid only, but this system is $name:
install what the build needs by name and run it again with DIRECTIONFIELDS_SKIP_PACKAGES=1 in the
environment, or build with CMake as the README describes. Their names, not tried:
  Ubuntu       sudo apt install ${plugin_packages[*]} ${paraview_packages[*]} ${qt6_packages[*]}
  Fedora       sudo dnf install gcc-c++ make cmake eigen3-devel gtest-devel
               paraview-devel python3-paraview python3-numpy python3-devel vtk-devel boost-devel
               hdf5-devel jsoncpp-devel libxml2-devel protobuf-devel protobuf-compiler pugixml-devel
               fmt-devel utf8cpp-devel PEGTL-devel json-devel qt6-qtbase-devel qt6-qttools-devel
               qt6-qtsvg-devel qt6-qt5compat-devel xorg-x11-server-Xvfb xauth
  Arch         sudo pacman -S base-devel cmake eigen gtest paraview python-numpy qt6-base
               qt6-tools qt6-svg qt6-5compat xorg-server-xvfb xorg-xauth
  conda-forge  conda install -c conda-forge cxx-compiler make cmake eigen gtest
               'paraview=*=*qt' qt6-main numpy
  Homebrew     brew install cmake eigen googletest vtk
               (the filters without the plugin: its ParaView has no development files)
EOF
  exit 1
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
  local said deadline=$((SECONDS + 300))
  say "Fetching the package lists (apt-get update)"
  # DPkg::Lock::Timeout does not hold for the lock of the lists.
  until said=$(LC_ALL=C "${privileged[@]}" apt-get --quiet update 2>&1); do
    if [[ $said != *"Could not get lock"* || $SECONDS -ge $deadline ]]; then
      tail -n 30 <<<"$said" >&2
      fail "apt-get update failed; are the network and the package sources in order?"
    fi
    sleep 2
  done
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

# In Debian 13 and sid the files of ParaView's Python modules have other names than those by which the
# CMake files of paraview-dev refer to them, without which find_package(ParaView) fails.
link_python_modules() {
  local name files links=() privileged
  while read -r name; do
    files=("/usr${name%.so}".cpython-*.so)
    if [[ ! -e /usr$name && -e ${files[0]} ]]; then
      links+=("/usr$name")
    fi
  done < <(grep -rhoE '/lib/python3/dist-packages/[^"]*\.so' /usr/lib/*/cmake/paraview-* | sort -u)
  if [[ ${#links[@]} -eq 0 ]]; then
    return
  fi
  become_root "Debian's paraview-dev refers to ${#links[@]} Python modules by names that they do not have" \
    "(${links[0]} and others): links have to be made"
  say "Making links for ${#links[@]} Python modules to which Debian's paraview-dev refers by names that" \
    "they do not have: ${links[0]} and others"
  for name in "${links[@]}"; do
    files=("${name%.so}".cpython-*.so)
    "${privileged[@]}" ln -s "${files[0]##*/}" "$name"
  done
}

# become_root WHAT...: sets privileged to what makes a command run as root.
become_root() {
  privileged=()
  if [[ $EUID -ne 0 ]]; then
    command -v sudo >/dev/null || fail "$*, which takes root or sudo."
    privileged=(sudo)
  fi
}

install_packages() {
  local missing
  if [[ ${DIRECTIONFIELDS_SKIP_PACKAGES:-} == 1 ]]; then
    return
  fi
  require_debian
  mapfile -t missing < <(missing_packages "$@")
  if [[ ${#missing[@]} -gt 0 ]]; then
    install_missing
  fi
  link_python_modules
}

install_missing() {
  local removal plan count privileged
  become_root "these packages have to be installed: ${missing[*]}"
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
