; strict: 2:5: error: G1 under G93 needs an F in its block [inverse-time-feed]
G93 G1 X1
M2
