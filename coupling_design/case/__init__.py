"""Case files: read, checked and turned into SI values."""

from coupling_design.case.case import Case as Case
from coupling_design.case.case import ConnectionKind as ConnectionKind
from coupling_design.case.case import ConnectionOption as ConnectionOption
from coupling_design.case.case import CouplingType as CouplingType
from coupling_design.case.case import Duty as Duty
from coupling_design.case.case import Joint as Joint
from coupling_design.case.case import LoadLimitReading as LoadLimitReading
from coupling_design.case.case import Plan as Plan
from coupling_design.case.case import Source as Source
from coupling_design.case.case import SourcedValue as SourcedValue
from coupling_design.case.load import load_case as load_case
