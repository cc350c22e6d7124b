-- hint: Most of the picture is wrong or black: the drawings are added up first, and a buffer bounded by [-1, 1] overflows into the negative. Weigh each drawing on its way in, or store in floats.
-- hint.ca: La major part de la imatge és incorrecta o negra: primer se sumen els dibuixos, i un buffer limitat a [-1, 1] desborda cap als negatius. Pondera cada dibuix en entrar, o desa en coma flotant.
-- hint.es: La mayor parte de la imagen es incorrecta o negra: primero se suman los dibujos, y un buffer limitado a [-1, 1] se desborda hacia los negativos. Pondera cada dibujo al entrar, o guarda en coma flotante.
-- hint.fr: La plus grande partie de l'image est fausse ou noire : les dessins sont d'abord additionnés, et un tampon borné à [-1, 1] déborde vers les négatifs. Pondère chaque dessin à l'entrée, ou garde en flottants.

local recipe = {
  title   = "Lab 04: an average without bands",
  lecture = "002_b957b372f85420d1: Banding in a limited buffer",
  params  = {
    times = param.integer(16, 1, 256),     -- drawings
    color = param.color(1, 0, 0),
    tilt  = param.number(180, 0, 360),     -- degrees; 180: bright at the left
  },
}

function recipe.setup(r)
  r.quad = mesh.quad()
  r.ramp = shader.compile{
    vertex = [[
      #version 330 core
      layout(location = 0) in vec3 position;
      void main() { gl_Position = vec4(position, 1.0); }
    ]],
    fragment = [[
      #version 330 core
      uniform vec2 size, along;
      uniform vec3 color;
      uniform float brightness;
      out vec4 fragment;
      void main() {
        float level = clamp(dot(gl_FragCoord.xy / size - 0.5, along) + 0.5, 0.0, 1.0);
        fragment = vec4(color * brightness * level, 1.0);
      }
    ]],
  }
end

-- The i-th of the drawings: the first at full brightness, the last at about half of it.
local function draw_ramp(r, i)
  local angle = math.rad(r.params.tilt)
  r.quad:draw(r.ramp, { size = vec2(r.width, r.height), along = vec2(math.cos(angle), math.sin(angle)),
                        color = r.params.color, brightness = 1 - 0.5 * (i - 1) / r.params.times })
end

function recipe.draw(r)
  local times = r.params.times

  pass("1. the drawings, accumulated", function()
    fbo.accumulation "snorm16"
    gl.Clear(gl.ACCUM_BUFFER_BIT)
    for i = 1, times do
      draw_ramp(r, i)
      gl.Accum(gl.ACCUM, 1)
    end
  end)

  pass("2. the average", function()
    gl.Accum(gl.RETURN, 1 / times)
  end)
end

return recipe
