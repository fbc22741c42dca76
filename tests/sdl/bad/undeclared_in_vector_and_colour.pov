sphere { <0,0,Foo>, 1 pigment { colour rgb Bar*2 } rotate Qux*x translate 3 }
