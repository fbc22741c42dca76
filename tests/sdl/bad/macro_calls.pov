#macro Inner(R)
  sphere { 0, R*Missing }
#end
#macro Outer(R)
  union { Inner(R) }
#end
Outer(3)
