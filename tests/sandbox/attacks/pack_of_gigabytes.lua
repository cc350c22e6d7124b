-- Packs gigabytes.
-- expect: recipe error
-- says: string.pack
return {
  draw = function(r)
    string.pack("!16 i16", 1 << 62)
  end,
}
