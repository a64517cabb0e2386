#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Remove.sh DIRECTORY: removes what Install.sh has installed, and looks for remains.
set -e
# shellcheck source-path=SCRIPTDIR source=Dpkg.sh
. "$(dirname "$0")/Dpkg.sh"
rm "$1/installed"
run_dpkg --purge direction-fields-dev direction-fields
if dpkg-query --show python3-direction-fields >/dev/null 2>&1
then
  run_dpkg --purge python3-direction-fields
fi
for remains in /usr/lib/*/paraview-*/plugins/*irection*ields* \
  /usr/share/paraview/plugins/*irection*ields* /usr/lib/*/libvtkDirectionFields* \
  /usr/lib/*/libDirectionFields* /usr/lib/*/cmake/DirectionFields /usr/include/DirectionFields* \
  /usr/lib/python3/dist-packages/direction*fields* /usr/share/doc/direction-fields*
do
  if [ -e "$remains" ] || [ -L "$remains" ]
  then
    echo "$remains remains." >&2
    exit 1
  fi
done
! grep --no-messages direction-fields /usr/bin/paraview.conf
