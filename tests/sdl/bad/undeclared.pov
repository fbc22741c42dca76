#declare Radius = 2;
sphere { <0, 0, Radis>, 1 }
