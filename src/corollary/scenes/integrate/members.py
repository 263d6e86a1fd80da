"""Many rows of bodies, or many contacts of two spheres, one after another in one call; a kernel."""

from __future__ import annotations

from corollary.scenes.integrate.both_ways import ways

kernel, module = ways(__name__)
follow_row, follow_contact = module("row_motion").follow, module("contact_motion").follow


@kernel
def rows(
    y,
    touching,
    inverse,
    falls,
    k,
    q,
    eta,
    powers,
    deepest,
    hardest,
    lasted,
    strains,
    openings,
    ends,
    tolerance,
    most,
    room,
):
    """Each row as `row_motion.follow` does it; `y`, `inverse`, `k`, `deepest`, `hardest` have a line for each, the others serve all.

    `lasted` becomes how long each touched, `strains` how much that hangs on slow touches, `openings` how often it did, `ends` how it ended.
    Gives the evaluations of all.
    """
    spent = 0
    for i in range(len(y)):
        row = (inverse[i], falls, k[i], q, eta, powers)
        ends[i], began, ended, openings[i], cost, strains[i] = follow_row(
            y[i], touching, row, deepest[i], hardest[i], tolerance, most, room
        )
        lasted[i], spent = max(ended - began, 0.0), spent + cost
    return spent


@kernel
def contacts(y, groups, smoothing, overlaps, forces, ends, tolerance, most, room):
    """Each contact as `contact_motion.follow` does it; a line of `y` and of `groups` (without s, `smoothing`) for each.

    Gives the evaluations of all.
    """
    spent = 0
    for i in range(len(y)):
        g = groups[i]
        pure = (g[0], smoothing, g[1], g[2], g[3], g[4])
        ends[i], overlaps[i], forces[i], cost = follow_contact(y[i], pure, tolerance, most, room)
        spent += cost
    return spent
