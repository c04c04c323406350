"""Eigenvalues and eigenvectors of a small symmetric matrix by Jacobi's rotations, the largest element off the diagonal first.

Source: C. G. J. Jacobi (1846), as in Press et al., Numerical Recipes, chapter 11; rotations and their order as in the public
domain library jacobi_pd, so that the last bits are those of LAMMPS.
"""

from __future__ import annotations

import math

Matrix = list[list[float]]
_SWEEPS = 50


def eigen(matrix: Matrix) -> tuple[list[float], Matrix]:
    """Values in falling order, and the vector of each. The upper triangle of matrix is read."""
    n = len(matrix)
    m = [row[:] for row in matrix]
    vectors = [[float(i == j) for j in range(n)] for i in range(n)]
    largest = [_largest(m, i) for i in range(n)]
    for _ in range(_SWEEPS * n * (n - 1) // 2):
        i = 0
        for row in range(1, n - 1):
            if abs(m[row][largest[row]]) > abs(m[i][largest[i]]):
                i = row
        j = largest[i]
        if m[i][i] + m[i][j] == m[i][i] and m[j][j] + m[i][j] == m[j][j]:
            m[i][j] = 0.0
        if m[i][j] == 0.0:
            break
        _rotate(m, vectors, i, j)
        largest = [_largest(m, row) for row in range(n)]
    order = sorted(range(n), key=lambda k: -m[k][k])
    return [m[k][k] for k in order], [vectors[k] for k in order]


def _largest(m: Matrix, i: int) -> int:
    """The column of the largest element of row i right of the diagonal, the first of equals."""
    return max(range(i + 1, len(m)), key=lambda j: abs(m[i][j]), default=0)


def _rotate(m: Matrix, vectors: Matrix, i: int, j: int) -> None:
    """Make the element (i, j) zero; i < j."""
    n = len(m)
    t, apart = 1.0, m[j][j] - m[i][i]
    if apart != 0.0:
        kappa = apart / (2.0 * m[i][j])
        t = 1.0 / (math.sqrt(1.0 + kappa * kappa) + abs(kappa))
        if kappa < 0.0:
            t = -t
    c = 1.0 / math.sqrt(1.0 + t * t)
    s = c * t
    m[i][i] -= t * m[i][j]
    m[j][j] += t * m[i][j]
    m[i][j] = 0.0
    for w in range(n):
        if w in (i, j):
            continue
        a, b = (min(w, i), max(w, i)), (min(w, j), max(w, j))
        left, right = m[a[0]][a[1]], m[b[0]][b[1]]
        m[a[0]][a[1]] = c * left - s * right
        m[b[0]][b[1]] = s * left + c * right
    for v in range(n):
        left, right = vectors[i][v], vectors[j][v]
        vectors[i][v] = c * left - s * right
        vectors[j][v] = s * left + c * right
