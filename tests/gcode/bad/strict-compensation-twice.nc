; strict: 3:1: error: cutter compensation is on already [compensation-twice]
F1 G41
G41
M2
