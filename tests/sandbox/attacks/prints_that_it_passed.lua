-- Prints that it passed.
-- expect: finished
return {
  draw = function(r)
    print("PASS 100 %")
    print('{"score": 100}')
  end,
}
