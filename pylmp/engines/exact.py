"""The exact engine (stand-in)."""


class Exact:
    name = "exact"

    def run(self, sim, scene, plan):
        raise NotImplementedError
