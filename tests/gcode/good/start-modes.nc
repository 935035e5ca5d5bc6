; dwell, stop, and what M30 leaves
G21 G90 G0 X0 Y0 Z0
G4 P0.5
M0
M1
G55
M30
X99
