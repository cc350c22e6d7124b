// Random calls of everything in gl.*, seeded: by functions that are mostly right, or by anything.
#pragma once

#include <fmt/format.h>

#include <string>

#include "gl/enums.h"
#include "gl/functions.h"

namespace shadowlab::lua {

namespace random_calls {

template <class... Kinds>
std::string enums() {
  std::string text;
  const auto add = [&text](std::string_view kind, std::span<const gl::Constant> values) {
    text += fmt::format("{} = {{", kind);
    for (const gl::Constant& constant : values) text += fmt::format("{}, ", constant.value);
    text += "},\n";
  };
  (add(Kinds::name, Kinds::values), ...);
  return text;
}

}  // namespace random_calls

/// Lua's side of the list of functions: `functions[i]` has a name and the names of its kinds,
/// `enums` the values of those that are enumerations.
inline std::string function_tables() {
  using namespace gl;
  std::string text =
      "enums = {\n" +
      random_calls::enums<
          CompareFunction, StencilAction, Face, Winding, BothFaces, FillMode, ProvokingConvention,
          ClipOrigin, ClipDepth, LogicOperation, Capability, IndexedCapability, BlendEquationName,
          BlendFactor, AccumOperation, TextureUnit, TextureTarget, ImageTarget2D, StorageTarget2D,
          ImageTarget3D, TextureParameter, SamplerParameter, InternalFormat, PixelFormat, PixelType,
          PixelStoreName, FramebufferTarget, RenderbufferTarget, Attachment, ColorBuffer,
          ClearedBuffer, ClearedDepthStencil, BlitFilter, AttachmentParameter,
          RenderbufferParameter, BufferTarget, BufferUsage, AttributeType, IndexType, Primitive,
          ShaderStage, ShaderParameter, ProgramParameter, QueryTarget, QueryParameter, StateName,
          ClearBits, BlitBits>() +
      "ParameterValue = {0, 1, 2, 9728, 9729, 9984, 9987, 33071, 33069, 10497, 34894, 515, 6403}}\n"
      "functions = {\n";
  for (const auto& function : function_descriptions()) {
    if (function.use == FunctionDescription::Use::core) continue;
    text += fmt::format("{{name = '{}', kinds = {{", function.name);
    std::string_view kinds = function.kinds;
    while (!kinds.empty()) {
      const std::size_t end = std::min(kinds.find(", "), kinds.size());
      text += fmt::format("'{}', ", kinds.substr(0, end));
      kinds.remove_prefix(std::min(kinds.size(), end + 2));
    }
    text += "}},\n";
  }
  return text + "}\n";
}

/// `call_random()` calls one function; `mostly_right` and `anything` give its arguments.
inline constexpr const char* random_calls_in_lua = R"lua(
  local random = math.random
  objects = {}
  local function pick(t) return t[random(#t)] end
  local function keep(...)
    for i = 1, select('#', ...) do
      local value = select(i, ...)
      if type(value) == 'userdata' then
        local kind = tostring(value):match '^(%a[%a ]*) %d+$'
        objects[kind] = objects[kind] or {}
        table.insert(objects[kind], value)
        if #objects[kind] > 12 then table.remove(objects[kind], 1) end
      end
    end
  end
  local kinds_of_objects = { TextureObject = 'texture', SamplerObject = 'sampler',
    FramebufferObject = 'framebuffer', RenderbufferObject = 'renderbuffer',
    BufferObject = 'buffer', VertexArrayObject = 'vertex array', ShaderObject = 'shader',
    ProgramObject = 'program', QueryObject = 'query' }
  local function object(kind)
    local known = objects[kinds_of_objects[kind]]
    if not known or #known == 0 or random(6) == 1 then return 0 end
    return pick(known)
  end
  local function numbers(count, make)
    local t = {}
    for i = 1, count do t[i] = make() end
    return t
  end
  local sizes = { 0, 1, 1, 2, 3, 4, 8, 16, 64 }
  local function mostly_right(kind)
    if enums[kind] then
      if kind:find 'Bits$' then return pick(enums[kind]) | pick(enums[kind]) end
      return pick(enums[kind])
    elseif kinds_of_objects[kind] then return object(kind)
    elseif kind == 'Int' then return random(-2, 20)
    elseif kind == 'Uint' then return random(0, 17)
    elseif kind == 'Mask' then return random(0, 255)
    elseif kind == 'Size' or kind == 'ByteCount' or kind == 'Offset' then return pick(sizes)
    elseif kind == 'Float' or kind == 'Double' then return random() * 4 - 1
    elseif kind == 'Bool' then return random(2) == 1
    elseif kind == 'Text' or kind == 'In<Text>' then return pick { 'color', 'position', 'x' }
    elseif kind == 'Bytes' then
      if random(3) == 1 then return nil end
      return numbers(pick(sizes), function() return random(0, 100) end)
    elseif kind:find '^In<%a+Object>' then
      local t = {}
      for i = 1, random(0, 2) do t[i] = object(kind:match '<(%a+)>') end
      return t
    elseif kind == 'In<ColorBuffer>' then
      return numbers(random(0, 3), function() return pick(enums.ColorBuffer) end)
    elseif kind == 'In<Float>' then
      return numbers(pick { 1, 4, 9, 16 }, function() return random() * 2 - 0.5 end)
    elseif kind:find '^In<' then
      return numbers(pick { 1, 4 }, function() return random(0, 5) end)
    end
    error('no value of kind ' .. kind)
  end

  local strange = { 0, 1, -1, 2^31 - 1, 2^31, 2^32 - 1, 2^32, 2^53, -2^31, 2^30, 0.5, 1e308, -1e308,
    0/0, 1/0, -1/0, math.maxinteger, math.mininteger, true, false, '', '1', 'gl.ALWAYS', '\0\255"',
    string.rep('x', 300), {}, { 1, 2, 3 }, { {} }, { 'x' }, { 0/0 }, print, gl, vec3(1, 2, 3),
    mat4.translate(1, 2, 3), coroutine.create(print), setmetatable({}, { __index = error, __len = error }) }
  local function anything(kind)
    local choice = random(10)
    if choice <= 6 then return mostly_right(kind) end
    if choice <= 8 then return pick(strange) end
    local known = objects[pick { 'texture', 'buffer', 'framebuffer', 'program', 'shader', 'query' }]
    if known and #known > 0 then return pick(known) end
    return nil
  end

  -- How the Lua form of a function differs from C's: results are no arguments, counts and lengths
  -- of texts are the texts' own.
  local function in_lua(kinds)
    local own = {}
    for i, kind in ipairs(kinds) do
      if not kind:find '^Out' then own[#own + 1] = kind end
    end
    if kinds[3] == 'In<Text>' then own = { 'ShaderObject', 'In<Text>' } end
    if kinds[4] == 'Out<Char>' then own = { kinds[1] } end
    return own
  end

  accepted, refused = 0, 0
  function call_random(wild)
    local f = pick(functions)
    local argument = wild and anything or mostly_right
    local kinds = in_lua(f.kinds)
    local count = #kinds
    if wild and random(20) == 1 then count = random(0, 12) end
    local arguments = {}
    for i = 1, count do arguments[i] = argument(kinds[i] or 'Int') end
    -- The count of an array is usually its length.
    for i = 2, count do
      if kinds[i - 1] == 'Size' and kinds[i] and kinds[i]:find '^In<' and
         type(arguments[i]) == 'table' and random(4) > 1 then
        arguments[i - 1] = rawlen(arguments[i])
      end
    end
    local results = table.pack(pcall(gl[f.name], table.unpack(arguments, 1, count)))
    if results[1] then accepted = accepted + 1 else refused = refused + 1 end
    keep(table.unpack(results, 2, results.n))
  end
  for _, name in ipairs { 'GenTextures', 'GenSamplers', 'GenFramebuffers', 'GenRenderbuffers',
                          'GenBuffers', 'GenVertexArrays', 'GenQueries' } do
    keep(gl[name](3))
  end
)lua";

}  // namespace shadowlab::lua
