"""Grains of snow in flight: what they build bonds while it lies."""

from typing import Any

from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.grains.bed import GrainGround
from barchan.grains.bonded_snow import BONDED, DERIVED, LOOSE, STRATA, BondedSnow
from barchan.grains.model import GrainModel
from barchan.grains.sintering import Sintering
from barchan.kernels.grains.air_state import Air
from barchan.kernels.grains.state import Bonds
from barchan.lattice import Lattice
from barchan.wind.segment import Segment


class SnowGrainModel(GrainModel):
    """A model of grains whose deposits bond, if its sintering grows."""

    material = "snow"
    temperature_range = (-90.0, 5.0)
    derived = (*GrainModel.derived, *DERIVED)
    strata = STRATA

    def __init__(self, parameters: Any, lattice: Lattice) -> None:
        """Set the model up with no grain in the air, and start the timer."""
        super().__init__(parameters, lattice)
        sintering = self.sintering
        self.bonded_snow = BondedSnow(sintering) if sintering.grows else None
        if self.bonded_snow is not None:
            self.fields = (*self.fields, *LOOSE, BONDED)

    @property
    def sintering(self) -> Sintering:
        """The closure of bonds."""
        found = self.parameters.part(Sintering)
        assert found is not None
        return found

    def initialise(self, bed: Bed, seed: int) -> None:
        """Add loose and bonded parcels to a bed, and what every model of grains adds."""
        super().initialise(bed, seed)
        if self.bonded_snow is not None:
            self.bonded_snow.initialise(bed)

    def change(self, parameters: Any) -> None:
        """Take new parameters from now on; the timer is kept."""
        super().change(parameters)
        if self.bonded_snow is not None:
            self.bonded_snow.sintering = self.sintering

    def state(self) -> dict[str, NDArray | float | int | str]:
        """The timer, and what every model of grains keeps."""
        timer = {} if self.bonded_snow is None else self.bonded_snow.state()
        return {**super().state(), **timer}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up grains in the air, and the timer."""
        super().restore(state)
        if self.bonded_snow is not None:
            self.bonded_snow.restore(state)

    def facts(self) -> dict[str, str]:
        """The bonding time, with parcels, settling and time."""
        if self.bonded_snow is None:
            return {**super().facts(), "bonds": "do not grow"}
        time = self.sintering.full_time / self.sintering.rate()
        shown = f"{time / 3600.0:.3g} h" if time >= 3600.0 else f"{time:.3g} s"
        text = f"grow in three quarters of {shown} at least, and in {shown} at most"
        return {**super().facts(), "bonds": text}

    def remarks(self, hop_length: float | None, direction: float) -> list[str]:
        """A bonding time beside the duration of a step, and parcels unlike those of the sources."""
        found, seconds = super().remarks(hop_length, direction), self.step_seconds
        return found if seconds is None else [*found, *self.sintering.remarks(seconds)]

    def bonds_of(self, bed: Bed) -> Bonds | None:
        """The bonds of a bed; None where none grow."""
        return None if self.bonded_snow is None else self.bonded_snow.bonds(bed)

    def blow(self, ground: GrainGround, wind: Segment) -> Air:
        """Recompute the wind over the ground, its effect on grains, and whether it lifts bonded ones."""
        threshold = self.sintering.bonded_threshold * self.parameters.threshold()
        ground.loosen(self.setting(wind).ustar > threshold)
        return super().blow(ground, wind)

    def pass_time(self, wind: Segment, ground: GrainGround) -> None:
        """Let the bonds age by a step."""
        bonds, seconds = ground.arrays.bonds, self.step_seconds
        if self.bonded_snow is not None and bonds is not None and seconds is not None:
            self.bonded_snow.pass_time(seconds * wind.share, wind.weather.temperature, bonds)

    def _store(self, bed: Bed, ground: GrainGround) -> None:
        super()._store(bed, ground)
        if self.bonded_snow is not None and ground.arrays.bonds is not None:
            self.bonded_snow.store(bed, ground.arrays.bonds)
