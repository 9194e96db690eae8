"""Case files: read, checked and turned into SI values."""

from coupling_design.case.load import load_case as load_case
from coupling_design.machine.coupling_type import CouplingType as CouplingType
from coupling_design.machine.duty import Duty as Duty
from coupling_design.machine.hub_seat import ConnectionOption as ConnectionOption
from coupling_design.machine.hub_seat import HubSeat as HubSeat
from coupling_design.machine.machine import Case as Case
from coupling_design.machine.sourced_value import SourcedValue as SourcedValue
from coupling_design.machine.words import ConnectionKind as ConnectionKind
from coupling_design.machine.words import LoadLimitReading as LoadLimitReading
from coupling_design.machine.words import Plan as Plan
from coupling_design.machine.words import Source as Source
