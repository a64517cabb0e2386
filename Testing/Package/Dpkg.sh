# shellcheck shell=sh
# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_dpkg ARGUMENT...: dpkg, which gives up at once where another process, an unattended upgrade say, holds
# its lock; this waits for up to five minutes.
run_dpkg() {
  seconds=0
  until said=$(LC_ALL=C dpkg "$@" 2>&1)
  do
    case $said in
      *"lock was locked by another process"*) ;;
      *) seconds=300 ;;
    esac
    if [ "$seconds" -ge 300 ]
    then
      echo "$said" >&2
      return 1
    fi
    sleep 2
    seconds=$((seconds + 2))
  done
  echo "$said"
}
