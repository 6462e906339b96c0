from typing import Any, List, Optional

import numpy as np

from . import Event, Ring, RingPoints, State

__version__: str

class InputError(ValueError): ...
class Cancelled(RuntimeError): ...

class Cursor:
    state: State
    events: List[Event]
    def forward(self, unit: str = "decision") -> Optional[State]: ...
    def back(self, unit: str = "decision") -> Optional[State]: ...
    def next(self, line: str) -> Optional[State]: ...

class Stepper:
    phase: str
    pivots: int
    status: np.ndarray
    triangles: np.ndarray
    rings: List[Ring]
    neighbor_ring: RingPoints
    def advance(self) -> bool: ...
    def step_pivot(self) -> bool: ...
    def run_until(self, condition: Any = None, progress: Any = None) -> str: ...

def __getattr__(name: str) -> Any: ...
