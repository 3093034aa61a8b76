"""Highest stacks of Momiji's and Bishop's models (parameters: Prague thesis, Tables 6.2 and 6.3).

Presets `momiji-barchans` (1000 steps), `momiji-transverse` (10,000 steps), `momiji-large` (1024² cells, 3
seeds) and `bishop-barchans` (1500 steps); for Bishop also with Moore's neighbourhood (`bishop-moore`), as
Elder (2009) reads the paper. The papers' rounding of hops is not known: the first three are also run with
hops of exact length.
"""

from validation.study import measures_after, number, over_seeds

TITLE = "Highest stacks under a wind that speeds up"

EXACT = {"model__hop_rounding": "none"}


def rows():
    cases = [
        ("momiji-barchans", {}, 26),
        ("momiji-barchans", EXACT, 26),
        ("momiji-transverse", {}, 34),
        ("bishop-barchans", {}, 28),
        ("bishop-barchans", EXACT, 28),
        ("bishop-moore", {}, 28),
    ]
    results = over_seeds(measures_after, [case[:2] for case in cases])
    for (preset, changes, published), result in zip(cases, results, strict=True):
        what = f"{preset}, exact hops" if changes else preset
        yield number(what, published, result["highest_stack"], "slabs")
    (large,) = over_seeds(measures_after, [("momiji-large", {"run__save_every": 500})], (1, 2, 3))
    yield number("momiji-large", 29, large["highest_stack"], "slabs")


READING = """
Momiji's transverse dunes and Bishop's barchans agree with single runs of the Prague thesis; Momiji's
barchans are a tenth lower with hops rounded to whole cells and agree with hops of exact length. Bishop's
with eight neighbours are as high as with four within the scatter of seeds.
"""
