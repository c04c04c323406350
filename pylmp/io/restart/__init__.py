"""Restart files: LAMMPS's binary format, read and written.

content   a restart file as a value, without any simulation
stream    its numbers and strings; layout: which stand where
encode    value to bytes; decode: bytes to value
gather    simulation to value; restore: value to simulation
"""
