%
(The table turns a corner of the part 0.8 mm past the column)
(STOCK/BLOCK,310.,310.,30.,155.,155.,-30.)
(T1 D=6. CR=0. - flat end mill)
G21 G90 G17 G54 G40 G49 G80
G10 L1 P1 Z80.
G91 G28 Z0.
G90
T1 M6
S3000 M3
G43 H1
G0 X0. Y0. Z200.
G0 Z200.
G0 C45.
G0 C0.
G0 X-165. Z65.
Z58.
G1 X-100. F500.
G0 Z200.
G91 G28 Z0.
G90
M5
M30
%
