%
(A clamp is tilted a millimetre below the head)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
(T1 D=6. CR=0. - flat end mill)
G21 G90 G17 G54 G40 G49 G80
G10 L1 P1 Z80.
G91 G28 Z0.
G90
T1 M6
S3000 M3
G43 H1
G0 X0. Y0. Z100.
G0 X-50. Z5.
Z-2.
G1 X50. F500.
G0 Z100.
G0 X110.
Z-3.
G0 A60.
G0 A0.
G0 Z100.
G91 G28 Z0.
G90
M5
M30
%
