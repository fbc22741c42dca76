sphere { 0, 1 }
#end
box { 0, Foo*1 }
