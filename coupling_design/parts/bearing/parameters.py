"""What describes a generator's bearings, shaft and lubrication, in SI."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from coupling_design.arithmetic import Scalar


class BearingType(StrEnum):
    """Rolling element and direction of load, as ISO 281 distinguishes them."""

    RADIAL_ROLLER = "radial_roller"
    RADIAL_BALL = "radial_ball"


class Cleanliness(StrEnum):
    """The five contamination classes of ISO 281:2007 Annex A for grease."""

    HIGH = "high"
    NORMAL = "normal"
    SLIGHT_TYPICAL = "slight_typical"
    SEVERE = "severe"
    VERY_SEVERE = "very_severe"


class OilCleanliness(StrEnum):
    """Solid contamination of oil by ISO 4406 code, ISO 281:2007 Annex A.

    Circulating oil filtered on-line (the filter's beta ratio in the comment), and oil
    baths or oil filtered off-line.
    """

    FILTERED_13_10 = "oil_filtered_13_10"  # beta_6(c) = 200
    FILTERED_15_12 = "oil_filtered_15_12"  # beta_12(c) = 200
    FILTERED_17_14 = "oil_filtered_17_14"  # beta_25(c) >= 75
    FILTERED_19_16 = "oil_filtered_19_16"  # beta_40(c) >= 75
    UNFILTERED_13_10 = "oil_unfiltered_13_10"
    UNFILTERED_15_12 = "oil_unfiltered_15_12"
    UNFILTERED_17_14 = "oil_unfiltered_17_14"
    UNFILTERED_19_16 = "oil_unfiltered_19_16"
    UNFILTERED_21_18 = "oil_unfiltered_21_18"


class Contact(StrEnum):
    """How the stress of a contact grows with its load: by Hertz, a root of it."""

    LINE = "line"  # square root: rollers
    POINT = "point"  # cube root: balls

    @property
    def root(self) -> int:
        """Which root of the load."""
        return 2 if self is Contact.LINE else 3


@dataclass(frozen=True)
class ShaftGeometry:
    """Overhung shaft: l1 hub to bearing 1, l2, l3 bearings to rotor [m], G [N]."""

    hub_to_bearing_1: Scalar
    bearing_1_to_rotor: Scalar
    rotor_to_bearing_2: Scalar
    rotor_weight: Scalar


@dataclass(frozen=True)
class Bearing:
    """A rolling bearing.

    Attributes
    ----------
    name, designation : as the report calls it, and the maker's (NU2326)
    type : BearingType
    dynamic_load_rating : C_r [N]
    static_load_rating : C_0 [N]
    pitch_diameter : D_pw [m]
    stress_coefficient : K1 in S = K1 sqrt(F) [Pa/sqrt(N)], or of a point contact in
        S = K1 F^(1/3) [Pa/N^(1/3)]
    minimum_stress : S_min, below which fatigue is neglected [Pa]
    contact : which of the two laws
    """

    name: str
    designation: str
    type: BearingType
    dynamic_load_rating: Scalar
    static_load_rating: Scalar
    pitch_diameter: Scalar
    stress_coefficient: Scalar
    minimum_stress: Scalar
    contact: Contact = Contact.LINE

    @property
    def is_a_ball_by_the_line_law(self) -> bool:
        """Whether its stress is counted by the law of rollers although it has balls."""
        return self.type is BearingType.RADIAL_BALL and self.contact is Contact.LINE


@dataclass(frozen=True)
class Lubrication:
    """Kinematic viscosity at operating temperature [m^2/s] and cleanliness."""

    viscosity: Scalar
    cleanliness: Cleanliness | OilCleanliness
