"""Case files: read, checked and turned into SI values."""

from coupling_design.case.load import load_case as load_case
from coupling_design.machine.machine import Case as Case
from coupling_design.machine.machine import ConnectionKind as ConnectionKind
from coupling_design.machine.machine import ConnectionOption as ConnectionOption
from coupling_design.machine.machine import CouplingType as CouplingType
from coupling_design.machine.machine import Duty as Duty
from coupling_design.machine.machine import Joint as Joint
from coupling_design.machine.machine import LoadLimitReading as LoadLimitReading
from coupling_design.machine.machine import Plan as Plan
from coupling_design.machine.machine import Source as Source
from coupling_design.machine.machine import SourcedValue as SourcedValue
