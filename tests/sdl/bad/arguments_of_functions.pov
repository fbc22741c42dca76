#declare A = sin 1;
#declare B = sin(1, 2);
#declare C = atan2(1);
#declare F = function(a, b) { a + b }
#declare D = F(1);
