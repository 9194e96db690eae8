"""What torque an engine puts on its crankshaft: cylinder, cycle, firing, orders.

>>> orders = engine_orders(engine, highest_order=8)  # doctest: +SKIP

Knows nothing of drivelines or files.
"""

from coupling_design.engine.crank_mode import first_crank_mode as first_crank_mode
from coupling_design.engine.figures import EngineFigures as EngineFigures
from coupling_design.engine.figures import engine_figures as engine_figures
from coupling_design.engine.firing import Arrangement as Arrangement
from coupling_design.engine.firing import firing_angles as firing_angles
from coupling_design.engine.orders import OrderRow as OrderRow
from coupling_design.engine.orders import TorqueOrder as TorqueOrder
from coupling_design.engine.orders import engine_orders as engine_orders
from coupling_design.engine.orders import list_orders as list_orders
from coupling_design.engine.parameters import Charge as Charge
from coupling_design.engine.parameters import Cycle as Cycle
from coupling_design.engine.parameters import Cylinder as Cylinder
from coupling_design.engine.parameters import Engine as Engine
from coupling_design.engine.parameters import IndicatedCombustion as IndicatedCombustion
from coupling_design.engine.parameters import PressureTrace as PressureTrace
