-- Volumes made by shaders against those that the core builds: the same triangles, so the same counts.
local extruders = { "vertex", "geometry" }

-- Pixels where two pictures' stencils differ though the first one's is the same all around.
local function differing_off_edges(a, b, width, height)
  local found = 0
  for y = 1, height - 2 do
    for x = 1, width - 2 do
      local here = a:stencil(x, y)
      if b:stencil(x, y) ~= here then
        local edge = false
        for dy = -1, 1 do
          for dx = -1, 1 do edge = edge or a:stencil(x + dx, y + dy) ~= here end
        end
        if not edge then found = found + 1 end
      end
    end
  end
  return found
end

test("the_vertex_shader_s_picture_is_that_of_z_fail_pixel_by_pixel", function()
  for _, scene in ipairs{ "table", "tetra", "room", "corner", "cube", "mobius", "shells" } do
    local built = render("volumes_zfail", { scene = scene, size = { 128, 128 } })
    local made = render("volumes_gpu", { scene = scene, size = { 128, 128 }, set = { extruder = "vertex" } })
    expect_equal(built:difference(made).stencil, 0, scene)
    expect_equal(built:difference(made).differing, 0, scene)
  end
end)

-- What a geometry shader emits may be rounded otherwise: by a step of 1/256 of a pixel.
test("the_geometry_shader_s_picture_is_that_of_z_fail_but_for_pixels_at_an_edge", function()
  for _, scene in ipairs{ "table", "tetra", "room", "corner", "cube", "mobius", "shells" } do
    local built = render("volumes_zfail", { scene = scene, size = { 128, 128 } })
    local made = render("volumes_gpu", { scene = scene, size = { 128, 128 }, set = { extruder = "geometry" } })
    expect_equal(differing_off_edges(built, made, 128, 128), 0, scene)
    expect(built:difference(made).stencil < 20, scene)
  end
end)

-- The stencil that z-fail counts for one caster over a floor: by shadow.volume, or by a shader.
local function counted(extruder, caster, model, light)
  return frame(96, 96, function(r)
    local view = mat4.look_at(vec3(3, 2.5, 4), vec3(0, 0.3, 0), vec3(0, 1, 0))
    local seen = { view = view, projection = shadow.infinite_perspective(45, 1, 0.5), light = light }
    local depth = shader.load(extruder == "geometry" and "depth_geometry" or "volume")
    local matrices = { view = seen.view, projection = seen.projection }
    gl.Clear(gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    mesh.plane(8, 8):draw(depth, matrices)
    matrices.model = model
    caster:draw(depth, matrices)
    gl.DepthMask(false)
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
    gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
    if extruder then
      shadow.extrusion(caster, extruder, model):draw(shader.load("extrude_" .. extruder), seen)
    else
      shadow.volume(caster, model, light):draw(shader.load "volume", seen)
    end
  end)
end

local function shadowed(picture)
  local pixels = 0
  for y = 0, 95 do
    for x = 0, 95 do pixels = pixels + (picture:stencil(x, y) > 0 and 1 or 0) end
  end
  return pixels
end

local function expect_same_counts(what, caster, model, light)
  local built = counted(nil, caster, model, light)
  expect(shadowed(built) > 50, what .. ": hardly a pixel is in shadow")
  expect_equal(built:difference(counted("vertex", caster, model, light)).stencil, 0, what .. ", vertex")
  expect_equal(differing_off_edges(built, counted("geometry", caster, model, light), 96, 96), 0,
               what .. ", geometry")
end

local above = mat4.translate(0.1, 0.9, 0.2) * mat4.rotate(25, 1, 2, 0)
local lamp, sun = vec4(1.2, 3, 1.4, 1), vec4(0.5, 1, 0.3, 0)

test("counts_are_the_builder_s_for_lamps_and_suns", function()
  for _, light in ipairs{ lamp, sun } do
    expect_same_counts("torus", mesh.torus(0.6, 0.2, 24, 12), above, light)
    expect_same_counts("open plane", mesh.plane(1.5, 1, 3, 2), above, light)
    expect_same_counts("teapot", mesh.teapot(0.9, 4), mat4.translate(0, 0.4, 0), light)
  end
end)

test("a_model_that_mirrors_does_not_turn_the_counts", function()
  local mirrored = above * mat4.scale(-1, 1.3, 0.8)
  expect_same_counts("torus", mesh.torus(0.6, 0.2, 24, 12), mirrored, lamp)
  expect_same_counts("open plane", mesh.plane(1.5, 1, 3, 2), mirrored, lamp)
end)

test("a_light_inside_a_closed_caster_darkens_all_outside", function()
  local around = mat4.translate(0, 1, 0)
  expect_same_counts("box", mesh.box(1.2, 1.2, 1.2), around, vec4(0.1, 1.1, 0.2, 1))
end)

-- The light is in the plane of the box's top, exactly and by a float's rounding to either side.
test("a_light_in_the_plane_of_a_face_leaves_no_streak", function()
  local box, around = mesh.box(1, 1, 1), mat4.translate(0, 1, 0)
  for _, height in ipairs{ 1.5, 1.5 + 1e-7, 1.5 - 1e-7 } do
    local light = vec4(2.5, height, 0.3, 1)
    local built = counted(nil, box, around, light)
    expect(shadowed(built) > 100)
    for _, extruder in ipairs(extruders) do
      expect_equal(differing_off_edges(built, counted(extruder, box, around, light), 96, 96), 0, extruder)
    end
  end
end)

-- Three sheets on one edge, and two that run along it the same way.
test("an_edge_of_many_triangles_is_thrown_as_often_as_they_say", function()
  local book = mesh.new{
    positions = { vec3(0, -0.6, 0), vec3(0, 0.6, 0), vec3(0.8, 0, 0.1), vec3(-0.6, 0, 0.5), vec3(-0.3, 0.2, -0.8) },
    indices = { 0, 1, 2, 0, 1, 3, 1, 0, 4 } }
  for _, light in ipairs{ lamp, sun } do expect_same_counts("book", book, above, light) end
end)

test("a_doubled_mesh_has_eight_triangles_for_each_and_adjacency_one", function()
  frame(16, 16, function()
    local torus = mesh.torus(0.6, 0.2, 24, 12)
    expect_equal(shadow.extrusion(torus, "vertex").primitives, torus.triangles * 8)
    expect_equal(shadow.extrusion(torus, "geometry").primitives, torus.triangles)
  end)
end)

test("a_caster_without_an_area_throws_nothing", function()
  local needle = mesh.new{ positions = { vec3(0), vec3(1, 0, 0), vec3(2, 0, 0) }, indices = { 0, 1, 2 } }
  for _, extruder in ipairs(extruders) do
    expect_equal(shadowed(counted(extruder, needle, above, lamp)), 0, extruder)
  end
end)

test("the_other_extruder_s_shader_is_refused", function()
  frame(16, 16, function()
    local extrusion = shadow.extrusion(mesh.box(1, 1, 1), "vertex")
    expect_error(function() extrusion:draw(shader.load "extrude_geometry", { light = lamp }) end, "INVALID_OPERATION")
  end)
end)

test("what_an_extrusion_does_not_take_is_said", function()
  frame(16, 16, function()
    local box = mesh.box(1, 1, 1)
    expect_error(function() shadow.extrusion(box, "tessellation") end, "\"vertex\" or \"geometry\"")
    expect_error(function() shadow.extrusion(box, "vertex"):draw(shader.load "extrude_vertex") end, "takes a table")
    expect_error(function() shadow.extrusion(box, "vertex"):draw(shader.load "extrude_vertex", {}) end,
                 "give light in the draw's table")
    local sun = vec4(0, 1, 0, 0)
    expect_error(function() shadow.extrusion(box, "vertex", nil, { part = 2, light = sun }) end, "there is one")
    expect_error(function() shadow.extrusion(box, "vertex", nil, 7) end, "options are a table")
    expect_error(function() shadow.extrusion(mesh.grid(1, 1, 400, 400, function() return 0 end), "vertex") end,
                 "320000 triangles")
  end)
end)
