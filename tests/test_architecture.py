"""The arrows of ARCHITECTURE.md and the budget of CONTRIBUTING.md, read off the source.

Imports count wherever they stand: at the top, in a function, under TYPE_CHECKING.
"""

import ast
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import coupling_design

PACKAGE = "coupling_design"
ROOT = Path(coupling_design.__file__).parent

LEAVES = {"errors", "arithmetic"}
LINE = LEAVES | {"signals", "march", "line", "events", "parts"}
MACHINE = LINE | {"machine", "speeds"}
WEAR = MACHINE | {"lanes", "wear", "checks"}
MAY_IMPORT = {
    "": set(),
    "errors": set(),
    "arithmetic": {"errors"},
    "signals": LEAVES,
    "lanes": LEAVES,
    "march": LEAVES | {"lanes"},
    "line": LEAVES,
    "engine": LEAVES,
    "parts": LEAVES,
    "events": LEAVES | {"signals", "march", "line"},
    "speeds": LEAVES | {"line"},
    "machine": LEAVES | {"line", "parts"},
    "case": LEAVES | {"line", "parts", "engine", "machine"},
    "wear": LINE | {"machine", "lanes"},
    "checks": MACHINE | {"wear"},
    "search": WEAR,
    "steps": WEAR | {"search"},
    "flow": WEAR | {"search", "steps"},
    "explore": WEAR | {"steps", "flow", "case"},
    "report": WEAR | {"search", "steps", "flow", "case"},
    "api": WEAR | {"search", "steps", "flow", "case", "explore", "report"},
    "commands": WEAR | {"search", "steps", "flow", "case", "explore", "report"},
    "__main__": {"commands"},
}
KNOWS_CASE = {"coupling_design.report.files"}  # of the report's rooms
ONLY_IN = {
    "rich": {"report", "commands"},
    "typer": {"commands"},
    "jinja2": {"report"},
    "markupsafe": {"report"},
    "plotly": set(),  # looked into for its script, never imported
    "scipy": set(),  # takes 0.3 s to import
    "yaml": {"case"},
    "pydantic": {"case"},
    "pydantic_core": {"case"},
    "pint": {"case"},
    "casadi": {"arithmetic", "case", "search", "steps", "flow"} | WEAR,
}
LINES_PER_MODULE = 250
LINES_PER_FUNCTION = 40


def modules(root):
    """Return the syntax tree of each module of a package by its dotted name."""
    trees = {}
    for path in sorted(root.rglob("*.py")):
        parts = path.relative_to(root).with_suffix("").parts
        name = ".".join((PACKAGE, *parts)).removesuffix(".__init__")
        trees[name] = ast.parse(path.read_text(encoding="utf-8"), filename=str(path))
    return trees


def packages(root):
    return {
        ".".join((PACKAGE, *path.parent.relative_to(root).parts))
        for path in root.rglob("__init__.py")
    }


def imported(name, tree, known, package_names):
    """Yield the dotted name of everything a module imports."""
    parent = name if name in package_names else name.rpartition(".")[0]
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            ancestors = parent.split(".")
            base = ancestors[: len(ancestors) + 1 - node.level] if node.level else []
            source = ".".join([*base, *filter(None, [node.module])])
            members = (f"{source}.{alias.name}" for alias in node.names)
            yield from (member if member in known else source for member in members)


def graph(root):
    """Return which modules of the package, and which libraries, each module imports."""
    trees = modules(root)
    names = packages(root)
    return {
        name: set(imported(name, tree, set(trees), names))
        for name, tree in trees.items()
    }


def layer(name):
    """Return the part directly under the package: `driveline` for its dynamics."""
    return name.removeprefix(PACKAGE).lstrip(".").partition(".")[0]


def is_ours(name):
    return name.split(".")[0] == PACKAGE


def wrong_arrows(root):
    """Return each import between our own parts that no arrow allows."""
    return sorted(
        f"{name} imports {target}"
        for name, targets in graph(root).items()
        for target in filter(is_ours, targets)
        if layer(target) not in {"", layer(name)} | MAY_IMPORT.get(layer(name), set())
    )


def wrong_libraries(root):
    """Return each import of a library outside the parts it belongs to."""
    return sorted(
        f"{name} imports {target}"
        for name, targets in graph(root).items()
        for target in targets
        if layer(name) not in ONLY_IN.get(target.split(".")[0], {layer(name)})
    )


def unknown_parts(root):
    """Return each part of the package of which MAY_IMPORT says nothing."""
    return sorted({layer(name) for name in modules(root)} - set(MAY_IMPORT))


def cycle(root):
    """Return the modules of one import cycle, or nothing."""
    try:
        TopologicalSorter(graph(root)).prepare()
    except CycleError as error:
        return error.args[1]
    return []


def forbidden_statements(root):
    """Return each call of print and each assert statement."""
    found = []
    for name, tree in modules(root).items():
        for node in ast.walk(tree):
            if isinstance(node, ast.Assert):
                found.append(f"{name}:{node.lineno} assert")
            if isinstance(node, ast.Name) and node.id == "print":
                found.append(f"{name}:{node.lineno} print")
    return found


def long_modules(root):
    lengths = {
        str(path.relative_to(root)): len(path.read_text(encoding="utf-8").splitlines())
        for path in root.rglob("*.py")
    }
    return {path: n for path, n in lengths.items() if n > LINES_PER_MODULE}


def code_lines(function):
    """Return a function's length from `def` to its end, docstring not counted."""
    total = function.end_lineno - function.lineno + 1
    if ast.get_docstring(function) is None:
        return total
    return total - (function.body[0].end_lineno - function.body[0].lineno + 1)


def long_functions(root):
    return {
        f"{name}:{node.name}": code_lines(node)
        for name, tree in modules(root).items()
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef)
        if code_lines(node) > LINES_PER_FUNCTION
    }


def invented_entries(root):
    """Return what a package's docstring calls as its entry and does not define."""
    found = []
    trees = modules(root)
    for package in packages(root):
        text = ast.get_docstring(trees[package]) or ""
        defined = {
            node.name
            for name, tree in trees.items()
            if name.startswith(package)
            for node in ast.walk(tree)
            if isinstance(node, ast.FunctionDef | ast.ClassDef)
        }
        found += [f"{package}: {name}" for name in called(text) if name not in defined]
    return sorted(found)


def called(text):
    """Return the names of the functions that the example lines of a docstring call."""
    lines = [line[4:] for line in text.splitlines() if line.startswith(">>> ")]
    return {
        node.func.id
        for line in lines
        for node in ast.walk(ast.parse(line))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    }


def test_every_room_says_its_entry():
    trees = modules(ROOT)
    silent = {
        package
        for package in packages(ROOT)
        if ">>> " not in (ast.get_docstring(trees[package]) or "")
    }
    # The whole program, whose entry is the command, and a folder of packages alone.
    assert silent == {PACKAGE, f"{PACKAGE}.parts"}
    assert invented_entries(ROOT) == []


def test_arrows_point_one_way():
    assert wrong_arrows(ROOT) == []


def test_every_part_has_its_arrows():
    assert unknown_parts(ROOT) == []


def test_libraries_stay_where_they_belong():
    assert wrong_libraries(ROOT) == []


def rooms(root):
    """Return which folders each folder imports from; a module at the top is its own."""
    names = packages(root)
    found = {}
    for name, targets in graph(root).items():
        source = room(name, names)
        found.setdefault(source, set()).update(
            room(target, names) for target in filter(is_ours, targets)
        )
    return {source: targets - {source, PACKAGE} for source, targets in found.items()}


def room(name, names):
    """Return the folder of a module, or the module itself at the top."""
    parent = name.rpartition(".")[0]
    return name if name in names or parent == PACKAGE else parent


def test_no_cycle_between_folders():
    found = rooms(ROOT)
    assert list(TopologicalSorter(found).static_order())


def test_only_one_room_of_the_report_knows_case_files():
    knowing = {
        source
        for source, targets in rooms(ROOT).items()
        if source.startswith(f"{PACKAGE}.report")
        if any(layer(target) == "case" for target in targets)
    }
    assert knowing == KNOWS_CASE


def test_no_import_cycle():
    assert cycle(ROOT) == []


def test_no_print_and_no_assert():
    assert forbidden_statements(ROOT) == []


def test_budget_of_modules():
    assert long_modules(ROOT) == {}


def test_budget_of_functions():
    assert long_functions(ROOT) == {}


@pytest.fixture
def plant(tmp_path):
    """Return a writer of modules into a small sound package."""

    def write(path, text):
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
        return tmp_path

    for path in ("", "line/", "parts/", "parts/bearing/", "steps/", "report/"):
        write(f"{path}__init__.py", "")
    write("errors.py", "")
    write("line/modes.py", "import casadi\nfrom ..errors import Error\n")
    write("parts/bearing/life.py", "from coupling_design import __version__, errors\n")
    write("flow/design.py", "from coupling_design.line import modes\n")
    return write


def test_a_sound_package_passes(plant):
    root = plant("report/panels.py", "import rich\nfrom coupling_design import steps")
    checks = (wrong_arrows, wrong_libraries, unknown_parts, cycle, forbidden_statements)
    assert [check(root) for check in checks] == [[]] * len(checks)


@pytest.mark.parametrize(
    "statement",
    [
        "import coupling_design.steps.key_gap",
        "from coupling_design.steps import flow",
        "from coupling_design.steps.key_gap import find_gap",
        "from ...steps import flow",
        "def late():\n    from coupling_design.steps import flow",
        "if TYPE_CHECKING:\n    from coupling_design.steps import flow",
    ],
)
def test_a_wrong_arrow_is_found(plant, statement):
    root = plant("parts/bearing/damage.py", statement)
    [found] = wrong_arrows(root)
    assert found.startswith(
        "coupling_design.parts.bearing.damage imports coupling_design.steps"
    )


def test_strangers_stay_strangers(plant):
    root = plant("parts/bearing/damage.py", "from coupling_design import line")
    assert wrong_arrows(root) == [
        "coupling_design.parts.bearing.damage imports coupling_design.line"
    ]


@pytest.mark.parametrize(
    ("path", "library"),
    [
        ("flow/design.py", "rich"),
        ("flow/design.py", "pint"),
        ("line/modes.py", "yaml"),
        ("errors.py", "pydantic"),
        ("report/panels.py", "casadi"),
    ],
)
def test_a_misplaced_library_is_found(plant, path, library):
    root = plant(path, f"def late():\n    from {library}.part import thing")
    assert [found.split()[-1] for found in wrong_libraries(root)] == [f"{library}.part"]


def test_a_cycle_is_found(plant):
    root = plant("line/modes.py", "from coupling_design.line import rollout")
    plant("line/rollout.py", "def late():\n    from . import modes")
    assert set(cycle(root)) == {
        "coupling_design.line.modes",
        "coupling_design.line.rollout",
    }


def test_an_invented_entry_is_found(plant):
    root = plant("line/__init__.py", '"""Say.\n\n>>> natural(line)\n"""')
    assert invented_entries(root) == ["coupling_design.line: natural"]


def test_an_unknown_part_is_found(plant):
    assert unknown_parts(plant("utils.py", "")) == ["utils"]


def test_print_and_assert_are_found(plant):
    root = plant("errors.py", "assert True\nprint('x')")
    assert forbidden_statements(root) == [
        "coupling_design.errors:1 assert",
        "coupling_design.errors:2 print",
    ]


def test_excess_length_is_found(plant):
    body = "    x = 1\n" * LINES_PER_FUNCTION
    root = plant("errors.py", f'def f():\n    """Say."""\n{body}' + "\n" * 250)
    assert list(long_modules(root)) == ["errors.py"]
    assert long_functions(root) == {"coupling_design.errors:f": LINES_PER_FUNCTION + 1}
