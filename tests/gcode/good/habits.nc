; what controls accept though RS274/NGC does not
%
(a remark (with another) in it)
$H
X0 Y0 Z5
G1 X10 X12 F100
G2 X22 I5 K0.000
G0 G28 G91 Z0
G90 G81 X0 Y0 Z-1 R1
G80
Z15.
G187 P1
M333
T2
( M6 T3 )
G1 Z-1*23
