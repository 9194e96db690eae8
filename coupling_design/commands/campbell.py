"""`campbell CASE`: critical speeds and steady vibration."""

from __future__ import annotations

from coupling_design.commands.options import CaseFile, Overrides, Size

EXAMPLES = (
    "campbell cases/16v280.yaml",
    "campbell cases/16v280.yaml --set coupling.torsional_stiffness=0.3MN*m/rad",
    "campbell reports/16v280/chosen.yaml",
    'campbell cases/16v280_catalogue.yaml --size "DP 125"',
)


def run(case: CaseFile, size: Size = None, overrides: Overrides = None) -> int:
    """Print the Campbell diagram as tables: orders against natural frequencies.

    Critical speeds with their margins to the working range, forbidden speeds, and
    the vibratory torque in the coupling. Of the present coupling, or of a size in its
    place: for the chosen one name the chosen.yaml that a design has written.
    """
    from coupling_design.case import load_case
    from coupling_design.checks.warnings import case_warnings
    from coupling_design.explore.points import find_point
    from coupling_design.flow.speed_map import evaluate_speed_map
    from coupling_design.report.console.blocks import bullets
    from coupling_design.report.console.console import make_report_console
    from coupling_design.report.console.speeds import render_speed_map

    loaded = load_case(case, overrides or ())
    other = find_point(loaded, size=size).candidate if size else None
    warned = bullets("Read first", case_warnings(loaded))
    report = render_speed_map(loaded, evaluate_speed_map(loaded, other=other))
    console = make_report_console()
    if warned is not None:
        console.print(warned, "")
    console.print(report)
    return 0
