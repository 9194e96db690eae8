import math
import re

import pytest

from coupling_design.engine import Arrangement, Cycle, firing_angles
from coupling_design.errors import CaseError

FOUR, TWO = Cycle.FOUR_STROKE, Cycle.TWO_STROKE
V16 = re.findall("..", "A1B8A5B4A7B2A3B6A8B1A4B5A2B7A6B3")


def rad(*degrees):
    return tuple(math.radians(angle) for angle in degrees)


def fired(cycle, cylinders, order, bank=None, **angles):
    arrangement = Arrangement(
        cylinders,
        tuple(order),
        None if bank is None else math.radians(bank),
        **{name: rad(*values) for name, values in angles.items()},
    )
    found = firing_angles(arrangement, cycle)
    return dict(
        zip(arrangement.names, (round(math.degrees(a), 6) for a in found), strict=True)
    )


def test_in_line_evenly():
    assert fired(FOUR, 4, "1342") == {"1": 0, "3": 180, "4": 360, "2": 540}
    assert fired(TWO, 3, "132") == {"1": 0, "3": 120, "2": 240}


def test_bank_b_follows_bank_a():
    found = fired(FOUR, 16, "15738426", 50)
    assert list(found) == [f"{bank}{n}" for bank in "AB" for n in range(1, 9)]
    assert (found["A5"], found["B5"], found["A6"], found["B6"]) == (90, 140, 630, 680)


def test_the_whole_order_tells_the_turn_in_which_bank_b_fires():
    # B1 is up at 50 degrees and, after A8 and before A4, fires at 410.
    found = fired(FOUR, 16, V16, 50)
    assert (found["A8"], found["B1"], found["A4"]) == (360, 410, 450)
    assert found["B8"] == 50
    assert sorted(found.values()) == sorted(
        [90 * k for k in range(8)] + [90 * k + 50 for k in range(8)]
    )


def test_intervals():
    assert fired(FOUR, 4, "1342", firing_intervals=(180, 180, 90, 270)) == {
        "1": 0, "3": 180, "4": 360, "2": 450,
    }  # fmt: skip
    found = fired(FOUR, 4, ["A1", "B1", "A2", "B2"], 90, firing_intervals=[270, 90] * 2)
    assert found == {"A1": 0, "B1": 270, "A2": 360, "B2": 630}


def test_throws():
    # A flat crank, 1 and 4 up together; 3 leads throw 1 by 180 either way.
    order = fired(FOUR, 4, "1342", crank_angles=(0, 180, 180, 0))
    assert order == {"1": 0, "3": 180, "4": 360, "2": 540}
    # A throw that leads by 120 is up again 240 later.
    assert fired(TWO, 3, "132", crank_angles=(0, 120, 240)) == {
        "1": 0, "3": 120, "2": 240,
    }  # fmt: skip
    # The cross-plane V8 of 1-8-4-3-6-5-7-2 that fires every 90 degrees: throws at 0,
    # 90, 270, 180; its even cylinders are ahead, so bank A: A1 is 2, B1 is 1.
    vee = fired(
        FOUR,
        8,
        ["A1", "B1", "A4", "A2", "B2", "A3", "B3", "B4"],
        90,
        crank_angles=(0, 90, 270, 180),
    )
    assert sorted(vee.values()) == [90 * k for k in range(8)]


@pytest.mark.parametrize(
    ("arguments", "angles", "words"),
    [
        ((FOUR, 4, "1322"), {}, "names each of 1 to 4 once"),
        ((FOUR, 4, "134"), {}, "names each of 1 to 4 once"),
        ((FOUR, 4, "1342", 90), {}, "names each of A1 to B2, or 1 to 2 once"),
        ((FOUR, 5, "12345", 90), {}, "found 5 cylinders, allowed is an even number"),
        ((FOUR, 2, "12"), {"firing_intervals": (180, 180)}, "together 720 deg"),
        ((FOUR, 2, "12"), {"firing_intervals": (720,)}, "found 1 firing intervals"),
        ((FOUR, 4, "1342"), {"crank_angles": (0, 180)}, "one for each throw, 4"),
        ((FOUR, 4, "1423"), {"crank_angles": (0, 180, 180, 0)}, "cannot be fired"),
        ((FOUR, 16, sorted(V16), 50), {}, "cannot be fired within one cycle"),
    ],
)
def test_contradictions(arguments, angles, words):
    with pytest.raises(CaseError, match=words):
        fired(*arguments, **angles)
