"""Which points hold together."""

import numpy as np


def pieces(x, reach):
    """Number of the piece of each point; points nearer to each other than reach [m] are of one.
    Boxes of that size; each point meets those of its own box and of the boxes around."""
    box = np.floor(x/reach).astype(int)
    boxes = {}
    for i, b in enumerate(map(tuple, box)):
        boxes.setdefault(b, []).append(i)
    number = np.full(len(x), -1)
    n = 0
    for start in range(len(x)):
        if number[start] >= 0:
            continue
        number[start], todo = n, [start]
        while todo:
            i = todo.pop()
            a, b = box[i]
            near = np.array([j for c in (a - 1, a, a + 1) for d in (b - 1, b, b + 1)
                             for j in boxes.get((c, d), ())])
            near = near[(number[near] < 0) & (np.sum((x[near] - x[i])**2, axis=1) < reach**2)]
            number[near] = n
            todo.extend(near)
        n += 1
    return number
