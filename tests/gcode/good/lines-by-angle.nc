%
O1004
G21 G90 G17 G54 F100
G0 X0. Y0. Z0.
G1 X10. ,A45.
Y20. ,A135.
(where this line ends, the next one tells)
,A0. ,R2.
X20. Y0. ,A-90. ,C1.
X0. Y0. ,A180.
,A90.
X-10. Y20. ,A135.
G91 X5. ,A-45.
G68 X0. Y0. R90.
G90 X0. Y0.
X10. ,A45.
M30
%
