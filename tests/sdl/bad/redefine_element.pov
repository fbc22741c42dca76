#declare A = array[2];
#declare A[0] = 1;
#declare A[0] = "one";
#declare F = function(a) { a }
#declare F = 2;
