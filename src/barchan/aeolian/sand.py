"""Sand and air, as parameters: declared once, with other defaults where a source has them."""

from barchan.parameters import Parameters, parameter


class Sand(Parameters):
    """The sand that the wind moves."""

    grain_diameter: float = parameter(
        0.25e-3,
        unit="m",
        ge=0.02e-3,
        le=5e-3,
        group="sand",
        meaning="Diameter of the grains.",
        source="Bagnold 1941, the reference size",
    )
    grain_density: float = parameter(
        2650.0,
        unit="kg/m³",
        ge=100,
        le=10_000,
        group="sand",
        meaning="Density of a grain.",
        source="quartz",
    )
    porosity: float = parameter(
        0.4,
        unit="-",
        ge=0,
        le=0.9,
        group="sand",
        meaning="Share of pores in the bed: a volume of sand as it lies is that of its grains over "
        "1 - porosity.",
        source="random packing of sand; pydune divides by 0.6",
    )


class Air(Parameters):
    """The air that blows over it."""

    air_density: float = parameter(
        1.225,
        unit="kg/m³",
        ge=0.001,
        le=100,
        group="air",
        meaning="Density of the air.",
        source="standard air at sea level",
    )
