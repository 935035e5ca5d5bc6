; LinuxCNC's control words: sub, call, return, if, while, do, repeat, break, continue
G21 G90 G0 X0 Y0 Z5
o100 sub
G0 X#1 Y#2
o101 if [#1 GT 5]
o100 return [#1 * 2]
o101 elseif [#1 EQ 5]
G0 Z6
o101 else
G0 Z7
o101 endif
o100 endsub [1]
o100 call [1] [2]
o100 call [5] [2]
o100 call [6] [2]
G0 X#<_value>
#1 = 0
o200 while [#1 LT 5]
#1 = [#1 + 1]
o201 if [#1 EQ 2]
o200 continue
o201 endif
o202 if [#1 EQ 4]
o200 break
o202 endif
G0 Y#1
o200 endwhile
o300 do
#1 = [#1 - 1]
o300 while [#1 GT 2]
G0 Y[#1 * 10]
o400 repeat [3]
G91 G0 X1
o400 endrepeat
G90
o<beside> call [42]
M2
