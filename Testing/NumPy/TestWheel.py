# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Installs the sources with pip, without a network, and uses them: TestWheel.py SOURCES LIBRARIES FOLDER

The libraries are those of another build, so that they are not compiled again."""

import os
import pathlib
import shutil
import subprocess
import sys

sources, libraries, folder = sys.argv[1:]
shutil.rmtree(folder, ignore_errors=True)
subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", folder], check=True)
python = os.path.join(folder, "bin", "python")
environment = {**os.environ, "CMAKE_ARGS": f"-DDIRECTIONFIELDS_LIBRARIES_OF={libraries}"}
subprocess.run(
    [python, "-m", "pip", "--disable-pip-version-check", "install", "--no-index", "--no-deps", sources],
    check=True, env=environment)
subprocess.run(
    [python, "-I", str(pathlib.Path(__file__).with_name("UsePackage.py")), folder], check=True)
