# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the hand waits for in ParaView, step by step:

    pvpython Testing/Benchmarks/handTimes.py PLUGIN [--triangles 100000] [--strokes 8]
        [--most SECONDS]

A bumpy torus is shown, strokes are drawn on it as the mouse draws them, the last one is taken away,
the slider of the cost of singularities is dragged, and the mesh becomes quads. Each step ends when
its picture is there, and its seconds are printed, with those of the filters that it ran; needs a
display. With --most the program fails where the median of the strokes after the first one is longer."""
import argparse
import statistics
import sys
import time

from paraview import simple

from dragging import bumpy_torus

SIZE = [800, 600]


def run_filters(step):
    """Calls a step; returns its seconds, and those of each filter of the plugin that it ran."""
    runs = {}

    def watch(name, proxy):
        filter, begin = proxy.GetClientSideObject(), [0.0]

        def start(*_):
            begin[0] = time.perf_counter()

        def end(*_):
            runs[name] = runs.get(name, 0.0) + time.perf_counter() - begin[0]
        return filter, [filter.AddObserver("StartEvent", start), filter.AddObserver("EndEvent", end)]
    watched = [watch(name, proxy) for (name, _), proxy in simple.GetSources().items()
               if proxy.GetClientSideObject()]
    begin = time.perf_counter()
    done = step()
    if done is None or done is False:
        sys.exit("A step did nothing.")
    took = time.perf_counter() - begin
    for filter, observers in watched:
        for observer in observers:
            filter.RemoveObserver(observer)
    return took, runs


def report(name, step):
    took, runs = run_filters(step)
    parts = ", ".join(f"{filter} {1e3 * part:.0f}" for filter, part in runs.items() if part > 5e-4)
    print(f"{name:>22} {1e3 * took:8.0f}   {parts}", flush=True)
    return took


def stroke(k):
    """Each at another height, and not straight."""
    y = SIZE[1] / 2 - 150 + 36 * k
    return [(SIZE[0] / 2 - 120 + 24 * i, y + 3.0 * (i % 3)) for i in range(11)]


def drag(view):
    """A part of a slider's way."""
    field = simple.GetActiveSource()
    for cost in (0.1, 0.2, 0.3):
        def step(cost=cost):
            field.SingularityCost = cost
            simple.Render(view)
            return True
        report("slider", step)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("plugin")
    parser.add_argument("--triangles", type=int, default=100000)
    parser.add_argument("--strokes", type=int, default=8)
    parser.add_argument("--most", type=float, help="seconds")
    options = parser.parse_args()
    simple.LoadPlugin(options.plugin, remote=False, ns=globals())
    import directionfields

    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    mesh = simple.TrivialProducer(registrationName="torus")
    mesh.GetClientSideObject().SetOutput(bumpy_torus(options.triangles))
    simple.Show(mesh, view)
    simple.ResetCamera(view)
    simple.SetActiveSource(mesh)
    simple.Render(view)
    print(f"{options.triangles} triangles, milliseconds")
    times = [report("first stroke" if k == 0 else "stroke",
                    lambda k=k: directionfields.draw_stroke(stroke(k)))
             for k in range(options.strokes)]
    end = stroke(options.strokes - 1)[5]
    report("stroke taken away", lambda: directionfields.remove_stroke(end))
    drag(view)
    report("quads", directionfields.remesh_active)
    further = statistics.median(times[1:]) if times[1:] else 0.0
    print(f"A further stroke took {further:.3f} s.")
    if options.most is not None and further > options.most:
        sys.exit(f"That is more than {options.most} s.")


main()
