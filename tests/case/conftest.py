import pytest

from coupling_design.case import load_case
from coupling_design.errors import CaseError

VALID = """\
name: Example
description: a small set
reading: transmission_force
driveline:
  engine_inertia: 2.5 kg*m^2
  coupling_inertia: 0.08 kg*m^2
  generator_inertia: 3.0 kg*m^2
  coupling:
    type: rubber
    torsional_stiffness: 12 kN*m/rad
  connection:
    kind: key
    radius: 50 mm
    gap: 0.10 mm
    contact_stiffness: 1e7 N*m/rad
    oil_damping: 10 N*m*s/rad
    smoothing: 1000 1/mm
  excitation:
    - order: 3
      amplitude: 40 N*m
      phase: 0 deg
    - order: 6
      amplitude: 10 N*m
      phase: 0 deg
  engine_resistance:
    viscous: 0.2 N*m*s/rad
    friction: 60 N*m
    transition_speed: 0.2 rad/s
  generator_resistance:
    viscous: 0.01 N*m*s/rad
    friction: 5 N*m
    transition_speed: 0.2 rad/s
shutdown:
  initial_speed: 750 rpm
  duration: 5 s
  time_step: 1e-4 s
shaft:
  hub_to_bearing_1: 150 mm
  bearing_1_to_rotor: 300 mm
  rotor_to_bearing_2: 300 mm
  rotor_weight: 2200 N
bearings:
  - name: drive end
    designation: 6318
    type: radial_ball
    dynamic_load_rating: 151 kN
    static_load_rating: 108 kN
    pitch_diameter: 140 mm
    stress_coefficient: 23 MPa/N^0.5
    minimum_stress: 1500 MPa
  - name: other end
    designation: 6314
    type: radial_ball
    dynamic_load_rating: 111 kN
    static_load_rating: 68 kN
    pitch_diameter: 110 mm
    stress_coefficient: 27 MPa/N^0.5
    minimum_stress: 1500 MPa
lubrication:
  viscosity: 40 mm^2/s
  cleanliness: normal
  reliability: 95 %
duty:
  working_speed:
    lowest: 1450 rpm
    highest: 1550 rpm
  rated_torque: 1.3 kN*m
  peak_torque: 3 kN*m
  service_factor: 1.2
coupling_types:
  - name: rubber
    plan: elastic
    nominal_torque: 2 kN*m
    maximum_torque: 5 kN*m
    maximum_speed: 2500 rpm
    stiffness:
      lowest: 8 kN*m/rad
      highest: 30 kN*m/rad
    damping:
      law: relative_damping
      relative_damping: 1.1
    connections: [key, spline]
design_space:
  connections:
    key:
      minimum_gap: 0.02 mm
      maximum_gap: 0.20 mm
    spline: {minimum_gap: 0.01 mm, maximum_gap: 0.05 mm}
"""


@pytest.fixture
def valid():
    """Return the text of a small case without fault."""
    return VALID


@pytest.fixture
def write(tmp_path, monkeypatch):
    """Write a case file into an empty working directory and return its name."""
    monkeypatch.chdir(tmp_path)

    def write_case(text):
        content = text if isinstance(text, bytes) else text.encode()
        (tmp_path / "case.yaml").write_bytes(content)
        return "case.yaml"

    return write_case


@pytest.fixture
def load(write):
    """Load the case that a text describes."""
    return lambda text: load_case(write(text))


@pytest.fixture
def problems(write):
    """Return the problems that loading a text must raise."""

    def raised(text):
        with pytest.raises(CaseError) as error:
            load_case(write(text))
        return error.value.problems

    return raised
