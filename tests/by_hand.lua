-- The scene tetra, of which the shadow is computed by hand (scripts/scenes/tetra.lua says how).
local analytic = require "analytic"

local by_hand = {
  size = 256,
  light = vec4(4, 5, 2, 1),
  plane = vec4(0, 1, 0, 0),
  plane_color = vec3(0.74, 0.78, 0.72),
  background = vec3(0.85, 0.88, 0.92),
  receiver = { vec3(-5, 0, -3), vec3(3, 0, -3), vec3(3, 0, 3), vec3(-5, 0, 3) },
  caster = { vec3(-1, 1, -1), vec3(1, 1, -1), vec3(0, 1, 1), vec3(0, 2.5, 0) },
  -- Of that light; for other lights analytic.cast.
  shadow = { vec3(-2.25, 0, -1.75), vec3(0.25, 0, -1.75), vec3(-1, 0, 0.75), vec3(-4, 0, -2) },
}

-- A light so low that the apex's shadow, at 2 v - L = (-9, 0, 0), is past the plane's edge at -5.
by_hand.low_light = vec4(9, 5, 0, 1)
by_hand.low_shadow = {}
for i, v in ipairs(by_hand.caster) do
  by_hand.low_shadow[i] = analytic.cast(by_hand.plane, by_hand.low_light, v)
end

-- The recipe's picture of it.
function by_hand.render(recipe, light, set)
  set = set or {}
  set.light = light.xyz
  return render(recipe, { scene = "tetra", size = { by_hand.size, by_hand.size }, set = set })
end

-- Calls visit(x, y, what, in_shadow, viewer) for each pixel that is a pixel or more from every edge:
-- what it shows is "caster", "receiver" or "background"; in_shadow, whether it is in the polygon of
-- `shadow` on the plane, which has no end.
function by_hand.each_pixel(shadow, visit)
  local size = by_hand.size
  local viewer = analytic.viewer(scene.load("tetra").camera, size, size)
  local caster_hull = analytic.window_hull(viewer, by_hand.caster)
  local receiver_hull = analytic.window_hull(viewer, by_hand.receiver)
  local shadow_hull = analytic.window_hull(viewer, shadow)
  local counts = {}
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local on_caster = analytic.side(caster_hull, x, y)
      local on_receiver = analytic.side(receiver_hull, x, y)
      local side = analytic.side(shadow_hull, x, y)
      if on_caster and on_receiver and side then
        local what = on_caster == "in" and "caster"
                     or on_receiver == "in" and "receiver" or "background"
        local kind = what .. (side == "in" and " in shadow" or "")
        counts[kind] = (counts[kind] or 0) + 1
        visit(x, y, what, side == "in", viewer)
      end
    end
  end
  for _, kind in ipairs{ "caster", "receiver", "receiver in shadow", "background" } do
    expect((counts[kind] or 0) > 300, "hardly a pixel shows the " .. kind)
  end
end

return by_hand
