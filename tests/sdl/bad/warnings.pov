#warning "look here"
#undef Nothing
#declare deprecated once "use New" Old = 1;
sphere { Old*x, vlength(vnormalize(0)) }
#version 3.7
