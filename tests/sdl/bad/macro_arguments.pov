#macro Two(A, B)
  sphere { A*x, B }
#end
Two(1)
Two(1, 2, 3)
Two(Foo, 1)
