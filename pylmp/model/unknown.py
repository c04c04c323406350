"""What to say of a style name that is not known here."""

from __future__ import annotations

from typing import Any, NoReturn

from pylmp.model.registry import Registry
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

# Styles of the LAMMPS manual that pylmp lacks: known, not misspelled.
ELSEWHERE = {
    "pair": "lj/cut/coul/cut lj/cut/coul/long lj/smooth lj/gromacs lj96/cut buck buck/coul/cut born coul/cut "
    "coul/long coul/debye yukawa table hybrid/scaled eam eam/alloy eam/fs sw tersoff airebo rebo reaxff dpd "
    "gran/hooke gran/hooke/history gran/hertz/history granular lubricate colloid gauss lj/class2 lj/cubic mie/cut python tri/lj zbl",
    "bond": "angles bpm/rotational class2 fene/nm gaussian harmonic/restrain lepton mesocnt mm3 oxdna/fene rheo/shell special table",
    "angle": "amoeba charmm class2 class2/p6 cosine cosine/buck6d cosine/delta cosine/periodic cosine/shift cosine/shift/exp "
    "cosine/squared cosine/squared/restricted cross dipole fourier fourier/simple gaussian harmonic hybrid lepton mesocnt mm3 "
    "mwlc quartic spica table",
    "dihedral": "charmm charmmfsw class2 cosine/shift/exp cosine/squared/restricted fourier harmonic helix hybrid lepton "
    "multi/harmonic nharmonic opls quadratic spherical table table/cut",
    "improper": "amoeba class2 cossq cvff distance distharm fourier harmonic hybrid inversion/harmonic ring sqdistharm umbrella",
    "fix": "adapt addtorque append/atoms ave/atom ave/chunk ave/correlate ave/histo balance bond/break bond/create "
    "bond/react bond/swap box/relax controller deposit drag dt/reset efield evaporate external flow/gauss freeze gcmc gravity "
    "heat langevin/drude lineforce msst neb nph npt nve/noforce nve/sphere nvk nvt/sllod orient/fcc "
    "oneway planeforce poems pour press/berendsen property/atom python/invoke qeq/point rattle restrain rigid "
    "rigid/small rigid/nve rigid/nvt setforce/spin shake shardlow spring/chunk spring/rg srd store/force "
    "temp/csld temp/csvr thermal/conductivity tfmc ttm vector viscosity wall/gran "
    "wall/srd widom",
    "compute": "angle angle/local angmom/chunk basal/atom body/local bond centro/atom cluster/atom "
    "cna/atom contact/atom dihedral dihedral/local dilatation/atom dipole erotate/sphere "
    "event/displace fragment/atom heat/flux hexorder/atom improper/local inertia/chunk  "
    "msd/nongauss nbond orientorder/atom pressure/cylinder   "
    "slice stress/mop temp/asphere temp/chunk temp/deform temp/profile "
    "temp/ramp temp/rotate temp/sphere torque/chunk voronoi/atom xrd",
    "dump": "dcd grid grid/vtk h5md molfile netcdf netcdf/mpiio vtk xtc",
}  # fmt: skip


def is_elsewhere(kind: str, name: str) -> bool:
    """LAMMPS has a style of that name."""
    return name.removesuffix("/omp").removesuffix("/opt") in ELSEWHERE.get(kind, "").split()


def unknown_style(args: Args, name: Word, kind: str, registry: Registry[Any]) -> NoReturn:
    """LAMMPS's sentence with a guess at what was meant; or that only LAMMPS has it."""
    if is_elsewhere(kind, name.text):
        raise Unsupported(
            f"LAMMPS has {kind} style {name.text}, pylmp's native engines do not", name.span,
            hint="--engine lammps runs this script on LAMMPS", manual=f"{kind}_{name.text.replace('/', '_')}.html",
        )  # fmt: skip
    near = registry.near(name.text)
    hint = f"did you mean {near}?" if near else f"known: {' '.join(registry.names())}"
    args.fail(f"Unrecognized {kind} style '{name.text}'", name, hint=hint)
