; 4:1: error: M428 depends on the rotary axes, and the machine is not specified; the program is stopped here [kinematics]
G0 X0 Y0 Z0
M428
A10 X5
