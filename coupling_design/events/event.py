"""What any event is to those who march it: torques, start, duration, time step."""

from __future__ import annotations

from typing import Protocol

from coupling_design.arithmetic import Scalar
from coupling_design.line.motion import Motion


class Event(Protocol):
    """What happens to a line, as equations.

    Only time step and number of steps must be numbers; all else may hold symbols. A
    class of one's own needs no more than this to be marched, judged and recorded.

    Attributes
    ----------
    state_names : of the state's entries (n_states,): the line's angles [rad] and speeds
        [rad/s] in the order of `line.motion.state_names`, then states of its own
    time_step : [s]
    n_steps : how many make the event
    crank_angle : of the generator's end of the line at the start [rad]
    gravity_angle : from the direction of F_c to gravity, at the start [rad]
    """

    @property
    def state_names(self) -> tuple[str, ...]:
        """The names of the state's entries."""

    @property
    def time_step(self) -> float:
        """The time step [s]."""

    @property
    def n_steps(self) -> int:
        """The number of steps."""

    @property
    def crank_angle(self) -> Scalar:
        """The crank angle at the start [rad]."""

    @property
    def gravity_angle(self) -> Scalar:
        """The angle to gravity at the start [rad]."""

    def motion(self, state: Scalar) -> Motion:
        """Return the motion at a state (n_states,), or an array (n_states, n_steps).

        Its `state_rate` has an entry for each of `state_names`.
        """

    def start(self) -> Scalar:
        """Return the state at the start (n_states,), joints closed."""
