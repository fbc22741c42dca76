#declare V = <1, 2>;
#declare A = V.z;
#declare B = V.foo;
