"""Steps in which nothing but kernels is called, one after the other without a way back to Python."""

from __future__ import annotations

from pylmp.kernels.machine import invoke, seconds

# plan: what the driver is told, and what it leaves
STEPS = 0  # to go; counts down when a step is over
STAGE = 1  # where in a step to go on, and where the driver stopped
AGO = 2  # steps since the last list
DANGEROUS = 3  # lists that came late
BROKEN = 4  # slots of bonds that broke
FIRST = 5  # calls before the forces: the first ones
LAST = 6  # calls behind them; between both the test who has moved, and the forces; the very last call renews the lists
EVERY, DELAY = 7, 8
REBUILDS = 9  # NEVER, ALWAYS, IF_MOVED
CLOCK, NUMBER = 10, 11  # of the C library, as machine.clock gives them
QUIET = 12  # while there are more steps than that to go the last call renews the lists, if it can
BUILDS = 13  # lists renewed that way
PLAN = 14

START, FORCES, BEHIND = 0, 1, 2  # stages
NEVER, ALWAYS, IF_MOVED = 0, 1, 2
DONE, REBUILD, BOOK = 0.0, 1.0, 2.0  # why it stopped
MODIFY, NEIGH, PAIR = 0, 1, 2  # sections of the table of timings


def drive(plan: "i8*", calls: "i8*", times: "f8*", room: "i8*", ticks: "i8*") -> "f8":
    """Carry out steps as Run.step does. calls: address and block of each call. times (3,): gets the seconds of the sections. room: (2,) scratch. ticks[0]: the step
    in progress, for calls that depend on it.

    Stops when all steps are done, between drift and forces when lists must be built anew by Python, or behind the forces when bonds broke.
    """
    first = plan[FIRST]
    behind = first + 2 + plan[LAST]
    every = plan[EVERY]
    delay = plan[DELAY]
    rebuilds = plan[REBUILDS]
    clock = plan[CLOCK]
    number = plan[NUMBER]
    before = seconds(clock, number, room)
    stage = plan[STAGE]
    while plan[STEPS] > 0:
        if stage == START:
            ticks[0] += 1
            for k in range(first):
                invoke(calls[2 * k], calls[2 * k + 1])
            now = seconds(clock, number, room)
            times[MODIFY] += now - before
            before = now
            plan[AGO] += 1
            ago = plan[AGO]
            if rebuilds != NEVER and ago >= delay and ago % every == 0:
                moved = True
                if rebuilds == IF_MOVED:
                    moved = invoke(calls[2 * first], calls[2 * first + 1]) != 0.0
                    now = seconds(clock, number, room)
                    times[NEIGH] += now - before
                    before = now
                    if moved and ago == max(every, delay):
                        plan[DANGEROUS] += 1
                if moved:
                    if plan[STEPS] <= plan[QUIET] or invoke(calls[2 * behind], calls[2 * behind + 1]) != 0.0:
                        plan[STAGE] = FORCES
                        return REBUILD
                    plan[AGO] = 0
                    plan[BUILDS] += 1
                    now = seconds(clock, number, room)
                    times[NEIGH] += now - before
                    before = now
        if stage != BEHIND:
            broken = int(invoke(calls[2 * first + 2], calls[2 * first + 3]))
            now = seconds(clock, number, room)
            times[PAIR] += now - before
            before = now
            if broken != 0:
                plan[BROKEN] = broken
                plan[STAGE] = BEHIND
                return BOOK
        for k in range(first + 2, behind):
            invoke(calls[2 * k], calls[2 * k + 1])
        stage = START
        plan[STEPS] -= 1
    plan[STAGE] = START
    times[MODIFY] += seconds(clock, number, room) - before
    return DONE
