; old posts write centres absolute without G90.1
G21 G90 G0 X100 Y50 Z0 F100
G3 X90 Y60 I90 J50
G3 X80 Y50 I90 J50
M2
