"""Work in parts that several threads carry out: each takes the next part that nobody has taken, until all are done.

Whoever has no time takes none: a thread that the system does not let run costs nobody anything, unless it is in the middle of a part.
"""

from __future__ import annotations

from pylmp.kernels.machine import invoke, seconds
from pylmp.kernels.sharing import add_to, give_way, look, post, swap_if

# mailbox: numbers that threads share, each in a line of the cache of its own
TICKETS = 0  # number of the job (from bit 32), how many parts it has (16 bits), how many are taken (16 bits)
FINISHED = 8  # parts that are finished
DISMISSED = 16  # not 0: helpers go home
MAILBOX = 24

MOST_PARTS = 64
_JOBS = (1 << 31) - 1
_COUNT = (1 << 16) - 1
_LOOKS = 2000  # at the mailbox, one after the other, before a thread gives way


def take(mailbox):
    """The next part of the job, -1 if all are taken. Number and parts of a job are one word: a ticket is never for another job."""
    word = look(mailbox, TICKETS)
    while word & _COUNT < (word >> 16) & _COUNT:
        if swap_if(mailbox, TICKETS, word, word + 1):
            return word & _COUNT
        word = look(mailbox, TICKETS)
    return -1


def fork(mailbox: "i8*", parts: "i8*", results: "f8*", calls: "i8*", count: "i8", way: "i8") -> "f8":
    """Carry out count calls, each address and block, with whoever helps; the sum of what they return, in their order.

    parts (2 MOST_PARTS,), results (MOST_PARTS,): of the team. way: address of sched_yield.
    """
    for k in range(2 * count):
        parts[k] = calls[k]
    job = ((look(mailbox, TICKETS) >> 32) + 1) & _JOBS
    post(mailbox, FINISHED, 0)
    post(mailbox, TICKETS, (job << 32) | (count << 16))
    k = take(mailbox)
    while k >= 0:
        results[k] = invoke(parts[2 * k], parts[2 * k + 1])
        add_to(mailbox, FINISHED, 1)
        k = take(mailbox)
    looks = 0
    while look(mailbox, FINISHED) < count:
        looks += 1
        if looks > _LOOKS:
            give_way(way)
    total = 0.0
    for k in range(count):
        total += results[k]
    return total


def serve(mailbox: "i8*", parts: "i8*", results: "f8*", way: "i8", clock: "i8", number: "i8", room: "i8*", patience: "f8") -> "f8":
    """Help with whatever is to be done, until dismissed, or for patience seconds there was nothing. clock, number: machine.clock; room: (2,) scratch."""
    looks = 0
    since = 0.0
    while True:
        k = take(mailbox)
        if k >= 0:
            results[k] = invoke(parts[2 * k], parts[2 * k + 1])
            add_to(mailbox, FINISHED, 1)
            looks = 0
            continue
        looks += 1
        if looks == _LOOKS:
            since = seconds(clock, number, room)
        if looks >= _LOOKS:
            if look(mailbox, DISMISSED) != 0 or seconds(clock, number, room) - since > patience:
                return 0.0
            give_way(way)
