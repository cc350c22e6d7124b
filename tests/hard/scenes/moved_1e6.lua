return require("scenes.moved")(vec3(1, 0.7, -1 / 3) * 1e6)
