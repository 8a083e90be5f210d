"""Checks which folder includes which: libraries and their rooms, and where foreign headers stop.

With `--self-test` it checks that it finds each kind of fault in a small tree that has one of each.
"""

import pathlib
import re
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

# A library may include itself and those after it.
LIBRARIES = ("app", "engine", "hydro")

# The floors of a library, the lowest first. A room may include the rooms of lower floors only.
FLOORS = {
    "app": (
        ("base", "render"),
        ("scene",),
        ("databases", "logs"),
        ("assembly",),
        ("analysis", "held", "pages", "pictures"),
        ("hydrostatics", "report", "run", "view"),
        ("commands", "compare", "export", "fmu", "sweep"),
        ("cli", "python"),
    ),
    "engine": (
        ("base",),
        ("machines",),
        ("motion",),
        ("hollows", "contacts"),
        ("constraints",),
        ("record", "rig"),
        ("step",),
    ),
}
MOST_FLOORS = 8

# Files that lie in no room, above all of them.
DOORS = ("engine/simulation", "engine/simulation_state", "engine/state_data")

# Foreign headers and the files that may include them.
FOREIGN = {
    r"ode/": ("ODE", r"engine/contacts/\w+\.cpp"),
    r"(EGL|GL|GLFW)/": ("EGL and OpenGL", r"app/(render|view)/\w+\.(h|cpp)"),
    r"(un)?zip\.h": ("minizip", r"app/fmu/zip_archive\.cpp"),
    r"j(peglib|error)\.h": ("libjpeg", r"app/render/jpeg\.cpp"),
    r"muParser": ("muparser", r"app/scene/formula\.cpp"),
    r"pybind11/": ("pybind11", r"app/python/\w+\.(h|cpp)"),
    r"yaml-cpp/": ("yaml-cpp", r"app/scene/\w+\.(h|cpp)"),
}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)


def includes_of(root):
    """The files of the libraries, and what each includes."""
    files = {}
    for library in LIBRARIES:
        for path in sorted((root / library).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                name = path.relative_to(root).as_posix()
                files[name] = INCLUDE.findall(path.read_text())
    return files


def library_of(name):
    return name.split("/")[0]


def component_of(name):
    """A header and the source of its name are one component."""
    return name.rsplit(".", 1)[0]


def room_of(name, rooms):
    """The innermost room that a file lies in; none of a file that lies in no room."""
    folders = name.split("/")[1:-1]
    for depth in range(len(folders), 0, -1):
        if "/".join(folders[:depth]) in rooms:
            return "/".join(folders[:depth])
    return None


def library_faults(files):
    for name, included in files.items():
        allowed = LIBRARIES[LIBRARIES.index(name.split("/")[0]):]
        for header in included:
            library = header.split("/")[0]
            if library in (*LIBRARIES, "tests") and library not in allowed:
                yield f"{name} includes {header}: {name.split('/')[0]}/ lies below {library}/"


def room_faults(files, library, floors):
    floor_of = {room: floor for floor, rooms in enumerate(floors) for room in rooms}
    if len(floors) > MOST_FLOORS:
        yield f"{library}/ has {len(floors)} floors, expected at most {MOST_FLOORS}"
    for name, included in files.items():
        if library_of(name) != library or component_of(name) in DOORS:
            continue
        room = room_of(name, floor_of)
        if room is None:
            yield f"{name} is in no room that has a floor"
            continue
        for header in included:
            if library_of(header) != library:
                continue
            if component_of(header) in DOORS:
                yield f"{name} includes {header}: {room} does not lie above the door"
            other = room_of(header, floor_of)
            if other and other != room and floor_of[other] >= floor_of[room]:
                yield f"{name} includes {header}: {room} does not lie above {other}"


def foreign_faults(files):
    for name, included in files.items():
        for header in included:
            for pattern, (library, allowed) in FOREIGN.items():
                if re.match(pattern, header) and not re.fullmatch(allowed, name):
                    yield f"{name} includes {header}: {library} is for {allowed} only"


def circle_faults(files):
    """Circles among the components of app/."""
    graph = {}
    for name, included in files.items():
        if not name.startswith("app/"):
            continue
        component = component_of(name)
        others = {component_of(header) for header in included if header.startswith("app/")}
        graph.setdefault(component, set()).update(others - {component})
    state = {}

    def visit(component, path):
        state[component] = "open"
        for other in sorted(graph.get(component, ())):
            if state.get(other) == "open":
                yield "circle: " + " -> ".join([*path[path.index(other):], other])
            elif other not in state:
                yield from visit(other, [*path, other])
        state[component] = "done"

    for component in sorted(graph):
        if component not in state:
            yield from visit(component, [component])


def faults_in(root):
    files = includes_of(root)
    yield from library_faults(files)
    for library, floors in FLOORS.items():
        yield from room_faults(files, library, floors)
    yield from foreign_faults(files)
    yield from circle_faults(files)


WRONG_TREE = {
    "hydro/water.h": '#include "engine/motion/body.h"\n',
    "engine/motion/body.h": "#include <ode/ode.h>\n",
    "engine/motion/body.cpp": '#include "engine/hollows/flooding.h"\n',
    "engine/contacts/world.cpp": '#include <ode/ode.h>\n#include "engine/hollows/flooding.h"\n',
    "engine/rig/rig.h": '#include "engine/simulation.h"\n',
    "engine/record/loads.cpp": '#include "engine/rig/rig.h"\n',
    "engine/simulation.h": '#include "engine/step/stepper.h"\n',
    "engine/loose.h": "",
    "app/base/words.h": '#include "app/scene/scene.h"\n',
    "app/scene/scene.h": '#include "app/scene/parts.h"\n#include "engine/motion/body.h"\n',
    "app/scene/parts.cpp": '#include "app/scene/scene.h"\n#include <yaml-cpp/yaml.h>\n',
    "app/run/run.cpp": '#include "app/view/view.h"\n#include <yaml-cpp/yaml.h>\n',
    "app/view/window.cpp": "#include <GL/gl.h>\n",
    "app/attic/old.h": "#include <GL/gl.h>\n",
}
EXPECTED = (
    "hydro/water.h includes engine/motion/body.h: hydro/ lies below engine/",
    "engine/motion/body.cpp includes engine/hollows/flooding.h: motion does not lie above hollows",
    "engine/contacts/world.cpp includes engine/hollows/flooding.h: "
    "contacts does not lie above hollows",
    "engine/record/loads.cpp includes engine/rig/rig.h: record does not lie above rig",
    "engine/rig/rig.h includes engine/simulation.h: rig does not lie above the door",
    "engine/loose.h is in no room that has a floor",
    "app/base/words.h includes app/scene/scene.h: base does not lie above scene",
    "app/run/run.cpp includes app/view/view.h: run does not lie above view",
    "app/attic/old.h is in no room that has a floor",
    r"engine/motion/body.h includes ode/ode.h: ODE is for engine/contacts/\w+\.cpp only",
    r"app/attic/old.h includes GL/gl.h: EGL and OpenGL is for app/(render|view)/\w+\.(h|cpp) only",
    r"app/run/run.cpp includes yaml-cpp/yaml.h: yaml-cpp is for app/scene/\w+\.(h|cpp) only",
    "circle: app/scene/scene -> app/scene/parts -> app/scene/scene",
)


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in WRONG_TREE.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        found = set(faults_in(root))
    nine = [(f"room{i}",) for i in range(MOST_FLOORS + 1)]
    found.update(room_faults({}, "app", nine))
    expected = {*EXPECTED, f"app/ has {MOST_FLOORS + 1} floors, expected at most {MOST_FLOORS}"}
    return [f"not found: {fault}" for fault in sorted(expected - found)] + [
        f"found in vain: {fault}" for fault in sorted(found - expected)]


def main():
    faults = self_test() if "--self-test" in sys.argv else list(faults_in(ROOT))
    print("\n".join(faults) or "every include goes downwards")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
