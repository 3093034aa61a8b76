"""The Basic Model Interface (BMI 2.0, Hutton et al. 2020) to a simulation, for frameworks that couple models.

The interface is met by its methods alone; nothing is imported from a framework.
"""

from barchan.bmi.model import BarchanBmi

__all__ = ["BarchanBmi"]
