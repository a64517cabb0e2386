# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The steps of a playback, between which it runs a macro again and again."""
import os
import traceback


def take_next(steps):
    """Takes the step that is due. The verdict, with the first failure, which is the one that counts,
    is in a file with the name of the playback."""
    step = int(os.environ.get("DIRECTIONFIELDS_TEST_STEP", "0"))
    os.environ["DIRECTIONFIELDS_TEST_STEP"] = str(step + 1)
    verdict = "passed\n" if step + 1 == len(steps) else None
    try:
        steps[step]()
    except BaseException:
        verdict = traceback.format_exc()
    path = os.path.join(os.environ["DIRECTIONFIELDS_TEST_OUTPUT"],
                        os.environ["DIRECTIONFIELDS_TEST_NAME"] + ".txt")
    if verdict and not os.path.exists(path):
        with open(path, "w") as file:
            file.write(verdict)
