# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plays what a hand does in the ParaView window, event by event, and prints what each step takes:

    python3 Testing/Benchmarks/playHand.py PLUGIN MESH [--paraview paraview] [--strokes 4]

The mesh is opened and applied; strokes are drawn, the first one is made soft by a double click, the
slider of the cost of singularities is held and moved, singularities are edited and one is dragged by 40
pixels, and the field becomes quads. The mouse is that of ParaView's own playbacks, so that the window
does all that it does for a user. A row says how often a step ran, the median and the longest of its
seconds from the mouse to the picture, and the median of its processor seconds, which depend less on
what else the machine does. It needs a display."""
import argparse
import os
import statistics
import subprocess
import sys
import tempfile

VIEW = ("pqClientMainWindow/centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/"
        "MultiViewWidget1/Container/Frame.0/CentralWidgetFrame/Viewport")
PANEL = ("pqClientMainWindow/propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_viewport/"
         "scrollAreaWidgetContents/PropertiesFrame/ProxyPanel")
SLIDER = f"{PANEL}/SingularityCost/DoubleRangeWidget/Slider"

# The macro that comes before the steps; the first time it watches what the window calls.
MACRO = '''
import os
import time

from paraview.simple import *
# The modules of plugins are known once ParaView's own are.
import directionfields
from directionfields import singularities


def log(name, wall, processor):
    with open(os.environ["HAND_TIMES"], "a") as file:
        file.write(f"{name} {wall} {processor}\\n")


def watch(module, name, label):
    call = getattr(module, name)

    def timed(*arguments):
        wall, processor = time.perf_counter(), time.process_time()
        answer = call(*arguments)
        log(label, time.perf_counter() - wall, time.process_time() - processor)
        return answer
    setattr(module, name, timed)


def watch_slider():
    """A change lasts from the begin of the field to the end of its picture."""
    field, window = GetActiveSource(), GetActiveView().GetRenderWindow()
    begin = []

    def start(*_):
        begin[:] = [time.perf_counter(), time.process_time()]

    def end(*_):
        if begin:
            log("slider", time.perf_counter() - begin[0], time.process_time() - begin[1])
            del begin[:]
    field.GetClientSideObject().AddObserver("StartEvent", start)
    window.AddObserver("EndEvent", end)


def aim():
    """Puts a singularity that is seen into the middle of the view."""
    hand, view = singularities._handles.hand, GetActiveView()
    towards = [a - b for a, b in zip(view.CameraPosition, view.CameraFocalPoint)]
    seen = [row for row, is_seen in zip(hand.rows, hand.seen) if is_seen]
    place = max(seen, key=lambda row: sum(a * b for a, b in zip(row, towards)))
    shift = [a - b for a, b in zip(place, view.CameraFocalPoint)]
    view.CameraFocalPoint = [a + b for a, b in zip(view.CameraFocalPoint, shift)]
    view.CameraPosition = [a + b for a, b in zip(view.CameraPosition, shift)]
    Render(view)
    singularities.refresh()


step = int(os.environ.get("HAND_STEP", "0"))
os.environ["HAND_STEP"] = str(step + 1)
if step == 0:
    for module, name, label in (
            (directionfields, "draw_stroke", "stroke"),
            (directionfields, "toggle_stroke", "double_click"),
            (directionfields, "remesh_active", "quads"), (singularities, "begin", "edit"),
            (singularities, "press", "press"), (singularities, "drag", "drag"),
            (singularities, "drop", "drop")):
        watch(module, name, label)
elif step == 1:
    watch_slider()
elif step == 2:
    aim()
'''


def event(target, command, arguments=""):
    return f'  <pqevent object="{target}" command="{command}" arguments="{arguments}" />'


def menu(action):
    return [event("pqClientMainWindow/menubar/menuTools", "activate", action)]


def clock():
    return [event("pqClientMainWindow/menubar/menu_Macros", "activate", "HandClock")]


def mouse(command, x, y, is_down):
    button = 1 if command != "mouseMove" else 0
    return event(VIEW, command, f"({x:.4f},{y:.4f},{button},{1 if is_down else 0},0)")


def drag(places):
    (x, y), (last_x, last_y) = places[0], places[-1]
    return [mouse("mousePress", x, y, True),
            *(mouse("mouseMove", *place, True) for place in places[1:]),
            mouse("mouseRelease", last_x, last_y, False)]


def events(strokes):
    steps = [event("pqClientMainWindow/propertiesDock/propertiesPanel/Accept", "activate")]
    steps += clock() + menu("actionDrawStrokes")
    for k in range(strokes):
        y = 0.46 + 0.1 * k / max(1, strokes - 1)
        steps += drag([(0.44 + 0.012 * i, y + 0.002 * (i % 3)) for i in range(11)])
    for command in ("mousePress", "mouseRelease", "mouseDblClick", "mouseRelease"):
        steps.append(mouse(command, 0.5, 0.464, command != "mouseRelease"))
    steps += menu("actionDrawStrokes") + clock()
    steps += [event(SLIDER, "set_int", "0"), event(SLIDER, "mousePress", "1,1,0,6,8")]
    steps += [event(SLIDER, "mouseMove", f"1,1,0,{x},8") for x in range(20, 100, 10)]
    steps += [event(SLIDER, "mouseRelease", "1,0,0,90,8")]
    steps += menu("actionEditSingularitiesByHand") + clock()
    steps += drag([(0.5 + 0.005 * i, 0.5) for i in range(11)])
    steps += menu("actionEditSingularitiesByHand") + menu("actionRemeshToQuads")
    return steps


def play(options, directory):
    macros = os.path.join(directory, ".config", "ParaView", "Macros")
    os.makedirs(macros)
    with open(os.path.join(macros, "HandClock.py"), "w", encoding="ascii") as file:
        file.write(MACRO)
    playback, times = (os.path.join(directory, name) for name in ("hand.xml", "times"))
    with open(playback, "w", encoding="ascii") as file:
        file.write("\n".join(['<?xml version="1.0" ?>', "<pqevents>", *events(options.strokes),
                              "</pqevents>", ""]))
    environment = dict(os.environ, HOME=directory, HAND_TIMES=times,
                       XDG_CONFIG_HOME=os.path.join(directory, ".config"),
                       PV_MACRO_PATH=macros, PARAVIEW_LOG_EXECUTION_VERBOSITY="OFF")
    done = subprocess.run(
        [options.paraview, "--dr", f"--plugin-search-paths={os.path.dirname(options.plugin)}",
         "--plugins=DirectionFields", f"--test-directory={directory}", f"--data={options.mesh}",
         f"--test-script={playback}", "--exit"],
        env=environment, capture_output=True, text=True, check=False)
    if not os.path.exists(times):
        sys.exit(f"The window did not play the events.\n{done.stdout}\n{done.stderr}")
    with open(times, encoding="ascii") as file:
        return done.returncode, [line.split() for line in file]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("plugin")
    parser.add_argument("mesh")
    parser.add_argument("--paraview", default="paraview")
    parser.add_argument("--strokes", type=int, default=4)
    options = parser.parse_args()
    options.plugin, options.mesh = map(os.path.abspath, (options.plugin, options.mesh))
    with tempfile.TemporaryDirectory() as directory:
        code, rows = play(options, directory)
    times = {}
    for name, wall, processor in rows:
        # The first stroke makes the pipeline.
        name = "first stroke" if name == "stroke" and "first stroke" not in times else name
        times.setdefault(name.replace("_", " "), []).append((float(wall), float(processor)))
    print(f"{'step':>14} {'times':>6} {'median':>8} {'longest':>8} {'processor':>10}   seconds")
    for name, values in times.items():
        walls, processors = zip(*values)
        print(f"{name:>14} {len(values):6} {statistics.median(walls):8.3f} {max(walls):8.3f} "
              f"{statistics.median(processors):10.3f}")
    wanted = ("first stroke", "stroke", "double click", "slider", "drag", "quads")
    missing = [name for name in wanted if name not in times]
    if code or missing:
        sys.exit(f"The playback ended with {code}; missing: {', '.join(missing) or 'nothing'}.")


if __name__ == "__main__":
    main()
