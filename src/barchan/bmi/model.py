"""The methods of the Basic Model Interface."""

import numpy as np
from numpy.typing import NDArray

from barchan.archive import source_at
from barchan.bmi.variables import FIELD, SCALAR, SPEED, VARIABLES, Variable
from barchan.errors import BarchanError
from barchan.scenario import load_scenario
from barchan.simulation import Simulation


class BarchanBmi:
    """A simulation behind the Basic Model Interface.

    Time is in seconds where steps have a duration, and in steps, unit 1, where they have none. Values are
    copies, whole fields flattened from the south-west corner eastwards, row by row northwards. A thickness
    that is set is laid in whole slabs, the ledger counts what enters and leaves, and slopes come to rest.
    """

    _simulation: Simulation | None = None
    _buffers: dict[str, NDArray[np.float64]]

    @property
    def simulation(self) -> Simulation:
        """The simulation; raises BarchanError before ``initialize`` and after ``finalize``."""
        if self._simulation is None:
            raise BarchanError("the model is not initialized: call initialize(scenario) first")
        return self._simulation

    def initialize(self, config_file: str) -> None:
        """Build the bed of a scenario: a JSON file, the name of a preset or the folder of a run."""
        self._simulation = Simulation(load_scenario(source_at(config_file)))
        self._buffers = {}

    def update(self) -> None:
        """Do one step."""
        self.simulation.advance(1)
        self._refresh()

    def update_until(self, time: float) -> None:
        """Do all steps up to a time; raises BarchanError where that is past or no whole number of steps."""
        steps = (time - self.get_current_time()) / self.get_time_step()
        if steps < -1e-9 or abs(steps - round(steps)) > 1e-6:
            raise BarchanError(
                f"update_until({time:g}): allowed: {self.get_current_time():g} and later, in whole steps of "
                f"{self.get_time_step():g} {self.get_time_units()}"
            )
        self.simulation.advance(round(steps))
        self._refresh()

    def finalize(self) -> None:
        """Let go of the simulation."""
        self._simulation = None
        self._buffers = {}

    def get_component_name(self) -> str:
        """The model's full name."""
        return f"Barchan: {self.simulation.model.title}"

    def get_input_item_count(self) -> int:
        """Number of variables that can be set."""
        return len(self.get_input_var_names())

    def get_output_item_count(self) -> int:
        """Number of variables that can be read."""
        return len(self.get_output_var_names())

    def get_input_var_names(self) -> tuple[str, ...]:
        """Names of the variables that can be set: those of the wind only where it is a steady one."""
        steady = self.simulation.wind.model_dump()["kind"] == "steady"
        return tuple(
            name
            for name, known in VARIABLES.items()
            if known.set and self._present(name) and (steady or known.grid == FIELD)
        )

    def get_output_var_names(self) -> tuple[str, ...]:
        """Names of the variables that can be read."""
        return tuple(name for name in VARIABLES if self._present(name))

    def get_var_grid(self, name: str) -> int:
        """The grid of a variable: 0, the lattice, or 1, a scalar."""
        return self._variable(name).grid

    def get_var_type(self, name: str) -> str:
        """The type of its values."""
        self._variable(name)
        return "float64"

    def get_var_units(self, name: str) -> str:
        """The unit of its values, as UDUNITS reads it."""
        return self._variable(name).units

    def get_var_itemsize(self, name: str) -> int:
        """Bytes of a value."""
        self._variable(name)
        return 8

    def get_var_nbytes(self, name: str) -> int:
        """Bytes of all its values."""
        return 8 * self.get_grid_size(self.get_var_grid(name))

    def get_var_location(self, name: str) -> str:
        """Where on the grid its values are: at nodes, which are the centres of cells."""
        self._variable(name)
        return "node"

    def get_current_time(self) -> float:
        """Time since the start."""
        return self.simulation.steps_done * self.get_time_step()

    def get_start_time(self) -> float:
        """Time of the first step."""
        return 0.0

    def get_end_time(self) -> float:
        """Time after the scenario's last step."""
        return self.simulation.scenario.run.steps * self.get_time_step()

    def get_time_units(self) -> str:
        """Seconds, or 1 where a step has no duration."""
        return "1" if self.simulation.scenario.step_seconds is None else "s"

    def get_time_step(self) -> float:
        """Duration of a step."""
        return float(self.simulation.scenario.step_seconds or 1.0)

    def get_value(self, name: str, dest: NDArray) -> NDArray:
        """Copy the values of a variable into ``dest``, flat, and return it."""
        dest[:] = self._values(name)
        return dest

    def get_value_ptr(self, name: str) -> NDArray[np.float64]:
        """An array that holds the values of a variable as they are, after every update too."""
        if name not in self._buffers:
            self._buffers[name] = self._values(name)
        return self._buffers[name]

    def get_value_at_indices(self, name: str, dest: NDArray, inds: NDArray) -> NDArray:
        """Copy the values at flat indices into ``dest`` and return it."""
        dest[:] = self._values(name)[np.asarray(inds)]
        return dest

    def set_value(self, name: str, src: NDArray) -> None:
        """Set all values of a variable; raises BarchanError for one that cannot be set or a wrong size."""
        variable = self._variable(name)
        if variable.set is None or name not in self.get_input_var_names():
            raise BarchanError(f"{name} cannot be set; what can: {', '.join(self.get_input_var_names())}")
        values = np.asarray(src, np.float64).ravel()
        size = self.get_grid_size(variable.grid)
        if values.size != size or not np.isfinite(values).all():
            raise BarchanError(f"{name}: {values.size} values; allowed: {size} finite numbers")
        variable.set(self.simulation, values)
        self._refresh()

    def set_value_at_indices(self, name: str, inds: NDArray, src: NDArray) -> None:
        """Set the values of a variable at flat indices."""
        values = self._values(name)
        values[np.asarray(inds)] = src
        self.set_value(name, values)

    def get_grid_rank(self, grid: int) -> int:
        """Number of dimensions."""
        return 2 if self._grid(grid) == FIELD else 0

    def get_grid_size(self, grid: int) -> int:
        """Number of nodes."""
        return self.simulation.lattice.cells if self._grid(grid) == FIELD else 1

    def get_grid_type(self, grid: int) -> str:
        """The type of a grid."""
        return "uniform_rectilinear" if self._grid(grid) == FIELD else "scalar"

    def get_grid_shape(self, grid: int, shape: NDArray) -> NDArray:
        """Rows and columns."""
        self._needs_field(grid, "shape")
        shape[:] = self.simulation.lattice.shape
        return shape

    def get_grid_spacing(self, grid: int, spacing: NDArray) -> NDArray:
        """Distance (m) of rows and of columns."""
        self._needs_field(grid, "spacing")
        spacing[:] = self.simulation.lattice.cell_size
        return spacing

    def get_grid_origin(self, grid: int, origin: NDArray) -> NDArray:
        """Distance (m) northwards and eastwards of the centre of the south-west cell."""
        self._needs_field(grid, "origin")
        origin[:] = self.simulation.lattice.cell_size / 2
        return origin

    def get_grid_x(self, grid: int, x: NDArray) -> NDArray:
        """Distance (m) of the columns from the west edge."""
        self._needs_field(grid, "x")
        x[:] = self.simulation.lattice.x
        return x

    def get_grid_y(self, grid: int, y: NDArray) -> NDArray:
        """Distance (m) of the rows from the south edge."""
        self._needs_field(grid, "y")
        y[:] = self.simulation.lattice.y
        return y

    def get_grid_z(self, grid: int, z: NDArray) -> NDArray:
        """A grid in the plane has no z."""
        raise self._not_there(grid, "z")

    def get_grid_node_count(self, grid: int) -> int:
        """Number of nodes."""
        return self.get_grid_size(grid)

    def get_grid_edge_count(self, grid: int) -> int:
        """A uniform grid states no edges."""
        raise self._not_there(grid, "edges")

    def get_grid_face_count(self, grid: int) -> int:
        """A uniform grid states no faces."""
        raise self._not_there(grid, "faces")

    def get_grid_edge_nodes(self, grid: int, edge_nodes: NDArray) -> NDArray:
        """A uniform grid states no edges."""
        raise self._not_there(grid, "edges")

    def get_grid_face_edges(self, grid: int, face_edges: NDArray) -> NDArray:
        """A uniform grid states no faces."""
        raise self._not_there(grid, "faces")

    def get_grid_face_nodes(self, grid: int, face_nodes: NDArray) -> NDArray:
        """A uniform grid states no faces."""
        raise self._not_there(grid, "faces")

    def get_grid_nodes_per_face(self, grid: int, nodes_per_face: NDArray) -> NDArray:
        """A uniform grid states no faces."""
        raise self._not_there(grid, "faces")

    def _refresh(self) -> None:
        for name, buffer in self._buffers.items():
            buffer[:] = self._values(name)

    def _values(self, name: str) -> NDArray[np.float64]:
        return np.array(self._variable(name).get(self.simulation), np.float64).ravel()

    def _present(self, name: str) -> bool:
        return name != SPEED or self.simulation.last_segment.speed is not None

    def _variable(self, name: str) -> Variable:
        if name not in VARIABLES or not self._present(name):
            known = ", ".join(self.get_output_var_names())
            raise BarchanError(f"no variable '{name}'; known: {known}")
        return VARIABLES[name]

    def _grid(self, grid: int) -> int:
        if grid not in (FIELD, SCALAR):
            raise BarchanError(f"no grid {grid}; allowed: {FIELD}, the lattice, and {SCALAR}, a scalar")
        return grid

    def _needs_field(self, grid: int, wanted: str) -> None:
        if self._grid(grid) != FIELD:
            raise self._not_there(grid, wanted)

    def _not_there(self, grid: int, wanted: str) -> NotImplementedError:
        return NotImplementedError(f"grid {self._grid(grid)}, {self.get_grid_type(grid)}, has no {wanted}")
