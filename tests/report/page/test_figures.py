import base64
import math
from dataclasses import replace

import numpy as np
import pytest

from coupling_design.report.page.comparison_figure import comparison_figure
from coupling_design.report.page.figure import logarithmic, packed
from coupling_design.report.page.plane_figures import plane_figure
from coupling_design.report.page.run_down_figures import run_down_figures
from coupling_design.report.page.speed_figures import speed_figures


def unpacked(values):
    if isinstance(values, dict):
        flat = np.frombuffer(base64.b64decode(values["bdata"]), dtype="<f4")
        shape = values.get("shape", str(flat.size))
        return flat.reshape([int(length) for length in shape.split(",")])
    return np.array(values)


def by_key(outcome):
    return {figure.key: figure for figure in run_down_figures(outcome)}


def lines(figure, axis="y"):
    """Return the curves of one row, limits left out."""
    return [t for t in figure.traces if t["yaxis"] == axis and t["mode"] == "lines"]


def test_all_figures_over_time_are_there(drawn):
    assert list(by_key(drawn)) == [
        "speed",
        "transmission-force",
        "collision-force",
        "loads",
        "life",
        "damage",
    ]


def test_without_histories_there_are_none(outcome):
    assert run_down_figures(outcome) == ()


def test_the_largest_force_drawn_is_the_largest_there_is(drawn):
    figure = by_key(drawn)["transmission-force"]
    for axis, rundown in zip(("y", "y2"), drawn.histories, strict=True):
        [curve] = lines(figure, axis)
        force = rundown.driveline.transmission_force / 1e3
        shown = unpacked(curve["y"])
        assert shown.min() == np.float32(force.min())
        assert shown.max() == np.float32(force.max())


def test_a_peak_is_drawn_at_its_own_time(drawn):
    [curve] = lines(by_key(drawn)["transmission-force"])
    time = drawn.histories[0].driveline.time[7777]
    assert unpacked(curve["x"])[unpacked(curve["y"]).argmin()] == np.float32(time)


def test_every_figure_over_time_says_how_it_was_thinned(drawn):
    for figure in run_down_figures(drawn):
        assert "the smallest and the largest of the 20000 samples" in figure.note
        assert figure.closer == pytest.approx((8.4, 9.6))


def test_damage_ends_at_the_last_value(drawn):
    [present, chosen] = lines(by_key(drawn)["damage"])
    for curve, rundown in zip((present, chosen), drawn.histories, strict=True):
        end = np.float32(rundown.bearings[0].damage[-1])
        assert unpacked(curve["y"])[-1] == end


def test_loads_are_held_against_f_min_inside_the_frame(drawn):
    figure = by_key(drawn)["loads"]
    limits = [t for t in figure.traces if t["mode"] == "lines+text"]
    assert [t["y"] for t in limits] == [[48.8, 48.8]] * 2
    for limit in limits:
        name = "yaxis" + limit["yaxis"].removeprefix("y")
        low, high = figure.layout[name]["range"]
        assert low < 48.8 < high


def test_life_has_a_row_for_each_index(drawn):
    figure = by_key(drawn)["life"]
    titles = [v["title"]["text"] for k, v in figure.layout.items() if "yaxis" in k]
    assert titles == [
        "kappa [-]",
        "e<sub>C</sub> [-]",
        "a<sub>ISO</sub> [-]",
        "L<sub>10</sub> [rev]",
        "L<sub>p</sub> [rev]",
    ]


def test_a_plane_shows_every_value_of_its_map(drawn):
    [map_] = drawn.steps[2].maps
    figure = plane_figure(drawn, map_, "plane")
    damage, force = (t for t in figure.traces if t["type"] == "heatmap")
    assert np.allclose(unpacked(damage["z"]), map_.damage, rtol=1e-6, atol=0)
    peaks = np.array(map_.peak_transmission_force) / 1e3
    assert np.allclose(unpacked(force["z"]), peaks, rtol=1e-6)


def test_a_plane_marks_the_present_and_the_optimum(drawn):
    [map_] = drawn.steps[2].maps
    own = replace(
        drawn.steps[2].optimum, coupling_type="steel-spring", connection="key"
    )
    steps = (*drawn.steps[:2], replace(drawn.steps[2], optimum=own), *drawn.steps[3:])
    figure = plane_figure(replace(drawn, steps=steps), map_, "plane")
    points = {t["name"]: (t["x"], t["y"]) for t in figure.traces if "symbol" in str(t)}
    assert points["present"] == ([pytest.approx(0.541)], [pytest.approx(0.28)])
    assert points["optimum"] == ([pytest.approx(0.541)], [pytest.approx(0.05)])


def test_a_plane_draws_where_the_force_meets_its_limits(drawn):
    [map_] = drawn.steps[2].maps
    borders = [
        t for t in plane_figure(drawn, map_, "p").traces if t["type"] == "contour"
    ]
    levels = [border["contours"]["start"] for border in borders]
    assert levels == pytest.approx([36.12018, 28.89614])


def test_a_plane_with_one_gap_is_a_line_with_the_chosen_point(drawn):
    figure = plane_figure(drawn, drawn.chosen_map, "plane")
    assert {t["type"] for t in figure.traces} == {"scatter"}
    chosen = [t for t in figure.traces if t.get("name") == "chosen"]
    assert [t["x"] for t in chosen] == [[pytest.approx(192.8)]] * 2


def test_the_stiffnesses_that_no_limit_leaves_are_grey(drawn):
    figure = plane_figure(drawn, drawn.chosen_map, "plane")
    areas = [(s["x0"], s["x1"]) for s in figure.layout["shapes"]]
    assert areas == [pytest.approx((100.0, 190.0))] * 2


def test_comparison_has_damage_and_peaks(drawn, drawn_without_design):
    for outcome, role in ((drawn, "chosen"), (drawn_without_design, "nearest")):
        figure = comparison_figure(outcome)
        assert len(figure.traces) == 5
        assert all(trace["x"] == ["present", role] for trace in figure.traces)
    assert comparison_figure(replace(drawn_without_design, nearest=None)) is None


def test_a_bar_shows_no_more_digits_than_stand(drawn):
    # The present damage, 4.0512345e-9, stands to 2 digits, the chosen one to 4.
    first = comparison_figure(drawn).traces[0]
    assert first["text"] == ["4.1·10<sup>−9</sup>", "2.562·10<sup>−9</sup>"]


def test_campbell_tells_a_critical_speed_too_near_by_its_shape(speed_map):
    campbell, vibration = speed_figures(speed_map)
    present = speed_map.present
    [marks, *_] = [t for t in campbell.traces if t["mode"] == "markers"]
    shapes = ["circle" if c.passes else "x" for c in present.critical_speeds]
    assert marks["marker"]["symbol"] == shapes
    drawn = unpacked(vibration.traces[0]["y"])
    torque = present.vibration.vibratory_torque_sum / 1e3
    assert drawn.max() == np.float32(torque.max())


def test_numbers_are_packed_with_seven_digits():
    values = np.array([1.0, -2.5e-9, 123456.7])
    assert unpacked(packed(values)) == pytest.approx(values, rel=1e-7)


@pytest.mark.parametrize(
    ("ends", "words"),
    [
        ((0.2, 3.0), ["0.2", "0.5", "1", "2"]),
        ((100.0, 400.0), ["100", "150", "200", "300", "400"]),
    ],
)
def test_a_short_logarithmic_axis_has_round_ticks(ends, words):
    assert logarithmic(*ends)["ticktext"] == words


def test_a_long_logarithmic_axis_has_powers_of_ten():
    assert logarithmic(1e8, 1e12)["dtick"] == 1
    assert logarithmic(1e8, 1e15)["dtick"] == 2


def test_the_campbell_diagram_shows_what_is_forbidden(speed_map):
    """Soft: each order's line from standstill to sqrt 2 above the lowest mode."""
    campbell = speed_figures(speed_map)[0]
    broad = [
        trace for trace in campbell.traces if trace.get("line", {}).get("width") == 7
    ]
    bands = speed_map.present.forbidden_bands
    for band, trace in zip(bands, broad, strict=False):
        assert trace["x"] == pytest.approx([0.0, band.border * 30 / math.pi])
        border = band.order * band.border / (2 * math.pi)
        assert trace["y"] == pytest.approx([0.0, border])
    assert len(broad) >= len(bands)
