sphere { 0, 1 }
light
camera { location 0 }
