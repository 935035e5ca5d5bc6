G90 G80 G40 G49
;T1=TC1
;begin preamble
G53 G00 G17
G20
;begin operation
G54
G0 Z0.7874
;end operation: G54
;begin operation
;T1 flat 9.525 mm
M6 T1
M3 S8000
;end operation: T1 flat 9.525 mm
;begin operation
;Slot 1
;Slot 1
;Tool type: EndMill
;Compensated Tool Path. Diameter: 9.525 mm
;
G0 Z1.5748
G0 X-0.7087 Y0.4724
G1 Z-0.0787 F9.8
G1 X0.7087 Y0.4724 F31.5
G1 Z-0.1575 F9.8
G1 X-0.7087 Y0.4724 F31.5
G1 Z-0.2362 F9.8
G1 X0.7087 Y0.4724 F31.5
G0 Z0.1181
G0 Z1.5748
G0 Z1.5748
;end operation: Slot 1
;begin operation
;Slot 2
;Slot 2
;Tool type: EndMill
;Compensated Tool Path. Diameter: 9.525 mm
;
G0 Z1.5748
G0 X-0.7087 Y-0.4724
G1 Z-0.0787 F9.8
G1 X0.7087 Y-0.4724 F31.5
G1 Z-0.1575 F9.8
G1 X-0.7087 Y-0.4724 F31.5
G1 Z-0.2362 F9.8
G1 X0.7087 Y-0.4724 F31.5
G0 Z0.1181
G0 Z1.5748
G0 Z1.5748
;end operation: Slot 2
;begin postamble
M5
M25
G49 H0
G90 G80 G40 G49
M99
