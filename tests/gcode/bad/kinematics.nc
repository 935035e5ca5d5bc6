; 4:1: error: M428 chooses how the rotary axes move the tip, and nothing tells how this machine is built; the program is stopped here [kinematics]
G0 X0 Y0 Z0
M428
A10 X5
