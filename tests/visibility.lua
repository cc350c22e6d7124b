-- Recipes whose picture is the visibility, against the truth's.
local visibility = { size = 128 }

function visibility.render(recipe, scene_name, set)
  return render(recipe, { scene = scene_name, size = { visibility.size, visibility.size }, set = set,
                          visibility = true })
end

-- How many pixels are on the wrong side: lit by more than half where the truth is dark, or the reverse.
function visibility.wrong(recipe, scene_name, set)
  return visibility.render(recipe, scene_name, set)
           :difference(visibility.render("truth", scene_name), 127).differing
end

return visibility
