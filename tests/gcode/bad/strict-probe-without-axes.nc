; strict: 2:4: error: G38.2 needs axis words [axes-missing]
F1 G38.2
M2
