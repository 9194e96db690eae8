"""An outcome with run-downs to draw, made of formulas, and pages of it, taken apart."""

from dataclasses import replace
from html.parser import HTMLParser
from types import SimpleNamespace

import numpy as np
import pytest

from coupling_design.flow.speed_map import evaluate_speed_map
from coupling_design.search.design_map import DesignMap
from coupling_design.signals.history import History
from coupling_design.wear.signals import BearingHistory, RundownHistory

SAMPLES = 20_000
VOID = {"meta", "br", "link", "img", "hr", "input"}


def rundown(role, label, swing):
    """Return a run-down of 12 s whose force swings most at 9 s, with one sharp peak."""
    time = np.linspace(0.0, 12.0, SAMPLES)
    force = -25e3 + swing * np.exp(-((time - 9) ** 2)) * np.sin(60 * time)
    force[7777] = -3 * swing
    load = np.abs(force) + 10e3
    speed = np.linspace(54.0, 0.5, SAMPLES)
    bearings = tuple(
        BearingHistory(
            combined_load=load / k,
            minimum_load=48.8e3,
            viscosity_ratio=speed / 20,
            contamination_factor=0.3 + 0.001 * speed,
            life_modification_factor=1 + speed,
            basic_rating_life=1e12 / load,
            modified_rating_life=1e13 / load,
            damage=np.cumsum(load) * 1e-18 / k,
        )
        for k in (1, 2)
    )
    history = History(time, force, force / 10, speed, 0.99 * speed, 8.5 * time)
    return RundownHistory(role, label, history, force, force - force, bearings, 9.0)


PLANE = DesignMap(
    "diaphragm, tight fit",
    torsional_stiffness=tuple(np.linspace(190e6, 400e6, 9)),
    key_gap=(0.0,),
    damage=(tuple(np.linspace(3e-9, 2e-9, 9)),),
    peak_transmission_force=(tuple(np.linspace(34e3, 40e3, 9)),),
)


def with_histories(outcome, role):
    histories = (
        rundown("present", "steel-spring, key", 40e3),
        rundown(role, "diaphragm, tight fit", 5e3),
    )
    return replace(outcome, histories=histories)


@pytest.fixture(scope="session")
def drawn(outcome):
    """The outcome with a design, and what its figures need."""
    return replace(with_histories(outcome, "chosen"), chosen_map=PLANE)


@pytest.fixture(scope="session")
def drawn_without_design(no_design):
    return with_histories(no_design, "nearest")


@pytest.fixture(scope="session")
def speed_map(case, outcome):
    return evaluate_speed_map(case, outcome.chosen)


class _Outline(HTMLParser):
    """Takes a page apart: every element with its attributes and the text in it."""

    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.open, self.elements, self.mismatches = [], [], []

    def handle_starttag(self, tag, attributes):
        element = SimpleNamespace(tag=tag, attributes=dict(attributes), text="")
        self.elements.append(element)
        if tag not in VOID:
            self.open.append(element)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop().tag != tag:
            self.mismatches.append(tag)

    def handle_data(self, data):
        for element in self.open:
            element.text += data


@pytest.fixture(scope="session")
def outline():
    """Return what takes a page apart."""

    def parse(page):
        parser = _Outline()
        parser.feed(page)
        parser.close()
        return parser

    return parse
