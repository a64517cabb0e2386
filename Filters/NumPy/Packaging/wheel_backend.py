# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds wheels of direction_fields with CMake, for pip and other frontends (PEP 517), from nothing
but the standard library. CMAKE_ARGS in the environment are further options of CMake."""

import base64
import hashlib
import os
import pathlib
import re
import shlex
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]


def _version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"VERSION (\d+\.\d+\.\d+)", text).group(1)


def _install(tree, build):
    """What the wheel consists of, below a folder."""
    cmake = os.environ.get("CMAKE", "cmake")
    subprocess.run(
        [cmake, "-S", str(ROOT), "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF",
         "-DDIRECTIONFIELDS_BUILD_VTK=OFF", "-DDIRECTIONFIELDS_BUILD_NUMPY=ON",
         "-DDIRECTIONFIELDS_NUMPY_SITE=.", f"-DPython3_EXECUTABLE={sys.executable}",
         *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
    subprocess.run([cmake, "--build", build, "--parallel", "--target", "DirectionFieldsNumPy"], check=True)
    subprocess.run(
        [cmake, "--install", build, "--component", "numpy", "--prefix", tree, "--strip"], check=True)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    version = _version()
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    name = f"direction_fields-{version}-{tag}.whl"
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder, "tree")
        _install(str(tree), str(pathlib.Path(folder, "build")))
        info = tree / f"direction_fields-{version}.dist-info"
        (info / "WHEEL").write_text(
            f"Wheel-Version: 1.0\nGenerator: direction_fields\nRoot-Is-Purelib: false\nTag: {tag}\n",
            encoding="utf-8")
        record = []
        with zipfile.ZipFile(pathlib.Path(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
            for path in sorted(p for p in tree.glob("direction_fields*/*") if p.is_file()):
                place, data = path.relative_to(tree).as_posix(), path.read_bytes()
                digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
                record.append(f"{place},sha256={digest},{len(data)}\n")
                wheel.write(path, place)
            place = f"{info.name}/RECORD"
            wheel.writestr(place, "".join(record) + f"{place},,\n")
    return name


def build_sdist(sdist_directory, config_settings=None):
    name = f"direction_fields-{_version()}"
    subprocess.run(
        ["git", "-C", str(ROOT), "archive", "--format=tar.gz", f"--prefix={name}/", "-o",
         os.path.abspath(os.path.join(sdist_directory, f"{name}.tar.gz")), "HEAD"], check=True)
    return f"{name}.tar.gz"
