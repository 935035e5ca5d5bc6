; strict: 2:10: error: X stands twice in this block; the last one counts [word-twice]
F1 G0 X1 X2
