; G43.1 moves nothing, but the tip is elsewhere
G21 G90 G0 X0 Y0 Z100
G43.1 Z40
G0 Z10
G49
G53 G0 Z0
M2
