"""Which records stand in a restart file, in the order in which LAMMPS 22 Jul 2025 writes them. Measured on its files.

A record is a flag (int) and a payload; a section of records ends with the flag -1.
"""

from __future__ import annotations

MAGIC = b"LammpS RestartT\0"  # the first and the last 16 bytes
ORDER, SWAPPED = 1, 0x1000  # the byte order mark, and what LAMMPS takes for one of a machine of the other kind
REVISION = 3
VERSION = "22 Jul 2025"
END = -1

# name in Content.header: (flag, kind of payload)
HEADER: dict[str, tuple[int, str]] = {
    "version": (0, "text"),
    "smallint": (1, "integer"), "imageint": (48, "integer"), "tagint": (2, "integer"), "bigint": (3, "integer"),
    "units": (4, "text"), "step": (5, "big"), "dimension": (6, "integer"),
    "processes": (7, "integer"), "process grid": (8, "integers"),
    "newton pair": (9, "integer"), "newton bond": (10, "integer"),
    "periodic x": (11, "integer"), "periodic y": (12, "integer"), "periodic z": (13, "integer"),
    "boundary": (14, "integers"), "least": (49, "numbers"),
    "atom style": (15, "style"),
    "atoms": (16, "big"), "atom types": (17, "integer"),
    "bonds": (18, "big"), "bond types": (19, "integer"), "bond per atom": (20, "integer"),
    "angles": (21, "big"), "angle types": (22, "integer"), "angle per atom": (23, "integer"),
    "dihedrals": (24, "big"), "dihedral types": (25, "integer"), "dihedral per atom": (26, "integer"),
    "impropers": (27, "big"), "improper types": (28, "integer"), "improper per atom": (29, "integer"),
    "triclinic": (30, "integer"), "lo": (31, "numbers"), "hi": (32, "numbers"),
    "xy": (33, "number"), "xz": (34, "number"), "yz": (35, "number"), "triclinic general": (73, "integer"),
    "special lj": (36, "numbers"), "special coul": (37, "numbers"),
    "timestep": (50, "number"),
    "atom id": (51, "integer"), "map style": (52, "integer"), "map user": (53, "integer"),
    "sort every": (54, "integer"), "sort bin": (55, "number"),
    "comm mode": (56, "integer"), "comm cutoff": (57, "number"), "comm velocity": (58, "integer"),
    "no pair": (59, "text"),
    "extra bond per atom": (60, "integer"), "extra angle per atom": (61, "integer"),
    "extra dihedral per atom": (62, "integer"), "extra improper per atom": (63, "integer"),
    "special per atom": (65, "integer"), "record growth": (75, "integer"),
    "ellipsoids": (66, "big"), "lines": (67, "big"), "triangles": (68, "big"), "bodies": (69, "big"),
    "time step": (71, "big"), "time": (70, "number"),
}  # fmt: skip
OPTIONAL = {"no pair"}
BY_FLAG = {flag: (name, kind) for name, (flag, kind) in HEADER.items()}

MASS, LABELS = 38, 72  # records by type
FORCES = {"pair": 39, "bond": 40, "angle": 41, "dihedral": 42, "improper": 43}
FILES, PIECES, PROCESS = 44, 46, 47  # how many files; pieces in this file; the atoms of one process

FACES = "pfsm"  # codes 0 to 3 of boundary
UNITS = ("lj", "real", "metal", "si", "cgs", "electron", "micro", "nano")
KINDS = {"bond": 1, "angle": 3, "dihedral": 4, "improper": 4}  # IDs that one entry keeps beside its type
