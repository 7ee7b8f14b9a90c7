from typing import (Any, Callable, Literal, Mapping, NamedTuple, Optional, Sequence, TypedDict,
                    Union)

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._routines import Routines

Real = NDArray[np.float64]
table: Mapping[str, Any]
__version__: str

class Error(ArithmeticError):
    info: Any
    results: Any

class DependentWarning(RuntimeWarning): ...
class RunWarning(RuntimeWarning): ...

class Piecewise:
    breaks: Real
    coefficients: Real
    def __init__(self, breaks: ArrayLike, coefficients: ArrayLike) -> None: ...
    @property
    def n(self) -> int: ...
    def __call__(self, t: ArrayLike, derivative: int = 0, side: int = 1) -> Real: ...

def plan(kind: str, q: ArrayLike, times: ArrayLike) -> Piecewise: ...
def table_of(times: ArrayLike, values: ArrayLike, order: int = 1) -> Piecewise: ...

class Linear(NamedTuple):
    a: Real
    b: Real
    c: Real
    d: Real

class LinearModel(NamedTuple):
    a: Real
    b: Real
    c: Real
    d: Real
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    tangent: Real
    independent: NDArray[np.int64]
    dropped: tuple[str, ...]

class Trim(NamedTuple):
    x: Real
    v: Real
    ud: Real
    lam: Optional[Real]
    phi: Real
    residual: float
    way: str
    running: tuple[str, ...]
    indifferent: tuple[str, ...]
    unique: NDArray[np.bool_]

class Modes(NamedTuple):
    frequency: Real
    damping: Real
    shapes: NDArray[np.complex128]
    eigenvalues: NDArray[np.complex128]
    real: Real
    rigid: int
    x: Real

class Campbell(NamedTuple):
    speeds: Real
    frequency: Real
    damping: Real
    shapes: NDArray[np.complex128]
    eigenvalues: NDArray[np.complex128]
    real: tuple[Real, ...]
    rigid: NDArray[np.intp]
    x: Real

class Sensitivity(NamedTuple):
    names: tuple[str, ...]
    dx: dict[str, Real]
    dv: dict[str, Real]
    dy: dict[str, Real]
    poles: NDArray[np.complex128]
    dpoles: dict[str, NDArray[np.complex128]]
    frequency: Real
    dfrequency: dict[str, Real]
    damping: Real
    ddamping: dict[str, Real]

class Mck(NamedTuple):
    M: Real
    C: Real
    K: Real
    B: Real
    E: Real
    D: Real
    G: Real
    S: Optional[Real]
    N: Optional[Real]
    coordinates: tuple[str, ...]
    speeds: tuple[str, ...]
    inputs: tuple[str, ...]
    devices: tuple[str, ...]

class Reach(NamedTuple):
    q: Real
    status: tuple[str, ...]
    distance: Real
    branch: NDArray[np.int64]
    solutions: tuple[Real, ...]
    free: Real

class Collocation(NamedTuple):
    t: Real
    x: Real
    v: Real
    ud: Real
    lam: Real
    y: Real
    costates: Real
    goal: float
    T: float
    parameters: dict[str, float]
    input: Optional[Piecewise]
    motion: Optional[Piecewise]
    error: float
    meshes: list[dict[str, Any]]
    active: list[dict[str, Any]]
    switches: Real
    singular: list[dict[str, Any]]
    solved: bool
    ended: str
    stopped: str

class Optimum(NamedTuple):
    values: dict[str, float]
    J: float
    model: Model
    results: dict[str, Any]
    active: list[dict[str, Any]]
    solved: bool
    ended: str
    limit: bool
    violation: float
    optimality: float
    iterations: Optional[int]
    evaluations: int
    solver: str
    starts: list[dict[str, Any]]
    stopped: str
    derivatives: str
    conflict: list[str]
    info: int
    choices: dict[str, Any]
    report: str

DesignRows = Union[tuple[Any, ...], Sequence[tuple[Any, ...]], Callable[..., Any], None]

Bounds = Optional[Mapping[str, tuple[float, float]]]

class Inverse(NamedTuple):
    t: Real
    q: Real
    u: Real
    ud: Real
    qj: Real
    tau: Optional[Real]
    lam: Optional[Real]
    v: Optional[Real]
    x: Optional[Real]
    margins: Optional[Real]

class Statistics(TypedDict):
    # statistics
    jacobians: int
    newton: int
    rank_loss_times: list[float]
    angle_times: list[float]
    singular_times: list[float]
    stiff: Optional[dict[str, Any]]
    method: str
    seconds: float
    rtol: float
    atol: Real
    failure: Optional[str]
    stopped: Optional[str]

class Result:
    t: Real
    x: Real
    v: Real
    y: Optional[Real]
    stats: Statistics
    samples: Optional[dict[str, Any]]
    events: Optional[dict[str, Any]]
    audit: Optional[dict[str, Any]]
    dx: dict[str, Real]
    dv: dict[str, Real]
    dy: dict[str, Real]

class Adjoint(NamedTuple):
    J: Real
    dJ: dict[str, Real]
    dx0: Real
    run: Result
    steps: int

class Ensemble:
    t: Real
    x: Real
    v: Real
    y: Optional[Real]
    ok: NDArray[np.bool_]
    reached: Real
    reason: list[str]
    stats: dict[str, Any]
    parameters: dict[str, Real]
    events: Optional[dict[str, Any]]

Input = Union[ArrayLike, Piecewise, Callable[[float, Real], ArrayLike]]

class Model(Routines):
    name: str
    sizes: Mapping[str, int]
    coordinates: tuple[str, ...]
    speeds: tuple[str, ...]
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    multipliers: tuple[str, ...]
    units: Mapping[str, Mapping[str, str]]
    nominal: Real
    cst: Real
    def __init__(self, /, **parameters: float) -> None: ...
    @property
    def parameters(self) -> Mapping[str, float]: ...
    @property
    def initial(self) -> Real: ...
    def changed(self, /, **parameters: float) -> Model: ...
    def kept(self, name: str) -> Any: ...
    def linearize(self, t: float, x: ArrayLike, v: Optional[ArrayLike] = None) -> Linear: ...
    def linear(self, t: float, x: ArrayLike, v: Optional[ArrayLike] = None, *,
               reduced: Union[str, Sequence[str]] = 'auto',
               drop: Union[str, Sequence[str]] = (),
               start: Literal['check', 'project'] = 'check') -> LinearModel: ...
    def assemble(self, guess: ArrayLike, *, hold: Union[str, Sequence[str]] = (),
                 time: float = 0.0, tolerance: float = 1e-10, branches: int = 0) -> Real: ...
    def trim(self, x: ArrayLike, v: Optional[ArrayLike] = None, *,
             hold: Union[str, Sequence[str]] = (), free: Union[str, Sequence[str]] = (),
             steady: Union[str, Sequence[str]] = (), time: float = 0.0, tolerance: float = 1e-9,
             margins: Literal['check', 'ignore'] = 'check') -> Trim: ...
    def modes(self, x: ArrayLike, v: Optional[ArrayLike] = None, *,
              hold: Union[str, Sequence[str]] = (), steady: bool = False, time: float = 0.0,
              start: Literal['check', 'project'] = 'check') -> Modes: ...
    def campbell(self, x: ArrayLike, spin: str, speeds: ArrayLike,
                 v: Optional[ArrayLike] = None, *, hold: Union[str, Sequence[str]] = (),
                 steady: bool = False, time: float = 0.0,
                 start: Literal['check', 'project'] = 'check') -> Campbell: ...
    def sensitivity(self, x: ArrayLike, v: Optional[ArrayLike] = None, *,
                    hold: Union[str, Sequence[str]] = (), free: Union[str, Sequence[str]] = (),
                    time: float = 0.0) -> Sensitivity: ...
    def mck(self, t: float, x: ArrayLike, v: Optional[ArrayLike] = None, *,
            reduced: Union[str, Sequence[str]] = 'auto',
            drop: Union[str, Sequence[str]] = (),
            start: Literal['check', 'project'] = 'check') -> Mck: ...
    def reach(self, name: str, P: ArrayLike, R: Optional[ArrayLike] = None, *,
              start: Optional[ArrayLike] = None, branch: int = 0,
              limits: Optional[ArrayLike] = None,
              method: Literal['auto', 'closed', 'newton'] = 'auto',
              given: Optional[ArrayLike] = None, time: float = 0.0) -> Reach: ...
    def collocate(self, x0: ArrayLike, xf: ArrayLike, *,
                  time: Union[float, tuple[float, float]],
                  goal: Union[str, Mapping[str, float]] = 'time', final: Bounds = None,
                  inputs: Bounds = None, states: Bounds = None, outputs: Bounds = None,
                  parameters: Bounds = None, method: Literal['radau', 'lobatto'] = 'radau',
                  intervals: int = 20, accuracy: float = 1e-6, refinements: int = 6,
                  guess: Union[Collocation, tuple[ArrayLike, ArrayLike, ArrayLike], None] = None,
                  polish: bool = True, regularize: float = 1.0, tolerance: float = 1e-9,
                  iterations: int = 500, seconds: float = 60.0,
                  timeout: float = 0.0) -> Collocation: ...
    def optimize(self, free: Union[tuple[Any, ...], Sequence[tuple[Any, ...]]],
                 goal: DesignRows = None, demands: DesignRows = None, cases: DesignRows = None, *,
                 solver: Literal['auto', 'slsqp', 'mma', 'cobyla', 'ipopt'] = 'auto',
                 starts: Union[int, ArrayLike] = 1, seed: int = 1, tolerance: float = 1e-10,
                 iterations: int = 500, evaluations: int = 1000, seconds: float = ...,
                 timeout: float = 0.0, choices: Literal['auto', 'all', 'branch'] = 'auto',
                 nodes: int = 1000) -> Optimum: ...
    # simulate
    def ensemble(self, times: ArrayLike, *, x0: Optional[ArrayLike] = ...,
                 parameters: Optional[Mapping[str, ArrayLike]] = ...,
                 starts: Optional[ArrayLike] = ..., inputs: Optional[ArrayLike] = ...,
                 threads: int = ..., method: str = ..., rtol: float = ...,
                 atol: Optional[ArrayLike] = ..., step: Optional[float] = ...,
                 maxstep: float = ..., maxsteps: int = ..., maxorder: Optional[int] = ...,
                 loops: Optional[str] = ..., drift: Optional[bool] = ..., start: str = ...,
                 input: Union[ArrayLike, Piecewise, None] = ...,
                 breaks: Sequence[float] = ...) -> Ensemble: ...
    def adjoint(self, x0: ArrayLike, times: ArrayLike, goal: Callable[[Result], tuple[Any, ...]],
                *, rtol: float = ..., atol: Optional[ArrayLike] = ..., start: str = ...,
                input: Union[None, ArrayLike, Piecewise] = ...,
                fixed: Union[None, str, Sequence[str]] = ..., dx0: Optional[ArrayLike] = ...
                ) -> Adjoint: ...
    def inverse(self, motion: Piecewise, times: ArrayLike, *, side: int = ...,
                guess: Optional[ArrayLike] = ..., internal: Optional[ArrayLike] = ...
                ) -> Inverse: ...
