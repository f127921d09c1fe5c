#!/usr/bin/env python3
"""Measures the shadow techniques' errors that the technique "auto" is calibrated by.

usage: measure-shadow-errors.py PENUMBRA_RENDER FOLDER   FOLDER: aneurism.mhd, bonsai.mhd, engine.mhd, headsq.mhd, stent.mhd
Writes ShadowErrors.inc and SteepShadowErrors.inc, which belong into Modules/Rendering.

Errors are root mean squares over a picture of 256 x 256 pixels, in grey levels of 255, against rays of
half the step. Those of a volume are divided by how much longer than their smallest its texels are.
None counts as less than that of matter that is thinner, down to a quarter of the optical depth.
"""
import array, json, math, os, subprocess, sys, tempfile

render, folder = sys.argv[1:3]
SHAPES = {"fog": [[0, 0], [1, 0.03]], "soft": [[0, 0], [0.4, 0.06], [1, 0.3]],
          "dense": [[0, 0], [0.15, 0.05], [1, 0.8]],
          "bone": [[0, 0], [0.12, 0.35], [0.4, 0.75], [1, 0.95]], "opaque": [[0, 0], [0.02, 0.9], [1, 0.98]]}
SCENES = [("engine", "fog"), ("engine", "soft"), ("engine", "dense"), ("bonsai", "dense"), ("engine", "bone"), ("engine", "opaque"), ("bonsai", "soft"),
          ("bonsai", "bone"), ("headsq", "soft"), ("headsq", "bone"), ("aneurism", "dense"), ("aneurism", "bone"),
          ("stent", "dense"), ("stent", "bone")]
PLAIN = ["shadows.resolution=1", "shadows.nearSteps=0"]
FINE = ["shadows.resolution=1", "shadows.nearSteps=4"]
COARSE = ["shadows.resolution=0.5", "shadows.nearSteps=0"]
ONE = ["shadows.resolution=1", "shadows.nearSteps=1"]
TWO = ["shadows.resolution=1", "shadows.nearSteps=2"]
FINER_PLAIN = ["shadows.resolution=1.25", "shadows.nearSteps=0"]
FINER = ["shadows.resolution=1.25", "shadows.nearSteps=3"]
FINEST = ["shadows.resolution=1.5", "shadows.nearSteps=4"]
MEDIUM = ["shadows.resolution=0.75", "shadows.nearSteps=0"]
OPTIONS = [("rays", FINE), ("volume", COARSE), ("volume", MEDIUM), ("deep-map", PLAIN), ("volume", FINE),
           ("deep-map", FINE), ("opacity-map", PLAIN), ("opacity-map", TWO), ("opacity-map", FINER), ("opacity-map", FINEST),
           ("volume", PLAIN), ("opacity-map", ONE), ("opacity-map", FINER_PLAIN), ("volume", ONE)]
COUNT = len(OPTIONS)


def run(scene, work, *settings):
    command = [render, scene, "--output", work + "/o.mha", "--report", work + "/r.json", "--save-scene", work + "/s.json"]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True, capture_output=True)
    raw = open(work + "/o.mha", "rb").read()
    values = array.array("f")
    values.frombytes(raw[raw.index(b"\n", raw.index(b"ElementDataFile")) + 1:])
    return values, json.load(open(work + "/r.json")), json.load(open(work + "/s.json"))


def rmse(picture, truth):
    squares = [((a - b) * 255) ** 2 for i, (a, b) in enumerate(zip(picture, truth)) if i % 4 < 3]
    return math.sqrt(sum(squares) / len(squares))


lines = {False: [], True: []}
for volume, shape in SCENES:
    with tempfile.TemporaryDirectory() as work:
        _, report, scene = run(os.path.join(folder, volume + ".mhd"), work, "image.size=[256,256]")
        points = scene["transferFunction"]["opacity"]
        low, high = points[0][0], points[-1][0]
        scene["transferFunction"]["opacity"] = [[low + (high - low) * x, y] for x, y in SHAPES[shape]]
        step = 2 * scene["sampleDistance"]
        scene["sampleDistance"] = step
        scene["lights"] = [{"direction": [0.55, -0.6, -0.75], "frame": "camera", "shadow": "soft"}]
        scene["volume"]["file"] = os.path.abspath(os.path.join(folder, volume + ".mhd"))
        file = work + "/scene.json"
        json.dump(scene, open(file, "w"))
        spacing = report["volume"]["spacing"]
        errors = {}
        for shadow in "soft", "hard":
            light = "lights.0.shadow=" + shadow
            truth, report, _ = run(file, work, light, "shadows.technique=rays", f"shadows.sampleDistance={step / 2}")
            found = []
            for technique, settings in OPTIONS:
                picture, _, _ = run(file, work, light, "shadows.technique=" + technique, f"shadows.sampleDistance={step}",
                                    *settings)
                resolution = float(settings[0].split("=")[1])
                ratio = max(spacing) / min(spacing)
                scale = max(ratio * resolution / 2, 1.0)
                scale = scale if technique == "volume" else 1.0
                found.append(max(rmse(picture, truth) / scale, 0.01))
            errors[shadow] = found
        depth = report["emptySpace"]["meanVoxelDepth"]
        lines[shape == "opaque"].append((depth, errors["soft"] + errors["hard"]))

HEADS = {False: """// Made by Data/study/measure-shadow-errors.py. A scene a line: the optical depth over a voxel,
// then errors of the options in their order, of a soft shadow and of a hard one.
""", True: "// Made by Data/study/measure-shadow-errors.py, see ShadowErrors.inc.\n"}
for steep, name in ((False, "ShadowErrors.inc"), (True, "SteepShadowErrors.inc")):
    with open(name, "w") as out:
        out.write(HEADS[steep])
        for depth, _ in sorted(lines[steep]):
            near = [errors for other, errors in lines[steep] if depth / 4 <= other <= depth]
            largest = [max(column) for column in zip(*near)]
            soft, hard = (", ".join(f"{error:.2f}" for error in largest[half:half + COUNT]) for half in (0, COUNT))
            out.write(f"{{ {depth:.3f}, {{ {soft} }}, {{ {hard} }} }},\n")
