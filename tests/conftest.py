"""Which tests run in one process, and which only with ``pytest -m long``.

On a machine that never ran pylmp the kernels of a scene take five to fifteen seconds to compile, most of the time of a test. So the tests of one
scene run in one process of several (--dist loadgroup); and of scenes and laws that are related to others, and of whole decks, few are
run each time.
"""

from __future__ import annotations

import pytest

SCENES = {"test_fast", "test_fast_scenes", "test_threads"}
FEW = {  # file: of its scenes, these are run each time
    **dict.fromkeys(
        SCENES,
        ("lj-quartic", "lj-plastic", "lj-spring", "lj-harmonic", "spring-plastic", "none-plastic", "flat", "narrow", "flow", "no pairs", "some that break",
         "shares of broken", "neighbors in a tilted box", "all pairs"),
    ),
    "test_renewal": ("periodic-", "flat-", "leaving-"),
    "test_bench_decks": ("in.A_melt", "in.C_impact", "in.D_sheet_", "in.E_network", "in.G_two_types"),
    "test_fast_lists": ("2-", "5-", "plastic", "quartic"),
}  # fmt: skip
LAWS = "test_all_programs_have_the_bits_of_the_law"
COMMON = ("bond quartic", "bond bpm/spring/plastic smooth yes normalize yes", "bond bpm/spring smooth yes normalize no", "pair lj/cut", "pair bpm/spring")
OF_SCENES = ("test_forces_energies_virials", "test_hundred_steps", "test_the_same_bits", "test_same_as_in_full", "test_any_number_of_types")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        call = getattr(item, "callspec", None)
        if call is None:
            continue
        file, test = item.path.stem, getattr(item, "originalname", "")
        if file in FEW and test in OF_SCENES:
            item.add_marker(pytest.mark.xdist_group(call.id.rstrip("0123456789")))
            if not call.id.startswith(FEW[file]):
                item.add_marker(pytest.mark.long)
        elif test == LAWS and call.id not in COMMON:
            item.add_marker(pytest.mark.long)
