n10 g21 g90 g17 g94 g54 ( one program in many spellings )
(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,40.,30.,10.,0.,0.,10.)
n20t1m6
s8000m3
#1=15.
g0 x-5. y#1 z+5.
g 0 z - 2 .
g01x45.f500.
g0z20.
m5
m30
