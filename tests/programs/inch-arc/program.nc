(an arc in inches, from an incremental end; a dwell)
(T1 D=.25 CR=0. - flat end mill)
(STOCK/BLOCK,3.,2.,.5,0.,0.,.5)
G20 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X.5 Y.5 Z.1
G1 Z-.1 F5.
X1. F10.
G91 G2 X1. Y1. J1.
G4 P2.
G90 G0 Z1.
M5
M30
