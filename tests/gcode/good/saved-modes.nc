; M70 to M73: modes are saved and restored; M72 without M70 says so; a cycle without depth, too
o1 sub
M73
G91 G1 X5 F50
G20
o1 endsub
G21 G90 F100
G0 X0 Y0 Z5
o1 call
G1 X20
M70
G91
M72
X21
M71
M72
G81 X22 Z2 R2
G4 P1 G1 X30
M2
