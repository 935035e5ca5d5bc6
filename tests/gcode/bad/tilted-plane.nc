; 3:1: error: G68.2 depends on how the machine turns (tool centre point, tilted plane, polar or cylindrical coordinates, compensation in space), which is not simulated; the program is stopped here [tilted-plane]
G0 X0
G68.2 X0 Y0 Z0 I0 J90 K0
