; strict: 3:5: error: G84 needs the spindle on by M3 [cycle-spindle]
F100 M4 S100
G90 G84 Z-1 R1
M2
