; strict: 3:1: error: G49 is not allowed while cutter compensation is on [forbidden-with-compensation]
G41.1 D2
G49
M2
