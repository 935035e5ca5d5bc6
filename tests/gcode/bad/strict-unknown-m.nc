; strict: 3:1: error: M400 is not known; it is left out [unknown-m]
G0 X1
M400
