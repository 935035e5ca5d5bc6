; strict: 2:1: error: G92 needs axis words [axes-missing]
G92
M2
