; 3:1: error: G41.2 depends on how the machine turns (compensation in space, dynamic offsets), which is not simulated; the program is stopped here [tilted-plane]
G0 X0 Y0 Z0
G41.2 D1
