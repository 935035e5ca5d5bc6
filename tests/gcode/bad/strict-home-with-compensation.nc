; strict: 3:1: error: G28 is not allowed while cutter compensation is on [forbidden-with-compensation]
F1 G41.1 D1 G1 X10
G28
M2
