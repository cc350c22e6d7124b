-- Keeps what it saw in one shot for the next.
-- expect: finished
return {
  draw = function(r)
    counter = (rawget(_G, "counter") or 0) + 1
    assert(counter == 1)
    assert(math.random(1000000) == math.random(1000000) or true)
  end,
}
