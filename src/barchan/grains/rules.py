"""The rules at the bed, from the closures of a model."""

from barchan.grains.bounce import Bounce
from barchan.grains.closure import Setting
from barchan.grains.entrainment import NO_ENTRAINMENT, Entrainment
from barchan.grains.splash import Splash
from barchan.kernels.grains.rules import Bounce as BounceRule
from barchan.kernels.grains.rules import Entrainment as EntrainmentRule
from barchan.kernels.grains.rules import Rules


def entrainment_of(setting: Setting, probability: float | None = None) -> EntrainmentRule:
    """Entrainment by the wind, with another ``probability`` if one is given."""
    closure = setting.rules.part(Entrainment)
    return NO_ENTRAINMENT if closure is None else closure.struct(setting, probability)


def rules_of(setting: Setting, lifts: bool = True) -> Rules:
    """The rules as kernels take them; without ``lifts`` the wind itself lifts nothing."""
    rules = setting.rules
    bounce, splash = rules.part(Bounce), rules.part(Splash)
    return Rules(
        BounceRule(0.0, 0.0, 0.0, rules.max_bounces) if bounce is None else bounce.struct(rules.max_bounces),
        entrainment_of(setting, None if lifts else 0.0),
        None if splash is None else splash.struct(setting),
    )
