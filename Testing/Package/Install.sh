#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Install.sh DIRECTORY: installs the packages in it, on a machine that has none of them.
set -e
# shellcheck source-path=SCRIPTDIR source=Dpkg.sh
. "$(dirname "$0")/Dpkg.sh"
if dpkg-query --show direction-fields >/dev/null 2>&1
then
  echo "direction-fields is installed already; remove it first." >&2
  exit 1
fi
run_dpkg --install "$1"/direction-fields_*.deb "$1"/direction-fields-dev_*.deb
for numpy in "$1"/python3-direction-fields_*.deb
do
  # There where the package for NumPy was built.
  [ ! -e "$numpy" ] || run_dpkg --install "$numpy"
done
touch "$1/installed"
