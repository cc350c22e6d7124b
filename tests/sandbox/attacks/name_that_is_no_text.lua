-- Names that are no text.
-- expect: recipe error
return {
  draw = function(r)
    pass("\255\254\27[31m", function() error("\255\254") end)
  end,
}
