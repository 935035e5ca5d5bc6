(LinuxCNC: a named subroutine with parameters, called in a loop)
(T1 D=3. CR=0. - flat end mill)
(STOCK/BLOCK,40.,40.,6.,0.,0.,6.)
o<bar> sub
  G0 X#1 Y#2
  G1 Z-1.5 F150.
  G1 X[#1+#3] F300.
  G0 Z2.
o<bar> endsub
G21 G90 G17 G94 G54
T1 M6
S9000 M3
G0 Z2.
#<row>=8
o10 while [#<row> LT 36]
  o<bar> call [8] [#<row>] [#<row>/2+6]
  #<row>=[#<row>+8]
o10 endwhile
G0 Z20.
M5
M2
