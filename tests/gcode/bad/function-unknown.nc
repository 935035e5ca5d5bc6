; 2:1: error: 'sinh' is no function [function-unknown]
Xsinh[1]
