; 3:1: error: G68.2 needs the rotary axes of the machine, which are not specified: two lines of a machine file are enough, preset = "xyzac-trt" (or another one) and pivot = … (--machine FILE); the program is stopped here [kinematics]
G0 X0
G68.2 X0 Y0 Z0 I0 J90 K0
