"""Hard cases: contracts where programs of this kind fail (docs/numerics.md)."""
